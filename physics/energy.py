"""Kinetic and potential energy of the chain (lecture D31, slides 4 to 6; D34, slide 5).

    T_i = m_i v_i^2/2,   V_i = k_i e_i^2/2,   e_1 = x_1 and e_2 = x_2 - x_1 the elongations of the springs

The elongations are carried by the motion: where k2 is 1e12 times k1, x2 - x1 of rounded displacements has no
digit left, and the energy of a free motion would seem to change. The energies of the modes are
FreeModes.energy.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import FreeModes, Motion, TwoMassChain
from physics.exact import Array, exact, precise, rounded
from physics.sampling import Sinusoid, root_mean_square
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


def mean_energy(free: FreeModes, t: Array) -> ChainEnergy:
    """The energies of a free motion, averaged over the swings that the grid t (n,) is too coarse to draw."""
    chain = free.chain
    with precise():
        stretches = [exact(row[0]) * mode.stretch for row, mode in zip(free.amplitude, chain.exact_modes, strict=True)]
    shapes = [[*row, rounded("an amplitude", e)] for row, e in zip(free.amplitude, stretches, strict=True)]
    drifts = list(zip(free.drift_a, free.drift_b, strict=True))
    stretch = (drifts[1][0] - drifts[0][0], drifts[1][1] - drifts[0][1])

    def root(place: int, base: tuple[float, float], rate: bool) -> Array:
        terms = [
            Sinusoid(shape[place] * (omega if rate else 1.0), omega, phase + (math.pi / 2 if rate else 0.0))
            for shape, omega, phase in zip(shapes, free.omega, free.phase, strict=True)
            if omega
        ]
        return root_mean_square(terms, t, base[1] + 0.0 * t if rate else base[0] + base[1] * t)

    velocities = [root(i, drifts[i], True) for i in (0, 1)]
    return _energies(chain, np.array([*velocities, root(0, drifts[0], False), root(2, stretch, False)]))


def half_square(quantity: str, factor: float, values: Array) -> Array:
    """factor values^2/2, also where values^2 alone is out of range."""
    return in_range(f"the energy {quantity}", _half_squares(factor, values))


def _half_squares(factor: ArrayLike, values: Array) -> Array:
    base, exponent = np.frexp(factor)
    bases, exponents = np.frexp(values)
    with np.errstate(over="ignore"):
        result: Array = np.ldexp(base * bases**2, 2 * exponents + exponent - 1)
        return result
