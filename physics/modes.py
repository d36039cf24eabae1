"""Looking for the modes of two masses and two springs (lecture D34, slides 2 to 4).

    wall --k1-- [m1] --k2-- [m2]        x1 = X1 sin(omega t + phi), x2 = X2 sin(omega t + phi)

    A (X1, X2)^T = 0,   A = [[m1 omega^2 - k1 - k2, k2], [k2, m2 omega^2 - k2]]

At any omega each row alone fixes a shape:

    row 1:  X2/X1 = (k1 + k2 - m1 omega^2)/k2        row 2:  X2/X1 = k2/(k2 - m2 omega^2)

Both hold for a motion that is not rest only where they are the same equation, which is where

    D = det A = k2 (k2 - m2 omega^2) (row 1 - row 2) = m1 m2 omega^4 - b omega^2 + k1 k2

vanishes. The same said with forces: to move with X sin(omega t) mass j needs -m_j omega^2 X_j, the springs give
-k1 X1 + k2 (X2 - X1) and -k2 (X2 - X1), and what is missing a hand would have to add.

What depends on one trial omega is worked out from exact rationals and rounded once to 80 digits, so that it is zero
only at a mode, and right beside one, for every positive double; it does not overflow. Curves are in float64.
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import Mode, TwoMassChain, each_mass, free_modes
from physics.exact import Array, exact, precise
from physics.valid import check_finite, check_not_negative

Vector = tuple[Decimal, Decimal]


class Trial(NamedTuple):
    """A X = 0 at one trial omega, in 80 digits.

    `matrix` is A; `determinant` is D. `rows` are the shapes X2/X1 that the rows fix: infinite where a row asks for X1 =
    0, None where it holds for every shape. `apart` is row 1 less row 2, None where one of them is not a number.
    """

    matrix: tuple[Vector, Vector]
    determinant: Decimal
    rows: tuple[Decimal | None, Decimal | None]
    apart: Decimal | None


class Forces(NamedTuple):
    """On each mass at full swing: what the motion needs, what the springs give, what is missing; N, in 80 digits."""

    amplitude: Vector
    needed: Vector
    springs: Vector
    missing: Vector


class Quadratic(NamedTuple):
    """m1 m2 omega^4 - b omega^2 + k1 k2 = 0 in 80 digits: why both roots are real and positive.

    Delta = b^2 - fourfold, fourfold = 4 m1 m2 k1 k2, so sqrt(Delta) <= b; and Delta = difference^2 + coupling with
    difference = m1 k2 - m2 (k1 + k2) and coupling = 4 m1 m2 k2^2, so Delta > 0.
    """

    leading: Decimal
    b: Decimal
    constant: Decimal
    fourfold: Decimal
    difference: Decimal
    coupling: Decimal
    Delta: Decimal
    root: Decimal


def trial(chain: TwoMassChain, omega: float) -> Trial:
    """What the two equations say at a trial omega in rad/s."""
    k2 = Fraction(chain.k2)
    one, two = _diagonal(chain, omega)
    first, second = _fixed(-one, k2), _fixed(k2, -two)
    known = isinstance(first, Fraction) and isinstance(second, Fraction)
    return Trial(
        matrix=((_decimal(one), _decimal(k2)), (_decimal(k2), _decimal(two))),
        determinant=_decimal(one * two - k2**2),
        rows=(_shape(first), _shape(second)),
        apart=_decimal(first - second) if known else None,  # type: ignore[operator]
    )


def _diagonal(chain: TwoMassChain, omega: float) -> tuple[Fraction, Fraction]:
    check_not_negative("an angular frequency in rad/s", omega=omega)
    square, k2 = Fraction(omega) ** 2, Fraction(chain.k2)
    return Fraction(chain.m1) * square - Fraction(chain.k1) - k2, Fraction(chain.m2) * square - k2


def _fixed(over: Fraction, under: Fraction) -> Fraction | float | None:
    """The shape X2/X1 = over/under."""
    if under:
        return over / under
    return float("inf") if over else None


def _shape(value: Fraction | float | None) -> Decimal | None:
    return _decimal(value) if isinstance(value, Fraction) else value and Decimal(value)


def _decimal(value: Fraction) -> Decimal:
    with precise():
        return Decimal(value.numerator) / Decimal(value.denominator)


def forces(chain: TwoMassChain, omega: float, ratio: float) -> Forces:
    """The forces in a motion of the shape X2/X1 = ratio at omega; the larger amplitude is 1 m."""
    check_finite("a ratio", ratio=ratio)
    one, two = _diagonal(chain, omega)
    k1, k2, r = Fraction(chain.k1), Fraction(chain.k2), Fraction(ratio)
    X1, X2 = (part / max(Fraction(1), abs(r)) for part in (Fraction(1), r))
    springs = (-k1 * X1 + k2 * (X2 - X1), -k2 * (X2 - X1))
    missing = (-(one * X1 + k2 * X2), -(k2 * X1 + two * X2))
    needed = (springs[0] + missing[0], springs[1] + missing[1])
    return Forces(*((_decimal(a), _decimal(b)) for a, b in ((X1, X2), needed, springs, missing)))


def quadratic(chain: TwoMassChain) -> Quadratic:
    """The coefficients of the equation for omega^2, and its discriminant in both of its forms."""
    m1, m2, k1, k2 = (Fraction(value) for value in (chain.m1, chain.m2, chain.k1, chain.k2))
    difference, fourfold = m1 * k2 - m2 * (k1 + k2), 4 * m1 * m2 * k1 * k2
    coupling = 4 * m1 * m2 * k2**2
    b = m1 * k2 + m2 * (k1 + k2)
    values = (m1 * m2, b, k1 * k2, fourfold, difference, coupling, b**2 - fourfold)
    exactly = [_decimal(value) for value in values]
    with precise():
        return Quadratic(*exactly, exactly[-1].sqrt())


def determinant_curve(chain: TwoMassChain, omega: ArrayLike) -> tuple[Array, int]:
    """D at the frequencies omega (n,) in units of 10**exponent, and that exponent: 0 unless D leaves [1e-150, 1e150].

    From its factors, so that it keeps its digits beside a root. For omega not beyond some 1e3 omega_+.
    """
    omega = np.asarray(omega, dtype=float)
    modes = chain.modes()
    unit = max(float(np.max(omega)), float(modes.omega[1]))
    factors = np.ones_like(omega)
    for hi, lo in zip(modes.omega, modes.omega_lo, strict=True):
        factors *= ((omega - hi - lo) / unit) * ((omega + hi) / unit)
    with precise():
        size = exact(chain.m1) * exact(chain.m2) * exact(unit) ** 4
        power = size.adjusted() if size else 0
        exponent = 0 if abs(power) <= 150 else 3 * (power // 3)
        return factors * float(size.scaleb(-exponent)), exponent


class Branches(NamedTuple):
    """A curve in pieces: frequencies (n,) and ratios X2/X1 (n,) of each."""

    omega: list[Array]
    ratio: list[Array]


def row_curves(chain: TwoMassChain, end: float, largest: float, count: int = 120) -> tuple[Branches, Branches]:
    """The shapes that row 1 and row 2 fix, for 0 <= omega <= end and |X2/X1| up to `largest` (> 1).

    In the plane of omega^2 row 1 is a straight line, of which the ends are given; row 2 is a hyperbola with a pole at
    k2/m2. With k2 = 0 row 1 is the upright line at k1/m1 (X1 = 0 elsewhere) and row 2 is 0.
    """
    if not chain.k2:
        upright = np.full(2, np.sqrt(chain.k1) / np.sqrt(chain.m1))
        reach = np.array([-largest, largest])
        return Branches([upright], [reach]), Branches([np.array([0.0, end])], [np.zeros(2)])
    held = np.sqrt([chain.k1 + chain.k2 if chain.k1 + chain.k2 < np.inf else chain.k1, chain.k2]) / np.sqrt([chain.m1, chain.m2])
    coupling = np.sqrt(chain.k2) / np.sqrt(chain.m1)
    top = (held[0] / coupling) ** 2  # row 1 at omega = 0
    last = top - (end / coupling) ** 2
    line = np.clip([top, last], -largest, largest)
    first = Branches([coupling * np.sqrt(np.maximum(top - line, 0.0))], [line])
    inverse = np.geomspace(1.0, 1.0 / largest, count)
    left = (held[1] * np.sqrt(1.0 - inverse), 1.0 / inverse)
    beyond = (end / held[1]) ** 2 - 1.0
    gap = np.geomspace(min(1.0 / largest, beyond), beyond, count)
    right = (held[1] * np.sqrt(1.0 + gap), -1.0 / gap)
    return first, Branches([left[0], right[0]], [left[1], right[1]])


@dataclass(frozen=True, eq=False)
class Sweep:
    """Frequencies (2, n) in rad/s and ratios (2, n) of both modes while one parameter takes the `values` (n,).

    `held` (2, n) is the frequency of each mass alone while the other is held: sqrt((k1 + k2)/m1) and sqrt(k2/m2).
    The modes keep outside of both, so where these two cross the modes avoid each other.
    """

    values: Array
    omega: Array
    ratio: Array
    held: Array


PARAMETERS = ("m1", "m2", "k1", "k2")


def sweep(chain: TwoMassChain, name: str, values: ArrayLike) -> Sweep:
    """Both modes for each of the positive values (n,) of the parameter `name`.

    Frequencies are good to 1e-15, ratios to 1e-15 times the root of the mass ratio. With k2 = 0 the ratios are inf, 0.
    """
    values = np.asarray(values, dtype=float)
    m1, m2, k1, k2 = _swept(chain, name, values)
    with np.errstate(divide="ignore", over="ignore", under="ignore"):
        own = [np.sqrt(a) / np.sqrt(b) for a, b in ((k1, m1), (k2, m1), (k2, m2))]
        held = np.array([np.hypot(own[0], own[1]), own[2]])
        unit = np.max(held, axis=0)
        a, c = (held / unit) ** 2
        root = np.hypot(a - c, 2.0 * (own[1] / unit) * np.sqrt(c))
        fast = np.sqrt((a + c + root) / 2.0)
        omega = np.array([own[0] / unit * own[2] / fast, unit * fast])
        larger = (np.abs(a - c) + root) / 2.0
        above = larger / (own[1] / unit) ** 2  # the ratio that is a sum without cancellation
        below = m1 / m2 / above
    ratio = np.where(a >= c, [above, -below], [below, -above])
    return Sweep(values, omega, ratio, held)


def _swept(chain: TwoMassChain, name: str, values: Array) -> list[Array]:
    if name not in PARAMETERS:
        raise ValueError(f"name = {name!r}: one of {', '.join(PARAMETERS)} is swept")
    return [values if name == each else np.full_like(values, getattr(chain, each)) for each in PARAMETERS]


class Limit(NamedTuple):
    """What both modes tend to: omega (2, n) and ratio (2, n) over the values of the sweep; `kind` names the limit."""

    kind: str
    omega: Array
    ratio: Array


LIMITS = {
    ("k2", 0): "apart", ("k1", 1): "apart",
    ("k2", 1): "rigid", ("k1", 0): "rigid",
    ("m1", 0): "series", ("m2", 1): "series",
    ("m1", 1): "stand", ("m2", 0): "stand",
}
"""The kind of limit of each parameter at 0 and at infinity.

apart   two oscillators of their own: mass 2 on k2, mass 1 on k1
rigid   one block on k1, and the two masses against each other on k2
series  mass 1 does without inertia: mass 2 on both springs in series, mass 1 between two walls
stand   mass 1 minds mass 2 no more: it is alone on k1, and mass 2 hangs on it as on a wall
"""


def limit(chain: TwoMassChain, name: str, end: int, values: ArrayLike) -> Limit:
    """The asymptotes of a sweep of `name` towards 0 (end = 0) or infinity (end = 1), to leading order."""
    values = np.asarray(values, dtype=float)
    m1, m2, k1, k2 = _swept(chain, name, values)
    kind = LIMITS[name, end]
    one, two = np.sqrt(k1) / np.sqrt(m1), np.sqrt(k2) / np.sqrt(m2)
    if kind == "apart":
        # the lower of the two is the slow mode; far out it is mass 2 on k2
        return Limit(kind, np.array([two, one]), np.array([k1 / k2, -(m1 / m2) * (k2 / k1)]))
    if kind == "rigid":
        together, internal = np.sqrt(k1) / np.sqrt(m1 + m2), two * np.sqrt(1.0 + m2 / m1)
        return Limit(kind, np.array([together, internal]), np.array([np.ones_like(values), -m1 / m2]))
    if kind == "series":
        share = k1 / (k1 + k2)
        between = np.sqrt(k1 + k2) / np.sqrt(m1)
        return Limit(kind, np.array([two * np.sqrt(share), between]), np.array([1.0 + k1 / k2, -(m1 / m2) * (k2 / (k1 + k2))]))
    return Limit(kind, np.array([one, two]), np.array([np.ones_like(values), -m1 / m2]))


def shares(chain: TwoMassChain, x_0: ArrayLike) -> tuple[float, float]:
    """The energies of the slow and the fast mode in a motion from rest at x_0 (2,), as parts of their sum.

    (0, 0) where nothing moves. Both are positive numbers of their own, so that a small one keeps its digits.
    """
    each = free_modes(chain, x_0, (0.0, 0.0)).each()
    with precise():
        energies = [mode.mass * (mode.omega * q) ** 2 for mode, q, _ in each]
        whole = sum(energies, Decimal(0))
        slow, fast = (float(energy / whole) if whole else 0.0 for energy in energies)
    return slow, fast
