"""Motions of one damped mass under a push that repeats, or acts once: m x'' + c x' + k x = F(t).

A push is constant, or rises evenly, on each of its pieces, so x and v at the end of a piece are affine in those at its
start: physics.push_maps has these maps, with B, E2 and E3. The steady motion is the one that the pieces of a period
bring back to its start: no Fourier sum. It does not exist where c = 0 and a line n of the push is at
omega_n = n omega, or where k = 0 and the push has a mean. From rest a period is applied M times by repeated squaring,
at a resonance too. States at the start of a piece have as many digits as they need; in pieces motions are summed as in
physics.transient.

Source: beyond lecture D31; J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.1 and 3.1.
"""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.laplace import NOTHING, Expansion, expanded
from physics.periodic import PeriodicPush, Piece, TimesInPieces
from physics.precision.exact import Array, two_product, two_sum
from physics.precision.polynomials import Polynomial, context
from physics.push_maps import STATE_DIGITS, ExactPieces, PhasePoint, in_context
from physics.transient import DIGITS, Effort, in_pairs
from physics.valid import check_not_negative, finite_array, in_range

QUANTITIES = "the displacement", "the velocity"
_CLOSE = Effort(2.0**-56, of_largest=True)
_MOST = 8000  # digits
_SHORT, _TERMS = 0.1, 12  # rad, and terms of a Taylor series
_DECAYED = 80.0  # twice the exponent after which a swing is below a rounding error


class PushedMotion(NamedTuple):
    """The motion of a mass under a push.

    Attributes
    ----------
    t : ndarray (n,)
        Times in s.
    x, v : ndarray (n,)
        Displacements in m, velocities in m/s.
    """

    t: Array
    x: Array
    v: Array


class PushLine(NamedTuple):
    """A line of F(t) = sum of Re(f exp(i n omega t)), and of the steady motion x = sum of Re(X exp(i n omega t)).

    Attributes
    ----------
    n : int
        The number of the line.
    f : complex
        The amplitude of the force in N.
    X : complex
        The amplitude of the motion in m; infinite where no steady motion exists because of this line.
    """

    n: int
    f: complex
    X: complex


@dataclass(frozen=True)
class PushedMass:
    """One damped mass under a push.

    Parameters
    ----------
    m : float
        The mass in kg.
    c : float
        The damping in N s/m.
    k : float
        The stiffness in N/m.
    push : PeriodicPush
        The push.
    """

    m: float
    c: float
    k: float
    push: PeriodicPush

    @cached_property
    def resonant_line(self) -> int | None:
        """The n of omega_n = n omega, decided without error; None with a dashpot, or if no line is there."""
        if self.c or not self.k:
            return None
        square = Fraction(self.k) / Fraction(self.m) / Fraction(self.push.omega) ** 2
        n = math.isqrt(int(square))
        return n if n and n * n == square else None

    @property
    def steady_exists(self) -> bool:
        """True if a steady motion exists, decided with exact fractions."""
        if not self.push.size:
            return True
        if (self.push.kind == "step" or self.push.mean) and not self.k:
            return False
        n = None if self.push.once else self.resonant_line
        return n is None or not self.push.has_line(n)

    @property
    def growth(self) -> float:
        """The rate in m/s at which the amplitude grows from rest where a line is at the natural frequency, else 0."""
        n = self.resonant_line
        if n is None or self.push.once or not self.push.has_line(n):
            return 0.0
        return abs(self.push.line(n)) / (2 * self.m * n * self.push.omega)

    @property
    def starts(self) -> list[tuple[float, float]]:
        """x in m and v in m/s at the start of each piece of the steady motion, each rounded once.

        ValueError if no steady motion exists.
        """
        self._check_steady()
        return [(float(x), float(v)) for x, v in _steady_starts(self)]

    def lines(self, count: int) -> list[PushLine]:
        """Return the lines 0 to `count` of the push and of the steady motion, within 5 u."""
        return [self.line(n) for n in range(count + 1)]

    def line(self, n: int) -> PushLine:
        """Return line n of the push and of the steady motion, within 5 u."""
        f = self.push.line(n)
        return PushLine(n, f, self._moved_by(n, f))

    def _moved_by(self, n: int, f: complex) -> complex:
        turn = n * Fraction(self.push.omega)
        real, turned = Fraction(self.k) - Fraction(self.m) * turn**2, Fraction(self.c) * turn
        square = real**2 + turned**2
        if not square:
            return complex(math.inf) if f else 0j
        return f * complex(float(real / square), -float(turned / square))

    def steady(self, t: ArrayLike) -> PushedMotion:
        """Return the steady motion at the times t (n,) in s, within 4 u of the largest value.

        The v of an impulse is that just after it. ValueError if no steady motion exists.
        """
        t, push = finite_array("t", t), self.push
        self._check_steady()
        x, v = np.zeros((2, t.size))
        if not push.size or push.once:
            return PushedMotion(t, x + (push.size / self.k if push.kind == "step" and push.size else 0.0), v)
        places = TimesInPieces.of(push, t)
        for i, piece in enumerate(push.pieces):
            here = places.piece == i
            if np.any(here):
                x[here], v[here] = self._in_piece(i, piece, places.tau[here], places.rest[here])
        return PushedMotion(t, in_range(QUANTITIES[0], x), in_range(QUANTITIES[1], v))

    def _in_piece(self, i: int, piece: Piece, tau: Array, rest: Array) -> tuple[Array, Array]:
        """The steady motion in a piece, at times tau + rest after it began."""
        start = _steady_starts(self)[i]
        x, _ = self._summed(tau, self._expansion(piece, start), lambda exactly, t: exactly.forced(t, piece).at(start))
        rate = self._rate(piece, start)
        v, a = self._summed(tau, self._expansion(*rate), lambda exactly, t: exactly.forced(t, rate[0]).at(rate[1]))
        rise = np.full_like(tau, float(piece.rise) / self.m * self.push.omega / (2 * math.pi))
        return self._advanced(x, v, a, rise, tau, rest)

    def _advanced(self, x: Array, v: Array, a: Array, rise: Array, tau: Array, rest: Array) -> tuple[Array, Array]:
        """x and v a moment later, by their Taylor series: a quick mass may swing by a share of a turn in that moment.

        `rise` (n,) is F'/m. After more than a tenth of a radian the slope is enough if the faster part has decayed by
        `tau`. If it still swings, more than 1e15 rad after its start, the rounding error of the time is left.
        """
        damping, swing = self.c / self.m, math.sqrt(self.k / self.m)
        short = np.where(max(damping, swing) * np.abs(rest) < _SHORT, rest, 0.0)
        # The terms of v: its derivatives alone would leave the range of doubles.
        last, now, push = v, a * short, rise * short * short / 2
        slope = np.where((short != 0) | (damping * tau > _DECAYED), rest, 0.0)
        x, v = x + v * slope, v + a * slope
        for n in range(2, _TERMS):
            later = push - damping * short * now / n - (swing * short) ** 2 * last / (n * (n - 1))
            x, v = x + now * short / n, v + later
            last, now, push = now, later, 0.0 * push
        return x, v

    def _rate(self, piece: Piece, start: PhasePoint) -> tuple[Piece, PhasePoint]:
        """The rate of change of the force in a piece, as a piece, and of the state at its start."""
        ctx = context(DIGITS)
        m, c, k, (x, v) = ctx.mpf(self.m), ctx.mpf(self.c), ctx.mpf(self.k), start
        rise = in_context(ctx, piece.rise) * self.push.omega / (2 * ctx.pi)
        return piece._replace(force=_fraction(rise), rise=Fraction(0)), (
            v,
            (in_context(ctx, piece.force) - c * v - k * x) / m,
        )

    def from_rest(self, t: ArrayLike) -> PushedMotion:
        """Return the motion from rest before the push at the times t (n,) in s, 0 or more.

        It is within 4 u of the largest value. ValueError if a time is not possible, or a result leaves the range of
        doubles.
        """
        t = finite_array("t", t)
        check_not_negative("a time in s", t=float(np.min(t, initial=0.0)))
        places, pieces = TimesInPieces.of(self.push, t), self.push.pieces
        starts, m = self._from_rest(places), Fraction(self.m)
        ctx = context(STATE_DIGITS)
        rises = [in_context(ctx, one.rise / m) * self.push.omega / (2 * ctx.pi) for one in pieces]
        numbers = [
            (*starts[key], in_context(ctx, pieces[key[1]].force / m), rises[key[1]])
            for key in zip(places.period, places.piece.tolist(), strict=True)
        ]
        hi = np.array([[float(one) for one in row] for row in numbers]).T
        lo = np.array([[float(one - float(one)) for one in row] for row in numbers]).T
        one, none = Fraction(self.m), np.zeros((2, t.size))
        A, dA = self._response(places.tau, (Fraction(self.c), one), 0)
        B, dB = self._response(places.tau, (one,), 0)
        E2 = self._response(places.tau, (one,), 1)[0] if any(hi[2]) or any(hi[3]) else none[0]
        E3 = self._response(places.tau, (one,), 2)[0] if any(hi[3]) else none[0]
        x = _combined(zip(hi, lo, (A, B, E2, E3), strict=True))
        v = _combined(zip(hi, lo, (dA, dB, B, E2), strict=True))
        damping, square = self.c / self.m, self.k / self.m
        a = -square * dB * hi[0] - (damping * dB + square * B) * hi[1] + dB * hi[2] + B * hi[3]
        x, v = self._advanced(x, v, a, hi[3], places.tau, places.rest)
        return PushedMotion(t, in_range(QUANTITIES[0], x), in_range(QUANTITIES[1], v))

    def force(self, t: ArrayLike) -> Array:
        """Return F (n,) in N at the times t (n,) in s, without impulses."""
        places = TimesInPieces.of(self.push, finite_array("t", t))
        force, rise = np.array([[float(one.force), float(one.rise)] for one in self.push.pieces])[places.piece].T
        return np.asarray(force + rise * self.push.omega / (2 * math.pi) * places.tau)

    def convolution(self, t: float, count: int) -> tuple[Array, Array, Array]:
        """Return the push until t in s as `count` impulses: times in s, sizes in N s, and the x in m that each leaves.

        The sum of the last row tends to the motion from rest like 1/count^2 if no edge of the push is inside a slice.
        """
        times = t * (np.arange(count) + 0.5) / count
        sizes = self.force(times) * t / count
        impulse = PushedMass(self.m, self.c, self.k, PeriodicPush(kind="impulse"))
        return times, sizes, sizes * impulse.from_rest(t - times).x

    @cached_property
    def work(self) -> float:
        """The energy in J that the push brings in a cycle of the steady motion and the dashpot takes, rounded once.

        ValueError if no steady motion exists.
        """
        if not self.c or not self.push.size or self.push.once:
            return 0.0
        self._check_steady()
        ((work, _),) = _agreed(self, lambda exactly: [(exactly.work, exactly.ctx.zero)])
        return float(work)

    def exactly(self, digits: int) -> ExactPieces:
        """Return the motion through the pieces of the push in numbers of so many decimal `digits`."""
        return ExactPieces(context(digits), (self.m, self.c, self.k), self.push, bool(self.resonant_line))

    def _check_steady(self) -> None:
        """Raise ValueError if no steady motion exists."""
        if self.steady_exists:
            return
        if not self.k:
            raise ValueError(
                "k = 0: without a spring a push with a mean drives the mass away; a stiffness above 0 N/m is needed"
            )
        raise ValueError(
            f"line {self.resonant_line} of the push is at the natural frequency of the undamped mass, where no steady "
            "motion exists: another frequency or a dashpot is needed"
        )

    def _from_rest(self, places: TimesInPieces) -> dict[tuple[int, int], PhasePoint]:
        """x and v at the start of each piece of each period in which a time is, from rest."""
        exactly = self.exactly(6 * STATE_DIGITS)
        state, period = exactly.jump.at((exactly.ctx.zero, exactly.ctx.zero)), 0
        found = dict[tuple[int, int], PhasePoint]()
        pieces = sorted(set(zip(places.period, places.piece.tolist(), strict=True)))
        for number in sorted({number for number, _ in pieces}):
            state, period = exactly.periods(state, number - period), number
            found |= dict(
                zip(((number, i) for i in range(len(self.push.pieces))), exactly.through(state), strict=False)
            )
        return found

    def _expansion(self, piece: Piece, start: PhasePoint) -> Expansion:
        """The motion in a piece as a sum of exponentials."""
        ctx, m, c = context(DIGITS), Fraction(self.m), Fraction(self.c)
        x, v = map(_fraction, start)
        rise = _fraction(in_context(ctx, piece.rise) * self.push.omega / (2 * ctx.pi))
        forces = (rise, piece.force) if rise else (piece.force,) if piece.force else ()
        return self._transformed((*forces, m * v + c * x, m * x), len(forces))

    def _response(self, tau: Array, start: Polynomial, zeros: int) -> Array:
        """x and v (2, n) of a motion whose transform is start/(s^zeros (m s^2 + c s + k))."""
        return self._summed(tau, self._transformed(start, zeros), lambda exactly, t: exactly.response(t, start, zeros))

    def _transformed(self, start: Polynomial, zeros: int) -> Expansion:
        P = (*(Fraction(0),) * zeros, *map(Fraction, (self.k, self.c, self.m)))
        return expanded(P, (start,) * 3, (NOTHING,) * 3, 0.0, DIGITS, undamped=not self.c)

    def _summed(self, tau: Array, terms: Expansion, one: Callable[[ExactPieces, float], PhasePoint]) -> Array:
        """x and v (2, n) as the sum of `terms`, one by one where these cancel too far."""
        values, sure = in_pairs(terms, tau, _CLOSE)
        exactly = self.exactly(3 * STATE_DIGITS)
        for n in np.flatnonzero(~sure | (tau == 0.0)).tolist():
            values[[0, 3], n] = [float(part) for part in one(exactly, tau[n])]
        return values[[0, 3]]


@lru_cache(maxsize=64)
def _steady_starts(mass: PushedMass) -> list[PhasePoint]:
    """x and v at the start of each piece of the steady motion."""
    return _agreed(mass, lambda exactly: exactly.steady_starts)


def _agreed(mass: PushedMass, compute: Callable[[ExactPieces], list[PhasePoint]]) -> list[PhasePoint]:
    """States that do not change with twice the digits, relative to their motion."""
    spent, states = 3 * STATE_DIGITS, list[PhasePoint]()
    while spent < _MOST:
        spent *= 2
        exactly = mass.exactly(spent)
        before, states = states, compute(exactly)
        if before and all(exactly.same(*pair) for pair in zip(before, states, strict=True)):
            break
    return states


def _combined(terms: Iterable[tuple[Array, Array, Array]]) -> Array:
    """The sum of products; hi and lo of each first factor, and the second one."""
    total = rest = np.zeros(1)
    for hi, lo, curve in terms:
        p, e = two_product(hi, curve)
        total, carried = two_sum(total, p)
        rest = rest + (carried + e + lo * curve)
    return np.asarray(total + rest)


def _fraction(value: Any) -> Fraction:
    """A number of mpmath, digit for digit."""
    sign, mantissa, exponent, _ = value.real._mpf_
    return Fraction(int(-mantissa if sign else mantissa)) * Fraction(2) ** int(exponent)
