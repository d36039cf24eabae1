"""The free motions of two masses as values (physics.motion): in each mode alone, and in both.

The elongation of spring 2 is a separate motion: x2 - x1 of rounded displacements has no digits if it is stiff.

Source: lecture D34, slide 5.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from physics.coupled import FreeModes, Motion
from physics.motion import Elementary, ExactMotion, Harmonic, harmonic_motion, remembered, superposed
from physics.precision.exact import Array, exact, precise, rounded
from physics.sampling import Sinusoid

QUARTER = math.pi / 2


class ChainMotions(NamedTuple):
    """The motions of both masses and springs.

    Attributes
    ----------
    x1, x2 : ExactMotion
        Displacements of the masses in m.
    e1, e2 : ExactMotion
        Elongations of the springs in m.
    v1, v2 : ExactMotion
        Velocities of the masses in m/s.
    """

    x1: ExactMotion
    x2: ExactMotion
    e1: ExactMotion
    e2: ExactMotion
    v1: ExactMotion
    v2: ExactMotion

    @property
    def x(self) -> tuple[ExactMotion, ExactMotion]:
        """The displacements of masses 1 and 2."""
        return self.x1, self.x2


@dataclass(frozen=True, eq=False)
class FreeMotions:
    """The motions of a free motion of the chain.

    `slow` is the slow mode, with the drifts of both; `fast` is the fast mode, None if that drifts too. `both` are sums:
    displacements are added, elongations and velocities rounded once.

    Attributes
    ----------
    free : FreeModes
        The coordinates of both modes at t = 0.
    """

    free: FreeModes

    @cached_property
    def slow(self) -> ChainMotions:
        """The motions in the slow mode."""
        return ChainMotions(*self._mode(0, "slow"))

    @cached_property
    def fast(self) -> ChainMotions | None:
        """The motions in the fast mode; None if it is at rest."""
        return ChainMotions(*self._mode(1, "fast")) if self.free.omega[1] else None

    @cached_property
    def both(self) -> ChainMotions:
        """The motions in both modes together."""
        modes = (self.slow, self.fast) if self.fast else (self.slow,)
        rows, motion = list(zip(ChainMotions._fields, *modes, strict=True)), remembered(self.free.motion)
        exact = (lambda t, i=i: _values(motion(t))[i] for i in range(2, len(rows)))
        sums = [superposed(*row) for row in rows[:2]]
        return ChainMotions(*sums, *(superposed(*row, exact=one) for row, one in zip(rows[2:], exact, strict=True)))

    def _mode(self, j: int, mode: str) -> list[Elementary]:
        """The motions in the mode j; the elongation of spring 1 is x1 itself."""
        part = self._parts[j]
        x1, x2, e2, v1, v2 = (
            harmonic_motion(f"{name}_{mode}", harmonic, lambda t, i=i: _values(part(t))[i])  # type: ignore[misc]
            for i, name, harmonic in zip(
                (0, 1, 3, 4, 5), ("x1", "x2", "e2", "v1", "v2"), self._harmonics(j), strict=True
            )
        )
        return [x1, x2, x1, e2, v1, v2]

    @cached_property
    def _parts(self) -> tuple[Callable[[Array], Motion], Callable[[Array], Motion]]:
        """The motion of each mode at given times, which share one computation; the slow one with all drifts."""
        parts = remembered(self.free.parts)
        if self.free.omega[1]:
            return (lambda t: parts(t)[0]), (lambda t: parts(t)[1])
        return (lambda t: parts(t)[0] + parts(t)[1]), (lambda t: parts(t)[1])

    def _harmonics(self, j: int) -> Iterator[Harmonic]:
        """The motions x1, x2, e2, v1, v2 in the mode j, in doubles."""
        omega, phase = float(self.free.omega[j]), float(self.free.phase[j])
        if not omega:
            starts, rates = self.free.drifts.tolist()
            yield from (Harmonic((), line) for line in zip(starts, rates, strict=True))
            yield from (Harmonic((), (rate, 0.0)) for rate in rates[:2])
            return
        sizes = self.free.amplitudes[j].tolist()
        yield from (Harmonic((Sinusoid(size, omega, phase),)) for size in sizes)
        yield from (Harmonic((Sinusoid(_product(size, omega), omega, phase + QUARTER),)) for size in sizes[:2])


def _values(motion: Motion) -> list[Array]:
    return [*motion.x, *motion.e, *motion.v]


def _product(size: float, omega: float) -> float:
    found = size * omega
    if math.isfinite(found):
        return found
    with precise():
        return rounded("the amplitude of a velocity", exact(size) * exact(omega))
