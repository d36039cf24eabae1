"""A trial frequency and a guessed shape: what both equations require there, the missing forces, and where they are
drawn.
"""

from __future__ import annotations

import math
from abc import ABC
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property

from components.chain import MODES
from components.chain.parameters import Pair
from components.quantities.axes import Axis
from physics.coupled import TwoMassChain
from physics.modes import Trial, TrialForces, trial, trial_forces
from physics.precision.exact import exact, precise, within_an_ulp

REACH = 0.17
"""The longest force arrow, as a fraction of the stage's width."""
NEAR, ALIKE = 1e-3, Decimal("0.01")
"""Limits for a frequency near a natural one, and for the relative gap of two rows that are nearly one equation."""
ROUNDING = Decimal("1e-12")
"""A typed ratio is rounded, so at a mode a force of this relative size is left. It is shown as 0."""
LITTLE = Decimal("0.005")
"""The share of the other forces below which the missing force counts as small."""


@dataclass(frozen=True, eq=False)
class AtFrequency(ABC):
    """A chain, a trial frequency in rad/s, and the axis of the frequencies, with the physical quantities at that
    frequency.
    """

    system: TwoMassChain
    omega: float
    frequency: Axis

    @cached_property
    def asked(self) -> Trial:
        return said(self.system, self.omega)

    @cached_property
    def modes(self) -> dict[str, tuple[float, float]]:
        """Frequency and shape of each mode."""
        modes = self.system.modes()
        return dict(zip(MODES, zip(modes.omega.tolist(), modes.ratio.tolist(), strict=True), strict=True))

    @cached_property
    def w_in(self) -> bool:
        return inside(self.frequency, self.omega)


@dataclass(frozen=True, eq=False)
class Guess(AtFrequency):
    """A trial frequency and shape, and the axis of the shapes."""

    ratio: float
    shape: Axis

    @cached_property
    def push(self) -> TrialForces:
        return trial_forces(self.system, self.omega, self.ratio)

    def seen(self, mode: str) -> bool:
        """Return True if the point of a mode is inside the frame."""
        return math.isfinite(self.modes[mode][1]) and inside(self.shape, self.modes[mode][1])

    @cached_property
    def swings(self) -> Pair:
        """Both amplitudes of the guess."""
        one, two = map(float, self.push.amplitude)
        return one, two

    def arrow(self, force: Decimal) -> float:
        """The length of the arrow of a force at the largest displacement, as a fraction of the stage's width."""
        largest = max(abs(value) for pair in self.push[1:] for value in pair)
        return REACH * float(force / largest) if largest else 0.0

    def reading(self, row: int) -> float:
        """The position of the shape that a row requires."""
        asked, shape = self.asked.rows[row - 1], self.shape
        return 0.0 if asked is None else shape.place(float(max(min(asked, Decimal(shape.end)), Decimal(shape.start))))

    def reads(self, row: int) -> bool:
        asked = self.asked.rows[row - 1]
        return self.w_in and asked is not None and inside(self.shape, asked)

    @property
    def sizes(self) -> list[Decimal]:
        """The larger of the needed force and the springs' force, on each mass."""
        return [max(abs(one), abs(two)) for one, two in zip(self.push.needed, self.push.springs, strict=True)]

    @cached_property
    def left(self) -> list[Decimal]:
        """The missing force on each mass. It is 0 at a mode, whose frequency and shape are rarely exact doubles."""
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
    """The missing force, in words."""
    if not any(guess.left):
        return "no extra force: a mode"
    little = all(abs(value) <= LITTLE * size for value, size in zip(guess.left, guess.sizes, strict=True))
    return "almost no extra force" if little else "force of your hand"


def said(system: TwoMassChain, omega: float) -> Trial:
    """Return the two equations at `omega`. If `omega` is the double nearest to a zero, they are evaluated at the zero
    itself.
    """
    asked, none = trial(system, omega), Decimal(0)
    for mode in system.exact_modes:
        if not within_an_ulp(omega, mode.omega):
            continue
        if not system.k2:
            if mode.shape[0]:  # mass 1 moves alone, so row 1 is 0 = 0
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


def agreement(guess: Guess) -> str:
    """The form of the sentence about both rows: how far apart they are, that they are one equation, or which shapes
    satisfy both.
    """
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


def kind_of(asked: Decimal | None) -> str:
    """The form of the sentence about the shape that one equation requires."""
    return "any" if asked is None else "number" if asked.is_finite() else "pole"


def inside(axis: Axis, value: float | Decimal) -> bool:
    """Return True if a value is within the range of an axis."""
    return axis.start <= value <= axis.end
