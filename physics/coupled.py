"""Two masses and two springs, free (lecture D34, slides 1 to 5).

    wall --k1-- [m1] --k2-- [m2]        x1, x2 to the right, from equilibrium; no friction

    m1 x1'' = -k1 x1 - k2 (x1 - x2)
    m2 x2'' =  k2 (x1 - x2)

With x_i = X_i sin(omega t + phi) both equations agree at two frequencies only. The lecture's
formulas are rearranged so that nothing cancels: with b = m1 k2 + m2 (k1 + k2), D = m1 k2 - m2 (k1 + k2) and
S = sqrt(Delta) = sqrt(D^2 + 4 m1 m2 k2^2),

    omega_-^2 = 2 k1 k2/(b + S),   omega_+^2 = (b + S)/(2 m1 m2),
    omega_+ - omega_- = S/(m1 m2 (omega_- + omega_+)),

and gamma = D/(2 m2 k2), delta = S/(2 m2 k2): one of the ratios X2/X1 = -gamma +- delta is a sum, the other
follows from their product -m1/m2. k1 = 0 and k2 = 0 are physics: the slow mode is then a drift.
"""

from dataclasses import dataclass, fields
from decimal import Decimal
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.oscillator import phase_of
from physics.precision.exact import Array, exact, precise, rounded, snapped, split, sum_of
from physics.sinusoids import ExactSinusoid, added, apart
from physics.valid import check_not_negative, check_positive, finite_array, in_range, keep_doubles

Vector = tuple[Decimal, Decimal]
Vector3 = tuple[Decimal, Decimal, Decimal]
QUANTITIES = (
    "the displacement x1",
    "the displacement x2",
    "the elongation of spring 2",
    "the velocity v1",
    "the velocity v2",
)


class Mode(NamedTuple):
    """One mode in 80 digits: the masses move as shape times one coordinate, shape = (1, X2/X1) or (0, 1).

    Attributes
    ----------
    omega : Decimal
        The natural frequency in rad/s; 0 for a drift.
    shape : tuple of Decimal
        The changes of x1 and x2 by one unit of the coordinate.
    stretch : Decimal
        shape[1] - shape[0], the change of the elongation of spring 2, computed without cancellation.
    mass : Decimal
        m1 shape[0]^2 + m2 shape[1]^2 in kg.
    """

    omega: Decimal
    shape: Vector
    stretch: Decimal  # shape[1] - shape[0], the elongation of spring 2, without its cancellation
    mass: Decimal  # M = m1 shape[0]^2 + m2 shape[1]^2

    @property
    def rows(self) -> tuple[Decimal, Decimal, Decimal]:
        """The changes of x1, x2 and the elongation of spring 2 by one unit of the coordinate."""
        return *self.shape, self.stretch

    def sinusoid(self, q: Decimal, v: Decimal) -> ExactSinusoid:
        """Return x1, x2, e2, v1, v2 of the motion whose coordinate starts from q in m with the velocity v in m/s."""
        with precise():
            rate = -(self.omega**2) * q
            cosine = [*(part * q for part in self.rows), *(part * v for part in self.shape)]
            sine = [*(part * v for part in self.rows), *(part * rate for part in self.shape)]
        return ExactSinusoid(self.omega, cosine, sine)


@dataclass(frozen=True, eq=False)
class Modes:
    """Natural frequencies and mode shapes: the slow mode, then the fast one.

    Attributes
    ----------
    omega : ndarray, shape (2,)
        Natural frequencies in rad/s, within 0.51 ulp.
    omega_lo : ndarray, shape (2,)
        omega + omega_lo is the frequency to 106 bits.
    ratio : ndarray, shape (2,)
        X2/X1, within 0.51 ulp; inf only if the mode leaves mass 1 at rest (k2 = 0), or beyond the range of doubles.
    beat : float
        omega_+ - omega_- in rad/s.
    gamma, delta : float
        X2/X1 = -gamma +- delta. With k2 = 0 the slow mode is mass 2 alone, gamma = -inf and delta = inf.
    """

    omega: Array
    omega_lo: Array
    ratio: Array
    beat: float
    gamma: float
    delta: float


@dataclass(frozen=True, kw_only=True)
class TwoMassChain:
    """Two masses and two springs: wall, k1, m1, k2, m2.

    Parameters
    ----------
    m1, m2 : float
        Masses in kg, above 0.
    k1, k2 : float
        Stiffnesses in N/m, 0 or more.

    Raises
    ------
    ValueError
        If a number is not possible.
    """

    m1: float
    m2: float
    k1: float
    k2: float

    def __post_init__(self) -> None:
        keep_doubles(self, *(field.name for field in fields(self)))
        check_positive("a mass in kg", m1=self.m1, m2=self.m2)
        check_not_negative("a stiffness in N/m", k1=self.k1, k2=self.k2)

    def modes(self) -> Modes:
        """Return both modes, rounded once from 80 digits.

        Returns
        -------
        Modes
            Frequencies in rad/s and the ratios X2/X1, each (2,), with their beat, gamma and delta.
        """
        return self._modes

    @cached_property
    def _modes(self) -> Modes:
        slow, fast = self.exact_modes
        D, S, _ = self._discriminant
        m1, m2, _, k2 = self.exact_parameters
        with precise():
            beat = S / (m1 * m2 * (slow.omega + fast.omega)) if S else fast.omega
            gamma = D / (2 * m2 * k2) if k2 else Decimal("-inf")
            delta = S / (2 * m2 * k2) if k2 else Decimal("inf")
            ratio = [b / a if a else Decimal("inf") for a, b in (slow.shape, fast.shape)]
        hi, lo = np.array([split(mode.omega) for mode in self.exact_modes]).T
        return Modes(hi, lo, np.array([float(r) for r in ratio]), float(beat), float(gamma), float(delta))

    @cached_property
    def exact_parameters(self) -> tuple[Decimal, Decimal, Decimal, Decimal]:
        """m1, m2, k1, k2."""
        return exact(self.m1), exact(self.m2), exact(self.k1), exact(self.k2)

    @cached_property
    def exact_modes(self) -> tuple[Mode, Mode]:
        """The slow mode and the fast one."""
        D, S, b = self._discriminant
        m1, m2, k1, k2 = self.exact_parameters
        with precise():
            omega_minus = (2 * k1 * k2 / (b + S)).sqrt() if b else Decimal(0)
            omega_plus = ((b + S) / (2 * m1 * m2)).sqrt()
            if not k2:
                one, none = Decimal(1), Decimal(0)
                return Mode(none, (none, one), one, m2), Mode(snapped(omega_plus), (one, none), -one, m1)
            in_phase = 2 * m1 * k2 / (D + S) if D > 0 else (S - D) / (2 * m2 * k2)
            against = -(D + S) / (2 * m2 * k2) if D > 0 else -2 * m1 * k2 / (S - D)
        return self._mode(omega_minus, in_phase), self._mode(omega_plus, against)

    @cached_property
    def exact_antiresonance(self) -> Decimal:
        """sqrt(k2/m2) in rad/s: driven at this frequency, mass 1 can be at rest."""
        _, m2, _, k2 = self.exact_parameters
        with precise():
            return snapped((k2 / m2).sqrt())

    def _mode(self, omega: Decimal, ratio: Decimal) -> Mode:
        """Newton's law for mass 2, m2 omega^2 X2 = k2 (X2 - X1), gives the stretch."""
        m1, m2, _, k2 = self.exact_parameters
        omega, ratio = snapped(omega), snapped(ratio)
        with precise():
            stretch = snapped(ratio * m2 * omega**2 / k2)
            return Mode(omega, (Decimal(1), ratio), stretch, m1 + m2 * ratio**2)

    @cached_property
    def _discriminant(self) -> Vector3:
        """D, S and b; the order of the terms of D matters where two of them cancel and the third is small."""
        m1, m2, k1, k2 = self.exact_parameters
        with precise():
            D = m1 * k2 - m2 * k1 - m2 * k2
            return D, (D**2 + 4 * m1 * m2 * k2**2).sqrt(), m1 * k2 + m2 * k1 + m2 * k2


@dataclass(frozen=True, eq=False)
class Motion:
    """The motion of both masses.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in s.
    x, v : ndarray, shape (2, n)
        Displacements in m and velocities in m/s of masses 1 and 2.
    e : ndarray, shape (2, n)
        Elongations in m of springs 1 and 2, not computed from the rounded x.
    """

    t: Array
    x: Array
    v: Array
    e: Array

    def __add__(self, other: "Motion") -> "Motion":
        """ValueError where the sum leaves the range of doubles."""
        with np.errstate(over="ignore"):
            x, v, e = self.x + other.x, self.v + other.v, self.e + other.e
        return Motion(
            self.t, in_range("a displacement", x), in_range("a velocity", v), in_range("the elongation of a spring", e)
        )


@dataclass(frozen=True, eq=False)
class FreeModes:
    """A free motion as the sum of its modes; index j is the mode (slow, fast), i the mass.

    x_i(t) = sum_j amplitude[j, i] sin(omega[j] t + phase[j]), amplitude[j, 0] >= 0, phase in (-pi, pi].
    A mode of zero frequency has amplitude and phase 0; it is the drift drift_a[i] + drift_b[i] t of mass i.
    energy[j] (J) is constant; for a drift it is kinetic. Everything is computed with 80 digits when asked
    for, and a ValueError names the quantity that leaves the range of doubles.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    coordinate : tuple of Decimal
        The coordinate of each mode in m at t = 0, mass 1 (or the mass that moves) being its measure.
    velocity : tuple of Decimal
        The velocity of each coordinate in m/s at t = 0.
    """

    chain: TwoMassChain
    coordinate: Vector  # of each mode at t = 0, mass 1 (or the mass that moves) being its measure
    velocity: Vector

    @property
    def omega(self) -> Array:
        """The natural frequencies (2,) in rad/s."""
        return self.chain.modes().omega

    @property
    def omega_lo(self) -> Array:
        """The rest of the frequencies (2,) in rad/s, beyond 53 bits."""
        return self.chain.modes().omega_lo

    @property
    def amplitude(self) -> Array:
        """The amplitudes (2, 2) of masses 1 and 2 in m, by mode."""
        return self.amplitudes[:, :2]

    @cached_property
    def amplitudes(self) -> Array:
        """The amplitudes of x1, x2 and the elongation of spring 2 (2, 3)."""
        rows = []
        for mode, q, v in self.each():
            with precise():
                size = (q**2 + (v / mode.omega) ** 2).sqrt() if mode.omega else Decimal(0)
                rows.append([rounded("an amplitude", size * part) for part in mode.rows])
        return np.array(rows)

    @cached_property
    def phase(self) -> Array:
        """The phases (2,) in rad."""
        with precise():
            return np.array([phase_of(q * mode.omega, v) if mode.omega else 0.0 for mode, q, v in self.each()])

    @property
    def drift_a(self) -> Array:
        """The starts (2,) of the drifts of masses 1 and 2 in m."""
        return self.drifts[0, :2]

    @property
    def drift_b(self) -> Array:
        """The velocities (2,) of the drifts of masses 1 and 2 in m/s."""
        return self.drifts[1, :2]

    @cached_property
    def drifts(self) -> Array:
        """The starts and the velocities of the drifts of x1, x2 and the elongation of spring 2 (2, 3)."""
        return np.array(
            [
                self._drift("the start of the drift", self.coordinate),
                self._drift("the velocity of the drift", self.velocity),
            ]
        )

    def _drift(self, quantity: str, values: Vector) -> list[float]:
        drifting = [(m.rows, q) for m, q in zip(self.chain.exact_modes, values, strict=True) if not m.omega]
        if not drifting:
            return [0.0, 0.0, 0.0]
        with precise():
            sums = [sum((rows[i] * q for rows, q in drifting), Decimal(0)) for i in (0, 1, 2)]
        return [rounded(quantity, total) for total in sums]

    @cached_property
    def energy(self) -> Array:
        """The energies (2,) of the modes in J."""
        with precise():
            both = [mode.mass * (v**2 + (mode.omega * q) ** 2) / 2 for mode, q, v in self.each()]
        return np.array([rounded("the energy of a mode", energy) for energy in both])

    def parts(self, t: ArrayLike) -> tuple[Motion, Motion]:
        """The motion of each mode at times t (n,), within 2 u of its amplitude.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        tuple of Motion
            The slow mode and the fast one; x, v and e are each (2, n).

        Raises
        ------
        ValueError
            If a time is not finite, or a result leaves the range of doubles.
        """
        t = finite_array("t", t)
        slow, fast = (as_motion(t, values) for values in apart(self._sinusoids(), t, QUANTITIES))
        return slow, fast

    def motion(self, t: ArrayLike) -> Motion:
        """The motion at times t (n,); see free_motion.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        Motion
            x, v and e, each (2, n).

        Raises
        ------
        ValueError
            If a time is not finite, or a result leaves the range of doubles.
        """
        t = finite_array("t", t)
        return as_motion(t, self.values(t))

    def values(self, t: Array) -> Array:
        """Return x1, x2, e2 in m and v1, v2 in m/s as (5, n) at the times t (n,) in s."""
        return added(self._sinusoids(), t, QUANTITIES)

    def _sinusoids(self) -> list[ExactSinusoid]:
        return [mode.sinusoid(q, v) for mode, q, v in self.each()]

    def each(self) -> list[tuple[Mode, Decimal, Decimal]]:
        """Return each mode with its coordinate in m and its velocity in m/s at t = 0."""
        return list(zip(self.chain.exact_modes, self.coordinate, self.velocity, strict=True))


def free_modes(chain: TwoMassChain, x_0: ArrayLike, v_0: ArrayLike) -> FreeModes:
    """The modes of the free motion from displacements x_0 (2,) and velocities v_0 (2,).

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    x_0, v_0 : array_like, shape (2,)
        Displacements in m and velocities in m/s at t = 0.

    Returns
    -------
    FreeModes
        The motion as the sum of its modes.

    Raises
    ------
    ValueError
        If x_0 or v_0 is not two finite numbers.
    """
    return started(chain, each_mass("x_0", x_0), each_mass("v_0", v_0))


def each_mass(name: str, values: ArrayLike) -> Vector:
    """Return two finite numbers, digit for digit.

    Parameters
    ----------
    name : str
        The name of the values in an error message.
    values : array_like, shape (2,)
        A number for each mass.

    Returns
    -------
    tuple of Decimal
        The two doubles without rounding.

    Raises
    ------
    ValueError
        If the values are not two finite numbers.
    """
    entries = finite_array(name, values)
    if entries.shape != (2,):
        raise ValueError(f"{name} = {values!r}: two numbers are needed, one for each mass")
    return exact(entries[0]), exact(entries[1])


def started(chain: TwoMassChain, x_0: Vector, v_0: Vector) -> FreeModes:
    """Return the modes of the free motion from a start in 80 digits.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    x_0, v_0 : tuple of Decimal
        Displacements in m and velocities in m/s of masses 1 and 2 at t = 0.

    Returns
    -------
    FreeModes
        The motion as the sum of its modes.
    """
    (x_slow, x_fast), (v_slow, v_fast) = coordinates(chain, x_0), coordinates(chain, v_0)
    return FreeModes(chain, (x_slow, x_fast), (v_slow, v_fast))


def coordinates(chain: TwoMassChain, values: Vector) -> Vector:
    """The shares of the modes in displacements or velocities, the modes being orthogonal in the masses.

    m1 x1 + m2 r x2 is written with r - 1 in place of r, and for the fast mode with the slow one's, since r =
    1 is where the digits would go.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    values : tuple of Decimal
        Displacements in m, or velocities in m/s, of masses 1 and 2.

    Returns
    -------
    tuple of Decimal
        The coordinates of the slow and of the fast mode, in the unit of the values.
    """
    slow, fast = chain.exact_modes
    m1, m2, _, k2 = chain.exact_parameters
    x1, x2 = values
    if not k2:
        return x2, x1
    with precise():
        momentum, gap = sum_of(m1 * x1, m2 * x2), sum_of(x1, -x2)
        return (
            sum_of(momentum, m2 * slow.stretch * x2) / slow.mass,
            m1 * sum_of(gap, slow.stretch * x1) / (slow.shape[1] * fast.mass),
        )


def free_motion(chain: TwoMassChain, x_0: ArrayLike, v_0: ArrayLike, t: ArrayLike) -> Motion:
    """Return the free motion of both masses.

    It is within 2 u of the sum of its amplitudes while omega_+ t < 1e15. Past that x and v stay on the orbit of the
    fast mode, but its phase is no longer certain.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    x_0, v_0 : array_like, shape (2,)
        Displacements in m and velocities in m/s at t = 0.
    t : array_like, shape (n,)
        Times in s.

    Returns
    -------
    Motion
        x, v and e, each (2, n).

    Raises
    ------
    ValueError
        If a number is not finite, or a result leaves the range of doubles.
    """
    return free_modes(chain, x_0, v_0).motion(t)


def as_motion(t: Array, values: Array) -> Motion:
    """Return the motion whose `values` (5, n) at the times t (n,) in s are x1, x2, e2 in m and v1, v2 in m/s."""
    return Motion(t, values[:2], values[3:], values[0:3:2])
