"""The driven motion as it is drawn: its parts, its energies, and near resonance the envelope of the growing beat."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from components.chain import components, free_signals, positions
from components.language.numbers import var
from components.language.signals import AnySignal, Sines
from components.quantities.axes import Axis
from components.quantities.motion import derived, responses, sines, total
from components.scene.traces import Columns, Floats, band_columns, trace
from physics.energy import chain_energy
from physics.forced import DrivenModes
from physics.sampling import Sinusoid, drawable

APART = 0.98
"""An envelope that falls below this share of the straight line is seen beside it."""
STRAIGHT = 1e-8
"""rad; an envelope that turns no further in its window is the line to the last digit."""


def motions(driven: DrivenModes, t: Floats) -> Columns:
    """x1, x2 and their particular and complementary parts in doubles, at times that resolve them: what a frame is
    fitted to. Where the parts are huge and opposite they are left out: see `limits`."""
    if not driven.split_is_meaningful:
        x = driven.motion(t).x
        return {"x1": x[0], "x2": x[1]}
    particular = np.outer(driven.particular, np.sin(driven.omega * t))
    found: Columns = {}
    for i, complementary in enumerate(positions(driven.complementary_modes, t).values()):
        name = f"x{i + 1}"
        found |= {name: particular[i] + complementary, f"{name}_p": particular[i], f"{name}_c": complementary}
    return found


def motion_columns(driven: DrivenModes, t: Floats) -> tuple[Columns, Columns]:
    """The motion and its parts to the last digits, as curves, or as bands where too fast to draw."""
    split = driven.split_is_meaningful
    motion, *parts = driven.apart(t) if split else (driven.motion(t),)
    drawn = dict(zip(("", "_p", "_c"), (motion.x, *parts), strict=False))
    if drawable(max(driven.free.omega[1], driven.omega), t):
        return {f"x{i + 1}{part}": x[i] for i in (0, 1) for part, x in drawn.items()}, {}
    curves, bands = Columns(), Columns()
    for i in (0, 1):
        for part, x in drawn.items():
            curve, band = _trace(driven, i, t, part, x[i]) if split else ({}, _band(driven, i, t))
            curves, bands = curves | curve, bands | band
    return curves, bands


def _trace(driven: DrivenModes, i: int, t: Floats, part: str, x: Floats) -> tuple[Columns, Columns]:
    """Of the displacement of mass i or one of its parts."""
    rest = driven.complementary_modes
    particular = [Sinusoid(driven.particular[i], driven.omega, 0.0)] if part != "_c" else []
    complementary = components(rest, i) if part != "_p" else []
    drift = rest.drift_a[i] + rest.drift_b[i] * t if part != "_p" else None
    return trace(f"x{i + 1}{part}", [*particular, *complementary], t, drift, x)


def resonant(driven: DrivenModes) -> bool:
    """Whether the drive is so close to a natural frequency that the motion is not shown as two parts."""
    return driven.omega > 0 and not driven.split_is_meaningful


def growth_rate(driven: DrivenModes, i: int) -> float:
    """The growth of the swing of mass i (0, 1) in a second at the nearest natural frequency, from rest, in m/s."""
    j = int(np.argmin(np.abs(driven.detuning)))
    return float(driven.F_0 * abs(driven.coupling[j, i]) / (2 * driven.free.omega[j]))


class Growth(NamedTuple):
    """size sin(rate t)/rate in m, at rate 0 size t: what a response next to resonance grows by."""

    size: float
    rate: float

    def at(self, t: Floats) -> Floats:
        swing: Floats = self.size * t * np.sinc(self.rate * t / np.pi)
        return swing

    def signal(self, size: Axis, time: Axis) -> Sines:
        if self.rate:
            return sines(size, time, (self.size / self.rate, self.rate, 0.0))
        return sines(size, time, line=(0.0, self.size))


def limits(driven: DrivenModes, end: float) -> dict[str, Growth]:
    """Near resonance the envelope of the growing part, up and down; empty elsewhere.

    With 2 d the detuning from the nearest mode it is growth_rate |sin(d t)/d|, at d = 0 growth_rate t; where the
    window is long enough to tell them apart, the straight line is there too.
    """
    found: dict[str, Growth] = {}
    if resonant(driven):
        d = _halfway(driven)
        if abs(d) * end < STRAIGHT:
            d = 0.0
        bent = abs(d) * end > 1 or np.sinc(d * end / np.pi) < APART
        for i in (0, 1):
            rate = math.copysign(growth_rate(driven, i), np.sinc(d * end / np.pi))
            found |= {f"x{i + 1}_beat": Growth(rate, d), f"x{i + 1}_fall": Growth(-rate, d)}
            if bent:
                found[f"x{i + 1}_growth"] = Growth(abs(rate), 0.0)
    return found


def _halfway(driven: DrivenModes) -> float:
    """Half the detuning from the nearest mode, in rad/s."""
    return float(driven.detuning[np.argmin(np.abs(driven.detuning))] / 2)


def _beat(driven: DrivenModes, i: int, t: Floats) -> Floats:
    return np.abs(Growth(growth_rate(driven, i), _halfway(driven)).at(t))


def _band(driven: DrivenModes, i: int, t: Floats) -> Columns:
    """The band that the displacement of mass i fills next to resonance."""
    beat = _beat(driven, i, t) if resonant(driven) else 0.0
    size = beat + _others(driven, i, int(np.argmin(np.abs(driven.detuning))))
    drift = driven.free.drift_a[i] + driven.free.drift_b[i] * t
    return dict(zip(band_columns(f"x{i + 1}"), (drift - size, drift + size), strict=True))


def _others(driven: DrivenModes, i: int, j: int) -> float:
    """The reach of all but the resonant response: the free motion of the start and the other mode's response."""
    other = 1 - j
    omega_n = driven.free.omega[other]
    reach = float(np.abs(driven.free.amplitude[:, i]).sum())
    if omega_n > 0 and driven.coupling[other, i]:
        reach += abs(driven.F_0 * driven.coupling[other, i] / driven.detuning[other]) / omega_n
    return reach


def energy_columns(driven: DrivenModes, t: Floats) -> Columns:
    """The gain of T + V since the start and the work of the drive."""
    energy = chain_energy(driven.chain, driven.motion(t)).total
    return {"gain": energy - energy[0], "work": driven.work(t), "none": np.zeros_like(t)}


def motion_signals(driven: DrivenModes, size: Axis, time: Axis, force: Axis) -> dict[str, AnySignal]:
    """The signals of the clock: the free motion of the start plus each mode's response, regular at resonance."""
    signals = free_signals(driven.free, size, time)
    X, omega = driven.particular.tolist(), driven.omega
    coupling, natural = driven.coupling.tolist(), driven.free.omega.tolist()
    for i in (0, 1):
        name = f"x{i + 1}"
        terms = [(driven.F_0, c[i], omega, omega_n) for c, omega_n in zip(coupling, natural, strict=True) if c[i]]
        signals[f"{name}_driven"] = responses(size, time, *terms)
        signals[name] = total(f"{name}_slow", f"{name}_fast", f"{name}_driven")
        if driven.split_is_meaningful:
            signals[f"{name}_p"] = sines(size, time, (X[i], omega, 0.0))
            signals[f"{name}_c"] = derived(var(name) - var(f"{name}_p"))
    signals["drive"] = sines(Axis(0.0, 1.0), time, (1.0 if driven.F_0 else 0.0, omega, 0.0))
    signals["force_now"] = sines(force, time, (driven.F_0, omega, 0.0))
    return signals
