"""Phugoid: the scene of an aircraft without control, which exchanges height and speed (D31, points 8 to 10)."""

from __future__ import annotations

from functools import cache

from components.language.blocks import Block
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.sheet import column, stage, words
from components.layout.views import View, in_views
from components.quantities.motion import pace
from components.quantities.parameters import Quantity, Values, mass, one_of, positive
from components.quantities.readouts import Readout, SceneNumber
from components.quantities.units import Unit
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scenes.phugoid.about import flight_about
from components.scenes.phugoid.axes import Axes, axes_of
from components.scenes.phugoid.curves import Signals, columns_of, curves
from components.scenes.phugoid.flight import (
    PATH,
    Places,
    flight_shapes,
    lift_shapes,
    outline,
    period_shapes,
    velocity_shapes,
)
from components.scenes.phugoid.numbers import Numbers as N
from components.scenes.phugoid.plots import exchange_plots, lift_plot, path_plot, period_plot, swing_plot, velocity_plot
from components.scenes.phugoid.swing import AIRCRAFT, FOOT, LENGTHS, SPEEDS, Swing
from components.scenes.phugoid.watch import WATCH
from physics.phugoid import CUSP_EXCESS, EXCESS_AT_LATENESS

LARGEST = 3.0  # largest extra speed in v_0; the flight is then a small circle far below level flight


class Phugoid(Scene):
    slug = "phugoid"
    title = "Phugoid"
    lecture = "D31"
    points = "points 8 to 10"
    headline = "Without losses, an aircraft oscillates; speed sets the period, not mass"
    spoken = {"period by the linear theory": N.tau, "this swing": N.late}
    equations = (
        "V' = -g sin(theta); V theta' = g (V/v_0)^2 - g cos(theta); lift over weight = (V/v_0)^2",
        "h and v from those of steady flight: v = V - v_0; v = excess v_0 at t = 0 in level flight",
        "to first order: h'' + omega^2 h = 0; omega = sqrt(2) g/v_0; v = -g h/v_0",
    )
    places = tuple(AIRCRAFT)
    watch = WATCH
    presets = {
        "Ripple, 0.1": {"excess": 0.1},
        "Deep, 0.6": {"excess": 0.6},
        "Cusp, 0.732": {"excess": CUSP_EXCESS},
        "Loop, 1": {"excess": 1.0},
    }

    excess = Quantity(
        0.6, symbol="v′", unit="v₀", label="extra speed at the start", tint="T",
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
    unit = one_of("ft/s", list(SPEEDS), "Unit of speed")
    views = (
        View(
            "Period", "Change the speed *v*_0, the mass *m*, the disturbance *v*′: which of them changes the period?",
            keys=(v_0, m, excess), names=("plot:path", "plot:period"),
        ),
        View(
            "Height, speed", "Follow the aircraft: where is it fastest, at the top, at the bottom, or between?",
            keys=(excess,), names=("plot:path", "plot:h_t", "plot:v_t"),
        ),
        View(
            "Lift", "Watch the lift: where is it more than the weight, and what does that do to the path?",
            keys=(excess,), names=("plot:path", "plot:lift"),
        ),
        View(
            "Energy", "Compare with a spring: how often in one period is energy exchanged?",
            keys=(excess,), names=("plot:flight_energy", "plot:spring_energy"),
        ),
        View(
            "Limits", "Drag the tip: from which disturbance on does the aircraft fly a loop?",
            keys=(excess,), names=("plot:path", "plot:velocity"),
        ),
    )  # fmt: skip
    old_views = {"show": {"period": "period", "lift": "lift", "exchange": "energy", "limits": "limits"}}

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

    groups = (
        Group("Extra speed at the start", (excess,), "period longer by"),
        Group("Aircraft", (v_0, m)),
        Group(
            "Examples",
            (g, unit),
            "Gravity, unit of speed",
            actions=tuple((name, label.split()[0]) for name, (label, _, _) in AIRCRAFT.items()),
            folded=True,
        ),
    )

    @classmethod
    @cache
    def sheet(cls) -> Block:
        shapes = [*flight_shapes(), *lift_shapes(), *period_shapes(), *velocity_shapes()]
        label = "The flight path with the aircraft, beside the spring and mass it mimics"
        return column(
            column(
                stage(*shapes, label=label, grow=0, basis=26, phone=0, height=28, style="still"), path_plot(), grow=262
            ),
            in_views(column(period_plot(), grow=370), "period"),
            in_views(column(swing_plot(low=False), swing_plot(low=True), grow=370), "height"),
            in_views(column(*lift_plot(), grow=370), "lift"),
            in_views(column(*exchange_plots(), grow=370), "energy"),
            in_views(column(velocity_plot(), grow=370), "limits"),
            in_views(words(f"{N.verdict}", phone=16), "height", "limits"),
        )

    def picture(self, frame: Frame = FITTED) -> Picture:
        swing = self._swing(frame)
        axes = framed(frame, axes_of(swing))
        traces, columns = curves(swing, Axes.along(axes).end)
        return Picture(
            columns=columns | columns_of(swing, axes),
            axes=axes,
            signals=Signals.signals(swing, axes),
            traces=traces,
            scalars=Places.scalars(swing, axes),
            pace=pace(swing.linear.omega, swing.fastest),
            values=N.texts(swing, axes),
            live=Signals.live(axes),
        )

    @property
    def numbers(self) -> dict[str, SceneNumber]:
        return N.numbers(self._swing())

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._swing())

    def about(self, shown: Picture) -> About:
        return flight_about(shown, self._swing())

    def _swing(self, frame: Frame = FITTED) -> Swing:
        seen = {"unit": self.unit, "view": self.view, "window": self.window, "frame_window": frame.window}
        return Swing(v_0=self.v_0, g=self.g, excess=self.excess, **seen)
