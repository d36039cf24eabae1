r"""One oscillator with a dashpot: what the lecture leaves out of D31, in one expression for every damping.

    wall --/\/\/ k \/\/\--+
                          [m] --> x        m x'' + c x' + k x = 0
    wall ------[ c ]------+

With a = c/2m and omega_n^2 = k/m the exponents are -a +- sqrt(a^2 - omega_n^2). Let sigma be the rate at which the
slower part dies, omega_d = sqrt(omega_n^2 - a^2) or 0, and beta = sqrt(a^2 - omega_n^2) or 0, whichever is real:

    x = exp(-sigma t) (x_0 cos(omega_d t) + (v_0 + sigma x_0) S(t)),

    S = sin(omega_d t)/omega_d   or   (1 - exp(-2 beta t))/(2 beta),   both t at critical damping.

sigma is a up to critical damping and omega_n^2/(a + beta) beyond, where a - beta would cancel. v and a obey the same
equation from (v_0, a_0) and (a_0, a_0').

FreeDecay is one such motion from its initial conditions: x and v as motions, its turns and its greatest speed, when it
has settled, what it has lost.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), section 2.6.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property, lru_cache
from itertools import pairwise
from math import inf, pi
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.curves import ScaledCurve, combined, product, turning
from physics.elementary import SMALLEST_EXPONENT, exponential
from physics.exact import Array, angle, exact, pair_sum, precise, rounded, sum_of, two_sum, within_an_ulp
from physics.motion import Elementary, ExactMotion
from physics.oscillator import OscillatorMotion, phase_of
from physics.valid import check_finite, check_not_negative, check_positive, finite_array, in_range

QUANTITIES = ("the displacement", "the velocity", "the acceleration")
NONE = Decimal(0)
_SAME = Decimal("1e-6")  # of a: exponents closer than this make one term in doubles
_SHORT = 2.0**-20  # of 2 beta t: S takes three terms of its series

_LIGHT, _HEAVY = 0.5, 2.0  # of zeta: beyond them the energy lost has a form without a difference
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(12)
_HALVINGS = 80

Start = tuple[Decimal, Decimal]  # a value and its rate at t = 0
Regime = Literal["under", "critical", "over"]


class Decay(NamedTuple):
    """(amplitude + slope t) exp(-rate t) sin(omega t + phase); a plain exponential has omega = 0, phase = pi/2."""

    amplitude: float
    slope: float
    rate: float
    omega: float
    phase: float


class Fading(NamedTuple):
    """exp(-slow t) (start C + rate S) as above, for a signal: the rates in 1/s, `apart` = 2 beta, `swing` = omega_d;
    `late` are the sizes of both exponentials where it does not swing."""

    start: float
    rate: float
    slow: float
    apart: float
    swing: float
    late: tuple[float, float]

    def at(self, t: Array) -> Array:
        """The motion at the times t in s, in doubles: as it is drawn."""
        if self.apart:
            parted = self.apart * t > 1
            late = self.late[0] * np.exp(-self.slow * t) + self.late[1] * np.exp(-(self.slow + self.apart) * t)
            soon = np.exp(-self.slow * t) * (self.start - self.rate * np.expm1(-self.apart * t) / self.apart)
            return np.where(parted, late, soon)
        sine = np.sin(self.swing * t) / self.swing if self.swing else t
        return np.asarray(np.exp(-self.slow * t) * (self.start * np.cos(self.swing * t) + self.rate * sine))


class Moment(NamedTuple):
    """A time in s with x in m and v in m/s."""

    t: float
    x: float
    v: float


@dataclass(frozen=True, kw_only=True)
class DampedOscillator:
    """A mass m (kg) on a spring k (N/m) and a dashpot c (N s/m)."""

    m: float
    c: float
    k: float

    def __post_init__(self) -> None:
        check_positive("a mass in kg", m=self.m)
        check_not_negative("a damping in N s/m", c=self.c)
        check_not_negative("a stiffness in N/m", k=self.k)

    @cached_property
    def omega_n(self) -> float:
        """The natural frequency without damping, in rad/s."""
        with precise():
            return float((exact(self.k) / exact(self.m)).sqrt())

    @cached_property
    def omega_d(self) -> float:
        """The frequency of the damped swing, in rad/s; 0 from critical damping on."""
        return float(self._swing)

    @cached_property
    def zeta(self) -> float:
        """c over the critical damping 2 sqrt(k m); 1 is critical."""
        if not self.c:
            return 0.0
        with precise():
            return float(exact(self.c) / (2 * (exact(self.k) * exact(self.m)).sqrt())) if self.k else inf

    @property
    def regime(self) -> Regime:
        """Whether it swings: critical is the double nearest to 2 sqrt(k m), and those next to it."""
        with precise():
            if self.k and within_an_ulp(self.c, 2 * (exact(self.k) * exact(self.m)).sqrt()):
                return "critical"
        return "under" if self._excess < 0 else "over"

    @cached_property
    def rates(self) -> tuple[float, float]:
        """The rates in 1/s at which the slower and the faster part die; equal where it swings."""
        with precise():
            return float(self._sigma), float(self._sigma + 2 * self._beta)

    @cached_property
    def log_decrement(self) -> float:
        """delta = 2 pi a/omega_d, the logarithm of a peak over the next one; infinite where it does not swing."""
        with precise():
            return float(2 * Decimal(pi) * self._a / self._swing) if self._swing else inf

    def motion(self, x_0: float, v_0: float, t: ArrayLike) -> OscillatorMotion:
        """x, v, a (n,) from x(0) = x_0, x'(0) = v_0 at the times t (n,) in s, 0 or more.

        Within 2 u of the sum of the sizes of both parts; a part that has died down to 1e-260 counts as nothing.
        """
        t = finite_array("t", t)
        check_not_negative("a time in s", t=float(np.min(t, initial=0.0)))
        starts = self._starts(x_0, v_0)
        result = np.empty((3, t.size))
        with precise():
            late = t > (float(1 / (2 * self._beta)) if self._beta else inf)
        for where, form in ((~late, self._together), (late, self._apart)):
            if np.any(where):
                result[:, where] = combined(*form(starts, t[where]), QUANTITIES)
        x, v, acceleration = result
        return OscillatorMotion(t=t, x=x, v=v, a=acceleration)

    def decays(self, x_0: float, v_0: float) -> tuple[Decay, ...]:
        """x as a sum for a signal, in doubles: one damped swing, or two exponentials.

        Where the exponents differ by less than 1e-6 of themselves, one exponential with a slope.
        """
        start = self._starts(x_0, v_0)[0]
        with precise():
            x, w = start[0], sum_of(start[1], self._sigma * start[0])
            apart = 2 * self._beta
            if self._swing > _SAME * self._a:
                sine = w / self._swing
                return (_decay((x * x + sine * sine).sqrt(), NONE, self._sigma, self._swing, phase_of(x, sine)),)
            if apart > _SAME * self._a:
                slow, fast = sum_of(x, w / apart), -w / apart
                return _decay(slow, NONE, self._sigma), _decay(fast, NONE, self._sigma + apart)
            return (_decay(x, w, self._sigma),)

    def fading(self, x_0: float, v_0: float) -> tuple[Fading, Fading, Fading]:
        """x, v and a for signals: regular at critical damping."""
        found = []
        for row, (value, rate) in zip(QUANTITIES, self._starts(x_0, v_0), strict=True):
            with precise():
                w, apart = sum_of(rate, self._sigma * value), 2 * self._beta
                late = (sum_of(value, w / apart), -w / apart) if apart else (NONE, NONE)
                numbers = (rounded(row, value), rounded(row, w), float(self._sigma), float(apart), float(self._swing))
            found.append(Fading(*numbers, (rounded(row, late[0]), rounded(row, late[1]))))
        x, v, a = found
        return x, v, a

    @cached_property
    def _a(self) -> Decimal:
        with precise():
            return exact(self.c) / (2 * exact(self.m))

    @cached_property
    def _excess(self) -> Decimal:
        """a^2 - omega_n^2: below 0 it swings."""
        m, c, k = exact(self.m), exact(self.c), exact(self.k)
        with precise():
            return sum_of(c * c, -4 * m * k) / (4 * m * m)

    @cached_property
    def _swing(self) -> Decimal:
        with precise():
            return max(-self._excess, NONE).sqrt()

    @cached_property
    def _beta(self) -> Decimal:
        with precise():
            return max(self._excess, NONE).sqrt()

    @cached_property
    def _sigma(self) -> Decimal:
        with precise():
            return exact(self.k) / exact(self.m) / (self._a + self._beta) if self._beta else self._a

    def _starts(self, x_0: float, v_0: float) -> list[Start]:
        """The start of x, v and a, each with its rate."""
        check_finite("a displacement in m", x_0=x_0)
        check_finite("a velocity in m/s", v_0=v_0)
        m, c, k = exact(self.m), exact(self.c), exact(self.k)
        values = [exact(x_0), exact(v_0)]
        with precise():
            for _ in range(2):
                values.append(sum_of(-k * values[-2], -c * values[-1]) / m)
        return list(pairwise(values))

    def _together(self, starts: list[Start], t: Array) -> tuple[list[Start], list[ScaledCurve]]:
        """Both exponents in one expression, while exp(-2 beta t) has not parted from 1."""
        decay = _dying(self._sigma, t)
        cosine, sine = turning(self._swing, t)
        curves = [product(decay, cosine), product(decay, _parting(self._beta, t) if self._beta else sine)]
        return [(x, sum_of(v, self._sigma * x)) for x, v in starts], curves

    def _apart(self, starts: list[Start], t: Array) -> tuple[list[Start], list[ScaledCurve]]:
        """Each exponent by itself, so that one keeps its digits where the other has little share."""
        x, v = starts[0]
        with precise():
            apart = 2 * self._beta
            fast = self._sigma + apart
            A, B = sum_of(v, fast * x) / apart, -sum_of(v, self._sigma * x) / apart
            rows = [(A, B), (-self._sigma * A, -fast * B), (self._sigma**2 * A, fast**2 * B)]
        return rows, [_dying(self._sigma, t), _dying(fast, t)]


@dataclass(frozen=True, kw_only=True)
class FreeDecay:
    """A motion of a damped oscillator from x(0) = x_0 (m), x'(0) = v_0 (m/s)."""

    oscillator: DampedOscillator
    x_0: float
    v_0: float

    @cached_property
    def x(self) -> ExactMotion:
        """The displacement in m. Where it oscillates it fills its envelope, and the spring has half of the energy."""
        one = self.oscillator
        return Elementary(
            symbol="x", exact=lambda t: self._motion(t).x, played=self.fadings[0], size=self.reach, omega=one.omega_d,
            band=lambda: self.envelope, square=lambda: self._decaying_energy / one.k,
        )  # fmt: skip

    @cached_property
    def v(self) -> ExactMotion:
        """The velocity in m/s. Where it oscillates the mass has half of the energy on average."""
        one = self.oscillator
        return Elementary(
            symbol="v", exact=lambda t: self._motion(t).v, played=self.fadings[1], size=lambda: abs(self.fastest.v),
            omega=one.omega_d, square=lambda: self._decaying_energy / one.m,
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
        found = self.first_top_speed
        moments = self.moments([0.0] if found is None else [0.0, found])
        return max(moments, key=lambda moment: abs(moment.v))

    def peaks(self, count: int) -> list[Moment]:
        """Return the first turns on the side of the first one, where it oscillates; at rest the start is a turn."""
        first, tau = 0.0 if not self.v_0 else self.first_turn or 0.0, 2 * pi / self.oscillator.omega_d
        return self.moments([first + i * tau for i in range(count)])

    def reach(self, end: float = inf) -> float:
        """Return the largest |x| in m up to the time `end` in s."""
        turn = self.first_turn
        times = [0.0, *([] if turn is None or turn > end else [turn]), *([end] if end < inf else [])]
        return max(abs(moment.x) for moment in self.moments(times))

    def moments(self, times: list[float]) -> list[Moment]:
        """Return the motion at these times in s."""
        motion = self.oscillator.motion(self.x_0, self.v_0, times)
        return list(map(Moment, times, motion.x.tolist(), motion.v.tolist()))

    @cached_property
    def _decaying_energy(self) -> ExactMotion:
        """The energy in J, averaged over a cycle of light damping."""
        rate = self.oscillator.rates[0]

        def energy(t: Array) -> Array:
            decay = np.exp(-rate * t)
            return np.asarray(self.E_0 * decay * decay)

        played = Decay(self.E_0, 0.0, 2 * rate, 0.0, pi / 2)
        return Elementary(symbol="energy", exact=energy, played=played, size=lambda: self.E_0)

    def _motion(self, t: Array) -> OscillatorMotion:
        return self._motions(t.tobytes())

    @cached_property
    def _motions(self) -> Callable[[bytes], OscillatorMotion]:
        """The motion at the times in a buffer: x, v and what is made of them share one computation."""
        return lru_cache(1)(lambda times: self.oscillator.motion(self.x_0, self.v_0, np.frombuffer(times)))

    @property
    def first_zero(self) -> float | None:
        """The time in s at which x passes 0 first, after the start; None where it never does."""
        return self._crossing(0)

    @property
    def first_turn(self) -> float | None:
        """The time in s at which it turns first, after the start; None where it never does."""
        return self._crossing(1)

    @property
    def first_top_speed(self) -> float | None:
        """The time in s at which |v| is greatest first, after the start, and with it the power lost."""
        return self._crossing(2)

    def settled(self, share: float) -> float | None:
        """The time in s from which |x| stays below that share (under 1) of |x_0|; None where there is none.

        To 1e-8 of itself where critical damping is within 1e-8, else to the digits of a double.
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
        """The energy in J that the dashpot has taken by the times t (n,) in s, within 64 u of itself.

        At first by quadrature of c v^2, whose terms are all positive; then by forms without a difference, or where none
        cancels as the difference of the energies.
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
        value, rate = one._starts(self.x_0, self.v_0)[row]
        with precise():
            w, apart = sum_of(rate, one._sigma * value), 2 * one._beta
            if one._swing:
                size = abs(value) + abs(w) / one._swing
                if not size:
                    return None
                side = -1 if value > 0 else 1
                turned = math.atan2(abs(value) / size, side * w / one._swing / size) if value else pi
                return float(Decimal(turned) / one._swing)
            if not value or not w or value / w > 0:
                return None
            if not apart:
                return float(-value / w)
            left = sum_of(w, apart * value) / w
            return float(-left.ln() / apart) if left > 0 else None

    def _place(self, t: float) -> float:
        """x at a time, in plain doubles."""
        one, (slow, fast) = self.oscillator, self.oscillator.rates
        omega, apart = one.omega_d, float(2 * one._beta)
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
    apart = float(2 * one._beta)
    A, B = (v + f * x) / apart, -(v + s * x) / apart
    slow, fast = -s * A * A * np.expm1(-2 * s * t) / 2, -f * B * B * np.expm1(-2 * f * t) / 2
    return np.asarray((s + f) * (slow + fast) - 2 * s * f * A * B * np.expm1(-(s + f) * t))


def _bisected(above: Callable[[float], float], low: float, high: float | None, step: float) -> float:
    """Where a function falls through 0 after `low`, where it is above; `high`, where it is below, is sought if None."""
    while high is None or above(high) > 0:
        low, high, step = high or low, (high or low) + step, 2 * step
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if above(middle) > 0 else (low, middle)
    return high


def _dying(rate: Decimal, t: Array) -> ScaledCurve:
    """exp(-rate t), nothing below 1e-260."""
    with precise():
        gone = t > (float(-Decimal(SMALLEST_EXPONENT) / rate) if rate else inf)
    hi, lo = exponential(angle(-rate, np.where(gone, 0.0, t)))
    return ScaledCurve(np.where(gone, 0.0, hi), np.where(gone, 0.0, lo), Decimal(1))


def _parting(beta: Decimal, t: Array) -> ScaledCurve:
    """(1 - exp(-2 beta t))/(2 beta), up to 2 beta t = 1."""
    with precise():
        y, y_lo = angle(2 * beta, t)
        hi, lo = exponential((-y, -y_lo))
        whole = pair_sum((np.ones_like(t), np.zeros_like(t)), (-hi, -lo))
        first = two_sum(y, y_lo - y * (y / 2) * (1 - y / 3))
        short = y < _SHORT
        hi, lo = np.where(short, first, whole)
        return ScaledCurve(hi, lo, 1 / (2 * beta))


def _exponential(symbol: str, size: float, rate: float) -> ExactMotion:
    return Elementary(
        symbol=symbol,
        exact=lambda t: np.asarray(size * np.exp(-rate * t)),
        played=Decay(size, 0.0, rate, 0.0, pi / 2),
        size=lambda: abs(size),
    )


def _decay(amplitude: Decimal, slope: Decimal, rate: Decimal, omega: Decimal = NONE, phase: float = pi / 2) -> Decay:
    sizes = rounded("the amplitude", amplitude), rounded("the slope", slope)
    return Decay(*sizes, float(rate), float(omega), phase)
