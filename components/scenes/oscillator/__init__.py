"""Oscillator: the scene of spring and mass, with x, v and a as one turning arrow (D31, points 1 to 3)."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from msgspec.structs import replace

from components.language.blocks import Block
from components.language.signals import AnySignal
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.stage import wire
from components.quantities.axes import ONE, Axis, nice_axis, time_axis
from components.quantities.motion import QUARTER, pace, scaled, sines
from components.quantities.numbers import MINUS, power_unit, three
from components.quantities.parameters import displacement, mass, one_of, stiffness, velocity
from components.quantities.readouts import Readout
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns, Floats, Traces, bands_over_time, samples, trace
from components.scenes.oscillator.about import oscillator_about
from components.scenes.oscillator.numbers import LEADS, Oscillation
from components.scenes.oscillator.numbers import Numbers as N
from components.scenes.oscillator.pull import Force, force
from components.scenes.oscillator.sheet import WATCH, oscillator_sheet
from physics.oscillator import Oscillator
from physics.sampling import Sinusoid, drawable

LONGEST = 24
"""Characters of numbers in the second form of x."""
MOST_SWINGS = 6
"""In a longer window a quarter period is too short to be marked."""
UNITS = {"x": "m", "v": "m/s", "a": "m/s²"}
ROOM = {"x": (1.25, 1.25), "v": (1.15, 1.6), "a": (1.2, 1.75)}
"""The reach of an axis below and above, in amplitudes; over v and a stand the marks of the quarter period."""


class OscillatorScene(Scene):
    slug = "oscillator"
    title = "Oscillator"
    lecture = "D31"
    points = "points 1 to 3"
    headline = "A swing is a turning arrow, seen from the side"
    spoken = {"natural frequency": N.omega, "period": N.tau}
    equations = (
        "m x'' + k x = 0",
        "omega_n = sqrt(k/m); v = x'; a = x''; x = x_0 and v = v_0 at t = 0",
    )
    groups = (Group("Mass and spring", ("m", "k")), Group("Start", ("x_0", "v_0")), Group("Shown", ("view",)))
    shares = {"mass": "m", "stiffness": "k"}
    watch = WATCH
    presets = {
        "Pulled": {"x_0": 0.15, "v_0": 0.0},
        "Kicked": {"x_0": 0.0, "v_0": 0.8},
        "Pushed back": {},
        "Heavy": {"m": 4.0},
        "Stiff": {"k": 158.0},
        "Rest": {"x_0": 0.0, "v_0": 0.0},
        "No spring": {"k": 0.0, "v_0": 0.02},
    }
    opens = {**presets["Pulled"], "view": "swing"}

    m = mass(
        1.0, symbol="m", tint="m1", says="is the mass. Four times the mass swings half as fast. Any value above 0."
    )
    k = stiffness(39.4, symbol="k", says="is the stiffness of the spring. At 0 the mass is free. Any value from 0 up.")
    x_0 = displacement(
        0.1, symbol="x_0", tint="m1", softbounds=(-0.3, 0.3),
        says="is where the mass starts, away from the wall. Any number.",
    )  # fmt: skip
    v_0 = velocity(
        -0.8, symbol="v_0", tint="T", softbounds=(-2.0, 2.0),
        says="is the velocity at the start, positive away from the wall. Any number.",
    )  # fmt: skip
    view = one_of(
        default="motion",
        objects={"Motion": "swing", "Formulas": "motion", "Force": "force"},
        label="What is shown beside the motion",
    )

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return oscillator_sheet()

    def picture(self, frame: Frame = FITTED) -> Picture:
        swing = self._swing(frame)
        t = np.linspace(0.0, swing.end, samples(swing.end, swing.omega))
        bands = {} if drawable(swing.omega, t) else _bands(swing, t)
        axes = framed(frame, _axes(swing))
        reach = max(swing.amplitudes["x"], abs(self.x_0))
        pull = force(self.k, reach, axes["x"]) if self.view == "force" else Force()
        values = N.texts(swing, axes) | pull.values
        return Picture(
            columns=bands_over_time(t, bands),
            axes=axes,
            signals=_signals(swing, axes) | pull.signals,
            traces={
                "time": Traces(swing.end, t.size, () if bands else tuple(LEADS), swing.exact),
                "loop": Traces(*swing.loop, tuple(LEADS), swing.exact),
            },
            scalars=_scalars(swing, axes, t) | pull.scalars,
            pace=pace(swing.omega, swing.omega),
            values=values,
            live={"x": axes["x"].digits(signed=True), **pull.live},
            forms=_forms(swing, values)
            | {
                "force": "shown" if self.view == "force" else "",
                "idea" if self.view == "swing" else "formulas": "shown",
            },
        )

    def _swing(self, frame: Frame = FITTED) -> Oscillation:
        oscillator = Oscillator(m=self.m, k=self.k)
        return Oscillation(oscillator=oscillator, x_0=self.x_0, v_0=self.v_0, window=self.window, standing=frame.window)

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._swing())

    def about(self, shown: Picture) -> About:
        return oscillator_about(shown, Oscillator(m=self.m, k=self.k), self.x_0, self.v_0)


def _bands(swing: Oscillation, t: Floats) -> Columns:
    """The bands that x, v and a fill where they are too fast to draw."""
    phi, bands = swing.constants.phi, Columns()
    for name, shift in LEADS.items():
        bands |= trace(name, [Sinusoid(swing.amplitudes[name], swing.omega, phi + shift)], t)[1]
    return bands


def _axes(swing: Oscillation) -> dict[str, Axis]:
    """Ticks stand at the amplitudes; the path of a free mass has round ones."""
    axes = {"t": time_axis(swing.own_end)}
    for name, room in ROOM.items():
        marked = swing.turns and name != "x"
        axes[name] = _amplitude_axis(swing.amplitudes[name], UNITS[name], *room, 0.95 * room[1] if marked else 1.0)
    if not swing.omega and swing.v_0:
        ends = 0.0, swing.x_0, swing.x_0 + swing.v_0 * swing.end
        low, high = min(ends), max(ends)
        power_unit(2 * (high - low))
        axes["x"] = nice_axis(low, high, "m")
    return axes | {"a_bare": replace(axes["a"], labels=("",) * len(axes["a"].ticks))}


def _amplitude_axis(size: float, unit: str, below: float, above: float, seen: float) -> Axis:
    """It reaches `below` and `above`, in amplitudes; what must be seen ends at `seen`."""
    if not size:
        return Axis(-below, above, unit, ticks=(0.0,), labels=(f"0 {unit}",), drawn=(0.0, 0.0))
    power_unit(above * size)
    exponent, suffix = power_unit(size)
    bare = Axis(-below * size, above * size, unit, exponent, suffix, drawn=(-size, seen * size))
    top = bare.place(size)
    return replace(bare, ticks=(-top, 0.0, top), labels=(MINUS + three(top), "0", f"{three(top)} {bare.full_unit}"))


def _signals(swing: Oscillation, axes: dict[str, Axis]) -> dict[str, AnySignal]:
    """x, v and a, and the direction of the arrow."""
    time, omega, phi = axes["t"], swing.omega, swing.constants.phi
    if not omega:
        lines = {"x": (swing.x_0, swing.v_0), "v": (swing.v_0, 0.0), "a": (0.0, 0.0)}
        return {name: sines(axes[name], time, line=line) for name, line in lines.items()}
    sizes = swing.amplitudes
    return {
        **{name: sines(axes[name], time, (sizes[name], omega, phi + shift)) for name, shift in LEADS.items()},
        "cosine": sines(ONE, time, (1.0, omega, phi + QUARTER)),
        "sine": sines(ONE, time, (1.0, omega, phi)),
    }


def _scalars(swing: Oscillation, axes: dict[str, Axis], t: Floats) -> dict[str, float]:
    """Sizes on the stage, the arrow at the start, the peaks that are marked, and the clock's speed."""
    phi, time = swing.constants.phi, axes["t"]
    reach = axes["x"].place(max(abs(axes["x"].start), axes["x"].end)) / ROOM["x"][0]
    scalars = {
        "side": min(max(math.sqrt(swing.oscillator.m), 0.5), 1.5),
        "wire": wire(swing.oscillator.k),
        "per_window": 1 / time.place(swing.end),
        "per_x": 1 / reach,
    }
    if not swing.turns:
        return scalars
    exponent = axes["x"].exponent - axes["v"].exponent
    scalars |= {"per_v": scaled(exponent, 1 / swing.omega), "x_start": axes["x"].place(swing.x_0)}
    scalars |= {"v_start": axes["v"].place(swing.v_0), "turns": 1.0}
    scalars |= {"C": axes["x"].place(swing.constants.C), "phi": phi}
    scalars |= {"start_cosine": math.cos(phi), "start_sine": math.sin(phi)}
    scalars |= {"middle_cosine": math.cos(phi / 2.6), "middle_sine": math.sin(phi / 2.6)}
    scalars |= {"under": math.copysign(1, phi), "outside": math.copysign(1, math.cos(phi))}
    scalars |= {"has_A": float(abs(math.sin(phi)) > 0.15), "has_B": float(abs(math.cos(phi)) > 0.15)}
    scalars |= {"has_phi": float(abs(phi) > 0.4), "atan": float(swing.v_0 < 0)}
    if drawable(swing.omega, t):
        scalars |= {"swings": swing.end / swing.oscillator.period} | _leads(swing, axes)
    return scalars


def _leads(swing: Oscillation, axes: dict[str, Axis]) -> dict[str, float]:
    """The last peak of x in the window, and those of v and a before it; none out of the frame or too close."""
    tau = swing.oscillator.period
    first_peak = ((QUARTER - swing.constants.phi) % (2 * math.pi)) / (2 * math.pi)
    peak = first_peak + math.floor(swing.end / tau - first_peak)
    if peak < 0.5 or swing.end > MOST_SWINGS * tau or any(swing.amplitudes[name] > axes[name].end for name in LEADS):
        return {}
    peaks = {f"peak_{name}": axes["t"].place((peak - i / 4) * tau) for i, name in enumerate(LEADS)}
    tops = {f"top_{name}": axes[name].place(swing.amplitudes[name]) for name in LEADS}
    return {"leads": 1.0, **peaks, **tops}


def _forms(swing: Oscillation, values: dict[str, str]) -> dict[str, str]:
    """Which sentences stand; the second form of x is left out where its numbers are too long for the line."""
    if not swing.omega:
        why = "drift" if swing.v_0 else "still"
        return {"kind": "drift", "why": why, "B": "drift", "C": "", "phi": "", "parts": "left_out"}
    start = "wrong" if swing.v_0 < 0 else "right" if swing.v_0 > 0 else "zero"
    length = sum(len(values[name]) for name in ("A_plain", "B_plus", "omega", "omega"))
    parts = "shown" if length <= LONGEST else "left_out"
    return {
        "kind": "turn",
        "why": start if swing.turns else "rest",
        "B": "turn",
        "C": "turn",
        "phi": "turn" if swing.turns else "",
        "parts": parts,
    }
