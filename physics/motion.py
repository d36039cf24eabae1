"""Motions as values: exact at given times, playable by a few numbers, averaged where they are too fast to draw.

A system gives `Elementary` motions. Motions and numbers combine with + - * / and **, so 0.5 * k * x**2 is a motion too.
Factors are decimals: no product of them leaves the range of doubles before the result does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cached_property, lru_cache
from typing import NamedTuple, TypeAlias, TypeVar

import numpy as np

from physics.precision.exact import Array
from physics.sampling import CurveOrBand, Sinusoid, curve_or_band, highest_drawn, root_mean_square

V = TypeVar("V")
ONE = Decimal(1)


class ExactMotion:  # an abstract class would be slower to recognize
    """A quantity that changes with time, in SI units.

    `omega` is the frequency of its fastest oscillation in rad/s, 0 if it does not oscillate. `symbol` names it if a
    scene does not, `size` returns about its largest magnitude.
    """

    omega: float
    symbol: str
    size: Callable[[], float]

    def at(self, t: Array) -> Array:
        """Return the exact values.

        Parameters
        ----------
        t : ndarray (n,)
            Times in s.

        Returns
        -------
        ndarray (n,)
            Values in SI units; infinite where they leave the range of doubles.
        """
        raise NotImplementedError

    @property
    def mean(self) -> ExactMotion:
        """The average over a cycle, slow enough to draw."""
        raise NotImplementedError

    def band(self, drawn: float) -> MotionBand | None:
        """Return the band that it fills.

        Parameters
        ----------
        drawn : float
            Oscillations up to this frequency in rad/s do not count: a line shows them.

        Returns
        -------
        tuple of two ExactMotion, or None
            The lower and the upper edge; None if they are not known.
        """
        raise NotImplementedError

    def extremes(self, t: Array) -> tuple[float, float]:
        """Return the least and the largest value at some times, or of the band that they show.

        Parameters
        ----------
        t : ndarray (n,)
            Times in s.

        Returns
        -------
        tuple of two floats
            Both in SI units.
        """
        low, high = self.band(highest_drawn(t)) or (self, self)
        return float(low.at(t).min()), float(high.at(t).max())

    @property
    def mean_square(self) -> tuple[ExactMotion, ...]:
        """The factors of the average of its square over a cycle, slow enough to draw; none if it is not known."""
        return ()

    def __add__(self, other: ExactMotion | float) -> ExactMotion:
        return MotionPolynomial((*_terms(self), *_terms(other)))

    def __mul__(self, other: ExactMotion | float) -> ExactMotion:
        if isinstance(other, (float, int)):
            return MotionPolynomial(((Decimal(other), (self,)),))
        return MotionPolynomial(((ONE, (self, other)),))

    def __truediv__(self, other: float) -> ExactMotion:
        return MotionPolynomial(((ONE / Decimal(other), (self,)),))

    def __pow__(self, power: int) -> ExactMotion:
        return MotionPolynomial(((ONE, (self,) * power),))

    def __neg__(self) -> ExactMotion:
        return self * -1.0

    def __sub__(self, other: ExactMotion | float) -> ExactMotion:
        return self + -other

    def __rsub__(self, other: float) -> ExactMotion:
        return -self + other

    __radd__, __rmul__ = __add__, __mul__


MotionBand: TypeAlias = tuple[ExactMotion, ExactMotion]
"""The lower and the upper edge of a band."""
MotionTerm: TypeAlias = tuple[Decimal, tuple[ExactMotion, ...]]
"""A factor and the motions that it multiplies."""


def remembered(values: Callable[[Array], V]) -> Callable[[Array], V]:
    """Return the function, which remembers its last result: the quantities of a motion share one computation.

    Parameters
    ----------
    values : callable
        A function of times (n,). It must not refer to an object that keeps a motion made with it: such a cycle waits
        for the garbage collector.

    Returns
    -------
    callable
        The same function, which computes only if the times differ from the last ones.
    """
    at_times = lru_cache(1)(lambda times: values(np.frombuffer(times)))
    return lambda t: at_times(t.tobytes())


def computed_by(exact: Callable[[Array], Array], motion: ExactMotion) -> ExactMotion:
    """Return a sum of motions whose values are computed in a way that loses fewer digits.

    Parameters
    ----------
    exact : callable
        Returns the values (n,) at the times (n,) in s.
    motion : ExactMotion
        The sum, a MotionPolynomial.

    Returns
    -------
    ExactMotion
        The same sum with these values.
    """
    assert isinstance(motion, MotionPolynomial)
    return replace(motion, exact=exact)


def constant(value: float) -> ExactMotion:
    """Return a motion with the same `value` at all times."""
    return MotionPolynomial(_terms(value))


def _terms(one: ExactMotion | float) -> tuple[MotionTerm, ...]:
    return ((Decimal(one), ()),) if isinstance(one, (float, int)) else ((ONE, (one,)),)


@dataclass(frozen=True, eq=False, kw_only=True)
class Elementary(ExactMotion):
    """A motion of a system.

    Attributes
    ----------
    symbol : str
        Its name if a scene gives no other.
    exact : callable
        Returns its values (n,) at the times (n,) in s.
    played : object
        The numbers by which the browser plays it.
    size : callable
        Returns about its largest magnitude.
    omega : float
        The frequency of its fastest oscillation in rad/s; 0 if it does not oscillate.
    amplitude : callable or None
        Returns half the height of the band around 0 that it fills.
    square : callable or None
        Returns the mean of its square.
    """

    symbol: str
    exact: Callable[[Array], Array]
    played: object
    size: Callable[[], float]
    omega: float = 0.0
    amplitude: Callable[[], ExactMotion] | None = None
    square: Callable[[], ExactMotion] | None = None

    def at(self, t: Array) -> Array:
        return self.exact(t)

    @property
    def mean(self) -> ExactMotion:
        return constant(0.0) if self.omega else self

    def band(self, drawn: float) -> MotionBand | None:
        if self.omega <= drawn:
            return self, self
        return (-self.amplitude(), self.amplitude()) if self.amplitude else None

    @property
    def mean_square(self) -> tuple[ExactMotion, ...]:
        return (self.square(),) if self.square else ()


@dataclass(frozen=True)
class Harmonic:
    """a + b t and a sum of sinusoids, by the numbers that the browser plays.

    Attributes
    ----------
    sinusoids : tuple of Sinusoid
        The oscillations.
    line : tuple of two floats
        (a, b): the value at t = 0 without the oscillations, and its rate of change per second.
    """

    sinusoids: tuple[Sinusoid, ...]
    line: tuple[float, float] = (0.0, 0.0)

    @property
    def omega(self) -> float:
        """The highest frequency in rad/s."""
        return max((one.omega for one in self.sinusoids), default=0.0)

    def size(self) -> float:
        """Return about its largest magnitude."""
        return sum(abs(one.amplitude) for one in self.sinusoids) or max(map(abs, self.line)) or 1.0

    def quick(self, t: Array) -> Array:
        """Return its values at the times t (n,), as exact as a plot needs."""
        found = self._base(t)
        for amplitude, omega, phase in self.sinusoids:
            found = found + amplitude * np.sin(omega * t + phase)
        return found

    def drawn(self, t: Array) -> CurveOrBand:
        """Return its values, or the band that it fills between the times.

        Parameters
        ----------
        t : ndarray (n,)
            Rising times in s.

        Returns
        -------
        CurveOrBand
            A curve if the times resolve all oscillations, else a band.
        """
        return curve_or_band(self.sinusoids, t, self._base(t))

    def root_mean_square(self, t: Array) -> Array:
        """Return its size, on average over the cycles that the times do not resolve.

        Parameters
        ----------
        t : ndarray (n,)
            Rising times in s.

        Returns
        -------
        ndarray (n,)
            The root of the mean square.
        """
        return root_mean_square(self.sinusoids, t, self._base(t))

    def _base(self, t: Array) -> Array:
        start, rate = self.line
        return start + rate * t


class SampledCycle(NamedTuple):
    """A motion that repeats after `period`: its values and rates of change at equal steps from 0 to it.

    Attributes
    ----------
    period : float
        The period in s.
    values, rates : ndarray (n,)
        Its values, and its rates of change per second, both ends included.
    """

    period: float
    values: Array
    rates: Array

    def at(self, t: Array) -> Array:
        """Return the values as the browser joins the samples.

        Parameters
        ----------
        t : ndarray (n,)
            Times in s.

        Returns
        -------
        ndarray (n,)
            Values in the unit of the samples.
        """
        steps = len(self.values) - 1
        place = np.mod(t, self.period) / self.period * steps
        i = np.minimum(place.astype(int), steps - 1)
        s, rise = place - i, self.values[i + 1] - self.values[i]
        first, last = self.rates[i] * self.period / steps, self.rates[i + 1] * self.period / steps
        found: Array = self.values[i] + s * (first + s * (3 * rise - 2 * first - last + s * (first + last - 2 * rise)))
        return found


@dataclass(frozen=True, eq=False)
class MotionPolynomial(ExactMotion):
    """A sum of products of motions, each with a factor.

    Attributes
    ----------
    terms : tuple of MotionTerm
        The factors, each with the motions that it multiplies.
    exact : callable or None
        Returns the values (n,) at the times (n,) in s, if the sum of the terms would lose digits.
    symbol : str
        Its name if a scene gives no other.
    """

    terms: tuple[MotionTerm, ...]
    exact: Callable[[Array], Array] | None = None
    symbol: str = "part"

    def size(self) -> float:
        return 1.0

    @cached_property
    def omega(self) -> float:  # type: ignore[override]
        return max((sum(one.omega for one in motions) for _, motions in self.terms), default=0.0)

    def at(self, t: Array) -> Array:
        if self.exact:
            return self.exact(t)
        with np.errstate(over="ignore", invalid="ignore"):
            parts = self.flat(whole=lambda one: isinstance(one, MotionPolynomial) and one.exact is not None)
            total, *others = [_product(factor, motions, t) for factor, motions in parts]
            for one in others:
                total = total + one
        return total

    @property
    def mean(self) -> ExactMotion:
        return MotionPolynomial(tuple((factor, _averaged(motions)) for factor, motions in self.flat()))

    def band(self, drawn: float) -> MotionBand | None:
        bands = [_band(factor, motions, drawn) for factor, motions in self.flat()]
        known = [band for band in bands if band]
        low, high = (MotionPolynomial(tuple((ONE, (band[i],)) for band in known)) for i in (0, 1))
        return (low, high) if len(known) == len(bands) else None

    def flat(self, whole: Callable[[ExactMotion], bool] = lambda motion: False) -> Iterator[MotionTerm]:
        """Return the terms with single products multiplied out, except the motions that stay `whole`."""
        for factor, motions in self.terms:
            parts: list[ExactMotion] = []
            for one in motions:
                if isinstance(one, MotionPolynomial) and len(one.terms) == 1 and not whole(one):
                    ((inner, more),) = one.flat(whole)
                    factor, parts = factor * inner, [*parts, *more]
                else:
                    parts.append(one)
            yield factor, tuple(parts)


def added(*motions: ExactMotion) -> ExactMotion:
    """Return the sum of motions."""
    return MotionPolynomial(tuple((ONE, (one,)) for one in motions))


@dataclass(frozen=True, eq=False)
class Superposition(MotionPolynomial):
    """A sum of motions that are played by harmonics. It knows which of them are close in frequency and beat.

    Attributes
    ----------
    harmonic : Harmonic
        The numbers by which the browser plays the sum.
    """

    harmonic: Harmonic = Harmonic(())

    def size(self) -> float:
        return self.harmonic.size()

    def extremes(self, t: Array) -> tuple[float, float]:
        if self.omega > highest_drawn(t):
            return super().extremes(t)
        values = self.harmonic.quick(t)
        return float(values.min()), float(values.max())

    def band(self, drawn: float) -> MotionBand:
        drawn_at = remembered(self.harmonic.drawn)
        return _slow(lambda t: drawn_at(t).lo), _slow(lambda t: drawn_at(t).hi)

    @property
    def mean_square(self) -> tuple[ExactMotion, ...]:
        root = _slow(self.harmonic.root_mean_square)
        return root, root


def superposed(symbol: str, *parts: Elementary, exact: Callable[[Array], Array] | None = None) -> Superposition:
    """Return the sum of motions that are played by harmonics.

    Parameters
    ----------
    symbol : str
        Its name if a scene gives no other.
    *parts : Elementary
        The motions.
    exact : callable or None
        Returns the values of the sum, if the sum of the parts would lose digits.

    Returns
    -------
    Superposition
        The sum, with the harmonic that plays it.
    """
    harmonics = [one.played for one in parts if isinstance(one.played, Harmonic)]
    starts, rates = zip(*(one.line for one in harmonics), strict=True)
    whole = Harmonic(tuple(wave for one in harmonics for wave in one.sinusoids), (sum(starts), sum(rates)))
    return Superposition(tuple((ONE, (one,)) for one in parts), exact, symbol, whole)


def harmonic_motion(symbol: str, harmonic: Harmonic, exact: Callable[[Array], Array]) -> Elementary:
    """Return the motion that a harmonic plays, with its exact values.

    Parameters
    ----------
    symbol : str
        Its name if a scene gives no other.
    harmonic : Harmonic
        The numbers by which the browser plays it.
    exact : callable
        Returns the values (n,) at the times (n,) in s.

    Returns
    -------
    Elementary
        The motion.
    """
    return Elementary(
        symbol=symbol, exact=exact, played=harmonic, size=harmonic.size, omega=harmonic.omega,
        amplitude=lambda: _slow(lambda t: harmonic.drawn(t).hi),
    )  # fmt: skip


def _slow(values: Callable[[Array], Array]) -> ExactMotion:
    """A slow motion that is never played."""
    return Elementary(symbol="", exact=values, played=None, size=lambda: 1.0)


def _product(factor: Decimal, motions: tuple[ExactMotion, ...], t: Array) -> Array:
    """Return the values of a product (n,), even if a factor alone leaves the range of doubles."""
    if len(motions) == 1 and abs(factor) == 1:
        return motions[0].at(t) if factor > 0 else -motions[0].at(t)
    base, exponent = np.frexp(float(factor))
    values, exponents = np.ones_like(t), np.full(t.shape, exponent)
    for one in motions:
        mantissas, powers = np.frexp(one.at(t))
        values, exponents = values * mantissas, exponents + powers
    return np.asarray(np.ldexp(base * values, exponents))


def _band(factor: Decimal, motions: tuple[ExactMotion, ...], drawn: float) -> MotionBand | None:
    """The band of a product: known if it is slow, or a multiple of one motion or of its square."""
    if not motions or sum(one.omega for one in motions) <= drawn:
        slow = MotionPolynomial(((factor, motions),))
        return slow, slow
    first, *others = motions
    band = first.band(0.0 if others else drawn)
    if not band or others not in ([], [first]) or (others and not isinstance(first, Elementary)):
        return None
    edges = (constant(0.0), band[1] ** 2) if others else band
    low, high = edges if factor > 0 else edges[::-1]
    return MotionPolynomial(((factor, (low,)),)), MotionPolynomial(((factor, (high,)),))


def _averaged(motions: Iterable[ExactMotion]) -> tuple[ExactMotion, ...]:
    """The factors of the mean of a product: the slow motions, and the mean of the fast one or of its square."""
    slow, fast = [one for one in motions if not one.omega], [one for one in motions if one.omega]
    if len(fast) < 2:
        return (*slow, *(one.mean for one in fast))
    first, *others = fast
    if others == [first] and first.mean_square:
        return (*slow, *first.mean_square)
    raise NotImplementedError("The mean of this product of fast motions is unknown: its system has to give it.")
