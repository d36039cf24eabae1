"""The exact state of a damped mass through the pieces of a push: affine maps in numbers of mpmath.

With p1, p2 the exponents of the free motion and f[..] divided differences over them, in e^(p t):

    x = A x_0 + B v_0 + F/m E2 + F'/m E3,   B = [p1, p2],  E2 = [0, p1, p2],  E3 = [0, 0, p1, p2],  A = B' + c/m B.

These are regular at zeta = 0, at critical damping and without a spring.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.1 and 3.1.
"""

from collections.abc import Callable
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

from physics.periodic import PeriodicPush, Piece
from physics.precision.polynomials import Polynomial

STATE_DIGITS = 40
"""Digits to which states agree."""
_DIED_OUT = -1e5  # of an exponent: e^-1e5 is negligible

PhasePoint = tuple[Any, Any]  # x and v, numbers of mpmath


class AffineMap(NamedTuple):
    """A map of the state: x and v become a x + b v + p and c x + d v + q, in SI units.

    Attributes
    ----------
    a, b, c, d, p, q : mpf
        The coefficients, numbers of mpmath.
    """

    a: Any
    b: Any
    c: Any
    d: Any
    p: Any
    q: Any

    def at(self, state: PhasePoint) -> PhasePoint:
        """Return the `state` after the map."""
        x, v = state
        return self.a * x + self.b * v + self.p, self.c * x + self.d * v + self.q

    def after(self, first: "AffineMap") -> "AffineMap":
        """Return the map that applies `first` before this one."""
        (p, q), zero = self.at((first.p, first.q)), 0 * self.p
        plain = AffineMap(*self[:4], zero, zero)
        (a, c), (b, d) = plain.at((first.a, first.c)), plain.at((first.b, first.d))
        return AffineMap(a, b, c, d, p, q)

    @property
    def fixed(self) -> PhasePoint:
        """The state that the map leaves alone."""
        below = (1 - self.a) * (1 - self.d) - self.b * self.c
        return ((1 - self.d) * self.p + self.b * self.q) / below, (self.c * self.p + (1 - self.a) * self.q) / below


class ExactPieces:
    """The motion through pieces in numbers of mpmath, and its steady states.

    Equal nodes of a divided difference are separated by a quarter of the digits; at least a quarter remains.

    Parameters
    ----------
    ctx : MPContext
        The context of the numbers.
    oscillator : tuple of three floats
        m in kg, c in N s/m and k in N/m.
    push : PeriodicPush
        The push.
    resonant : bool
        True if the mass has no dashpot and its natural frequency is a multiple of omega.
    """

    def __init__(self, ctx: Any, oscillator: tuple[float, float, float], push: PeriodicPush, resonant: bool) -> None:
        self.ctx, self.push = ctx, push
        self.m, self.c, self.k = map(ctx.mpf, oscillator)
        self.T = 2 * ctx.pi / self.push.omega
        self.hair = ctx.mpf(10) ** (-ctx.dps // 4) / self.T
        half, square = self.c / (2 * self.m), self.k / self.m
        excess = half**2 - square
        if excess < 0:
            swing = ctx.sqrt(-excess)
            self.p: tuple[Any, Any] = (ctx.mpc(-half, swing), ctx.mpc(-half, -swing))
        else:
            fast = half + ctx.sqrt(excess)
            self.p = (ctx.mpc(-square / fast if fast else 0), ctx.mpc(-fast))
        self.rate = max(abs(self.p[1]), self.push.omega * ctx.one)
        self.least = abs(ctx.mpf(self.push.size)) / self.m / (1 if self.push.impulsive else self.rate)
        if resonant:  # of a line that is missing, or no steady motion would exist
            self.p = (self.p[0] - self.hair, self.p[1] - self.hair)

    @property
    def steady_starts(self) -> list[PhasePoint]:
        """x in m and v in m/s at the start of each piece of the steady motion."""
        half, *others = self.maps
        if self.push.alternates:
            for one in others[: len(self.maps) // 2 - 1]:
                half = one.after(half)
            return self.through(AffineMap(*(-one for one in half)).fixed)
        for one in others:
            half = one.after(half)
        return self.through(self.jump.after(half).fixed)

    @cached_property
    def maps(self) -> list[AffineMap]:
        """The map of each piece."""
        return [self._map(piece) for piece in self.push.pieces]

    @cached_property
    def jump(self) -> AffineMap:
        """The map of the impulse at the start of a period."""
        one, none = self.ctx.one, self.ctx.zero
        J = self.ctx.mpf(self.push.size) if self.push.impulsive else none
        return AffineMap(one, none, none, one, none, J / self.m)

    def same(self, before: PhasePoint, now: PhasePoint) -> bool:
        """Return True if the states `before` and `now` are equal, relative to the least velocity caused by the push."""
        (x, v), (y, w) = before, now
        size = self.least + abs(y) * self.rate + abs(w)
        return bool(max(abs(x - y) * self.rate, abs(v - w)) <= self.ctx.mpf(10) ** -STATE_DIGITS * size)

    def through(self, state: PhasePoint) -> list[PhasePoint]:
        """Return x and v at the start of each piece, from the `state` at the start of a period."""
        states = [state]
        for one in self.maps[:-1]:
            states.append(one.at(states[-1]))
        return states

    def periods(self, state: PhasePoint, count: int) -> PhasePoint:
        """Return the `state` after `count` periods."""
        for i in range(count.bit_length()):
            while len(self._powers) <= i:
                self._powers.append(self._powers[-1].after(self._powers[-1]))
            if count >> i & 1:
                state = self._powers[i].at(state)
        return state

    @cached_property
    def _powers(self) -> list[AffineMap]:
        """A period, two of them, four and so on."""
        whole, *others = self.maps
        for one in (*others, self.jump):
            whole = one.after(whole)
        return [whole]

    @property
    def work(self) -> Any:
        """The energy in J that a cycle brings."""
        F, T, m, w = self.ctx.mpf(self.push.size), self.T, self.m, self.ctx.mpf(self.push.width)
        exp = self._exp
        if self.push.kind == "square":
            return 4 * F**2 / m * self._divided(lambda z: (exp(z * T / 2) - 1) / (exp(z * T / 2) + 1), 1)
        if self.push.kind == "triangle":
            return -64 * F**2 / (m * T**2) * self._divided(lambda z: (exp(z * T / 2) - 1) / (exp(z * T / 2) + 1), 3)
        if self.push.kind == "pulses":
            on, off = w * T, T - w * T
            over = lambda z: (1 - exp(z * off)) * (1 - exp(z * on)) / (exp(z * T) - 1) if z else z  # noqa: E731
            return F**2 / m * self._divided(over, 1)
        return -(F**2) / (2 * m) * self._divided(lambda z: z * (exp(z * T) + 1) / (exp(z * T) - 1), 0)

    def _map(self, piece: Piece) -> AffineMap:
        return self.forced(in_context(self.ctx, piece.end - piece.begin) * self.T, piece)

    def forced(self, tau: Any, piece: Piece) -> AffineMap:
        """Return the map from the start of a `piece` to the time `tau` in s after it."""
        F, rise = in_context(self.ctx, piece.force) / self.m, in_context(self.ctx, piece.rise) / self.T / self.m
        B, slope = self.B(tau, 0), self._divided(lambda z: z * self._exp(z * tau), 0)
        E2, E3 = self.B(tau, 1) if F or rise else F, self.B(tau, 2) if rise else rise
        return AffineMap(
            slope + self.c / self.m * B, B, -self.k / self.m * B, slope, F * E2 + rise * E3, F * B + rise * E2
        )

    def B(self, tau: Any, zeros: int) -> Any:
        """Return e^(p tau)[0, .., 0, p1, p2] with so many `zeros`, nodes at 0: B, E2 or E3. `tau` is in s."""
        return self._divided(lambda z: self._exp(z * tau), zeros)

    def response(self, tau: float, start: Polynomial, zeros: int) -> PhasePoint:
        """Return x and v of a motion by its transform start/(s^zeros (m s^2 + c s + k)).

        Parameters
        ----------
        tau : float
            The time in s.
        start : tuple of Fraction
            The polynomial m, or m s + c, the constant first.
        zeros : int
            The power of s.

        Returns
        -------
        tuple of two mpf
            x and v at this time.
        """
        if len(start) > 1:
            free = self.forced(tau, Piece(*(Fraction(0),) * 3))
            return free.a, free.c
        slope = self.B(tau, zeros - 1) if zeros else self._divided(lambda z: z * self._exp(z * tau), 0)
        return self.B(tau, zeros), slope

    def _divided(self, f: Callable[[Any], Any], zeros: int) -> Any:
        """f[0, .., 0, p1, p2] with so many nodes at 0."""
        nodes: list[Any] = []
        for z in (*(self.ctx.mpc(0),) * zeros, *self.p):
            while any(abs(z - other) < self.hair / 2 for other in nodes):
                z += self.hair
            nodes.append(z)
        parts = (f(z) / self.ctx.fprod(z - other for other in nodes if other is not z) for z in nodes)
        return self.ctx.fsum(parts).real

    def _exp(self, z: Any) -> Any:
        return self.ctx.exp(z) if z.real > _DIED_OUT else self.ctx.zero


def in_context(ctx: Any, value: Fraction) -> Any:
    """Return the `value` as a number of the context `ctx`."""
    return ctx.mpf(value.numerator) / value.denominator
