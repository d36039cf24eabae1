"""The curves of the coupled masses: sums of the modes, the stack of the energies, and the plane of x1 and x2."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, pairwise

import numpy as np

from components import chain
from components.chain.grabs import shares
from components.language.numbers import var
from components.language.signals import AnySignal
from components.quantities.declared import AxesInForce, Declared, DrawnAxis, Family, Scalar, Signal
from components.quantities.motion import derived, scaled, total
from components.scene.traces import Columns, Floats, Traces, band_columns, over_time, trace
from components.scenes.coupled.starting import GIVEN
from physics.coupled import FreeModes, Motion
from physics.energy import ChainEnergy, chain_energy
from physics.sampling import drawable

NAMED = 0.8
"""The names in the plane stand at this share of the way to its edge."""


@dataclass(frozen=True, eq=False)
class CoupledCase:
    """A free motion, what gives it, and what is shown of it."""

    free: FreeModes
    given_by: str
    energy: str
    view: str

    @cached_property
    def levels(self) -> dict[str, float]:
        """The energies of the modes and their sum, which stay as they are."""
        slow, fast = self.free.energy.tolist()
        return {"slow": slow, "fast": fast, "total": float(self.free.energy.sum())}

    def averaged(self, t: Floats) -> bool:
        """Whether the energies of masses and springs are drawn as means: they swing too fast for the instants t."""
        return self.energy == "parts" and not drawable(2 * float(self.free.omega[1]), t)


signal = Signal[CoupledCase]


class Axes(chain.Axes):
    E = DrawnAxis()


def _square(axes: AxesInForce, size: float, of: Signal[CoupledCase], per: int = 0) -> AnySignal:
    """Half the square of a displacement, or of a velocity (`per` 1), times the size of what has that energy."""
    exponent = Axes.E(axes).exponent - 2 * Axes.x(axes).exponent + 2 * per * Axes.t(axes).exponent
    return derived(scaled(exponent, 0.5, size) * var(of) * var(of))


def _level(case: CoupledCase, axes: AxesInForce, one: str) -> AnySignal | None:
    return derived(Axes.E(axes).place(case.levels[one])) if case.energy == "modes" else None


class Signals(chain.FreeSignals):
    """The energies of masses and springs and the edges of their stack, or the levels of the modes."""

    v = Family(chain.BOTH, lambda i: signal(lambda c, a: chain.both(Signals.v_part, i)))
    stretch = signal(lambda c, a: derived(var(Signals.x[2]) - var(Signals.x[1])))
    T1 = signal(lambda c, a: _square(a, c.free.chain.m1, Signals.v[1], 1), Axes.E)
    T2 = signal(lambda c, a: _square(a, c.free.chain.m2, Signals.v[2], 1), Axes.E)
    V1 = signal(lambda c, a: _square(a, c.free.chain.k1, Signals.x[1]), Axes.E)
    V2 = signal(lambda c, a: _square(a, c.free.chain.k2, Signals.stretch), Axes.E)
    e = Family(range(5), lambda i: signal(lambda c, a: total(*LAYERS[:i]) if c.energy == "parts" else None))
    E = Family((*chain.MODES, "total"), lambda one: signal(lambda c, a: _level(c, a, one)))


S = Signals
LAYERS: tuple[Signal[CoupledCase], ...] = (S.T1, S.V1, S.V2, S.T2)
EDGES, LEVELS = (tuple(family.values()) for family in (S.e, S.E))
BETWEEN = dict(zip(LAYERS, pairwise(EDGES), strict=True))
"""The edges of each energy in the stack."""


def exact(case: CoupledCase, t: Floats) -> dict[Signal[CoupledCase], Floats]:
    """All that may be drawn over time."""
    moved = _by_modes(case.free, t)
    motion = {one: moved[modes].x[i] for one, i, modes in motions(case.free)}
    levels = {S.E[one]: np.full_like(t, level) for one, level in case.levels.items()}
    energy = chain_energy(case.free.chain, case.free.motion(t))
    return motion | dict(zip(LAYERS, _layers(energy), strict=True)) | edges(energy) | levels


def _layers(energy: ChainEnergy) -> list[Floats]:
    return [energy.T[0], energy.V[0], energy.V[1], energy.T[1]]


def edges(energy: ChainEnergy) -> dict[Signal[CoupledCase], Floats]:
    layers = _layers(energy)
    return dict(zip(EDGES, accumulate([np.zeros_like(layers[0]), *layers]), strict=True))


def _by_modes(free: FreeModes, t: Floats) -> dict[tuple[int, ...], Motion]:
    """The motion in both modes, and in each."""
    slow, fast = free.parts(t)
    return {(0, 1): slow + fast, (0,): slow, (1,): fast}


def motions(free: FreeModes) -> Iterator[tuple[Signal[CoupledCase], int, tuple[int, ...]]]:
    """The displacements and their parts, of which mass and of which modes each is; of two drifts the slow part has
    both, as on the stage."""
    for i in chain.BOTH:
        yield S.x[i], i - 1, (0, 1)
        yield S.x_part[i, "slow"], i - 1, (0,) if free.omega[1] else (0, 1)
        if free.omega[1]:
            yield S.x_part[i, "fast"], i - 1, (1,)


def traces_of(case: CoupledCase, t: Floats, bands: Columns) -> dict[str, Traces]:
    """The curves over the instants t, but those that are `bands`; a file has all motions and the energies shown."""
    found = [one for one, *_ in motions(case.free)]
    lines = [one for one in found if band_columns(one.name)[0] not in bands]
    stacked, averaged = case.energy == "parts", case.averaged(t)
    drawn, shown = (() if averaged else EDGES, LAYERS) if stacked else (LEVELS, LEVELS)
    return over_time(
        float(t[-1]), float(case.free.chain.modes().omega[1]), [*lines, *drawn], lambda t: exact(case, t),
        moving=[*found, *shown], layers=BETWEEN, averaged=EDGES if averaged else (),
    )  # fmt: skip


def traced_motion(free: FreeModes, t: Floats) -> tuple[Columns, Columns]:
    """Columns of the displacements and their parts: curves, and bands where too fast."""
    moved, curves, bands = _by_modes(free, t), Columns(), Columns()
    for one, i, modes in motions(free):
        drifts = any(free.omega[j] == 0 for j in modes)
        base = free.drift_a[i] + free.drift_b[i] * t if drifts else None
        curve, band = trace(one, chain.components(free, i, modes), t, base, moved[modes].x[i])
        curves, bands = curves | curve, bands | band
    return curves, bands


class Places(Declared[CoupledCase]):
    """In the plane of x1 and x2 both mode directions and the places of their names; what gives the motion to a hand."""

    line = chain.lines_of("modes")
    name = Scalar[CoupledCase].each(((mode, i) for i, mode in chain.PARTS), "{}_name{}")
    by = Family(GIVEN, lambda one: Scalar[CoupledCase](lambda c, a: c.given_by == one))


def places(case: CoupledCase, axes: AxesInForce) -> dict[str, float]:
    """The name of the slow direction stands at its upper end, that of the fast one at its lower end; a mode is taken in
    hand where there is a fast one."""
    x, system = Axes.x(axes), case.free.chain
    end, ways = NAMED * x.place(min(-x.start, x.end)), chain.directions(system)
    names = {Places.name[mode, i].name: end * ways[j][i - 1] for j, mode in enumerate(chain.MODES) for i in chain.BOTH}
    return names | Places.scalars(case, axes) | (shares(system) if case.free.omega[1] else {})
