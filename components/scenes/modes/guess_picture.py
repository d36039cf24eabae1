"""The numbers of the view Guess: curves, forces, and what the matrix says at the trial frequency."""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property

import numpy as np
from msgspec.structs import replace

from components.chain import BOTH, MODES
from components.chain.parameters import Pair
from components.language.signals import AnySignal
from components.language.state import Frame
from components.quantities import declared
from components.quantities.axes import Axis, nice_axis, squared_axis, time_axis
from components.quantities.declared import (
    Column,
    Declared,
    DrawnAxis,
    Family,
    Form,
    LiveNumber,
    Scalar,
    Signal,
    by_name,
)
from components.quantities.motion import QUARTER, pace, sines
from components.quantities.numbers import signed, ten, three
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns
from physics.coupled import Modes, TwoMassChain
from physics.exact import exact, precise, within_an_ulp
from physics.modes import Trial, TrialForces, determinant_curve, row_curves, trial, trial_forces
from physics.sampling import NOTHING_OSCILLATES, periods
from physics.valid import DOUBLES

REACH = 0.17
"""The longest force arrow, as a fraction of the stage's width."""
NEAR, ALIKE = 1e-3, Decimal("0.01")
"""Limits: of a frequency near a natural one, and of the gap of rows, over the larger, that are nearly one equation."""
ROUNDING = Decimal("1e-12")
"""A typed ratio is rounded, so at a mode a force of this size, compared with the others, is left: it is shown as 0."""
LITTLE = Decimal("0.005")
"""The share of the other forces below which a hand's is little."""


@dataclass(frozen=True, eq=False)
class Guess:
    """A chain, a trial frequency and shape, and the axes that they are drawn on, with what the physics says of them.

    `det` counts D in units of 10**exponent, since D leaves the range of doubles long before the rest does.
    """

    system: TwoMassChain
    omega: float
    ratio: float
    frequency: Axis
    shape: Axis
    det: Axis
    exponent: int

    def place_D(self, value: Decimal) -> float:
        """A value of D on its axis, cut far outside the frame."""
        scaled = float(value.scaleb(-self.exponent))
        return self.det.place(scaled if abs(scaled) < 1e30 else 1e30)

    @cached_property
    def asked(self) -> Trial:
        return said(self.system, self.omega)

    @cached_property
    def push(self) -> TrialForces:
        return trial_forces(self.system, self.omega, self.ratio)

    @cached_property
    def at_rest(self) -> Decimal:
        """D at omega = 0."""
        _, _, k1, k2 = self.system.exact_parameters
        with precise():
            return k1 * k2

    @property
    def held(self) -> Decimal:
        """D where mass 2 alone, mass 1 held, would swing."""
        return -(Decimal(self.system.k2) ** 2)

    def has_D(self, value: Decimal) -> bool:
        """Whether a value of D is inside the frame."""
        return inside(self.det, value.scaleb(-self.exponent))

    @cached_property
    def modes(self) -> dict[str, tuple[float, float]]:
        """Frequency and shape of each mode."""
        modes = self.system.modes()
        return dict(zip(MODES, zip(modes.omega.tolist(), modes.ratio.tolist(), strict=True), strict=True))

    def seen(self, mode: str) -> bool:
        """Whether the point of a mode is inside the frame."""
        return math.isfinite(self.modes[mode][1]) and inside(self.shape, self.modes[mode][1])

    @cached_property
    def swings(self) -> Pair:
        """Both amplitudes."""
        one, two = map(float, self.push.amplitude)
        return one, two

    def arrow(self, force: Decimal) -> float:
        """The length of the arrow of a force at full swing, as a fraction of the stage's width."""
        largest = max(abs(value) for pair in self.push[1:] for value in pair)
        return REACH * float(force / largest) if largest else 0.0

    @cached_property
    def w_in(self) -> bool:
        return inside(self.frequency, self.omega)

    def reading(self, row: int) -> float:
        """The place of the shape that a row asks for."""
        asked, shape = self.asked.rows[row - 1], self.shape
        return 0.0 if asked is None else shape.place(float(max(min(asked, Decimal(shape.end)), Decimal(shape.start))))

    def reads(self, row: int) -> bool:
        asked = self.asked.rows[row - 1]
        return self.w_in and asked is not None and inside(self.shape, asked)

    @property
    def sizes(self) -> list[Decimal]:
        """The larger of the force that is needed and that of the springs, on each mass."""
        return [max(abs(one), abs(two)) for one, two in zip(self.push.needed, self.push.springs, strict=True)]

    @cached_property
    def left(self) -> list[Decimal]:
        """The force missing on each mass; nothing at a mode, whose frequency and shape few doubles are."""
        for mode in self.system.exact_modes:
            if not mode.shape[0]:
                continue
            with precise():
                ratio = mode.shape[1] / mode.shape[0]
            alike = abs(ratio - exact(self.ratio)) <= ROUNDING * abs(ratio)
            if alike and within_an_ulp(self.omega, mode.omega):
                return [Decimal(0)] * 2
        sizes = zip(self.push.missing, self.sizes, strict=True)
        return [value if abs(value) > ROUNDING * size else Decimal(0) for value, size in sizes]


def added(guess: Guess) -> str:
    """The force of the hand, in words."""
    if not any(guess.left):
        return "no extra force: a mode"
    little = all(abs(value) <= LITTLE * size for value, size in zip(guess.left, guess.sizes, strict=True))
    return "almost no extra force" if little else "force of your hand"


number, scalar, form = LiveNumber[Guess], Scalar[Guess], Form[Guess]
METRES = Axis(-1.0, 1.0, "m")


class GuessNumbers(Declared[Guess]):
    a11, a12 = number.both(lambda g: g.asked.matrix[0])
    a22 = number(lambda g: g.asked.matrix[1][1])
    D = number(lambda g: g.asked.determinant)
    square = number(lambda g: Decimal(g.omega) ** 2)
    apart = number(lambda g: g.asked.apart)
    distance = number(lambda g: None if g.asked.apart is None else abs(g.asked.apart))
    k1k2 = number(lambda g: g.at_rest)
    k2k2 = number(lambda g: g.held)
    row = row1, row2 = number.both(lambda g: g.asked.rows, signed)
    omega = omega_slow, omega_fast = number.both(lambda g: g.system.modes().omega)
    r = r_slow, r_fast = number.both(lambda g: g.system.modes().ratio, signed)
    slow_long, fast_long = number.both(
        lambda g: [f"{w:.5g}" if 0.1 <= w < 1e4 else three(w) for w in g.system.modes().omega]
    )
    X = X1, X2 = number.both(lambda g: g.push.amplitude, signed)
    need = need1_N, need2_N = number.both(lambda g: g.push.needed, signed, unit="N", whole=True)
    give = give1_N, give2_N = number.both(lambda g: g.push.springs, signed, unit="N", whole=True)
    add = add1_N, add2_N = number.both(lambda g: g.left, signed, unit="N", whole=True)
    you_add = number(added)


class GuessAxes(Declared[Guess]):
    t, w, r, D = DrawnAxis.some(4)


class GuessCurves(Declared[Guess]):
    """The shape that each equation fixes, the second one on both sides of its pole, and D."""

    w = Column[Guess]("")
    row1, D = Column[Guess]("row1"), Column[Guess]("det")
    row2_below, row2_above = Column[Guess]("row2_below"), Column[Guess]("row2_above")


def _swung(guess: Guess, axes: declared.Axes, size: float) -> AnySignal:
    """A motion of the guess, from full swing; at omega = 0 it stays there."""
    return sines(METRES, GuessAxes.t(axes), (size, guess.omega, QUARTER))


class GuessPlaces(Declared[Guess]):
    """Swings and forces, and over the plots the modes, the known values of D, the guess, and the readings of both
    equations, in the units of the axes; `_in` tells which are inside the frame."""

    swing = Signal[Guess](lambda g, a: _swung(g, a, 1.0))
    x = Family(BOTH, lambda i: Signal[Guess](lambda g, a: _swung(g, a, g.swings[i - 1])))
    # At full swing: both amplitudes, which of them is not the larger one, and the lengths of the arrows.
    X = Family(BOTH, lambda i: scalar(lambda g, a: g.swings[i - 1]))
    less = Family(BOTH, lambda i: scalar(lambda g, a: abs(g.swings[i - 1]) <= abs(g.swings[2 - i])))
    need = Family(BOTH, lambda i: scalar(lambda g, a: g.arrow(g.push.needed[i - 1])), "need{}_N")
    give = Family(BOTH, lambda i: scalar(lambda g, a: g.arrow(g.push.springs[i - 1])), "give{}_N")
    # The modes, D at rest and where mass 2 would be held.
    w_of = Family(MODES, lambda mode: scalar(lambda g, a: g.frequency.place(g.modes[mode][0])), "w_{}")
    w_si = Family(MODES, lambda mode: scalar(lambda g, a: g.modes[mode][0]), "w_{}_si")
    r_of = Family(MODES, lambda mode: scalar(lambda g, a: g.seen(mode) and g.shape.place(g.modes[mode][1])), "r_{}")
    seen = Family(MODES, lambda mode: scalar(lambda g, a: g.seen(mode)), "{}_in")
    D0 = scalar(lambda g, a: g.place_D(g.at_rest))
    D0_in = scalar(lambda g, a: g.system.k1 > 0 < g.system.k2)
    w_held = scalar(lambda g, a: g.frequency.place(math.sqrt(g.system.k2) / math.sqrt(g.system.m2)))
    D_held = scalar(lambda g, a: g.place_D(g.held))
    held_in = scalar(lambda g, a: g.system.k2 > 0 and g.has_D(g.held))
    # The guess, D there, and what both equations ask for.
    w = scalar(lambda g, a: g.frequency.place(min(g.omega, 2 * g.frequency.end)))
    w_in = scalar(lambda g, a: g.w_in)
    r = scalar(lambda g, a: g.shape.place(max(min(g.ratio, 2 * g.shape.end), 2 * g.shape.start)))
    guess_in = scalar(lambda g, a: g.w_in and inside(g.shape, g.ratio))
    D = scalar(lambda g, a: g.place_D(g.asked.determinant))
    D_in = scalar(lambda g, a: g.w_in and g.has_D(g.asked.determinant))
    row = Family(BOTH, lambda i: scalar(lambda g, a: g.reading(i)))
    row_in = Family(BOTH, lambda i: scalar(lambda g, a: g.reads(i)), "row{}_in")
    gap = scalar(lambda g, a: g.w_in and None not in g.asked.rows)


class GuessForms(Declared[Guess]):
    says = Family(BOTH, lambda i: form(lambda g: _kind(g.asked.rows[i - 1])), "row{}_says")
    agree = form(lambda g: agreement(g))
    D = form(lambda g: "value" if g.asked.apart is None else "product")
    roots = form(lambda g: "loose" if not g.system.k2 else "two" if g.system.k1 else "wall")


def _kind(asked: Decimal | None) -> str:
    """The form of the sentence on the shape that an equation asks for."""
    return "any" if asked is None else "number" if asked.is_finite() else "pole"


def inside(axis: Axis, value: float | Decimal) -> bool:
    """Whether a value is within the range of an axis."""
    return axis.start <= value <= axis.end


def picture(system: TwoMassChain, omega: float, ratio: float, window: float | None, frame: Frame = FITTED) -> Picture:
    """All of the view for one chain and one guess; ValueError where a curve leaves the range of doubles."""
    modes = system.modes()
    if system.k2 and not np.all(np.isfinite(modes.ratio)):
        raise ValueError(f"a mode ratio X2/X1 leaves {DOUBLES}")
    end = _end(float(modes.omega[1]), omega)
    reach, shape = _shape_axis(modes)
    across = replace(squared_axis(end, "(rad/s)²", 3), drawn=(0.0, max(float(modes.omega[1]), min(omega, end))))
    A, time = GuessAxes, time_axis(window or (periods(omega, 4) if omega else NOTHING_OSCILLATES))
    axes = framed(frame, by_name({A.w: across, A.r: shape, A.t: time}))
    columns, det, exponent = _columns(system, A.w(axes).end, reach)
    axes |= framed(frame, by_name({A.D: det}))
    guess = Guess(system, omega, ratio, frequency=A.w(axes), shape=A.r(axes), det=A.D(axes), exponent=exponent)
    return Picture(
        columns=columns,
        axes=axes,
        signals=GuessPlaces.signals(guess, axes),
        scalars=GuessPlaces.scalars(guess, axes),
        pace=pace(omega, omega),
        values=GuessNumbers.texts(guess, axes),
        forms=GuessForms.forms(guess),
    )


def _shape_axis(modes: Modes) -> tuple[float, Axis]:
    """The reach of the curves of X2/X1, and their axis, which holds both modes."""
    half = 2 * max((abs(float(r)) for r in modes.ratio if r and math.isfinite(r)), default=2.0)
    reach = 3 * half
    if math.isinf(reach):
        raise ValueError(f"three times the larger mode ratio X2/X1, as far as it is drawn, leaves {DOUBLES}")
    axis = nice_axis(-half, half, "", 4, exact=True)
    return reach, replace(axis, ticks=axis.ticks[1:-1], drawn=(-half / 2, half / 2))


def said(system: TwoMassChain, omega: float) -> Trial:
    """The two equations at `omega`; next to a zero, where hardly a double is nearer, at the zero itself."""
    asked, none = trial(system, omega), Decimal(0)
    for mode in system.exact_modes:
        if not within_an_ulp(omega, mode.omega):
            continue
        if not system.k2:
            if mode.shape[0]:  # mass 1 alone: row 1 is 0 = 0
                asked = asked._replace(matrix=((none, none), asked.matrix[1]), rows=(None, asked.rows[1]))
            return asked._replace(determinant=none)
        with precise():
            rows = (mode.shape[1] / mode.shape[0],) * 2
        return asked._replace(determinant=none, rows=rows, apart=none)
    m1, m2, k1, k2 = system.exact_parameters
    with precise():
        alone = ((k1 + k2) / m1).sqrt(), (k2 / m2).sqrt()
    (a11, a12), (_, a22), (one, two) = *asked.matrix, asked.rows
    if k2 and within_an_ulp(omega, alone[0]):
        a11, one = none, none
    if k2 and within_an_ulp(omega, alone[1]):
        a22, two = none, Decimal("inf")
    return asked._replace(matrix=((a11, a12), (a12, a22)), rows=(one, two), apart=asked.apart if a22 else None)


def _end(fast: float, omega: float) -> float:
    """The frame holds both modes, and the trial frequency where it is not far beyond them."""
    both = math.sqrt(1.375) * fast
    return (max(both, 1.1 * omega) if omega < 2 * fast or not fast else both) or 1.0


def _columns(system: TwoMassChain, end: float, largest: float) -> tuple[dict[str, Columns], Axis, int]:
    C, (first, second) = GuessCurves, row_curves(system, end, largest)
    columns = {C.row1.source: by_name({C.w: first.omega[0], C.row1: first.ratio[0]})}
    for one, w, r in zip((C.row2_below, C.row2_above), second.omega, second.ratio, strict=False):
        columns[one.source] = by_name({C.w: w, one: r})
    w = end * np.sqrt(np.linspace(0.0, 1.0, 201))
    curve, exponent = determinant_curve(system, w)
    columns[C.D.source] = by_name({C.w: w, C.D: curve})
    low, at_zero = float(np.min(curve)), float(curve[0])
    unit = f"{ten(exponent)} N²/m²" if exponent else "N²/m²"
    size = max(1.2 * at_zero, -2.1 * low, 0.0) or 1.0
    det = nice_axis(min(1.33 * low, -0.1 * size), size, unit, 2, exact=True)
    return columns, replace(det, drawn=(low, at_zero)), exponent


def agreement(guess: Guess) -> str:
    """Which sentence on both rows holds: how far apart they are, that they are one equation, or what obeys both."""
    one, two = guess.asked.rows
    if not guess.system.k2:
        free = {(True, True): "every", (True, False): "alone_1", (False, True): "alone_2"}
        return free.get((one is None, two is None), "pole")
    for mode, exactly in zip(MODES, guess.system.exact_modes, strict=True):
        if within_an_ulp(guess.omega, exactly.omega):
            return f"same_{mode}"
    if guess.asked.apart is None or one is None or two is None:
        return "pole"
    for mode, w in zip(MODES, guess.system.modes().omega, strict=True):
        if abs(guess.omega - w) <= NEAR * w and abs(guess.asked.apart) <= ALIKE * max(abs(one), abs(two)):
            return f"near_{mode}"
    return "apart"
