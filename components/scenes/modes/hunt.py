"""The view Hunt of the scene modes: find the initial displacements for which the path is a straight line."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from msgspec.structs import replace

from components import chain
from components.chain.grabs import mass_grab
from components.chain.parameters import Pair
from components.chain.signals import Axes
from components.chain.signals import Signals as S
from components.language.blocks import Block
from components.language.expressions import var
from components.language.plots import Handle
from components.language.state import Frame
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, plot
from components.layout.sheet import Paragraph, choice, column, either, row, stage, words
from components.layout.stage import H, PlotFrame, Shape, W, arrow, circle, line, text
from components.quantities.axes import Axis, nice_axis, time_axis
from components.quantities.declared import Declared, Family, Form, Scalar, by_name
from components.quantities.motion import pace, round_down
from components.quantities.parameters import one_of
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scene.traces import Traces
from components.scenes.modes.numbers import AnswerNumbers as N
from components.scenes.modes.numbers import ShareNumbers
from physics.coupled import FreeModes, TwoMassChain, free_modes
from physics.modes import Mixture, mixture
from physics.sampling import time_window
from physics.valid import DOUBLES

FOUND = 0.03
"""If the weaker mode has less than this share of the stronger mode's amplitude, the path looks like a line."""
SWINGS, PER_SWING, MOST = 40, 96, 1281
"""Limits of the path: cycles of the fast mode, points per cycle, and points in all."""

ANSWER = one_of("hidden", {"hidden": "Answer hidden", "shown": "Reveal"}, "The answer")


@dataclass(frozen=True, eq=False)
class HuntCase:
    """A chain that is released at rest, and a flag: the answer is shown."""

    system: TwoMassChain
    x_0: Pair
    revealed: bool

    @cached_property
    def shares(self) -> Mixture:
        """The amplitude of each mode."""
        return mixture(self.system, self.x_0)


class Hunt(Declared[HuntCase]):
    """The initial displacements in the plane, their parts in each mode, the verdict, and both directions if they are
    shown.
    """

    start = Family(chain.BOTH, lambda i: Scalar[HuntCase](lambda c, a: Axes.x(a).place(c.x_0[i - 1])))
    share_slow = Scalar[HuntCase](lambda c, a: c.shares[0])
    share_fast = Scalar[HuntCase](lambda c, a: c.shares[1])
    verdict = Form[HuntCase](lambda c: found(c.system, c.shares))
    answer = Form[HuntCase](lambda c: c.revealed)
    line = chain.lines_of("answer")


PLANE = PlotFrame("plane")
START = PLANE.x(var(Hunt.start[1])), PLANE.y(var(Hunt.start[2]))
WAYS = on_plot(PLANE, "x", "x1_0", Hunt.start[1], Axes.x), on_plot(PLANE, "y", "x2_0", Hunt.start[2], Axes.x)
START_GRAB = grab("Start of both masses", *WAYS, inside=PLANE)


def sheet() -> Block:
    return row(
        _plane(),
        column(
            stage(*_shapes(), label="The chain in motion, and how far each mode swings", grow=1, height=196),
            words(_verdict(), _answer(), style="verdict", phone=12),
            choice(ANSWER, phone=13),
            grow=352, gap=10,
        ),
    )  # fmt: skip


def _verdict() -> Paragraph:
    return either(
        Hunt.verdict,
        thin="**Nearly a line, but not one mode:** both modes are in it, so mass 1 and mass 2 do not keep step.",
        mixed="**Not yet:** both modes are in it, so mass 1 and mass 2 do not keep step.",
        slow="[slow|**✓ Found: a straight line, the slow mode.**] Both masses pass 0 together, in phase. "
        "There is another one.",
        fast="[fast|**✓ Found: a straight line, the fast mode.**] Both masses pass 0 together, opposite. "
        "There is another one.",
        rest="**Nothing moves:** it starts at rest, and no spring is stretched.",
        drift="**Every start gives a line here:** with a spring missing the slow mode is a drift, and from rest "
        "it does not move.",
    )


def _answer() -> Paragraph:
    return either(
        Hunt.answer,
        shown=rf"The directions of the modes: [slow|$X_2/X_1 = {N.answer_slow}$] and "
        rf"[fast|$X_2/X_1 = {N.answer_fast}$].",
    )


def _plane() -> Block:
    return plot(
        PLANE, x=Axes.x, y=Axes.x, x_column=S.x[1],
        title="Displacement of mass 2 against that of mass 1, from a start that can be dragged",
        curves=(
            curve(Hunt.line["slow", 2], x=Hunt.line["slow", 1], tint="slow", width="sum"),
            curve(Hunt.line["fast", 2], x=Hunt.line["fast", 1], tint="fast", width="dash"),
            curve(S.x[2], source="path", x=S.x[1], tint="ink", signal_x=S.x[1], signal=S.x[2]),
        ),
        room=Room(64, 10, top=10), square=True,
        handles=(
            Handle(parameter="x1_0", symbol="x₁", label="Start of mass 1", tint="m1", axis="x", covering="m"),
            Handle(parameter="x2_0", symbol="x₂", label="Start of mass 2", tint="m2", axis="y"),
        ),
        shapes=(circle(*START, 8, tint="ink", style="ring", grab=START_GRAB),),
        grow=536, phone=10, height=330,
    )  # fmt: skip


def _shapes() -> list[Shape]:
    foot = 0.5 * H
    shapes = [chain.standing_wall(0.17 * H, 0.33 * H), *chain.ground(foot)]
    for i in chain.BOTH:
        place = chain.place(i)
        shapes += [
            line(chain.rest(i), 0.14 * H, chain.rest(i), foot, tint="mute", style="eq"),
            arrow(chain.rest(i), 0.15 * H, place, 0.15 * H, tint=f"m{i}"),
            text(chain.rest(i), 0.1 * H, f"*x*_{i} = {S.x[i]} {chain.Places.x_unit}", tint=f"m{i}", style="t2 b"),
        ]
    grabs = mass_grab(1, flicked=False), mass_grab(2, flicked=False)
    shapes += chain.masses(foot, chain.place(1), chain.place(2), grabs=grabs)
    shares = (Hunt.share_slow, ShareNumbers.share_slow, 0.76), (Hunt.share_fast, ShareNumbers.share_fast, 0.94)
    for mode, (share, told, at) in zip(chain.MODES, shares, strict=True):
        y = at * H
        shapes += [
            text(0, y - 12, f"{mode} mode {told} of the swing", "start", tint=mode, style="t1 b"),
            line(0, y, W, y, tint="rule", style="thick faint revealing"),
            line(0, y, var(share) * W, y, tint=mode, style="thick", show=share),
        ]
    return shapes


def picture(system: TwoMassChain, x_0: Pair, revealed: bool, window: float | None, frame: Frame = FITTED) -> Picture:
    """Return everything that the view shows for one chain and one start. It contains the answer only if the answer is
    shown.
    """
    case, free = HuntCase(system, x_0, revealed), free_modes(system, x_0, (0.0, 0.0))
    slow, fast = system.modes().omega.tolist()
    own_window = window or time_window(slow, fast)
    end = frame.window or own_window
    bound = _bound(free)
    axes = framed(frame, by_name({Axes.t: time_axis(own_window), Axes.x: _size(bound)}))
    size = Axes.x(axes)
    extremes = {f"x{i}": (-bound[i - 1], bound[i - 1]) for i in (1, 2)} | {"e2": (-bound[2], bound[2])}
    drawn = chain.to_scale(system, extremes, size, frame.scale)
    return Picture(
        columns={"answer": chain.direction_lines(Hunt.line, system, 2 * size.end)} if revealed else {},
        axes=axes,
        signals=chain.free_signals(free, size, Axes.t(axes)) | chain.FreeSignals.signals(free, axes),
        traces={"path": _path(free, end, fast)},
        scalars=drawn.scalars | Hunt.scalars(case, axes),
        pace=pace(slow or fast, fast),
        scale=drawn.scale,
        fits=drawn.fits,
        values=drawn.values
        | ShareNumbers.texts(case.shares, axes)
        | (N.texts(system.modes(), axes) if revealed else {}),
        live=chain.FreeSignals.live(axes),
        forms=Hunt.forms(case),
        to_scale=drawn.to_scale,
    )


def _path(free: FreeModes, end: float, fast: float) -> Traces:
    shown = min(end, SWINGS * 2 * math.pi / fast) if fast else end
    count = int(min(max(PER_SWING * shown * fast / (2 * math.pi), 300), MOST))
    names = tuple(S.x[i].name for i in chain.BOTH)
    return Traces(shown, count, names, lambda t: dict(zip(names, free.motion(t).x, strict=True)))


def _bound(free: FreeModes) -> tuple[float, float, float]:
    """The bounds of x1, x2 and the elongation of spring 2."""
    reach = np.abs(free.amplitude).sum(axis=0) + np.abs(free.drift_a)
    one, two = (float(value) for value in reach)
    return one, two, one + two


def _size(bound: tuple[float, float, float]) -> Axis:
    """A frame that does not follow every move of the start. It grows in steps of 1, 2, 5."""
    reach = max(bound[:2])
    if not math.isfinite(reach):
        raise ValueError(f"the motion leaves {DOUBLES}")
    half = _round_up(1.05 * reach) if reach else 1.0
    return replace(nice_axis(-half, half, "m", 4, exact=True), drawn=(-reach, reach))


def _round_up(value: float) -> float:
    """Return the smallest of 1, 2, 4, 5 times a power of ten that is not below `value`."""
    below = round_down(value)
    return value if below == value else min(f * below for f in (2.0, 2.5) if f * below >= value * (1 - 1e-9))


def found(system: TwoMassChain, parts: Mixture) -> str:
    """Return True if the path is a line, judged by the amplitudes of the modes."""
    slow, fast, width = parts
    if not (slow or fast):
        return "rest"
    if not (system.k1 and system.k2):
        return "drift"
    if min(slow, fast) <= FOUND * max(slow, fast):
        return "slow" if fast < slow else "fast"
    return "thin" if width <= FOUND else "mixed"
