"""Over and beside the absorber's plots: goals, their limits, readings at the running speed."""

from __future__ import annotations

import math

from components.language.blocks import Block
from components.language.numbers import Number, var
from components.layout.sheet import stage
from components.layout.stage import HALL, NARROW, WIDE, Shape, circle, line, on_x, on_y, path, text
from components.layout.text import rich
from components.quantities.axes import Axis
from components.quantities.numbers import short, three
from components.scenes.absorber.duty import AWAY, Duty
from components.scenes.absorber.numbers import Numbers as N
from components.scenes.absorber.numbers import bound, length

TICK, CROSS = "M-3.5 .5l2.6 2.6 5-5.600", "M-2.800 -2.800l5.600 5.600M2.800 -2.800l-5.600 5.600"
MARKS = (("slow", rf"$\omega_-$ {N.slow}"), ("F", rf"$\omega$ {N.omega}"), ("fast", rf"$\omega_+$ {N.fast}"))


def frequencies() -> list[tuple[str, str, str]]:
    """The lines that cross both plots: scalar, colour, flag."""
    return [(tint if tint != "F" else "omega", tint, rich(words)) for tint, words in MARKS]


def goals() -> Block:
    """Three goals: a dotted line runs from each limit in a plot to its mark and its sentence, with a bend in a hall."""
    shapes = [*_bracket(), *_joints(), *_readings(), *_fixed()]
    limits = _limits()
    for i, limit in enumerate(limits):
        y = WIDE * (limit + HALL * (limits[0] + 46 * i - limit)) + NARROW * (18 + 46 * i)
        begin = on_x("swing", var("away_high")) + 6 if i == 0 else var("swing.left")
        shapes.append(line(begin, limit, -16, limit, style="dotted", show="wide"))
        shapes.append(line(-16, limit, -4, y, style="dotted", show="wide"))
        met, missed = f"met{i}", f"open{i}"
        shapes += [circle(9, y, 8, style="told", show=met), path(TICK, 9, y, style="counter told", show=met)]
        shapes += [circle(9, y, 8, style="hollow told", show=missed), path(CROSS, 9, y, style="told", show=missed)]
        shapes.append(text(26, y + 5, f"{{goal{i}}}", "start", style="t2 b"))
        shapes.append(text(26, y + 23, f"{{found{i}}}", "start", tint="mute", style="t0"))
    return stage(*shapes, label="The goals, met or not", grow=0, basis=286, phone=12, height=150, style="still")


def _limits() -> tuple[Number, Number, Number]:
    return var("swing.top") - 6, on_y("swing", var("limit1")), on_y("stroke", var("limit2"))


def _bracket() -> list[Shape]:
    """Where no resonance should be: around the machine's speed."""
    y = _limits()[0]
    low, high = on_x("swing", var("away_low")), on_x("swing", var("away_high"))
    return [line(low, y, high, y), *(line(x, y - 5, x, y + 5) for x in (low, high))]


def _readings() -> list[Shape]:
    """Dots and numbers at the machine's speed: hollow alone, filled with the absorber."""
    here = on_x("swing", var("omega"))
    alone, swing = on_y("swing", var("alone")), on_y("swing", var("swing"))
    stroke = on_y("stroke", var("stroke"))
    over, bold = swing + var("swing_aside"), "t1 b halo"
    return [
        circle(here, alone, 6, tint="m1", style="hollow", show="alone_seen"),
        circle(here, swing, 7, tint="m1", show="swing_seen"),
        circle(here, stroke, 7, tint="m2", show="stroke_seen"),
        text(here - 11, alone + 5, f"{N.alone}", "end", tint="m1", style=bold, show="alone_seen"),
        text(here + 11, over, f"{N.swing}", "start", tint="m1", style=bold, show="swing_seen"),
        text(here + 11, stroke - 8, f"{N.stroke}", "start", tint="m2", style=bold, show="stroke_seen"),
    ]


def _fixed() -> list[Shape]:
    """The fixed points, by their names."""
    shapes = []
    for name in ("P", "Q"):
        x, y = on_x("swing", var(f"{name}_x")), on_y("swing", var(f"{name}_y"))
        shapes.append(circle(x, y, 4, show="fixed_seen"))
        shapes.append(text(x, y - 11, f"*{name}*", style="t1 b halo", show="fixed_seen"))
    return shapes


def _joints() -> list[Shape]:
    """The lines of the frequencies go on between the two plots."""
    shapes = []
    for at, tint, _ in frequencies():
        x = on_x("swing", var(at))
        shapes.append(line(x, var("swing.bottom"), x, var("stroke.top"), tint=tint, show=f"{at}_seen"))
    return shapes


def goal_texts(duty: Duty, axes: dict[str, Axis], lightest: float | None) -> dict[str, str]:
    """Goals, what is found in the particular solution, by which they are judged, and from the start; the score."""
    j, share = duty.nearest
    near = f"{('ω₋', 'ω₊')[j]} {(N.slow, N.fast)[j].text(duty, axes)} rad/s"
    texts = {
        "lightest": f"{_score(lightest)} kg" if lightest else "none yet",
        "goal0": f"Resonances {short(100 * AWAY)} % away",
        "found0": f"nearest is {_percent(share)} % away: {near}",
    }
    for i, what in enumerate(("Machine's", "Stroke in"), start=1):
        axis, way, within = axes[f"X{i}"], duty.swings[i - 1], bound(duty, i - 1)
        told = "" if within is None else f"; {duty.whence} within {length(axis, within)} {axis.full_unit}"
        found = f"xₚ: {length(axis, way)} {axis.full_unit}{told}"
        texts[f"goal{i}"] = f"{what} xₚ within {short(axis.place(duty.limits[i - 1]))} {axis.full_unit}"
        texts[f"found{i}"] = found if math.isfinite(way) else "no xₚ here: it grows without limit"
    return texts


def _score(mass: float) -> str:
    """A digit more than is usual, for those who go for the last one."""
    return f"{mass:.4g}" if 0.1 <= mass < 1e4 else three(mass)


def _percent(share: float) -> str:
    """A share in percent, never rounded up to the limit where it does not reach it."""
    if share >= 10:
        return short(100 * share)
    short_of_it = share < AWAY <= round(share, 3)
    return f"{math.floor(1000 * share) / 10 if short_of_it else 100 * share:.1f}"
