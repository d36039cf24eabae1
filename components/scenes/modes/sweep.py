"""The view Sweep of the scene modes: frequencies and shapes while one parameter varies over six decades."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from components.chain import BOTH, MODES
from components.language.blocks import Block
from components.language.plots import Curve, Handle
from components.language.state import Frame
from components.layout.plots import Room, curve, mark, plot
from components.layout.sheet import Paragraph, choice, column, either, phrase, row, term, words
from components.layout.stage import PlotFrame
from components.layout.text import rich
from components.quantities.axes import Axis, log_axis
from components.quantities.declared import Column, Declared, DrawnAxis, Family, Form, Scalar, Text, by_name
from components.quantities.parameters import one_of
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns
from components.scenes.modes.numbers import SweptNumbers as N
from physics.coupled import TwoMassChain
from physics.sweeps import PARAMETERS, limit, sweep
from physics.sweeps import Sweep as Run
from physics.valid import DOUBLES

DECADES = 6
UNITS = {"m": "kg", "k": "N/m"}
SYMBOLS = {"m1": "m₁", "m2": "m₂", "k1": "k₁", "k2": "k₂"}
SWEPT = one_of("k2", SYMBOLS, "Swept parameter")
PARTNER = {"m1": "m2", "m2": "m1", "k1": "k2", "k2": "k1"}
"""The other parameter of the same kind. A sweep is centred where both are equal."""

LIMITS = {
    "free": (
        "no wall, so the pair drifts as one block; the masses against each other",
        "0",
        "1",
        r"\sqrt{k_2 (1/m_1 + 1/m_2)}",
        "-m_1/m_2",
    ),
    "loose": (
        "no coupling, so each mass moves on its own",
        "0",
        r"\infty \text{: mass 2 alone}",
        r"\sqrt{k_1/m_1}",
        r"0 \text{: mass 1 alone}",
    ),
    "apart": ("two separate oscillators", r"\sqrt{k_2/m_2}", r"k_1/k_2", r"\sqrt{k_1/m_1}", r"-m_1 k_2/(m_2 k_1)"),
    "rigid": (
        "one block on the wall's spring; the masses against each other",
        r"\sqrt{k_1/(m_1 + m_2)}",
        "1",
        r"\sqrt{k_2 (1/m_1 + 1/m_2)}",
        "-m_1/m_2",
    ),
    "series": (
        "both springs in series under mass 2; mass 1 between them",
        r"\sqrt{k_1 k_2/((k_1 + k_2)\, m_2)}",
        "1 + k_1/k_2",
        r"\sqrt{(k_1 + k_2)/m_1}",
        r"-m_1 k_2/(m_2 (k_1 + k_2))",
    ),
    "stand": (
        "mass 1 alone on its spring; mass 2 hangs on it as on a wall",
        r"\sqrt{k_1/m_1}",
        "1",
        r"\sqrt{k_2/m_2}",
        "-m_1/m_2",
    ),
}
"""For each kind of limit: its words, the limits of omega_- and its X2/X1, then those of omega_+ and its X2/X1."""


@dataclass(frozen=True, eq=False)
class SweepCase:
    """A chain, the parameter that varies, and the limits at both ends."""

    system: TwoMassChain
    swept: str
    kinds: dict[str, str]

    @property
    def tied(self) -> bool:
        """Return True if spring 2 couples the masses somewhere in the sweep."""
        return bool(self.system.k2 or self.swept == "k2")


ENDS = {"low": "0", "high": "∞"}
"""Both ends of the sweep, and the limits of the parameter there."""
BothModes = Family[str, Column[Any]]


class Sweep(Declared[SweepCase]):
    """Frequencies and ratios against the parameter, the frequency of each mass while the other one is fixed, and the
    words of the limits.
    """

    p, f, q = DrawnAxis.some(3)
    held = Column[Any].each(BOTH, source="omega_sweep")
    omega, ratio = Column[Any].each(MODES, source=""), Column[Any].each(MODES, source="")
    cross = Scalar[Any]()
    limit = Family(ENDS, lambda end: Form[SweepCase](lambda c: c.kinds[end]), "{}")
    name = Family(ENDS, lambda end: Text[SweepCase](lambda c, a: f"{SYMBOLS[c.swept]} → {ENDS[end]}"), "{}_name")
    swept = Family(PARAMETERS, lambda one: Form[SweepCase](lambda c: c.swept == one))
    tied = Form[SweepCase](lambda c: "shown" if c.tied else "loose")


def sheet() -> Block:
    return row(
        column(
            choice(SWEPT, phone=6),
            _frequencies(),
            _ratios(),
            grow=600,
        ),
        words(
            "**Now**",
            rf"[slow|$\omega_- = {N.now_slow}$ rad/s, $X_2/X_1 = {N.now_ratio_slow}$]",
            rf"[fast|$\omega_+ = {N.now_fast}$ rad/s, $X_2/X_1 = {N.now_ratio_fast}$]",
            *_limits("low"),
            *_limits("high"),
            either(
                Sweep.tied,
                shown=r"**The thin lines** are the frequency of one mass with the other one fixed, "
                r"$\sqrt{(k_1 + k_2)/m_1}$ and $\sqrt{k_2/m_2}$. Where they cross, "
                "the modes avoid each other: one stays below both, the other above.",
                loose="**The thin lines** are the frequency of one mass with the other one fixed: without spring 2 "
                "they are the modes.",
            ),
            either(
                Sweep.tied,
                shown=r"With spring 2 the two shapes mirror each other: $|X_2/X_1|_- \cdot |X_2/X_1|_+ = m_1/m_2$.",
            ),
            grow=288,
            phone=20,
        ),
    )


def _limits(end: str) -> list[Paragraph]:
    """Describe the limit at one end in words and formulas."""

    def told(before: str, place: int, after: str) -> Paragraph:
        return either(Sweep.limit[end], **{kind: f"{before}{texts[place]}{after}" for kind, texts in LIMITS.items()})

    lines = [told(f"**{Sweep.name[end]}:** ", 0, "")]
    for mode, sign, at in (("slow", "-", 1), ("fast", "+", 3)):
        lines += [
            told(rf"[{mode}|$\omega_{sign} \to ", at, "$]"),
            told(rf"[{mode}|$X_2/X_1 \to ", at + 1, "$]"),
        ]
    return lines


def _curves(kind: str, of: BothModes, labels: tuple[str, str]) -> tuple[Curve, ...]:
    """Both modes, with dotted asymptotes at both ends; `kind` is omega or ratio."""
    pair = [(of[mode], mode) for mode in MODES]
    limits = [
        curve(one, source=f"{kind}_{end}", tint=mode, width="dash", group="limits")
        for end in ENDS
        for one, mode in pair
    ]
    run = [
        curve(one, source=f"{kind}_sweep", tint=mode, width="sum", label=label)
        for (one, mode), label in zip(pair, labels, strict=True)
    ]
    now = [curve(one, source=f"{kind}_now", tint=mode, width="none", marker="disc", group="now") for one, mode in pair]
    return (*limits, *run, *now)


def _frequencies() -> Block:
    held = tuple(curve(Sweep.held[i], tint=f"m{i}", width="thin", group="held") for i in BOTH)
    return plot(
        PlotFrame("frequencies"), x=Sweep.p, y=Sweep.f,
        title="Both natural frequencies against the swept parameter, with their asymptotes",
        x_column=Sweep.p,
        curves=held + _curves("omega", Sweep.omega, ("*ω*_{−}", "*ω*_{+}")),
        heading=(
            term("", "none", "ink", formula=r"\omega_\pm"),
            phrase("held", "line", "mute", formula="one mass fixed"),
            phrase("limits", "dash", "mute", formula="limits"),
        ),
        x_labels=False, room=Room(72, 60, top=30), handles=_handles(bare=True),
        marks=(mark(at=Sweep.cross, tint="mute", style="dashed", html=rich("these cross"), lift=26),),
        phone=10, height=230,
    )  # fmt: skip


def _ratios() -> Block:
    return plot(
        PlotFrame("ratios"), x=Sweep.p, y=Sweep.q,
        title="Both mode ratios, without their sign, against the swept parameter",
        x_column=Sweep.p,
        curves=_curves("ratio", Sweep.ratio, ("in phase", "opposite")),
        heading=(term("", "none", "ink", formula=r"|X_2/X_1|"),),
        room=Room(72, 60), handles=_handles(), phone=11, height=200,
    )  # fmt: skip


def _handles(bare: bool = False) -> tuple[Handle, ...]:
    return tuple(
        Handle(
            parameter=name, symbol=SYMBOLS[name], label=f"{SYMBOLS[name]}, swept", tint="ink", axis="x",
            form=Sweep.swept[name].name, bare=bare, covering=UNITS[name[0]],
        )
        for name in PARAMETERS
    )  # fmt: skip


def picture(system: TwoMassChain, swept: str, frame: Frame = FITTED) -> Picture:
    """Return all that the view shows for one chain. Raise ValueError if a frequency leaves the range of doubles."""
    values = np.geomspace(*_range(system, swept), 241)
    run = sweep(system, swept, values)
    if not np.all(np.isfinite(run.omega)):
        raise ValueError(f"a natural frequency in this sweep leaves {DOUBLES}")
    case = SweepCase(system, swept, {})
    if case.tied and not np.all(np.isfinite(run.ratio)):
        raise ValueError(f"a mode ratio X2/X1 in this sweep leaves {DOUBLES}")
    columns = _columns(run)
    for end, (name, part) in enumerate(zip(ENDS, (slice(None, 121), slice(120, None)), strict=True)):
        tends = limit(system, swept, end, values[part])
        case.kinds[name] = _kind(system, swept, tends.kind)
        columns |= _pair(name, values[part], tends.omega, tends.ratio)
    modes = system.modes()
    columns |= _pair("now", np.array([getattr(system, swept)]), modes.omega[:, None], modes.ratio[:, None])
    decades = log_axis(float(values[0]), float(values[-1]), UNITS[swept[0]], DECADES)
    ratios = _log_range(np.abs(run.ratio), "") if case.tied else log_axis(0.1, 10)
    axes = framed(frame, by_name({Sweep.p: decades, Sweep.f: _log_range(run.omega, "rad/s"), Sweep.q: ratios}))
    return Picture(
        columns=columns,
        axes=axes,
        scalars=_crossing(run, Sweep.p(axes)),
        values=N.texts(modes, axes) | Sweep.texts(case, axes),
        forms=Sweep.forms(case),
    )


def _kind(system: TwoMassChain, swept: str, kind: str) -> str:
    """The words of a limit. A spring that is missing in the whole sweep has its own words."""
    if swept != "k2" and not system.k2:
        return "loose"
    return "free" if swept != "k1" and not system.k1 else kind


def _range(system: TwoMassChain, swept: str) -> tuple[float, float]:
    """The range of the sweep: six decades around the other parameter of the same kind, or around the value itself, or
    around 1.
    """
    about = getattr(system, PARTNER[swept]) or getattr(system, swept) or 1.0
    middle = min(max(math.floor(math.log10(about)), -304), 304)
    return float(f"1e{middle - DECADES // 2}"), float(f"1e{middle + DECADES // 2}")


def _columns(run: Run) -> dict[str, Columns]:
    columns = _pair("sweep", run.values, run.omega, run.ratio)
    columns["omega_sweep"] |= by_name(dict(zip(Sweep.held.values(), run.held, strict=True)))
    return columns


def _pair(
    name: str, values: NDArray[np.float64], omega: NDArray[np.float64], ratio: NDArray[np.float64]
) -> dict[str, Columns]:
    """Columns of both frequencies, and of the moduli of both ratios. There are none where a ratio is infinite, because
    nothing is coupled.
    """

    def over(one: BothModes, rows: NDArray[np.float64]) -> Columns:
        return by_name({Sweep.p: values, one["slow"]: rows[0], one["fast"]: rows[1]})

    ratios = over(Sweep.ratio, np.abs(ratio)) if np.all(np.isfinite(ratio)) else {}
    return {f"omega_{name}": over(Sweep.omega, omega), f"ratio_{name}": ratios}


def _log_range(rows: NDArray[np.float64], unit: str) -> Axis:
    """A logarithmic axis that contains all positive numbers of the rows, at most twelve decades."""
    seen = rows[(rows > 0) & np.isfinite(rows)]
    if not len(seen):
        return log_axis(0.1, 10.0, unit)
    low, high = float(np.log10(seen.min())), float(np.log10(seen.max()))
    low, high = max(low, high - 12), high + 0.06 * (high - low) + 0.02
    axis = log_axis(10.0 ** max(low - 0.04 * (high - low) - 0.02, -307), 10.0 ** min(high, 307), unit, 4)
    return replace(axis, ticks=axis.ticks or (float(round(high)),))


def _crossing(run: Run, axis: Axis) -> dict[str, float]:
    """Return the parameter values at which both masses have the same frequency while the other one is fixed."""
    gap = np.log(run.held[0]) - np.log(run.held[1]) if np.all(run.held > 0) else np.ones(2)
    change = np.flatnonzero(np.sign(gap[:-1]) != np.sign(gap[1:]))
    if not len(change):
        return {}
    i = int(change[0])
    share = float(gap[i] / (gap[i] - gap[i + 1]))
    low, high = axis.place(float(run.values[i])), axis.place(float(run.values[i + 1]))
    return by_name({Sweep.cross: low + share * (high - low)})
