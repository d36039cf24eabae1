"""Kinetic and potential energy of the chain (lecture D31, slides 4 to 6; D34, slide 5).

    T_i = m_i v_i^2/2,   V_i = k_i e_i^2/2,   e_1 = x_1 and e_2 = x_2 - x_1 the elongations of the springs

A motion has the elongations too. If k2 is 1e12 times k1, x2 - x1 of rounded displacements has no correct digit, and the
energy of a free motion would seem to change. The energies of the modes are
FreeModes.energy.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import Motion, TwoMassChain
from physics.precision.exact import Array
from physics.valid import in_range, rows_in_range

_NAMES = [f"the energy {name}" for name in ("T1", "T2", "V1", "V2")]


@dataclass(frozen=True, eq=False)
class ChainEnergy:
    """Energies of the chain in J: T (2, n) of the masses, V (2, n) of the springs."""

    T: Array
    V: Array

    @property
    def total(self) -> Array:
        """T + V (n,), constant within 8 u while nothing drives the chain."""
        result: Array = self.T[0] + self.T[1] + (self.V[0] + self.V[1])
        return result


def chain_energy(chain: TwoMassChain, motion: Motion) -> ChainEnergy:
    """The energies along a motion; ValueError names the one that leaves the range of doubles."""
    return _energies(chain, np.concatenate([motion.v, motion.e]))


def _energies(chain: TwoMassChain, values: Array) -> ChainEnergy:
    """The energies of velocities and elongations, or of their root mean squares, (4, n)."""
    factors = np.array([[chain.m1], [chain.m2], [chain.k1], [chain.k2]])
    found = rows_in_range(_NAMES, _half_squares(factors, values))
    return ChainEnergy(T=found[:2], V=found[2:])


def half_square(quantity: str, factor: float, values: Array) -> Array:
    """factor values^2/2, also where values^2 alone is out of range."""
    return in_range(f"the energy {quantity}", _half_squares(factor, values))


def _half_squares(factor: ArrayLike, values: Array) -> Array:
    base, exponent = np.frexp(factor)
    bases, exponents = np.frexp(values)
    with np.errstate(over="ignore"):
        result: Array = np.ldexp(base * bases**2, 2 * exponents + exponent - 1)
        return result
