"""The curves of the hanging mass, over time (with bands for what is too fast) and over x; the places on its stage."""

from __future__ import annotations

import math

import numpy as np

from components.language.numbers import Expression, var
from components.layout.stage import PlotFrame, wire
from components.quantities.axes import ONE, Axis
from components.quantities.declared import AxesInForce, Column, Declared, Scalar, Signal, by_name
from components.quantities.motion import QUARTER, derived, sines
from components.scene.traces import Columns, Floats, band_columns, bands_over_time, trace
from components.scenes.energy.case import Axes, HangingCase
from physics.sampling import Sinusoid, drawable

PLANETS = {"moon": ("Moon", 1.62), "mars": ("Mars", 3.71), "earth": ("Earth", 9.81), "jupiter": ("Jupiter", 24.8)}
"""Names and gravities in m/s^2."""
X, WELL, ENERGY = map(PlotFrame, ("x", "well", "energy"))

signal, scalar = Signal[HangingCase], Scalar[HangingCase]


def _weight(case: HangingCase, axes: AxesInForce) -> Expression:
    return Axes.E(axes).place(case.weight) * var(Signals.sine)


class Signals(Declared[HangingCase]):
    """x, and the energies from the sine and cosine of the phase."""

    x = signal(lambda c, a: sines(Axes.x(a), Axes.t(a), (c.constants.C, c.omega, c.constants.phi)), Axes.x, signed=True)
    sine = signal(lambda c, a: sines(ONE, Axes.t(a), (1.0, c.omega, c.constants.phi)))
    cosine = signal(lambda c, a: sines(ONE, Axes.t(a), (1.0, c.omega, c.constants.phi + QUARTER)))
    T = signal(lambda c, a: derived(Axes.E(a).place(c.E) * COSINE_2), Axes.E)
    V = signal(lambda c, a: derived(Axes.E(a).place(c.E) * SINE_2 + Axes.E(a).place(c.shift)), Axes.E)
    spring = signal(
        lambda c, a: derived(Axes.E(a).place(c.E) * SINE_2 + _weight(c, a) + Axes.E(a).place(c.constant)), Axes.E
    )
    gravity = signal(lambda c, a: derived(-_weight(c, a)), Axes.E, signed=True)
    constant = signal(lambda c, a: derived(-Axes.E(a).place(c.constant)), Axes.E, signed=True)
    total = signal(lambda c, a: derived(Axes.E(a).place(c.E) + Axes.E(a).place(c.shift)))
    V_share = signal(lambda c, a: derived((c.total and c.E / c.total) * SINE_2 + (c.total and c.shift / c.total)))


SINE_2: Expression = var(Signals.sine) * var(Signals.sine)
COSINE_2: Expression = var(Signals.cosine) * var(Signals.cosine)


def exact(case: HangingCase, t: Floats) -> dict[Signal[HangingCase], Floats]:
    """x, T and V, the energies of spring and gravity counted apart, and what stands still."""
    motion, S = case.system.motion(case.x_0, case.v_0, t), Signals
    energies = case.system.energies(motion.x, motion.v, "separate" if case.separate else "equilibrium")
    return {
        S.x: motion.x, S.T: energies.T, S.V: energies.V, S.spring: energies.spring, S.gravity: energies.gravity,
        S.total: np.full_like(t, case.total), S.constant: np.full_like(t, -case.constant),
    }  # fmt: skip


def drawn(case: HangingCase) -> tuple[list[Signal[HangingCase]], dict[str, Columns]]:
    """The signals that are drawn as curves over time, and the bands of those that are too fast."""
    omega, phi, half, S = case.omega, case.constants.phi, case.E / 2, Signals
    potential = Sinusoid(half, 2 * omega, 2 * phi - QUARTER)
    swings: dict[Signal[HangingCase], tuple[list[Sinusoid], float]] = {
        S.x: ([Sinusoid(case.constants.C, omega, phi)], 0.0),
        S.T: ([Sinusoid(half, 2 * omega, 2 * phi + QUARTER)], half),
        S.V: ([potential], half + case.shift),
    }
    if case.apart:
        stretch = Sinusoid(case.weight, omega, phi)
        swings[S.spring] = [potential, stretch], half + case.constant
        swings[S.gravity] = [stretch._replace(phase=phi + math.pi)], 0.0
    bands: Columns = {}
    for one, (parts, base) in swings.items():
        if not drawable(max(part.omega for part in parts), case.t):
            bands |= trace(one, parts, case.t, np.full_like(case.t, base))[1]
    slow = [one for one in moving(case) if band_columns(one.name)[0] not in bands]
    return slow, bands_over_time(case.t, bands)


def moving(case: HangingCase) -> list[Signal[HangingCase]]:
    """x, the energies that are shown, and their levels."""
    S = Signals
    terms = [S.spring, S.gravity] if case.apart else []
    levels = [S.total, S.constant] if case.datum == "slide" else [S.total]
    return [S.x, S.T, S.V, *terms, *levels]


class Well(Declared[HangingCase]):
    """V and its terms over x."""

    x, V, spring, gravity, constant, other = Column[HangingCase].some(6, "well")


def well_columns(case: HangingCase, axes: dict[str, Axis]) -> Columns:
    """V over x; term by term, also its terms, and where the slide's constant is not among them, the slide's V."""
    x = np.linspace(Axes.x_well(axes).start, Axes.x_well(axes).end, 121)
    slide = case.system.well(x)
    if not case.apart:
        return by_name({Well.x: x, Well.V: slide})
    parts = case.system.energies(x, np.zeros_like(x))
    columns = {Well.x: x, Well.spring: parts.spring, Well.gravity: parts.gravity}
    if case.separate:
        return by_name(columns | {Well.V: case.system.well(x, "separate"), Well.other: slide})
    return by_name(columns | {Well.V: slide, Well.constant: np.full_like(x, -case.constant)})


def _tenth(axes: AxesInForce) -> float:
    """Less than this apart, in m, two levels have one name."""
    return 0.1 * (Axes.x(axes).start - Axes.x(axes).end)


class Places(Declared[HangingCase]):
    x_top = scalar(lambda c, a: Axes.x(a).place(Axes.x(a).end))
    x_bottom = scalar(lambda c, a: Axes.x(a).place(Axes.x(a).start))
    per_span = scalar(lambda c, a: 1 / (Axes.x(a).place(Axes.x(a).start) - Axes.x(a).place(Axes.x(a).end)))
    per_window = scalar(lambda c, a: 1 / Axes.t(a).place(c.end))
    natural = scalar(lambda c, a: Axes.x(a).place(max(-c.system.delta_st, Axes.x(a).end)))
    natural_seen = scalar(lambda c, a: -c.system.delta_st >= Axes.x(a).end)
    natural_far = scalar(lambda c, a: -c.system.delta_st < Axes.x(a).end)
    apart = scalar(lambda c, a: c.system.delta_st > _tenth(a))
    close = scalar(lambda c, a: 0 < c.system.delta_st <= _tenth(a))
    together = scalar(lambda c, a: not c.system.delta_st)
    has_energy = scalar(lambda c, a: c.total > 0)
    swinging = scalar(lambda c, a: c.constants.C > 0)
    shift = scalar(lambda c, a: Axes.E(a).place(c.shift))
    shifted = scalar(lambda c, a: c.shift > 0.1 * (Axes.E(a).end - Axes.E(a).start))
    C = scalar(lambda c, a: Axes.x(a).place(c.constants.C))
    phi = scalar(lambda c, a: c.constants.phi)
    side = scalar(lambda c, a: min(max(math.sqrt(c.system.m), 0.5), 1.3))
    wire = scalar(lambda c, a: wire(c.system.k))
    swings = scalar(lambda c, a: c.end / c.system.oscillator.period if drawable(c.omega, c.t) else None)
    planet, seen, here = (scalar.each(PLANETS, called) for called in ("{}", "{}_seen", "{}_here"))


def planets_of(case: HangingCase, axes: dict[str, Axis]) -> dict[str, float]:
    """Where the mass would hang elsewhere, as far as that is in the picture and apart from what else is."""
    found, x, taken = {}, Axes.x(axes), [0.0, -case.system.delta_st]
    for slug, (_, g) in PLANETS.items():
        found[Places.here[slug]] = float(g == case.system.g)
        place = case.system.delta_st * (g / case.system.g - 1) if case.system.g else g * case.system.m / case.system.k
        apart = min(abs(place - other) for other in taken) > 0.065 * (x.start - x.end)
        if apart and x.end <= place <= x.start:
            taken.append(place)
            found |= {Places.planet[slug]: x.place(place), Places.seen[slug]: 1.0}
        elif found[Places.here[slug]]:
            found[Places.planet[slug]] = 0.0
    return by_name(found)
