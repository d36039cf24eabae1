"""The live numbers of the modes, by what they are numbers of; those of a guess stand with it."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property

from components.chain.modes import MODES, PARTS, directions
from components.chain.parameters import Pair
from components.quantities.declared import Declared, LiveNumber
from components.quantities.numbers import plus, signed, three
from components.scenes.modes.guess import Numbers as GuessNumbers
from physics.braked_modes import BrakedMode, braked_modes, in_line
from physics.coupled import Modes, TwoMassChain
from physics.laplace import Driven, transform
from physics.modes import Mixture, Quadratic


@dataclass(frozen=True)
class BrakedChain:
    """A chain with its dashpots."""

    system: TwoMassChain
    damping: Pair

    @cached_property
    def modes(self) -> tuple[BrakedMode, BrakedMode]:
        return braked_modes(self.system, *self.damping)

    @cached_property
    def brakes(self) -> bool:
        return any(self.damping)

    @cached_property
    def amplitudes(self) -> dict[tuple[int, str], complex]:
        """The complex amplitude of each mass in each mode, the larger one of a mode of size 1."""
        shapes = [one.shape for one in self.modes] if self.brakes else directions(self.system)
        return {(i, mode): complex(shapes[MODES.index(mode)][i - 1]) for i, mode in PARTS}

    @cached_property
    def exponents(self) -> dict[str, complex]:
        """The first exponent of each mode."""
        if self.brakes:
            return {mode: one.exponents[0] for mode, one in zip(MODES, self.modes, strict=True)}
        return {mode: omega * 1j for mode, omega in zip(MODES, self.system.modes().omega.tolist(), strict=True)}

    def plainly(self, coupled: str, loose: str) -> str:
        """The variant of what stands without dashpots alone, with spring 2 or without it."""
        return "" if self.brakes else coupled if self.system.k2 else loose

    def root(self, mode: str) -> str:
        """The form of the roots of a mode."""
        return "" if not self.brakes else "pair" if self.modes[MODES.index(mode)].swings else "real"

    @property
    def arrows(self) -> str:
        """The form of the sentence on how the arrows stand to each other."""
        if not all(one.swings for one in self.modes):
            return "creeps"
        return "line" if in_line(self.system, *self.damping) else "apart"

    @cached_property
    def powers(self) -> list[float]:
        """The coefficients of D in powers of s, the constant first."""
        c1, c2 = self.damping
        P = transform(Driven(self.system, c2, 0.0, 0.0, (1.0, 0.0), (0.0, 1.0), c1)).P
        return [0.0] * (5 - len(P)) + [float(a) for a in P]


number = LiveNumber[Modes]
solved = LiveNumber[TwoMassChain]
term = LiveNumber[Quadratic]
braked = LiveNumber[BrakedChain]


class SweptNumbers(Declared[Modes]):
    now_slow, now_fast = number.both(lambda m: m.omega)
    now_ratio_slow, now_ratio_fast = number.both(lambda m: m.ratio, signed)


class AnswerNumbers(Declared[Modes]):
    answer_slow, answer_fast = number.both(lambda m: m.ratio, signed)


class EquationNumbers(Declared[Quadratic]):
    """The terms of the quadratic for omega^2, and of its discriminant as a sum of squares."""

    m1m2 = term(lambda q: q.leading)
    b = term(lambda q: q.b)
    k1k2_ = term(lambda q: q.constant)
    Delta = term(lambda q: q.Delta)
    difference = term(lambda q: q.difference)
    coupling = term(lambda q: q.coupling)
    root = term(lambda q: q.root)
    gap = term(lambda q: q.fourfold / (q.b + q.root) if q.b else 0.0)
    fourfold = term(lambda q: q.fourfold)


class SolvedNumbers(Declared[TwoMassChain]):
    gamma = solved(lambda c: c.modes().gamma)
    delta = solved(lambda c: c.modes().delta)
    product = solved(lambda c: -Decimal(c.m1) / Decimal(c.m2))
    omega = slow_omega, fast_omega = solved.both(lambda c: c.modes().omega)
    slow_square, fast_square = solved.both(lambda c: [mode.omega**2 for mode in c.exact_modes])
    ratio = slow_ratio, fast_ratio = solved.both(lambda c: c.modes().ratio, signed)


class ShareNumbers(Declared[Mixture]):
    share_slow, share_fast = LiveNumber[Mixture].both(lambda m: [f"{three(100 * part)} %" for part in m])


def off_line(one: BrakedMode) -> float:
    """The angle in degrees by which the arrows of a mode are out of line."""
    X1, X2 = one.shape
    if not X1 or not X2:
        return 0.0
    ratio = X2 / X1
    return math.degrees(math.atan2(abs(ratio.imag), abs(ratio.real)))


def shape(one: BrakedMode) -> str:
    """X2/X1 with its sign, or with its angle where the arrows are out of line."""
    X1, X2 = one.shape
    ratio = X2 / X1 if X1 else complex(math.inf)
    return f"{three(abs(ratio))} at {three(math.degrees(cmath.phase(ratio)))}°" if off_line(one) else signed(ratio.real)


class BrakedNumbers(Declared[BrakedChain]):
    slow_omega = braked(lambda c: c.modes[0].exponents[0].imag, "ω_{−}", "rad/s", "slow")
    slow_rate = braked(lambda c: c.modes[0].exponents[0].real, "Re s_{−}", "1/s", "slow")
    fast_omega = braked(lambda c: c.modes[1].exponents[0].imag, "ω_{+}", "rad/s", "fast")
    fast_rate = braked(lambda c: c.modes[1].exponents[0].real, "Re s_{+}", "1/s", "fast")
    rate = slow_rate, fast_rate
    turn = slow_turn, fast_turn = braked.both(lambda c: [one.exponents[0].imag for one in c.modes])
    other = slow_other, fast_other = braked.both(lambda c: [one.exponents[-1].real for one in c.modes])
    slow_ratio, fast_ratio = braked.both(lambda c: [shape(one) for one in c.modes])
    slow_angle, fast_angle = braked.both(lambda c: [off_line(one) for one in c.modes])
    cross = braked(lambda c: Decimal(c.damping[0]) * Decimal(c.system.k2))
    other_cross = braked(lambda c: Decimal(c.damping[1]) * Decimal(c.system.k1))
    p4 = braked(lambda c: c.powers[4])
    p3, p2 = braked.both(lambda c: c.powers[3:1:-1], plus)
    p1, p0 = braked.both(lambda c: c.powers[1::-1], plus)


class ComparedNumbers(Declared[Modes]):
    """The frequencies and the shapes, with all numbers by which a view tells them."""

    omega_slow = number(
        lambda m: m.omega[0], "ω_{−}", "rad/s", "slow",
        also=(SolvedNumbers.slow_omega, GuessNumbers.slow_long, SweptNumbers.now_slow),
    )  # fmt: skip
    ratio_slow = number(
        lambda m: m.ratio[0], "X₂/X₁_{−}", "", "slow",
        also=(SolvedNumbers.slow_ratio, GuessNumbers.r_slow, SweptNumbers.now_ratio_slow, AnswerNumbers.answer_slow),
    )  # fmt: skip
    omega_fast = number(
        lambda m: m.omega[1], "ω_{+}", "rad/s", "fast",
        also=(SolvedNumbers.fast_omega, GuessNumbers.fast_long, SweptNumbers.now_fast),
    )  # fmt: skip
    ratio_fast = number(
        lambda m: m.ratio[1], "X₂/X₁_{+}", "", "fast",
        also=(SolvedNumbers.fast_ratio, GuessNumbers.r_fast, SweptNumbers.now_ratio_fast, AnswerNumbers.answer_fast),
    )  # fmt: skip
