"""A machine with a tuned absorber (lecture D34, notes), and damping between the two (beyond the lecture).

    wall --k1-- [m1] --k2, c-- [m2]        F_0 sin(omega t) on m1, the machine; m2 is the absorber

    m1 x1'' = -k1 x1 - k2 (x1 - x2) - c (x1' - x2') + F_0 sin(omega t)
    m2 x2'' =  k2 (x1 - x2) + c (x1' - x2')

With x_i = Im(X_i exp(i omega t)), and with kappa = k2 + i c omega in the place of k2, the lecture's formulas hold:

    X1 = (kappa - m2 omega^2) F_0/D,   X2 = kappa F_0/D,
    D = (k1 - m1 omega^2)(kappa - m2 omega^2) - m2 omega^2 kappa.

Every number is a double, so N, kappa and D are whole numbers times powers of two: amplitudes come from
these without error and are rounded once, next to a resonance and at the ends of the range of doubles too.
Source of what is beyond the lecture: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), section 3.3.
"""

import math
from decimal import Decimal
from typing import NamedTuple

import numpy as np
from numpy.polynomial.polynomial import polyder, polyroots, polyval
from numpy.typing import ArrayLike, NDArray

from physics.coupled import TwoMassChain
from physics.forced import particular_solution
from physics.precision.exact import Array, exact, precise, rounded
from physics.valid import DOUBLES, check_finite, check_not_negative, check_positive, finite_array

_BITS = 120  # bits of a modulus before it is rounded to the 53 of a double

Band = tuple[float, float]


class Optimum(NamedTuple):
    """The absorber of Den Hartog's rule.

    Attributes
    ----------
    k2 : float
        Its stiffness in N/m.
    c : float
        Its damping in N s/m.
    height : float
        The amplitude of the machine at the two fixed points, over F_0/k1.
    """

    k2: float
    c: float
    height: float


def tuned_stiffness(m2: float, omega: float) -> float:
    """Return the stiffness for which the machine is at rest, m2 omega^2 (lecture D34, notes).

    It is worked out from the digits in which both are written: 16.7 kg at 48 rad/s need 38476.8 N/m.

    Parameters
    ----------
    m2 : float
        The mass of the absorber in kg, above 0.
    omega : float
        The drive frequency in rad/s, 0 or more.

    Returns
    -------
    float
        k2 in N/m, within 2 ulp.

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    check_positive("a mass in kg", m2=m2)
    check_not_negative("a drive frequency in rad/s", omega=omega)
    with precise():
        return rounded("the tuned stiffness", Decimal(repr(float(m2))) * Decimal(repr(float(omega))) ** 2)


def alone(chain: TwoMassChain) -> TwoMassChain:
    """Return the machine without its absorber: mass 2 has no spring.

    Parameters
    ----------
    chain : TwoMassChain
        The machine (mass 1 on spring 1) with its absorber (mass 2 on spring 2).

    Returns
    -------
    TwoMassChain
        The same chain with k2 = 0.
    """
    return TwoMassChain(m1=chain.m1, m2=chain.m2, k1=chain.k1, k2=0.0)


def damped_solution(chain: TwoMassChain, c: float, F_0: float, omega: float, c1: float = 0.0) -> NDArray[np.complex128]:
    """Return the complex amplitudes of both masses, x_i = Im(X_i exp(i omega t)); c = c1 = 0 is particular_solution.

    Parameters
    ----------
    chain : TwoMassChain
        The machine (mass 1 on spring 1) with its absorber (mass 2 on spring 2).
    c : float
        The damping between the masses in N s/m, 0 or more.
    F_0 : float
        The amplitude of the force on the machine in N, finite.
    omega : float
        The drive frequency in rad/s, 0 or more.
    c1 : float
        The damping parallel to spring 1 in N s/m, 0 or more.

    Returns
    -------
    ndarray (2,) of complex
        X1, X2 in m, both parts rounded once; inf if no steady amplitude exists.

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    checked_damping(c, F_0, omega=[omega], c1=c1)
    parts = _Whole.of(chain, c, F_0, c1).at(omega)
    (a, b), size, (above, below) = parts.D, parts.D[0] ** 2 + parts.D[1] ** 2, parts.unit
    result = []
    for re, im in (parts.N, parts.kappa):
        if not size:
            result.append(complex(math.inf if re or im else 0.0))
            continue
        top = above * (re * a + im * b), above * (im * a - re * b)
        result.append(complex(*(_ratio(part, below * size, omega) for part in top)))
    return np.array(result)


def damped_amplitude(chain: TwoMassChain, c: float, F_0: float, omega: ArrayLike, c1: float = 0.0) -> Array:
    """Return the amplitudes of both masses; without dashpots those of particular_solution.

    Parameters
    ----------
    chain : TwoMassChain
        The machine (mass 1 on spring 1) with its absorber (mass 2 on spring 2).
    c : float
        The damping between the masses in N s/m, 0 or more.
    F_0 : float
        The amplitude of the force on the machine in N, finite.
    omega : float or array_like (n,)
        Drive frequencies in rad/s, 0 or more.
    c1 : float
        The damping parallel to spring 1 in N s/m, 0 or more.

    Returns
    -------
    ndarray (2,) or (2, n)
        |X1|, |X2| in m, within 0.51 ulp; inf where no steady amplitude exists.

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    frequencies = checked_damping(c, F_0, omega, c1)
    if not (c or c1):
        return np.abs(particular_solution(chain, F_0, omega))
    whole = _Whole.of(chain, c, F_0, c1)
    rows = [whole.at(w).moduli(w) for w in frequencies.tolist()]
    return np.array(rows).T if np.ndim(omega) else np.array(rows[0])


def damped_lags(chain: TwoMassChain, c: float, omega: ArrayLike, c1: float = 0.0) -> Array:
    """Return the lags of both masses behind the force.

    Lag 1 is in [0, pi] within 2 u of a radian, lag 2 in [0, 2 pi] within 8 u. Both are continuous in omega, without
    unwrapping. Where mass 1 is at rest, and at a natural frequency without dashpots, they jump: the value is the limit
    of the frequencies just below. If nothing moves mass 2 it has the lag of mass 1.

    Parameters
    ----------
    chain : TwoMassChain
        The machine (mass 1 on spring 1) with its absorber (mass 2 on spring 2).
    c : float
        The damping between the masses in N s/m, 0 or more.
    omega : float or array_like (n,)
        Drive frequencies in rad/s, 0 or more.
    c1 : float
        The damping parallel to spring 1 in N s/m, 0 or more.

    Returns
    -------
    ndarray (2,) or (2, n)
        The lags of mass 1 and mass 2 in rad.

    Raises
    ------
    ValueError
        If a damping or a frequency is not possible.
    """
    frequencies = checked_damping(c, 0.0, omega, c1)
    whole = _Whole.of(chain, c, 0.0, c1)
    rows = [whole.lags(w) for w in frequencies.tolist()]
    return np.array(rows).T if np.ndim(omega) else np.array(rows[0])


def swing_and_stroke(chain: TwoMassChain, c: float, F_0: float, omega: ArrayLike, c1: float = 0.0) -> Array:
    """Return the amplitude of the machine and the stroke of the absorber, which is what its spring must allow.

    X2 - X1 = m2 omega^2 F_0/D, whatever c.

    Parameters
    ----------
    chain : TwoMassChain
        The machine (mass 1 on spring 1) with its absorber (mass 2 on spring 2).
    c : float
        The damping between the masses in N s/m, 0 or more.
    F_0 : float
        The amplitude of the force on the machine in N, finite.
    omega : float or array_like (n,)
        Drive frequencies in rad/s, 0 or more.
    c1 : float
        The damping parallel to spring 1 in N s/m, 0 or more.

    Returns
    -------
    ndarray (2,) or (2, n)
        |X1| and |X2 - X1| in m, within 0.51 ulp; inf where no steady amplitude exists.

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    frequencies = checked_damping(c, F_0, omega, c1)
    whole = _Whole.of(chain, c, F_0, c1)
    rows = [whole.at(w).swing_and_stroke(w) for w in frequencies.tolist()]
    return np.array(rows).T if np.ndim(omega) else np.array(rows[0])


def helped_band(chain: TwoMassChain, c: float = 0.0) -> Band | None:
    """Return the band of drive frequencies at which the machine swings less than without an absorber.

    With and without absorber |X1| is equal if A s^2 + B s + C = 0 in s = omega^2, with A = c^2 (2 m1 + m2) -
    2 m1 m2 k2, B = k2^2 (2 m1 + m2) + 2 k1 (m2 k2 - c^2), C = -2 k1 k2^2: it helps where this is positive.

    Parameters
    ----------
    chain : TwoMassChain
        The machine (mass 1 on spring 1) with its absorber (mass 2 on spring 2).
    c : float
        The damping between the masses in N s/m, 0 or more.

    Returns
    -------
    tuple of two floats, or None
        The ends of the band in rad/s. The upper one is inf if it helps at every higher frequency; None if it never
        helps.

    Raises
    ------
    ValueError
        If the damping is not possible.
    """
    check_not_negative("a damping in N s/m", c=c)
    m1, m2, k1, k2, damping, _, *_ = _Whole.of(
        chain, c
    )  # the scale cancels, because A, B and C have the same power of it
    A = damping**2 * (2 * m1 + m2) - 2 * m1 * m2 * k2
    B = k2**2 * (2 * m1 + m2) + 2 * k1 * (m2 * k2 - damping**2)
    C = -2 * k1 * k2**2
    square = B**2 - 4 * A * C
    if A <= 0 and not (B > 0 and square > 0):
        return None
    with precise():
        a, b, constant, root = Decimal(A), Decimal(B), Decimal(C), Decimal(square).sqrt()
        if B <= 0:
            return float(((root - b) / (2 * a)).sqrt()), math.inf
        q = -(b + root) / 2
        return float((constant / q).sqrt()), float((q / a).sqrt()) if A < 0 else math.inf


def fixed_points(chain: TwoMassChain) -> Array:
    """Return the two drive frequencies at which |X1| is the same whatever the damping.

    There no damping and a rigid link give the same amplitude: m2 (2 m1 + m2) s^2 - 2 (k1 m2 +
    k2 (m1 + m2)) s + 2 k1 k2 = 0 in s = omega^2. Source: Den Hartog, section 3.3.

    Parameters
    ----------
    chain : TwoMassChain
        The machine (mass 1 on spring 1) with its absorber (mass 2 on spring 2).

    Returns
    -------
    ndarray (2,)
        The frequencies in rad/s, the lower one first, rounded once.
    """
    m1, m2, k1, k2 = chain.exact_parameters
    with precise():
        a, b = m2 * (2 * m1 + m2), k1 * m2 + k2 * (m1 + m2)
        root = ((k1 * m2 - k2 * (m1 + m2)) ** 2 + 2 * m2**2 * k1 * k2).sqrt()
        squares = (2 * k1 * k2 / (b + root), (b + root) / a) if b else (Decimal(0), Decimal(0))
        return np.array([float(square.sqrt()) for square in squares])


def den_hartog(m1: float, k1: float, m2: float) -> Optimum:
    """Return the absorber whose fixed points are of one height and nearly the peaks: see `highest_peak`.

    omega_2 = omega_1/(1 + mu) and c/(2 m2 omega_1) = sqrt(3 mu/(8 (1 + mu)^3)), mu = m2/m1; the fixed points
    are then sqrt(1 + 2/mu) F_0/k1 high.

    Parameters
    ----------
    m1, m2 : float
        The masses of the machine and of the absorber in kg, above 0.
    k1 : float
        The stiffness under the machine in N/m, above 0.

    Returns
    -------
    Optimum
        Stiffness k2 in N/m, damping c in N s/m, and the height of the fixed points over F_0/k1.

    Raises
    ------
    ValueError
        If a number is not possible, or a result leaves the range of doubles.
    """
    check_positive("a mass in kg", m1=m1, m2=m2)
    check_positive("a stiffness in N/m", k1=k1)
    big, small, k = exact(m1), exact(m2), exact(k1)
    with precise():
        k2 = k * big * small / (big + small) ** 2
        c = 2 * small * (3 * k * big * small / (8 * (big + small) ** 3)).sqrt()
        height = ((2 * big + small) / small).sqrt()
    return Optimum(rounded("the stiffness", k2), rounded("the damping", c), rounded("the height", height))


def highest_peak(mu: float, tuning: float, damping: float) -> float:
    """Return the largest |X1| at any drive frequency.

    At Den Hartog's optimum the fixed points miss it
    by 0.27 % at mu = 0.16, by 1.3 % at mu = 1.

    Parameters
    ----------
    mu : float
        The ratio of the masses, m2/m1.
    tuning : float
        The ratio of the frequencies of the absorber and of the machine, omega_2/omega_1.
    damping : float
        The damping of the absorber over its scale, c/(2 m2 omega_1).

    Returns
    -------
    float
        |X1| over F_0/k1, to 1e-9 for mu from 0.001 on; inf without damping.
    """
    if not damping:
        return math.inf
    # |X1|^2 = above/below in s = (omega/omega_1)^2, below = free^2 + square s link^2: coefficients, the constant first,
    # of which a product of polynomials is the convolution.
    square = (2 * damping) ** 2
    above = np.array([tuning**4, square - 2 * tuning**2, 1.0])
    free, link = np.array([tuning**2, -(1 + (1 + mu) * tuning**2), 1.0]), np.array([-1.0, 1 + mu])
    below = np.convolve(free, free) + square * np.array([0.0, *np.convolve(link, link), 0.0])
    roots = polyroots(np.convolve(polyder(above), below) - np.convolve(above, polyder(below)))
    at = np.maximum(roots.real[np.abs(roots.imag) < 1e-6 * np.abs(roots)], 0.0)
    return float(np.sqrt(np.max(polyval(at, above) / polyval(at, below), initial=1.0)))


class _Parts(NamedTuple):
    """X1 = unit N/D, X2 = unit kappa/D: complex whole numbers (re, im), and a quotient of two."""

    N: tuple[int, int]
    kappa: tuple[int, int]
    D: tuple[int, int]
    unit: tuple[int, int]

    def moduli(self, omega: float) -> tuple[float, float]:
        return self._modulus(self.N, omega), self._modulus(self.kappa, omega)

    def swing_and_stroke(self, omega: float) -> tuple[float, float]:
        stretch = self.kappa[0] - self.N[0], self.kappa[1] - self.N[1]
        return self._modulus(self.N, omega), self._modulus(stretch, omega)

    def _modulus(self, above: tuple[int, int], omega: float) -> float:
        below = (self.D[0] ** 2 + self.D[1] ** 2) * self.unit[1] ** 2
        return _root((above[0] ** 2 + above[1] ** 2) * self.unit[0] ** 2, below, omega)


class _Whole(NamedTuple):
    """The parameters as whole numbers: each is that number over `scale`, a power of two."""

    m1: int
    m2: int
    k1: int
    k2: int
    c: int
    c1: int
    F_0: tuple[int, int]
    scale: int

    @classmethod
    def of(cls, chain: TwoMassChain, c: float, F_0: float = 0.0, c1: float = 0.0) -> "_Whole":
        ratios = [v.as_integer_ratio() for v in map(float, (chain.m1, chain.m2, chain.k1, chain.k2, c, c1))]
        scale = max(below for _, below in ratios)
        m1, m2, k1, k2, damping, first = (above * (scale // below) for above, below in ratios)
        return cls(m1, m2, k1, k2, damping, first, float(F_0).as_integer_ratio(), scale)

    def at(self, omega: float) -> _Parts:
        """Return N, kappa and D for omega = p/q; without the common factor of N and kappa where k2 = 0."""
        p, q = float(omega).as_integer_ratio()
        machine, braked = self.k1 * q**2 - self.m1 * p**2, self.c1 * p * q
        inertia = self.m2 * p**2
        if self.k2:
            N, kappa = (self.k2 * q**2 - inertia, self.c * p * q), (self.k2 * q**2, self.c * p * q)
        elif self.c:
            N, kappa = (-self.m2 * p, self.c * q), (0, self.c * q)
        else:
            N, kappa = (1, 0), (0, 0)
        D = (
            machine * N[0] - braked * N[1] - inertia * kappa[0],
            machine * N[1] + braked * N[0] - inertia * kappa[1],
        )
        return _Parts(N, kappa, D, (self.F_0[0] * self.scale * q**2, self.F_0[1]))

    def lags(self, omega: float) -> tuple[float, float]:
        """The lag of mass 1, in which c1 only adds to the imaginary part, and the lag of mass 2, which is behind it."""
        N, kappa, D, _ = self.at(omega)
        if not any(N):
            N = (1, 0)
        if not any(D) and not omega:
            D = (-N[1], N[0]) if self.c1 else (-kappa[0] or -N[0], -kappa[1])
        first = _angle(_turned_back(D, N))
        return first, first + _angle(_turned_back(N, kappa))


def _angle(z: tuple[int, int]) -> float:
    """The angle in rad of a complex whole number of any size; 0 of 0."""
    shift = max(0, max(map(int.bit_length, z)) - _BITS)
    re, im = (float(part >> shift) if part >= 0 else -float(-part >> shift) for part in z)
    return math.atan2(im + 0.0, re + 0.0)


def _turned_back(a: tuple[int, int], b: tuple[int, int]) -> tuple[int, int]:
    """a times the conjugate of b."""
    return a[0] * b[0] + a[1] * b[1], a[1] * b[0] - a[0] * b[1]


def checked_damping(c: float, F_0: float, omega: ArrayLike, c1: float = 0.0) -> Array:
    """Check dampings, a force and drive frequencies.

    Parameters
    ----------
    c : float
        The damping between the masses in N s/m, 0 or more.
    F_0 : float
        The amplitude of the force on the machine in N, finite.
    omega : float or array_like (n,)
        Drive frequencies in rad/s, 0 or more.
    c1 : float
        The damping parallel to spring 1 in N s/m, 0 or more.

    Returns
    -------
    ndarray (n,)
        The drive frequencies in rad/s; one frequency becomes (1,).

    Raises
    ------
    ValueError
        If one of them is not possible.
    """
    check_not_negative("a damping in N s/m", c=c, c1=c1)
    check_finite("a force in N", F_0=F_0)
    frequencies = finite_array("omega", omega)
    check_not_negative("a drive frequency in rad/s", omega=float(np.min(frequencies, initial=0.0)))
    return frequencies


def _ratio(above: int, below: int, omega: float) -> float:
    """Return the double nearest to a quotient of whole numbers."""
    try:
        return above / below
    except OverflowError:
        raise ValueError(f"the amplitude Xp at omega = {omega:.6g} rad/s leaves {DOUBLES}") from None


def _root(above: int, below: int, omega: float) -> float:
    """The square root of a quotient of whole numbers; inf over 0."""
    if not below:
        return math.inf if above else 0.0
    shift = max(0, (below.bit_length() - above.bit_length()) // 2 + _BITS)
    return _ratio(math.isqrt((above << 2 * shift) // below), 1 << shift, omega)
