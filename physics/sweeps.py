"""Both modes of two masses and two springs while one parameter runs over decades (lecture D34, slides 3 and 4).

    wall --k1-- [m1] --k2-- [m2]

Each mass alone, the other held, has sqrt((k1 + k2)/m1) and sqrt(k2/m2). With these squared, a and c, and g = k2/m1,

    omega_+^2 = (a + c + S)/2,   S = sqrt((a - c)^2 + 4 g c),   omega_- omega_+ = sqrt(k1 k2/(m1 m2)),

and the ratios X2/X1 are (a - c + S)/(2 g) and -2 c/(a - c + S) for a >= c: neither cancels. Far out every sweep ends in
one of four limits. In float64, for plots; frequencies are normalised first, so that nothing overflows on the way.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import TwoMassChain
from physics.precision.exact import Array


@dataclass(frozen=True, eq=False)
class Sweep:
    """Both modes while one parameter changes.

    The frequencies of the modes keep outside of both of `held`, so where these two cross the modes avoid each other.

    Attributes
    ----------
    values : ndarray (n,)
        The values of the parameter, in its SI unit.
    omega : ndarray (2, n)
        Natural frequencies in rad/s, the slow mode first.
    ratio : ndarray (2, n)
        X2/X1 of each mode.
    held : ndarray (2, n)
        The frequency of each mass alone in rad/s while the other is held: sqrt((k1 + k2)/m1) and sqrt(k2/m2).
    """

    values: Array
    omega: Array
    ratio: Array
    held: Array


PARAMETERS = ("m1", "m2", "k1", "k2")


def sweep(chain: TwoMassChain, name: str, values: ArrayLike) -> Sweep:
    """Return both modes for each value of one parameter.

    Frequencies are within 8 u (u = 2^-53), ratios within 1e-15 times the root of the mass ratio.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs; the parameter's own value is not used.
    name : {"m1", "m2", "k1", "k2"}
        The parameter.
    values : array_like (n,)
        Its values in its SI unit, above 0.

    Returns
    -------
    Sweep
        Frequencies and ratios; with k2 = 0 the ratios are inf, 0.

    Raises
    ------
    ValueError
        If there is no parameter of this name.
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
        raise ValueError(f"“{name}” cannot be swept: choose one of {', '.join(PARAMETERS)}")
    return [values if name == each else np.full_like(values, getattr(chain, each)) for each in PARAMETERS]


class Limit(NamedTuple):
    """The limits of both modes over the values of a sweep.

    Attributes
    ----------
    kind : {"apart", "rigid", "series", "stand"}
        The name of the limit, as in LIMITS.
    omega : ndarray (2, n)
        Natural frequencies in rad/s, the slow mode first.
    ratio : ndarray (2, n)
        X2/X1 of each mode.
    """

    kind: str
    omega: Array
    ratio: Array


LIMITS = {
    ("k2", 0): "apart",
    ("k1", 1): "apart",
    ("k2", 1): "rigid",
    ("k1", 0): "rigid",
    ("m1", 0): "series",
    ("m2", 1): "series",
    ("m1", 1): "stand",
    ("m2", 0): "stand",
}
"""The kind of limit of each parameter at 0 and at infinity.

apart   two separate oscillators: mass 2 on k2, mass 1 on k1
rigid   one block on k1, and the two masses against each other on k2
series  mass 1 has no inertia: mass 2 on both springs in series, mass 1 between two walls
stand   mass 1 does not feel mass 2: it is alone on k1, and mass 2 is attached to it as to a wall
"""


def limit(chain: TwoMassChain, name: str, end: int, values: ArrayLike) -> Limit:
    """Return the asymptotes of a sweep, to leading order.

    For k2 = 0 the masses are always separate, for k1 = 0 there is only the pair: there the limits are exact.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    name : {"m1", "m2", "k1", "k2"}
        The parameter that is swept.
    end : {0, 1}
        0 for its limit 0, 1 for infinity.
    values : array_like (n,)
        Its values in its SI unit, above 0.

    Returns
    -------
    Limit
        The asymptotes at these values.

    Raises
    ------
    ValueError
        If there is no parameter of this name.
    """
    values = np.asarray(values, dtype=float)
    m1, m2, k1, k2 = _swept(chain, name, values)
    kind = LIMITS[name, end]
    if name != "k2" and not chain.k2:
        kind = "apart"
    elif name != "k1" and not chain.k1:
        kind = "rigid"
    with np.errstate(over="ignore", divide="ignore", invalid="raise"):
        omega, ratio = _tends(kind, m1, m2, k1, k2)
        return Limit(kind, np.array(omega), np.array(ratio))


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
