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
    """Energies of the chain.

    Attributes
    ----------
    T : ndarray (2, n)
        Kinetic energies of the masses in J.
    V : ndarray (2, n)
        Potential energies of the springs in J.
    """

    T: Array
    V: Array

    @property
    def total(self) -> Array:
        """T + V (n,), constant within 8 u while nothing drives the chain."""
        result: Array = self.T[0] + self.T[1] + (self.V[0] + self.V[1])
        return result


def chain_energy(chain: TwoMassChain, motion: Motion) -> ChainEnergy:
    """Return the energies along a motion (lecture D31, slides 4 to 6; D34, slide 5).

    Parameters
    ----------
    chain : TwoMassChain
        The chain that moves.
    motion : Motion
        Its motion at n times, with velocities and elongations.

    Returns
    -------
    ChainEnergy
        Energies at the same n times, in J.

    Raises
    ------
    ValueError
        If an energy leaves the range of doubles; the message names it.
    """
    return _energies(chain, np.concatenate([motion.v, motion.e]))


def _energies(chain: TwoMassChain, values: Array) -> ChainEnergy:
    """The energies of velocities and elongations, or of their root mean squares, (4, n)."""
    factors = np.array([[chain.m1], [chain.m2], [chain.k1], [chain.k2]])
    found = rows_in_range(_NAMES, _half_squares(factors, values))
    return ChainEnergy(T=found[:2], V=found[2:])


def half_square(quantity: str, factor: float, values: Array) -> Array:
    """Return factor values^2/2, also where values^2 alone is out of range.

    Parameters
    ----------
    quantity : str
        The name of the energy, for the message of an error.
    factor : float
        A mass in kg or a stiffness in N/m.
    values : ndarray (n,)
        Velocities in m/s or elongations in m.

    Returns
    -------
    ndarray (n,)
        Energies in J.

    Raises
    ------
    ValueError
        If an energy leaves the range of doubles.
    """
    return in_range(f"the energy {quantity}", _half_squares(factor, values))


def _half_squares(factor: ArrayLike, values: Array) -> Array:
    base, exponent = np.frexp(factor)
    bases, exponents = np.frexp(values)
    with np.errstate(over="ignore"):
        result: Array = np.ldexp(base * bases**2, 2 * exponents + exponent - 1)
        return result
