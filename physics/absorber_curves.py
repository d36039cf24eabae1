"""Swing and stroke of the machine with its absorber over many drive frequencies (see physics.absorber), in doubles.

With d(r) = omega^2 - r^2, which next to r is worked out from the digits of r beyond a double, nothing cancels:

    |X1| = F_0/m1 |d(omega_2) - i omega c/m2|/E,   |X2 - X1| = F_0/m1 omega^2/E,

    E = |d(omega_-) d(omega_+) - i omega c (m1 + m2)/(m1 m2) d(omega_12)|,

Here omega_- and omega_+ are the natural frequencies without damping, omega_2 = sqrt(k2/m2), and
omega_12 = sqrt(k1/(m1 + m2)) is the natural frequency of both masses as one body.
The machine alone, omega_1 = sqrt(k1/m1), swings |X1| = F_0/m1/|d(omega_1)|.
"""

from decimal import Decimal
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from physics.absorber import alone, checked_damping, swing_and_stroke
from physics.coupled import TwoMassChain
from physics.particular import from_roots, particular_solution
from physics.precision.exact import Array, binary, exact, precise

_COMFORT = 2.0**60  # if omega, the damping and F_0/m1 are between 1/this and this, no product leaves the doubles


class _Scaled(NamedTuple):
    """In a unit of time near the fast mode's: F_0/m1, c/m2, c (m1 + m2)/(m1 m2), omega and the roots."""

    size: float
    link: float
    both: float
    omega: Array
    roots: list[Decimal]

    @classmethod
    def of(cls, chain: TwoMassChain, c: float, F_0: float, omega: Array) -> "_Scaled":
        slow, fast = chain.exact_modes
        m1, m2, k1, _ = chain.exact_parameters
        exponent = binary(fast.omega)[2]
        with precise():
            unit = Decimal(2) ** exponent
            link = exact(c) / m2 / unit
            roots = slow.omega, fast.omega, chain.exact_antiresonance, (k1 / (m1 + m2)).sqrt(), (k1 / m1).sqrt()
            return cls(
                float(abs(exact(F_0)) / m1 / unit**2),
                float(link),
                float(link * (m1 + m2) / m1),
                np.ldexp(omega, -exponent),
                [root / unit for root in roots],
            )

    @property
    def comfortable(self) -> bool:
        factors = (
            self.size,
            self.link,
            self.both,
            float(self.omega.min(initial=1.0)),
            float(self.omega.max(initial=1.0)),
        )
        return all(1 / _COMFORT < factor < _COMFORT for factor in factors if factor) and bool(self.omega.all())


def machine_curves(chain: TwoMassChain, c: float, F_0: float, omega: ArrayLike) -> Array:
    """Return |X1|, |X2 - X1| and |X1| of the machine alone at n drive frequencies.

    Parameters
    ----------
    chain : TwoMassChain
        The machine (mass 1 on spring 1) with its absorber (mass 2 on spring 2).
    c : float
        The damping between the masses in N s/m, 0 or more.
    F_0 : float
        The amplitude of the force on the machine in N, finite.
    omega : float or array_like (n,)
        Drive frequencies in rad/s, 0 or more; one frequency counts as (1,).

    Returns
    -------
    ndarray (3, n)
        The amplitudes in m, within 6 ulp; inf where no steady amplitude exists.

    Raises
    ------
    ValueError
        If a number is not possible, or an amplitude leaves the range of doubles.
    """
    frequencies = checked_damping(c, F_0, omega)
    scaled = _Scaled.of(chain, c, F_0, frequencies)
    if not scaled.comfortable:
        with_it = swing_and_stroke(chain, c, F_0, frequencies)
        return np.array([*with_it, np.abs(particular_solution(alone(chain), F_0, frequencies)[0])])
    square = scaled.omega**2
    slow, fast, two, both, one = (difference for difference, _ in from_roots(scaled.omega, scaled.roots))
    above = two**2 + square * scaled.link**2
    below = (slow * fast) ** 2 + square * (scaled.both * both) ** 2
    with np.errstate(divide="ignore"):
        curves: Array = scaled.size * np.array([np.sqrt(above / below), square / np.sqrt(below), 1 / np.abs(one)])
    return curves
