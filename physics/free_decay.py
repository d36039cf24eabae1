"""Free motion of a damped oscillator from its initial conditions: its turns, its greatest speed, what it loses.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), section 2.6; equations in physics.damped.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cached_property, partial
from math import inf, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.damped import DampedOscillator, Decay, Fading
from physics.motion import Elementary, ExactMotion, remembered
from physics.oscillator import OscillatorMotion
from physics.precision.exact import Array, exact, precise, rounded, sum_of
from physics.valid import finite_array, in_range

_LIGHT, _HEAVY = 0.5, 2.0  # of zeta: beyond them the energy lost has a form without a difference
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(12)
_HALVINGS = 80


class Moment(NamedTuple):
    """A time in s with x in m and v in m/s.

    Attributes
    ----------
    t : float
        The time in s.
    x, v : float
        The displacement in m and the velocity in m/s.
    """

    t: float
    x: float
    v: float


@dataclass(frozen=True, kw_only=True)
class FreeDecay:
    """A motion of a damped oscillator from x(0) = x_0 (m), x'(0) = v_0 (m/s).

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass on its spring and its dashpot.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    """

    oscillator: DampedOscillator
    x_0: float
    v_0: float

    @cached_property
    def x(self) -> Elementary:
        """The displacement in m. If it oscillates, it fills its envelope, and the spring has half of the energy."""
        one, motion, twin = self.oscillator, self._motion, replace(self)  # a copy that does not refer to this motion
        return Elementary(
            symbol="x", exact=lambda t: motion(t).x, played=self.fadings[0], size=twin._size, omega=one.omega_d,
            amplitude=lambda: twin.envelope, square=lambda: twin._decaying_energy / one.k,
        )  # fmt: skip

    @cached_property
    def v(self) -> ExactMotion:
        """The velocity in m/s. If it oscillates, the mass has half of the energy on average."""
        one, motion, twin = self.oscillator, self._motion, replace(self)
        a_0 = float(one.exact_starts(self.x_0, self.v_0)[1][1])
        speed = replace(self, x_0=self.v_0, v_0=a_0)  # the decay whose displacement is this velocity
        return Elementary(
            symbol="v", exact=lambda t: motion(t).v, played=self.fadings[1], size=speed._size,
            omega=one.omega_d, square=lambda: twin._decaying_energy / one.m,
        )  # fmt: skip

    @cached_property
    def fadings(self) -> tuple[Fading, Fading, Fading]:
        """x, v and a for signals."""
        return self.oscillator.fading(self.x_0, self.v_0)

    @cached_property
    def amplitude_and_phase(self) -> tuple[float, float]:
        """The amplitude of the envelope at the start in m and the phase in rad, where it oscillates."""
        first = self.oscillator.decays(self.x_0, self.v_0)[0]
        return first.amplitude, first.phase

    @cached_property
    def envelope(self) -> ExactMotion:
        """The upper envelope in m, where it oscillates."""
        return _exponential("envelope", self.amplitude_and_phase[0], self.oscillator.rates[0])

    @cached_property
    def parts(self) -> tuple[ExactMotion, ExactMotion]:
        """The slow and the fast exponential in m, where it does not oscillate."""
        (slow, fast), rates = self.fadings[0].late, self.oscillator.rates
        return _exponential("slow", slow, rates[0]), _exponential("fast", fast, rates[1])

    @cached_property
    def E_0(self) -> float:
        """The energy at the start in J."""
        one = self.oscillator
        with precise():
            kinetic, potential = exact(one.m) * exact(self.v_0) ** 2, exact(one.k) * exact(self.x_0) ** 2
            return rounded("the energy at the start", (kinetic + potential) / 2)

    @cached_property
    def fastest(self) -> Moment:
        """The moment at which the mass is fastest."""
        top = self._first_turn_and_top_speed[1] or self._start
        return max(self._start, top, key=lambda moment: abs(moment.v))

    def peaks(self, count: int) -> list[Moment]:
        """Return the first turns on the side of the first one, where it oscillates; at rest the start is a turn.

        Parameters
        ----------
        count : int
            The number of turns.

        Returns
        -------
        list of Moment
            The turns in order, a period 2 pi/omega_d apart.

        Raises
        ------
        ValueError
            If a number is not possible, or a result leaves the range of doubles.
        """
        first, tau = 0.0 if not self.v_0 else self.first_turn or 0.0, 2 * pi / self.oscillator.omega_d
        return self.moments([first + i * tau for i in range(count)])

    def reach(self, end: float = inf) -> float:
        """Return the largest |x| in m up to the time `end` in s.

        Parameters
        ----------
        end : float
            The last time in s, 0 or more; inf for the whole motion.

        Returns
        -------
        float
            The largest |x| in m.

        Raises
        ------
        ValueError
            If a number is not possible, or a result leaves the range of doubles.
        """
        turn = self._first_turn_and_top_speed[0]
        if turn and turn.t <= end:  # later turns are smaller
            return max(abs(self.x_0), abs(turn.x))
        last = self.moments([end]) if end < inf else []
        return max(abs(moment.x) for moment in [self._start, *last])

    @property
    def _start(self) -> Moment:
        return Moment(0.0, self.x_0, self.v_0)

    @cached_property
    def _first_turn_and_top_speed(self) -> tuple[Moment | None, Moment | None]:
        """The first turn and the first top speed after the start. Computing both takes as long as computing one."""
        times = self.first_turn, self.first_top_speed
        moments = iter(self.moments([t for t in times if t is not None]))
        turn, top = (None if t is None else next(moments) for t in times)
        return turn, top

    def _size(self) -> float:
        """Return about the largest |x| in m."""
        turn = self.first_turn
        return max(abs(self.x_0), 0.0 if turn is None else abs(self._place(turn)))

    def moments(self, times: list[float]) -> list[Moment]:
        """Return the motion at these times in s.

        Parameters
        ----------
        times : list of float
            Times in s, 0 or more.

        Returns
        -------
        list of Moment
            A moment for each time, with x in m and v in m/s.

        Raises
        ------
        ValueError
            If a number is not possible, or a result leaves the range of doubles.
        """
        motion = self.oscillator.motion(self.x_0, self.v_0, times)
        return list(map(Moment, times, motion.x.tolist(), motion.v.tolist()))

    @cached_property
    def _decaying_energy(self) -> ExactMotion:
        """The energy in J, averaged over a cycle of light damping."""
        rate, E_0 = self.oscillator.rates[0], self.E_0

        def energy(t: Array) -> Array:
            decay = np.exp(-rate * t)
            return np.asarray(E_0 * decay * decay)

        played = Decay(E_0, 0.0, 2 * rate, 0.0, pi / 2)
        return Elementary(symbol="energy", exact=energy, played=played, size=lambda: E_0)

    @cached_property
    def _motion(self) -> Callable[[Array], OscillatorMotion]:
        """The motion at given times: x, v and what is made of them share one computation."""
        return remembered(partial(self.oscillator.motion, self.x_0, self.v_0))

    @property
    def first_zero(self) -> float | None:
        """The time in s of the first zero of x after the start; None if there is none."""
        return self._crossing(0)

    @property
    def first_turn(self) -> float | None:
        """The time in s of the first turning point after the start; None if there is none."""
        return self._crossing(1)

    @property
    def first_top_speed(self) -> float | None:
        """The time in s at which |v| is greatest first, after the start, and with it the power lost."""
        return self._crossing(2)

    def settled(self, share: float) -> float | None:
        """The time in s from which |x| stays below that share (under 1) of |x_0|; None if there is none.

        Within 1e-8, relatively, near critical damping (within 1e-8), else exact to a double.

        Parameters
        ----------
        share : float
            The share of |x_0|, 0 or more and below 1.

        Returns
        -------
        float or None
            The time in s; None if x_0 or the share is 0, and without a dashpot or a spring.
        """
        one, level = self.oscillator, share * abs(self.x_0)
        turn, delta = self.first_turn, one.log_decrement
        if not level or not one.c or not one.k:
            return None
        low, high = 0.0, self.first_zero
        if turn is not None:
            peak = abs(self._place(turn))
            if peak > level:
                low = turn + (math.floor(2 * math.log(peak / level) / delta) * pi / one.omega_d if one.omega_d else 0.0)
                high = low + math.atan2(one.omega_d, -one.rates[0]) / one.omega_d if one.omega_d else None
        return _bisected(lambda t: abs(self._place(t)) - level, low, high, 1 / one.rates[0])

    def lost(self, t: ArrayLike) -> Array:
        """The energy in J that the dashpot has taken by the times t (n,) in s, within 64 u.

        At first by quadrature of c v^2, whose terms are all positive; then by forms without a difference, or where none
        cancels as the difference of the energies.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s, 0 or more.

        Returns
        -------
        ndarray (n,)
            The energy lost in J, 0 without a dashpot.

        Raises
        ------
        ValueError
            If a number is not possible, or the energy leaves the range of doubles.
        """
        t, one = finite_array("t", t), self.oscillator
        speed = max(abs(self.v_0), one.omega_n * abs(self.x_0))
        if not one.c or not speed:
            return np.zeros_like(t)
        x, v = self.x_0 / speed, self.v_0 / speed
        taken = np.zeros_like(t)
        early = max(one.omega_n, one.rates[1]) * t <= 1
        if np.any(early):
            taken[early] = self._quadrature(t[early], speed)
        if not np.all(early):
            late = t[~early]
            form = _light if one.zeta < _LIGHT else _heavy if one.zeta > _HEAVY else None
            taken[~early] = form(one, x, v, late) if form else self._difference(late, speed)
        with np.errstate(over="ignore"):
            return in_range("the energy lost", one.m * speed * taken * speed)

    def _crossing(self, row: int) -> float | None:
        """The first time after the start at which x, v or a is 0."""
        one = self.oscillator
        value, rate = one.exact_starts(self.x_0, self.v_0)[row]
        with precise():
            w, apart = sum_of(rate, one.exact_sigma * value), 2 * one.exact_beta
            if one.exact_omega_d:
                size = abs(value) + abs(w) / one.exact_omega_d
                if not size:
                    return None
                side = -1 if value > 0 else 1
                turned = math.atan2(abs(value) / size, side * w / one.exact_omega_d / size) if value else pi
                return float(Decimal(turned) / one.exact_omega_d)
            if not value or not w or value / w > 0:
                return None
            if not apart:
                return float(-value / w)
            left = sum_of(w, apart * value) / w
            return float(-left.ln() / apart) if left > 0 else None

    def _place(self, t: float) -> float:
        """x at a time, in plain doubles."""
        one, (slow, fast) = self.oscillator, self.oscillator.rates
        omega, apart = one.omega_d, float(2 * one.exact_beta)
        w = self.v_0 + slow * self.x_0
        if apart * t > 1:
            return (self.x_0 + w / apart) * math.exp(-slow * t) - w / apart * math.exp(-fast * t)
        grown = math.sin(omega * t) / omega if omega else -math.expm1(-apart * t) / apart if apart else t
        return math.exp(-slow * t) * (self.x_0 * math.cos(omega * t) + w * grown)

    def _quadrature(self, t: Array, speed: float) -> Array:
        times = t[:, None] * ((1 + _NODES) / 2)
        v = self.oscillator.motion(self.x_0, self.v_0, times.ravel()).v.reshape(times.shape) / speed
        return np.asarray(self.oscillator.c / self.oscillator.m * t / 2 * (v * v @ _WEIGHTS))

    def _difference(self, t: Array, speed: float) -> Array:
        motion, ratio = self.oscillator.motion(self.x_0, self.v_0, t), self.oscillator.k / self.oscillator.m
        x_0, v_0, x, v = self.x_0 / speed, self.v_0 / speed, motion.x / speed, motion.v / speed
        return np.asarray((ratio * (x_0 - x) * (x_0 + x) + (v_0 - v) * (v_0 + v)) / 2)


def _light(one: DampedOscillator, x: float, v: float, t: Array) -> Array:
    """The energy lost over the mass where zeta < 1/2, from v = Re(V exp(p t))."""
    a, p = one.rates[0], complex(-one.rates[0], one.omega_d)
    V = complex(v, (a * v + one.omega_n**2 * x) / one.omega_d)
    return np.asarray(-(abs(V) ** 2) * np.expm1(-2 * a * t) / 2 + a * (V * V * np.expm1(2 * p * t) / (2 * p)).real)


def _heavy(one: DampedOscillator, x: float, v: float, t: Array) -> Array:
    """The energy lost over the mass where zeta > 2, from x = A exp(-s t) + B exp(-f t)."""
    s, f = one.rates
    apart = float(2 * one.exact_beta)
    A, B = (v + f * x) / apart, -(v + s * x) / apart
    slow, fast = -s * A * A * np.expm1(-2 * s * t) / 2, -f * B * B * np.expm1(-2 * f * t) / 2
    return np.asarray((s + f) * (slow + fast) - 2 * s * f * A * B * np.expm1(-(s + f) * t))


def _bisected(above: Callable[[float], float], low: float, high: float | None, step: float) -> float:
    """The zero of a falling function, positive at `low` and negative at `high`; `high` is searched for if None."""
    while high is None or above(high) > 0:
        low, high, step = high or low, (high or low) + step, 2 * step
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if above(middle) > 0 else (low, middle)
    return high


def _exponential(symbol: str, size: float, rate: float) -> ExactMotion:
    return Elementary(
        symbol=symbol,
        exact=lambda t: np.asarray(size * np.exp(-rate * t)),
        played=Decay(size, 0.0, rate, 0.0, pi / 2),
        size=lambda: abs(size),
    )
