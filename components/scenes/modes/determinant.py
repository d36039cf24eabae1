"""The plot of the determinant D of A against omega squared, whose zeros are the modes, for the views Guess and
Determinant.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from typing import Any

import numpy as np
from msgspec.structs import replace

from components.chain import MODES
from components.language.blocks import Block
from components.language.expressions import Number, var
from components.language.plots import Handle, Mark
from components.language.state import Frame
from components.layout.plots import Room, curve, mark, plot
from components.layout.sheet import Paragraph, either, term
from components.layout.stage import PlotFrame, Shape, ShownBy, circle, line, text
from components.layout.text import rich
from components.quantities.axes import Axis, nice_axis, squared_axis
from components.quantities.declared import (
    Column,
    Declared,
    DrawnAxis,
    Family,
    Form,
    LiveNumber,
    Scalar,
    by_name,
)
from components.quantities.formatting import ten
from components.scene.frames import framed
from components.scene.traces import Columns
from components.scenes.modes.guess_case import AtFrequency, inside
from physics.coupled import TwoMassChain
from physics.modes import determinant_curve
from physics.precision.exact import precise


@dataclass(frozen=True, eq=False)
class Determinant(AtFrequency):
    """A trial frequency, and the axis of D in units of 10**exponent, because D leaves the range of doubles long before
    other values do.
    """

    det: Axis
    exponent: int

    def place(self, value: Decimal) -> float:
        """A value of D on its axis, limited to slightly outside the frame."""
        scaled = float(value.scaleb(-self.exponent))
        return self.det.place(scaled if abs(scaled) < 1e30 else 1e30)

    def has(self, value: Decimal) -> bool:
        """Return True if a value of D is inside the frame."""
        return inside(self.det, value.scaleb(-self.exponent))

    @cached_property
    def at_rest(self) -> Decimal:
        """D at omega = 0."""
        _, _, k1, k2 = self.system.exact_parameters
        with precise():
            return k1 * k2

    @property
    def held(self) -> Decimal:
        """D at the natural frequency of mass 2 while mass 1 is held fixed."""
        return -(Decimal(self.system.k2) ** 2)


tried, scalar = LiveNumber[AtFrequency], Scalar[Determinant]
number = LiveNumber[Determinant]


class Axes(Declared[AtFrequency]):
    w, D = DrawnAxis.some(2)


class TriedNumbers(Declared[AtFrequency]):
    square = tried(lambda g: Decimal(g.omega) ** 2)
    omega = omega_slow, omega_fast = tried.both(lambda g: g.system.modes().omega)


class TriedPlaces(Declared[AtFrequency]):
    """The modes and the trial frequency in the unit of the axis. Names that end with `_in` say whether a point is
    inside the frame.
    """

    w_of = Family(MODES, lambda mode: Scalar[AtFrequency](lambda g, a: g.frequency.place(g.modes[mode][0])), "w_{}")
    w_si = Family(MODES, lambda mode: Scalar[AtFrequency](lambda g, a: g.modes[mode][0]), "w_{}_si")
    w = Scalar[AtFrequency](lambda g, a: g.frequency.place(min(g.omega, 2 * g.frequency.end)))
    w_in = Scalar[AtFrequency](lambda g, a: g.w_in)


class Numbers(Declared[Determinant]):
    D = number(lambda g: g.asked.determinant, unit="N²/m²", meaning="determinant at the trial frequency")
    apart = number(lambda g: g.asked.apart)
    k1k2 = number(lambda g: g.at_rest)
    k2k2 = number(lambda g: g.held)


class Places(Declared[Determinant]):
    """D at omega = 0, where mass 2 is held fixed, and at the trial frequency."""

    D0 = scalar(lambda g, a: g.place(g.at_rest))
    D0_in = scalar(lambda g, a: g.system.k1 > 0 < g.system.k2)
    w_held = scalar(lambda g, a: g.frequency.place(math.sqrt(g.system.k2) / math.sqrt(g.system.m2)))
    D_held = scalar(lambda g, a: g.place(g.held))
    held_in = scalar(lambda g, a: g.system.k2 > 0 and g.has(g.held))
    D = scalar(lambda g, a: g.place(g.asked.determinant))
    D_in = scalar(lambda g, a: g.w_in and g.has(g.asked.determinant))


class Forms(Declared[Determinant]):
    D = Form[Determinant](lambda g: "value" if g.asked.apart is None else "product")
    det = Form[Determinant](lambda g: True)
    roots = Form[Determinant](lambda g: "loose" if not g.system.k2 else "two" if g.system.k1 else "wall")


class Curves(Declared[Determinant]):
    w, D = Column[Determinant]("det"), Column[Determinant]("det")


A, N, P, T = Axes, Numbers, Places, TriedPlaces
DET = PlotFrame("det")


def frequency_handle(**rest: Any) -> Handle:
    """The handle of the trial frequency."""
    return Handle(
        parameter="omega", symbol="ω²", label="Trial frequency, squared", tint="F", axis="x",
        text=TriedNumbers.square.name, covering="(rad/s)²", **rest,
    )  # fmt: skip


def flags(lift: float) -> tuple[Mark, ...]:
    """The natural frequencies; pressing one sets the trial frequency to it."""
    return tuple(
        mark(
            T.w_of[mode], tint=mode, set="omega", exactly=T.w_si[mode], lift=lift, label=f"Go to the {mode} mode",
            html=rich(rf"$\omega_{sign}$ {omega}"), flag="one",
        )
        for mode, sign, omega in zip(MODES, "-+", TriedNumbers.omega, strict=True)
    )  # fmt: skip


def determinant_plot() -> Block:
    return plot(
        DET, x=A.w, y=A.D, x_column=Curves.w,
        title="The determinant D of A against omega squared",
        curves=(curve(Curves.D, tint="ink", width="sum"),),
        heading=(term("", "none", "ink", formula="D"),),
        room=Room(60, 12, top=28), handles=(frequency_handle(),), marks=flags(4),
        shapes=_shapes(), form=Forms.det, grow=120, phone=11, height=160,
    )  # fmt: skip


def determinant_words() -> list[Paragraph]:
    return [
        either(
            Forms.D,
            product=rf"$D = k_2 (k_2 - m_2 \omega^2) \cdot ({N.apart})$$= {N.D}$",
            value=f"$D = {N.D}$",
        ),
        either(
            Forms.roots,
            two=r"$D = \text{det } A$ is + at 0, − at $k_2/m_2$, + far out: two zeros, whatever the chain.",
            wall=r"No wall: $D$ is 0 at 0, − at $k_2/m_2$, + far out: one zero is at 0.",
            loose=r"No coupling: $D = m_2 \omega^2 (m_1 \omega^2 - k_1)$, each equation holds one mass only.",
        ),
    ]


def _shapes() -> tuple[Shape, ...]:
    """Shapes over D: its value at the trial frequency, its zeros, and the two values that prove that there are two
    zeros.
    """
    here, rest, held = (DET, var(T.w), var(P.D)), (DET, 0.0, var(P.D0)), (DET, var(P.w_held), var(P.D_held))
    w = DET.x(var(T.w))
    return (
        line(w, DET.top, w, DET.bottom, tint="F", show=T.w_in),
        label(*here, "ink", (10, -9), f"*D* = {N.D}", show=P.D_in),
        point(*rest, 4, "ink", show=P.D0_in),
        label(*rest, "ink", (0, 0), f"*k*_1*k*_2 = {N.k1k2}", "beside", P.D0_in, "t0"),
        point(*held, 4, "ink", show=P.held_in),
        label(*held, "ink", (0, 0), f"−*k*_2² = {N.k2k2}", "beside", P.held_in, "t0"),
        *(point(DET, var(T.w_of[mode]), 0.0, 5, mode, style="ring") for mode in MODES),
        point(*here, 6, "ink", show=P.D_in),
    )


def point(frame: PlotFrame, x: Number, y: Number, radius: float, tint: str, **look: Any) -> Shape:
    return circle(frame.x(x), frame.y(y), radius, tint=tint, **look)


def label(
    frame: PlotFrame, x: Number, y: Number, tint: str, shift: tuple[int, int], words_: str, anchor: str = "start",
    show: ShownBy | None = None, weight: str = "t1 b",
) -> Shape:  # fmt: skip
    place = frame.x(x) + shift[0], frame.y(y) + shift[1]
    return text(*place, words_, anchor, tint=tint, style=f"{weight} halo", show=show)


@dataclass(frozen=True, eq=False)
class DeterminantPart:
    """Return the part of a picture that shows D for a trial frequency in a frame."""

    axes: dict[str, Axis]
    columns: dict[str, Columns]
    case: Determinant

    @classmethod
    def of(cls, system: TwoMassChain, omega: float, frame: Frame) -> DeterminantPart:
        axes = framed(frame, by_name({A.w: _frequencies(float(system.modes().omega[1]), omega)}))
        columns, det, exponent = _curve(system, A.w(axes).end)
        axes |= framed(frame, by_name({A.D: det}))
        return cls(axes, columns, Determinant(system, omega, A.w(axes), A.D(axes), exponent))

    @property
    def scalars(self) -> dict[str, float]:
        return TriedPlaces.scalars(self.case, self.axes) | Places.scalars(self.case, self.axes)

    @property
    def texts(self) -> dict[str, str]:
        return TriedNumbers.texts(self.case, self.axes) | Numbers.texts(self.case, self.axes)

    @property
    def forms(self) -> dict[str, str]:
        return Forms.forms(self.case)


def _frequencies(fast: float, omega: float) -> Axis:
    """Return a range that contains both modes, and the trial frequency unless it is far away."""
    both = math.sqrt(1.375) * fast
    end = (max(both, 1.1 * omega) if omega < 2 * fast or not fast else both) or 1.0
    return replace(squared_axis(end, "(rad/s)²", 3), drawn=(0.0, max(fast, min(omega, end))))


def _curve(system: TwoMassChain, end: float) -> tuple[dict[str, Columns], Axis, int]:
    w = end * np.sqrt(np.linspace(0.0, 1.0, 201))
    curve, exponent = determinant_curve(system, w)
    low, at_zero = float(np.min(curve)), float(curve[0])
    unit = f"{ten(exponent)} N²/m²" if exponent else "N²/m²"
    size = max(1.2 * at_zero, -2.1 * low, 0.0) or 1.0
    det = nice_axis(min(1.33 * low, -0.1 * size), size, unit, 2, exact=True)
    return {"det": by_name({Curves.w: w, Curves.D: curve})}, replace(det, drawn=(low, at_zero)), exponent
