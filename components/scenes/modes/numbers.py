"""The live numbers of the scene modes, grouped by their subject."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from typing import Any

from components.chain.modes import BOTH, MODES, PARTS, directions
from components.chain.parameters import Pair
from components.quantities.declared import Declared, Family, LiveNumber
from components.quantities.formatting import plus, short, signed, three
from components.scenes.modes.guess import Numbers as GuessNumbers
from physics.coupled import Modes, TwoMassChain
from physics.damped_chain import ComplexMode, ComplexModes, DampedChain, Kind
from physics.laplace import Driven, transform
from physics.modes import Mixture, Quadratic
from physics.precision.exact import precise

MOTIONS = (*MODES, "third", "fourth")
"""Indices of the free motions of a chain with dashpots. The first two are drawn."""
NAMES = {
    Kind.UNDAMPED: ("slow mode", "fast mode"),
    Kind.DRIFT_BOTH: ("drift", "other motion"),
    Kind.DRIFT_TWO: ("drift of mass 2", "motion of mass 1"),
    Kind.REST_EACH: ("slower motion", "faster motion"),
    Kind.PROPORTIONAL: ("slow mode", "fast mode"),
    Kind.EXCEPTIONAL: ("the one mode",),
    Kind.PARTED: ("decays later", "decays sooner"),
    Kind.TWO_PAIRS: ("slow mode", "fast mode"),
}
CROSSED = ("from the slow mode", "from the fast mode")
NUMBERED = ("motion 1", "motion 2", "motion 3", "motion 4")
OFTEN = {2: "twice", 3: "three times", 4: "four times"}
CRITICAL = (Kind.PROPORTIONAL, Kind.DRIFT_BOTH, Kind.DRIFT_TWO)
"""The case in which a double root is a mode with critical damping."""


@dataclass(frozen=True)
class BrakedChain:
    """A chain with its dashpots."""

    system: TwoMassChain
    damping: Pair

    @cached_property
    def damped(self) -> DampedChain:
        return DampedChain.of(self.system, *self.damping)

    @property
    def found(self) -> ComplexModes:
        return self.damped.free_motions

    @cached_property
    def motions(self) -> dict[str, ComplexMode]:
        """The free motions with dashpots, by index."""
        return dict(zip(MOTIONS, self.found.modes, strict=False))

    @cached_property
    def brakes(self) -> bool:
        return any(self.damping)

    @cached_property
    def amplitudes(self) -> dict[tuple[int, str], complex]:
        """The complex amplitude of each mass in each drawn motion, scaled so that the larger one has modulus 1."""
        if self.brakes:
            return {(i, place): one.shape[i - 1] for place, one in self._drawn for i in BOTH}
        shapes = directions(self.system)
        return {(i, mode): complex(shapes[MODES.index(mode)][i - 1]) for i, mode in PARTS}

    @cached_property
    def exponents(self) -> dict[str, complex]:
        """The exponent with which each drawn motion is played: the slowest one that is not 0, if there is one."""
        if self.brakes:
            return {place: next(filter(None, one.exponents), 0j) for place, one in self._drawn}
        return {mode: omega * 1j for mode, omega in zip(MODES, self.system.modes().omega.tolist(), strict=True)}

    @property
    def _drawn(self) -> list[tuple[str, ComplexMode]]:
        return [(place, one) for place, one in self.motions.items() if place in MODES]

    @property
    def named(self) -> bool:
        """Return True if the first two motions are the slow and the fast mode, or have developed from them."""
        return self.found.kind in (Kind.PROPORTIONAL, Kind.TWO_PAIRS)

    def name(self, place: str) -> str:
        """The name of a motion in its title and at its root."""
        names = CROSSED if self.found.crossed else NAMES.get(self.found.kind, NUMBERED)
        return dict(zip(MOTIONS, names, strict=False)).get(place, "")

    def root(self, place: str) -> str:
        """The form of the line on the roots of a motion."""
        one = self.motions.get(place)
        if one is None:
            return ""
        if not any(one.exponents):
            return "drift" if one.repeats == 2 else "rest"
        if one.swings:
            return "lasting" if not self.brakes else "met" if one.repeats == 2 else "pair"
        if one.repeats > 1:
            return "critical" if self.found.kind in CRITICAL else "again"
        return "single" if len(one.exponents) == 1 else "real" if all(one.exponents) else "settles"

    @property
    def statement(self) -> str:
        """The form of the sentence on the kinds of the free motions."""
        kind, shared = self.found.kind, any(one.repeats > 1 for one in self.motions.values())
        if kind is Kind.PROPORTIONAL:
            return f"{kind}_late" if not any(one.swings for one in self.motions.values()) else kind
        if kind is Kind.TWO_PAIRS:
            return f"{kind}_lags" if self.gap < 0 else f"{kind}_leads"
        return f"{kind}_met" if kind in (Kind.ONE_PAIR, Kind.FOUR_REAL) and shared else kind

    @property
    def gap(self) -> Decimal:
        """c1 k2 - c2 k1, from the numbers as written; negative if mass 2 lags behind mass 1 in an oscillation."""
        c1, c2, k1, k2 = (Decimal(repr(one)) for one in (*self.damping, self.system.k1, self.system.k2))
        with precise():
            return c1 * k2 - c2 * k1

    @property
    def met(self) -> Pair | tuple[None, None]:
        """The damping at which both pairs of roots meet, if the current damping is beyond it."""
        return self.damped.meeting if self.found.kind is Kind.PARTED else (None, None)

    @cached_property
    def powers(self) -> list[float]:
        """The coefficients of D in powers of s, the constant one first."""
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
    """The terms of the quadratic in omega^2, and of its discriminant as a sum of squares."""

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
    """The terms of Solve, without dashpots. `slow_omega` and `fast_omega` are natural frequencies here.

    A scene's `numbers` have them as `omega_slow` and `omega_fast`; `slow_omega` there is the frequency of
    `BrakedNumbers`, with dashpots.
    """

    gamma = solved(lambda c: c.modes().gamma, meaning="gamma of the lecture: X2/X1 is -gamma ± delta")
    delta = solved(lambda c: c.modes().delta, meaning="delta of the lecture: X2/X1 is -gamma ± delta")
    product = solved(lambda c: -Decimal(c.m1) / Decimal(c.m2))
    omega = slow_omega, fast_omega = solved.both(lambda c: c.modes().omega)
    slow_square, fast_square = solved.both(lambda c: [mode.omega**2 for mode in c.exact_modes])
    ratio = slow_ratio, fast_ratio = solved.both(lambda c: c.modes().ratio, signed)


class ShareNumbers(Declared[Mixture]):
    share_slow, share_fast = LiveNumber[Mixture].both(lambda m: [f"{three(round(100 * part, 9))} %" for part in m])


def off_line(one: ComplexMode) -> float:
    """The angle in degrees between the arrows of a mode and a common line."""
    X1, X2 = one.shape
    if not X1 or not X2:
        return 0.0
    ratio = X2 / X1
    return math.degrees(math.atan2(abs(ratio.imag), abs(ratio.real)))


def shape(one: ComplexMode) -> str:
    """X2/X1 with its sign, or with its angle if the arrows are not parallel."""
    X1, X2 = one.shape
    ratio = X2 / X1 if X1 else complex(math.inf)
    return f"{three(abs(ratio))} at {three(math.degrees(cmath.phase(ratio)))}°" if off_line(one) else signed(ratio.real)


def exponents(one: ComplexMode) -> str:
    """The roots of a motion as they are written in its title."""
    first = one.exponents[0]
    if one.swings:
        return f"{three(first.real)} ± {three(first.imag)} i"
    return three(first.real) if one.repeats > 1 else " and ".join(three(s.real) for s in one.exponents)


def of_motion(
    place: str,
    value: Callable[[ComplexMode], Any],
    form: Callable[[Any], str] = three,
    unit: str = "",
    meaning: str = "",
) -> LiveNumber[Any]:
    """A number of the motion at an index, described by `meaning`; None if there is no such motion."""
    means = f"{meaning} of the {place} motion" if meaning else ""
    return braked(
        lambda c: value(c.motions[place]) if place in c.motions else None, form=form, unit=unit, meaning=means
    )


def _turn(one: ComplexMode) -> float | None:
    """The angular frequency; None for a motion that does not oscillate."""
    return one.exponents[0].imag if one.swings else None


def _rate(one: ComplexMode) -> float:
    return one.exponents[0].real


def _zeta(one: ComplexMode) -> float | None:
    return abs(_rate(one)) / abs(one.exponents[0]) if one.swings else None


def _fate(one: ComplexMode) -> str:
    zeta = _zeta(one)
    return "does not swing" if zeta is None else f"ζ = {three(zeta)}"


def _quality(one: ComplexMode) -> float | None:
    return -abs(one.exponents[0]) / (2 * _rate(one)) if one.swings and _rate(one) else None


def _decay(one: ComplexMode) -> float | None:
    """The time in s in which the motion decays to 1/e."""
    return -1 / _rate(one) if one.swings and _rate(one) else None


class BrakedNumbers(Declared[BrakedChain]):
    """The roots of the motions with dashpots, their shapes, and the kinds of motion for the sentence on them."""

    name = Family(MOTIONS, lambda place: braked(lambda c: c.name(place)), "{}_name")
    s = Family(MOTIONS, lambda place: of_motion(place, exponents), "{}_s")
    rate = Family(
        MOTIONS, lambda place: of_motion(place, _rate, unit="1/s", meaning="real part of the root"), "{}_rate"
    )
    turn = Family(
        MODES, lambda place: of_motion(place, _turn, unit="rad/s", meaning="frequency, with dashpots"), "{}_omega"
    )
    other = Family(MODES, lambda place: of_motion(place, lambda one: one.exponents[-1].real), "{}_other")
    zeta = Family(MODES, lambda place: of_motion(place, _zeta, meaning="damping ratio"), "{}_zeta")
    Q = Family(MODES, lambda place: of_motion(place, _quality, meaning="quality factor"), "{}_Q")
    decay = Family(MODES, lambda place: of_motion(place, _decay, unit="s", meaning="decay time"), "{}_decay")
    repeats = Family(MOTIONS, lambda place: of_motion(place, lambda one: OFTEN.get(one.repeats), str), "{}_repeats")
    ratio = Family(MOTIONS, lambda place: of_motion(place, shape), "{}_ratio")
    angle = Family(MODES, lambda place: of_motion(place, off_line), "{}_angle")
    fate = Family(MODES, lambda place: of_motion(place, _fate, str), "{}_fate")
    cross = braked(lambda c: Decimal(c.damping[0]) * Decimal(c.system.k2))
    gap = braked(lambda c: c.gap)
    c1_met, c2_met = braked.both(lambda c: c.met, short)
    p4 = braked(lambda c: c.powers[4])
    p3, p2 = braked.both(lambda c: c.powers[3:1:-1], plus)
    p1, p0 = braked.both(lambda c: c.powers[1::-1], plus)


def _readout(
    shown: Family[str, LiveNumber[BrakedChain]], symbol: str, unit: str, signs: str, *, named: bool
) -> Family[str, LiveNumber[BrakedChain]]:
    """Numbers of the motions for the comparison: named as modes if `named`, otherwise as motions."""

    def one(place: str) -> LiveNumber[BrakedChain]:
        index = signs[MOTIONS.index(place)]
        tint = place if place in MODES else "ink"
        read, also = shown[place].value, (shown[place], BrakedNumbers.s[place])
        return braked(lambda c: read(c) if c.named is named else None, f"{symbol}_{{{index}}}", unit, tint, also=also)

    return Family(MOTIONS[: len(signs)], one)


class RootReadouts(Declared[BrakedChain]):
    """The roots for the comparison with another picture."""

    mode_turn = _readout(BrakedNumbers.turn, "ω", "rad/s", "−+", named=True)
    mode_rate = _readout(BrakedNumbers.rate, "Re s", "1/s", "−+", named=True)
    motion_turn = _readout(BrakedNumbers.turn, "ω", "rad/s", "12", named=False)
    motion_rate = _readout(BrakedNumbers.rate, "Re s", "1/s", "1234", named=False)


class ComparedNumbers(Declared[Modes]):
    """The frequencies and the shapes, with all numbers in which a view shows them."""

    omega_slow = number(
        lambda m: m.omega[0], "ω_{−}", "rad/s", "slow",
        also=(SolvedNumbers.slow_omega, GuessNumbers.slow_long, SweptNumbers.now_slow),
        meaning="slow natural frequency",
    )  # fmt: skip
    ratio_slow = number(
        lambda m: m.ratio[0], "X₂/X₁_{−}", "", "slow",
        also=(SolvedNumbers.slow_ratio, GuessNumbers.r_slow, SweptNumbers.now_ratio_slow, AnswerNumbers.answer_slow),
        meaning="X2/X1 of the slow mode",
    )  # fmt: skip
    omega_fast = number(
        lambda m: m.omega[1], "ω_{+}", "rad/s", "fast",
        also=(SolvedNumbers.fast_omega, GuessNumbers.fast_long, SweptNumbers.now_fast),
        meaning="fast natural frequency",
    )  # fmt: skip
    ratio_fast = number(
        lambda m: m.ratio[1], "X₂/X₁_{+}", "", "fast",
        also=(SolvedNumbers.fast_ratio, GuessNumbers.r_fast, SweptNumbers.now_ratio_fast, AnswerNumbers.answer_fast),
        meaning="X2/X1 of the fast mode",
    )  # fmt: skip
