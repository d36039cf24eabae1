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
    return _row_one(chain, end, largest), _row_two(chain, end, largest, count)


def _row_one(chain: TwoMassChain, end: float, largest: float) -> Branches:
    m1, _, k1, k2 = chain.exact_parameters
    with precise():
        both, far = k1 + k2, exact(largest)
        line = [min(both / k2, far), max((both - m1 * exact(end) ** 2) / k2, -far)]
        square = [max((both - k2 * r) / m1, Decimal(0)) for r in line]
        omega = [min(float(value.sqrt()), end) for value in square]
    return Branches([np.array(omega)], [np.array([float(r) for r in line])])


def _row_two(chain: TwoMassChain, end: float, largest: float, count: int) -> Branches:
    pole = float(np.sqrt(chain.k2) / np.sqrt(chain.m2))
    below = np.geomspace(1.0, largest, count)
    last = 1.0 / ((end / pole) ** 2 - 1.0) if end < 1e100 * pole else 0.0
    above = np.geomspace(largest, max(last, 1e-6), count)
    omega = np.append(pole * np.sqrt(1.0 + 1.0 / above[:-1]), end)
    return Branches([pole * np.sqrt(1.0 - 1.0 / below), omega], [below, -np.append(above[:-1], last)])


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
        unit = _not_zero(np.max(held, axis=0))
        a, c = (held / unit) ** 2
        coupling = own[1] / unit
        root = np.hypot(a - c, 2.0 * coupling * np.sqrt(c))
        fast = np.sqrt((a + c + root) / 2.0)
        omega = np.array([own[0] / unit * own[2] / _not_zero(fast), unit * fast])
        larger = _not_zero((np.abs(a - c) + root) / 2.0)  # a sum without cancellation, in both ratios
        above, below = larger / coupling**2, c / larger
    ratio = np.where(a >= c, [above, -below], [below, -above])
    return Sweep(values, omega, ratio, held)


def _not_zero(values: Array) -> Array:
    """1 in place of 0, where there is no spring at all."""
    return np.where(values > 0.0, values, 1.0)


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
    """The asymptotes of a sweep of `name` towards 0 (end = 0) or infinity (end = 1), to leading order.

    Without k2 the masses are apart all along, without k1 there is only the pair: there the limits are exact.
    """
    values = np.asarray(values, dtype=float)
    m1, m2, k1, k2 = _swept(chain, name, values)
    kind = LIMITS[name, end]
    if name != "k2" and not chain.k2:
        kind = "apart"
    elif name != "k1" and not chain.k1:
        kind = "rigid"
    with np.errstate(over="ignore", divide="ignore", invalid="raise"):
        return Limit(kind, *(np.array(pair) for pair in _tends(kind, m1, m2, k1, k2)))


def _tends(kind: str, m1: Array, m2: Array, k1: Array, k2: Array) -> tuple[list[Array], list[Array]]:
    """Both frequencies and both ratios; sums of roots of sums are hypotenuses, which do not overflow."""
    root_m, root_k = np.hypot(np.sqrt(m1), np.sqrt(m2)), np.hypot(np.sqrt(k1), np.sqrt(k2))
    one, two, coupling = (np.sqrt(k) / np.sqrt(m) for k, m in ((k1, m1), (k2, m2), (k2, m1)))
    if kind == "apart":
        with np.errstate(invalid="ignore"):
            ratios = [np.where(k2 > 0.0, k1 / k2, np.inf), -np.where(k2 > 0.0, (two / one) ** 2, 0.0)]
        return [two, one], ratios
    if kind == "rigid":
        return [np.sqrt(k1) / root_m, np.hypot(two, coupling)], [np.ones_like(m1), -m1 / m2]
    if kind == "series":
        between = root_k / np.sqrt(m1)
        return [two * (np.sqrt(k1) / root_k), between], [1.0 + k1 / k2, -((two / between) ** 2)]
    return [one, two], [np.ones_like(m1), -m1 / m2]


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
