"""Peaks, dips and half-power points of the response of a damped chain and of a driven mass.

In w = omega^2 the square of an amplitude is a quotient A/B of polynomials with rational coefficients. Its extremes are
roots of A' B - A B', and with A0/B0 the square of a peak 2 A B0 - A0 B is 0 where half of its power is left. For the
chain, with P = p4 s^4 + ... + p0 of physics.transient,

    B = (p4 w^2 - p2 w + p0)^2 + w (p1 - p3 w)^2,
    A = (k2 - m2 w)^2 + c2^2 w for X1,   k2^2 + c2^2 w for X2,   (m2 w)^2 for the stroke X2 - X1.

No peak is exactly at a natural frequency, at Im s or at |s| unless damping is absent.

Source: beyond lecture D34, slide 8; J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.10 and 3.3.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

from physics.damped_chain import DampedChain
from physics.driven import Drive, DrivenOscillator, check_drive_kind
from physics.precision.polynomials import (
    DIGITS,
    Polynomial,
    added,
    context,
    derivative,
    negative,
    numbers,
    positive_roots,
    product,
    reduced,
    trimmed,
)
from physics.precision.roots import horner, roots

_SAME = 1e-50  # roots with 120 digits that are closer than this, relatively, are equal


class ResponsePeak(NamedTuple):
    """A peak or a dip: its frequency in rad/s, and the amplitude there, over the size of the drive.

    Attributes
    ----------
    omega : float
        The frequency in rad/s.
    height : float
        The amplitude over the size of the drive: in m/N for a force.
    half_power : tuple of float or None
        The frequencies in rad/s below and above a peak at which the amplitude is 1/sqrt(2) of it; None if another
        extreme comes first, or 0.
    """

    omega: float
    height: float
    half_power: tuple[float | None, float | None] = (None, None)

    @property
    def ends(self) -> tuple[float, float] | None:
        """The frequencies of half its power, if it has both."""
        low, high = self.half_power
        return (low, high) if low and high else None

    @property
    def width(self) -> float | None:
        """The width at half its power in rad/s, if it has one."""
        return self.ends[1] - self.ends[0] if self.ends else None


class Resonances(NamedTuple):
    """Peaks, dips, and the frequencies in rad/s at which the amplitude is infinite, lowest first; all rounded once.

    Attributes
    ----------
    peaks, dips : tuple of ResponsePeak
        The peaks and the dips.
    poles : tuple of float
        The frequencies in rad/s at which the amplitude is infinite.
    """

    peaks: tuple[ResponsePeak, ...]
    dips: tuple[ResponsePeak, ...]
    poles: tuple[float, ...]


class ChainResonances(NamedTuple):
    """Peaks and dips of |X1|, |X2| and |X2 - X1| in m over F_0 in N.

    Attributes
    ----------
    X1, X2 : Resonances
        Those of mass 1 and of mass 2.
    stroke : Resonances
        Those of X2 - X1.
    """

    X1: Resonances
    X2: Resonances
    stroke: Resonances


@lru_cache(64)  # cached, because a scene needs it again for each change of its drive
def chain_resonances(chain: DampedChain) -> ChainResonances:
    """Return the peaks and dips of the chain under a force on mass 1.

    Parameters
    ----------
    chain : DampedChain
        The masses, springs and dashpots.

    Returns
    -------
    ChainResonances
        Frequencies in rad/s and heights in m/N, rounded once from 120 digits.
    """
    p0, p1, p2, p3, p4, m2, k2, c2 = _coefficients(chain)
    real, turned = (p0, -p2, p4), (p1, -p3)
    below = added(product(real, real), product((Fraction(0), Fraction(1)), turned, turned))
    above = (k2**2, c2**2 - 2 * k2 * m2, m2**2), (k2**2, c2**2), (Fraction(0), Fraction(0), m2**2)
    return ChainResonances(*(resonances(one, below) for one in above))


def driven_resonances(oscillator: DrivenOscillator, kind: Drive = "force") -> Resonances:
    """Return the peaks of |X| over F_0, over Y or over mu e.

    Parameters
    ----------
    oscillator : DrivenOscillator
        The mass, the dashpot and the spring.
    kind : {"force", "base", "unbalance"}
        The kind of drive.

    Returns
    -------
    Resonances
        Frequencies in rad/s; heights in m/N for a force, without unit for a base, in 1/kg for an unbalance.

    Raises
    ------
    ValueError
        If there is no drive of this kind.
    """
    check_drive_kind(kind)
    m, c, k = map(Fraction, (oscillator.m, oscillator.c, oscillator.k))
    none, one = Fraction(0), Fraction(1)
    above = {"force": (one,), "base": (k * k, c * c), "unbalance": (none, none, one)}[kind]
    return resonances(above, (k * k, c * c - 2 * m * k, m * m))


def magnification_peak(oscillator: DrivenOscillator, kind: Drive = "force") -> ResponsePeak | None:
    """The peak of the magnification: |X| over F_0/k, over Y, or over mu e/m.

    Parameters
    ----------
    oscillator : DrivenOscillator
        The mass, the dashpot and the spring.
    kind : {"force", "base", "unbalance"}
        The kind of drive.

    Returns
    -------
    ResponsePeak or None
        Frequencies in rad/s and a height without unit; None if there is no peak.

    Raises
    ------
    ValueError
        If there is no drive of this kind.
    """
    check_drive_kind(kind)
    unit = {"force": oscillator.k, "base": 1.0, "unbalance": oscillator.m}[kind]
    return next((one._replace(height=unit * one.height) for one in driven_resonances(oscillator, kind).peaks), None)


def quarter_lags(chain: DampedChain) -> tuple[float, ...]:
    """The frequencies in rad/s at which mass 1 lags by a quarter turn: Re X1 = 0, in which c1 has no part.

    For c2 = 0 these frequencies are the natural ones and sqrt(k2/m2). There mass 1 may be at rest, and its lag jumps.

    Parameters
    ----------
    chain : DampedChain
        The masses, springs and dashpots.

    Returns
    -------
    tuple of float
        The frequencies in rad/s, the lowest first, rounded once from 120 digits.
    """
    p0, p1, p2, p3, p4, m2, k2, c2 = _coefficients(chain)
    real = added(product((p0, -p2, p4), (k2, -m2)), product((Fraction(0), c2), (p1, -p3)))
    return tuple(float(w**0.5) for w, _ in positive_roots(real))


def resonances(above: Polynomial, below: Polynomial) -> Resonances:
    """Return peaks, dips and poles of sqrt(above/below) over w > 0, polynomials in w; `below` is nowhere negative.

    Parameters
    ----------
    above, below : tuple of Fraction
        Coefficients of the polynomials in w = omega^2, the constant first.

    Returns
    -------
    Resonances
        Frequencies sqrt(w) in rad/s, and heights sqrt(above/below); empty if `above` is 0.
    """
    above, below = reduced(above, below)
    if not above:
        return Resonances((), (), ())
    poles, zeros = ([w for w, _ in positive_roots(one)] for one in (below, above))
    slope = trimmed(added(product(derivative(above), below), negative(product(above, derivative(below)))))
    turns = [w for w, times in positive_roots(slope) if times % 2] if slope else []
    ends = [context(DIGITS).zero, *turns, context(DIGITS).inf]
    peaks, dips, rises = [], [], bool(slope) and (slope[-1] > 0) == (len(turns) % 2 == 0)
    for low, w, high in zip(ends, turns, ends[2:], strict=False):
        if rises and not _among(w, poles):
            peaks.append(_peak(above, below, w, (low, high)))
        elif not rises:
            height = 0.0 if _among(w, zeros) else float(_height(above, below, w))
            dips.append(ResponsePeak(float(w**0.5), height))
        rises = not rises
    return Resonances(tuple(peaks), tuple(dips), tuple(float(w**0.5) for w in poles))


def _peak(above: Polynomial, below: Polynomial, w: Any, ends: tuple[Any, Any]) -> ResponsePeak:
    """The peak at w, between the extremes before and after it."""
    ctx = context(DIGITS)
    A, B = (numbers(ctx, one) for one in (above, below))
    top, bottom, longest = horner(A, w), horner(B, w), max(len(A), len(B))
    A, B = (one + [ctx.zero] * (longest - len(one)) for one in (A, B))
    level = [2 * a * bottom - top * b for a, b in zip(A, B, strict=True)]
    first = next(i for i, one in enumerate(level) if one)
    half = [s.real for s in roots(ctx, level[first:]) if not s.imag]
    before = max((s for s in half if ends[0] < s < w), default=None)
    after = min((s for s in half if w < s < ends[1]), default=None)
    sides = tuple(None if s is None else float(ctx.sqrt(s)) for s in (before, after))
    return ResponsePeak(float(ctx.sqrt(w)), float(_height(above, below, w)), (sides[0], sides[1]))


def _height(above: Polynomial, below: Polynomial, w: Any) -> Any:
    ctx = context(DIGITS)
    return ctx.sqrt(horner(numbers(ctx, above), w) / horner(numbers(ctx, below), w))


def _among(w: Any, others: Sequence[Any]) -> bool:
    return any(abs(w - other) <= _SAME * w for other in others)


def _coefficients(chain: DampedChain) -> tuple[Fraction, ...]:
    """p0 to p4, m2, k2 and c2."""
    m1, m2, k1, k2, c1, c2 = map(Fraction, (chain.m1, chain.m2, chain.k1, chain.k2, chain.c1, chain.c2))
    p2, p3 = m1 * k2 + m2 * (k1 + k2) + c1 * c2, m1 * c2 + m2 * (c1 + c2)
    return k1 * k2, c1 * k2 + c2 * k1, p2, p3, m1 * m2, m2, k2, c2
