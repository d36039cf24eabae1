"""Two masses, the first of which is driven: the base class of the motions with and without dashpots."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from components import chain
from components.chain import BOTH
from components.chain.parameters import Pair
from components.language.signals import AnySignal, Sines
from components.quantities.axes import Axis
from components.quantities.declared import Column, Declared, DrawnAxis, Family, Signal, by_name
from components.quantities.motion import sines
from components.scene.traces import Columns, Floats
from physics.bode import Resonances, chain_resonances
from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain
from physics.forced import DrivenModes, antiresonance
from physics.sampling import drawable
from physics.transient import DampedModes

signal = Signal[Any]


class Axes(chain.Axes):
    """Axes of energies, of the response, of lags and of the complex plane. F scales the drive and is not drawn."""

    E, omega, X, F, lag, re, im = DrawnAxis.some(7)


class Signals(chain.Signals):
    """Further axes: the parts of the displacements, or the responses of both modes to the drive; near resonance, the
    envelopes of the growing motion, up and down, and the straight line; the drive.
    """

    x_p, x_c = signal.each(BOTH, "x{}_p"), signal.each(BOTH, "x{}_c")
    x_driven = signal.each(BOTH, "x{}_driven")
    beat, fall = signal.each(BOTH, "x{}_beat"), signal.each(BOTH, "x{}_fall")
    growth = signal.each(BOTH, "x{}_growth")
    force_now = signal(on=Axes.F, signed=True)


class Work(Declared[Any]):
    """The change of T + V since the start, the work of the drive, and the lower limit of both."""

    gain, work, zero = Column[Any].some(3, "energy")


S = Signals
MARKS = ("minus", "still", "plus")
"""The natural frequencies, and between them the frequency at which mass 1 does not move."""
Both = Family[int, Signal[Any]]
Found = dict[Signal[Any], AnySignal]


def of_both(*parts: tuple[Both, Floats]) -> Columns:
    """Return columns by name, from an array with one row for each mass."""
    return by_name({of[i]: rows[i - 1] for i in BOTH for of, rows in parts})


class Growth(NamedTuple):
    """Return size sin(rate t)/rate in m, and size t at rate 0: the factor by which a response near resonance grows."""

    size: float
    rate: float

    def at(self, t: Floats) -> Floats:
        swing: Floats = self.size * t * np.sinc(self.rate * t / np.pi)
        return swing

    def signal(self, size: Axis, time: Axis) -> Sines:
        if self.rate:
            return sines(size, time, (self.size / self.rate, self.rate, 0.0))
        return sines(size, time, line=(0.0, self.size))


@dataclass(frozen=True, eq=False)
class ForcedCase:
    """A driven motion over a window that ends at `end`, in s, shown in a `view`."""

    modes: DrivenModes | DampedModes
    end: float
    view: str = "response"

    @property
    def chain(self) -> TwoMassChain:
        return self.modes.chain

    @property
    def driven(self) -> bool:
        return bool(self.modes.F_0 and self.modes.omega)

    @property
    def comparable(self) -> bool:
        """True if the lecture's units sqrt(k1/m1) and F0/k1 exist."""
        return self.chain.k1 > 0 and self.modes.F_0 > 0

    @cached_property
    def natural(self) -> Pair:
        """Both natural frequencies without dashpots."""
        slow, fast = self.chain.modes().omega.tolist()
        return slow, fast

    @cached_property
    def fastest(self) -> float:
        """The largest angular frequency of the motions."""
        return max(self.modes.omega, self.natural[1])

    @property
    def stills(self) -> bool:
        """True if mass 1 does not move at some drive frequency."""
        return bool(self.chain.k2)

    @cached_property
    def marks(self) -> dict[str, float]:
        """The natural frequencies at which mass 1 moves, and the frequency at which it does not."""
        slow, fast = self.natural
        if not self.chain.k2:
            return {"plus": fast}
        return {"minus": slow, "plus": fast} | ({"still": antiresonance(self.chain)} if self.stills else {})

    @cached_property
    def marked(self) -> dict[str, float]:
        """The natural frequencies above 0, and sqrt(k2/m2), even if mass 1 moves there."""
        every = self.marks | ({"still": antiresonance(self.chain)} if self.chain.k2 else {})
        return {name: w for name, w in every.items() if w > 0}

    @property
    def damping(self) -> Pair:
        """The damping constants c1 and c2."""
        return 0.0, 0.0

    @cached_property
    def damped(self) -> DampedChain:
        return DampedChain.of(self.chain, *self.damping)

    @property
    def extremes(self) -> tuple[Resonances, ...]:
        """Peaks and dips of X1 and X2 over F_0, with dashpots and in the view that shows them."""
        return chain_resonances(self.damped)[:2] if self.view == "bode" and any(self.damping) else ()

    @cached_property
    def works(self) -> Pair:
        """The energies in J that the dashpots take in a cycle of the steady motion, in the view that shows them."""
        shown = self.view == "nyquist" and self.driven
        return self.damped.works(self.modes.omega, self.modes.F_0) if shown else (0.0, 0.0)

    @property
    def split(self) -> bool:
        """True if the parts are drawn."""
        raise NotImplementedError

    @property
    def moving(self) -> tuple[str, ...]:
        """The displacements, and their parts if they are drawn."""
        return tuple(of[i].name for i in BOTH for of in ((S.x, S.x_p, S.x_c) if self.split else (S.x,)))

    @property
    def in_doubles(self) -> bool:
        """True if the motion, computed in doubles, is right to all digits that are drawn."""
        return True

    def energy(self, t: Floats) -> dict[Column[Any], Floats]:
        """The change of T + V since the start and the work of the drive."""
        raise NotImplementedError

    def energy_range(self, t: Floats) -> dict[Column[Any], Floats]:
        """The energies between which all of them are."""
        return self.energy(t)

    def energies(self, t: Floats, is_drawn: bool) -> dict[Column[Any], Floats]:
        """The energies, or only what their axis needs; none if they are too fast to be drawn.

        If they would be expensive or leave the range of doubles, the view Work raises ValueError; other views leave
        them out.
        """
        if not drawable(2 * self.fastest, t) or not (self.in_doubles or self.view == "work"):
            return {}
        try:
            return self.energy(t) if is_drawn else self.energy_range(t)
        except ValueError:
            if self.view == "work":
                raise
            return {}

    @property
    def limits(self) -> dict[Signal[Any], Growth]:
        """The growth of the amplitudes, up and down, if they grow."""
        return {}

    def limiting(self, t: Floats) -> Columns:
        return by_name({one: limit.at(t) for one, limit in self.limits.items()})

    def drive(self, time: Axis, force: Axis) -> Found:
        """The drive for the clock, as a sine of size 1 and as a force."""
        F_0, omega = self.modes.F_0, self.modes.omega
        size = sines(Axis(0.0, 1.0), time, (1.0 if F_0 else 0.0, omega, 0.0))
        return {S.drive: size, S.force_now: sines(force, time, (F_0, omega, 0.0))}
