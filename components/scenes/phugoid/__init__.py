"""Phugoid: the scene of an aircraft left alone, which trades height for speed (D31, points 8 to 10)."""

from __future__ import annotations

from functools import cache

import numpy as np
from msgspec.structs import replace

from components.language.blocks import Block
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.sheet import choice, column, desk, row, stage, when, words
from components.layout.stage import NARROW, WIDE, Shape, W, text
from components.quantities.axes import Axis, nice_axis, time_axis
from components.quantities.motion import pace
from components.quantities.parameters import Quantity, Values, mass, one_of, positive
from components.quantities.readouts import Readout
from components.quantities.units import Unit
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scene.traces import samples
from components.scenes.phugoid.about import flight_about
from components.scenes.phugoid.flight import (
    flight_shapes,
    ground_axes,
    lift_shapes,
    outline,
    velocity_axes,
    velocity_shapes,
)
from components.scenes.phugoid.numbers import Numbers as N
from components.scenes.phugoid.plots import (
    exchange_plots,
    lift_plot,
    path_plot,
    period_plot,
    period_shapes,
    swing_plot,
    velocity_plot,
)
from components.scenes.phugoid.swing import (
    AIRCRAFT,
    FOOT,
    Swing,
    curves,
    family_velocities,
    lift_signals,
    motion_signals,
    path_times,
    share_signals,
    velocities,
)
from components.scenes.phugoid.watch import WATCH
from physics.phugoid import CUSP_EXCESS, EXCESS_AT_LATENESS, flight, linear_phugoid

KNOT = 1852 / 3600
SPEEDS = {"ft/s": FOOT, "m/s": 1.0, "knots": KNOT, "km/h": 1 / 3.6}
LENGTHS = {"ft/s": ("ft", FOOT), "knots": ("ft", FOOT), "m/s": ("m", 1.0), "km/h": ("m", 1.0)}
FASTEST = 275.0  # m/s, the end of the plot of periods
LARGEST = 3.0  # v_0; the flight is then a small circle far below the level line
NAMES = {name: label for name, (label, _, _) in AIRCRAFT.items()}
VIEWS = {"period": "Period", "lift": "Lift", "exchange": "Exchange", "limits": "Limits"}
BESIDE = WIDE * 225 + NARROW * 165
"""Where v' stands: beside h', with room for the one that is held."""
TASK = "Change the speed v₀, the mass, the disturbance: which of them changes the period?"


class Phugoid(Scene):
    slug = "phugoid"
    title = "Phugoid"
    lecture = "D31"
    points = "points 8 to 10"
    headline = "Left alone, an aircraft swings; only its speed sets the period"
    pictured = ("path", {"excess": 0.5})
    spoken = {"period by the linear theory": N.tau, "this swing": N.late}
    equations = (
        "V' = -g sin(theta); V theta' = g (V/v_0)^2 - g cos(theta); lift over weight = (V/v_0)^2",
        "h and v from those of steady flight: v = V - v_0; v = excess v_0 at t = 0 in level flight",
        "to first order: h'' + omega^2 h = 0; omega = sqrt(2) g/v_0; v = -g h/v_0",
    )
    groups = (
        Group("Excess of speed", ("excess",), "period longer by"),
        Group("Aircraft", ("v_0", "m")),
        Group(
            "",
            ("g", "unit"),
            "Examples, gravity, unit of speed",
            actions=tuple((name, label.split()[0]) for name, (label, _, _) in AIRCRAFT.items()),
            folded=True,
        ),
    )
    places = tuple(AIRCRAFT)
    watch = WATCH
    presets = {
        "Ripple, 0.1": {"excess": 0.1},
        "Deep, 0.6": {"excess": 0.6},
        "Cusp, 0.732": {"excess": CUSP_EXCESS},
        "Loop, 1": {"excess": 1.0},
    }
    opens = {**presets["Ripple, 0.1"], "show": "lift"}

    excess = Quantity(
        0.6, symbol="v′", unit="v₀", label="excess of speed", tint="T",
        bounds=(-1.0, LARGEST), softbounds=(0.0, 1.1),
        allowed="an excess of speed is from −v₀ (standstill) to 3 v₀",
        says="is the speed in excess of v₀ at the start, in level flight. Below 0 the flight starts at its top.",
        marks=(
            (0.0, "0"), *((excess, f"{100 * late:.3g} %") for late, excess in EXCESS_AT_LATENESS.items()),
            (CUSP_EXCESS, "cusp"), (1.1, "loops"),
        ),
    )  # fmt: skip
    v_0 = positive(
        150 * FOOT, symbol="v_0", unit="m/s", label="speed of steady flight", tint="T",
        scale="log", softbounds=(5.0, 300.0),
        says="is the speed of steady flight. Of the aircraft it alone sets the period.",
    )  # fmt: skip
    m = mass(
        1100.0, symbol="m", tint="m1", label="mass of the aircraft", softbounds=(1.0, 1e5),
        says="is the mass. Move it: the flight does not change. Only v₀, g and the disturbance enter.",
    )  # fmt: skip
    g = positive(
        9.80665, symbol="g", unit="m/s²", label="gravity", tint="k", softbounds=(1.0, 30.0),
        says="is the gravity. A weaker one swings more slowly.",
    )  # fmt: skip
    unit = one_of(default="ft/s", objects=list(SPEEDS), label="Unit of speed")
    show = one_of(default="period", objects=list(VIEWS), label="View")

    @classmethod
    def drawings(cls) -> dict[str, str]:
        return {label: outline(values["excess"]) for label, values in cls.presets.items()}

    def units(self) -> dict[str, Unit]:
        size, (length, metres) = SPEEDS[self.unit], LENGTHS[self.unit]
        own = {"excess": Unit(self.unit, size / self.v_0)}
        speed = {} if size == 1 else {"v_0": Unit(self.unit, size)}
        return own | speed | ({} if metres == 1 else {"g": Unit(f"{length}/s²", metres)})

    def action(self, name: str) -> Values:
        _, speed, weight = AIRCRAFT[name]
        return {"v_0": speed, "m": weight}

    @classmethod
    @cache
    def sheet(cls) -> Block:
        shapes = [
            *_words(),
            *flight_shapes("path"),
            *lift_shapes("path", "is_lift"),
            *period_shapes(NAMES, "is_period"),
            *velocity_shapes("velocity", "is_limits"),
        ]
        label = "The flight path with the aircraft, beside the spring and mass it mimics"
        return column(
            desk(words(TASK, style="task", phone=0)),
            column(
                stage(*shapes, label=label, grow=0, basis=26, phone=0, height=28, style="still"), path_plot(), grow=262
            ),
            words(f"{N.verdict}", style="narrow", phone=6),
            row(
                column(
                    desk(choice("show", VIEWS, "View", phone=5)),
                    when("period", period_plot(NAMES)),
                    *(when("lift", block) for block in lift_plot()),
                    *(when("exchange", block) for block in exchange_plots()),
                    when("limits", velocity_plot()),
                    grow=430,
                ),
                column(swing_plot("h", "V", low=False), swing_plot("v", "T", low=True), grow=456),
                grow=370,
                gap=26,
            ),
        )

    def picture(self, frame: Frame = FITTED) -> Picture:
        swing = Swing(self.v_0, self.g, self.excess)
        own_window = self.window or float(f"{2.2 * swing.linear.tau:.2g}")
        end = frame.window or own_window
        swing.check(end)
        t = np.linspace(0.0, end, samples(end, swing.fastest))
        axes = framed(frame, {"t": time_axis(own_window), **self._axes(swing, end)})
        to_the_end = path_times(swing, end, axes["along"].end / swing.length)
        lap = flight(self.v_0, self.g, self.excess, np.linspace(0.0, swing.period, swing.nodes))
        traces, columns = curves(swing, t, to_the_end, self.show)
        limits = self.show == "limits"
        reach = np.array([0.0, axes["v_0"].end])
        return Picture(
            columns={
                **columns,
                "velocity": velocities(swing) if limits else {},
                "family": family_velocities() if limits else {},
                "periods": {"v_0": reach, "tau": linear_phugoid(1.0, self.g).tau * reach},
            },
            axes=axes,
            signals=motion_signals(swing, lap, axes["t"], axes["along"], axes["h"], axes["v"])
            | (lift_signals(swing, axes["v"]) if self.show == "lift" else {})
            | (share_signals(swing, axes, t) if self.show == "exchange" else {}),
            traces=traces,
            scalars=self._scalars(swing, axes),
            pace=pace(swing.linear.omega, swing.fastest),
            values=N.texts(swing, axes),
            live={
                **{name: axes[name].digits(signed=True) for name in ("h", "v")},
                **{name: axes["lift"].digits() for name in ("lift", "lift_linear") if self.show == "lift"},
            },
            forms={self.show: "shown"},
        )

    def _axes(self, swing: Swing, end: float) -> dict[str, Axis]:
        size, (length, metres) = SPEEDS[self.unit], LENGTHS[self.unit]
        along, up = ground_axes(swing, end, length, metres)
        # One frame for both: h' in v_0^2/g and v' in v_0 are mirror images in the linear theory.
        reach = max(abs(float(swing.lap.h.min())), abs(float(swing.lap.h.max())), abs(self.excess))
        fastest = FASTEST if self.v_0 <= FASTEST else 1.25 * self.v_0
        tau = nice_axis(0.0, linear_phugoid(fastest, self.g).tau, "s", 2, exact=True)
        return {
            "along": along,
            "up": up,
            "h": nice_axis(-reach * swing.length, reach * swing.length, length, 3, factor=metres),
            "v": nice_axis(-reach * swing.v_0, reach * swing.v_0, self.unit, 3, factor=size),
            "v_0": nice_axis(0.0, fastest, self.unit, 2, exact=True, factor=size),
            "tau": replace(tau, drawn=(0.0, tau.end * max(AIRCRAFT["airliner"][1], self.v_0) / fastest)),
            "share": Axis(0.0, 1.0, "%", ticks=(0.0, 50.0, 100.0), factor=0.01),
            "lift": nice_axis(0.0, float(max(swing.lap.u[0], 1.0)) ** 2, count=2),
            **velocity_axes(swing),
        }

    def _scalars(self, swing: Swing, axes: dict[str, Axis]) -> dict[str, float]:
        scalars = {
            "excess": self.excess,
            "head": axes["up"].place(swing.length),
            "is_period": float(self.show == "period"),
            "is_limits": float(self.show == "limits"),
            "is_lift": float(self.show == "lift"),
        }
        for name, top in (("top", swing.top), ("top_lin", swing.top_linear)):
            scalars |= {f"{name}_x": axes["along"].place(top[0]), f"{name}_y": axes["up"].place(top[1])}
        # Where many swings share the frame the names of the two paths have no room.
        scalars["named"] = float(swing.top[0] > 0.07 * axes["along"].end)
        # Beside a wide loop the others are too small to be named.
        scalars["family_named"] = float(axes["upward"].end < 2)
        scalars |= {"v_here": axes["v_0"].place(self.v_0), "tau_here": axes["tau"].place(swing.linear.tau)}
        for name, (_, speed, _) in AIRCRAFT.items():
            tau = linear_phugoid(speed, self.g).tau
            scalars |= {
                f"at_{name}": axes["v_0"].place(speed),
                f"tau_{name}_at": axes["tau"].place(tau),
            }
        return scalars

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(Swing(self.v_0, self.g, self.excess))

    def about(self, shown: Picture) -> About:
        return flight_about(shown, Swing(self.v_0, self.g, self.excess))


def _words() -> list[Shape]:
    return [
        text(0, 17, f"*h*′ = {{h}} {N.h_unit}", anchor="start", tint="V", style="t2 b"),
        text(BESIDE, 17, f"*v*′ = {{v}} {N.v_unit}", anchor="start", tint="T", style="t2 b"),
        text(W, 17, f"{N.verdict}", anchor="end", tint="ink", show="wide"),
    ]
