"""A mass between two walls: its springs stand side by side, so their stiffnesses add."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property

from components.language.blocks import Block
from components.language.numbers import var
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.plots import curve, plot
from components.layout.sheet import column, stage, term, words
from components.layout.stage import H, PlotFrame, Shape, W, box, line, spring, text, wall, wire
from components.quantities.axes import nice_axis, time_axis
from components.quantities.declared import AxisUnit, Declared, DrawnAxis, LiveNumber, Scalar, Signal, by_name
from components.quantities.motion import pace, sines
from components.quantities.parameters import displacement, mass, positive
from components.scene import Picture, Scene
from components.scene.frames import FITTED, framed
from components.scene.traces import over_time
from physics.oscillator import Oscillator, OscillatorConstants

TASK = "Exchange the two springs: what does the mass feel of it?"
LEFT, REST, FOOT = 0.03 * W, 0.5 * W, 0.8 * H
X = PlotFrame("x")


@dataclass(frozen=True)
class WallsCase:
    """A mass between its walls, and where it is let go."""

    system: Oscillator
    springs: tuple[float, float]
    x_0: float

    @cached_property
    def swing(self) -> OscillatorConstants:
        return self.system.constants(self.x_0, 0.0)


class Axes(Declared[WallsCase]):
    t, x = DrawnAxis.some(2)


class Numbers(Declared[WallsCase]):
    x = Signal[WallsCase](
        lambda c, a: sines(Axes.x(a), Axes.t(a), (c.swing.C, c.system.omega_n, c.swing.phi)), Axes.x, signed=True
    )
    reach = Scalar[WallsCase](lambda c, a: 0.2 / max(abs(Axes.x(a).ruler.start), abs(Axes.x(a).ruler.end)))
    wire1 = Scalar[WallsCase](lambda c, a: wire(c.springs[0]))
    wire2 = Scalar[WallsCase](lambda c, a: wire(c.springs[1]))
    k = LiveNumber[WallsCase](lambda c: c.system.k)
    omega_n = LiveNumber[WallsCase](lambda c: c.system.omega_n)
    x_unit = AxisUnit(Axes.x)


class Walls(Scene):
    slug = "walls"
    title = "Two walls"
    lecture = "Beyond the slides"
    points = "springs side by side"
    headline = "Between two walls the stiffnesses of both springs add"
    equations = ("m x'' + (k1 + k2) x = 0",)
    presets = {"Equal": {}, "One does nearly all": {"k1": 40.0, "k2": 0.4}, "Soft": {"k1": 0.5, "k2": 0.5}}
    watch = {
        "Equal": "Each spring gives half of the force.",
        "One does nearly all": "The soft spring hardly changes the period.",
        "Soft": "With a quarter of the stiffness the period is twice as long.",
    }

    m = mass(1.0, symbol="m", tint="m1")
    k1 = positive(
        2.0, symbol="k_1", unit="N/m", label="stiffness", tint="k", scale="log", softbounds=(0.1, 100.0),
        says="is the stiffness of the left spring. Any value above 0.",
    )  # fmt: skip
    k2 = positive(
        2.0, symbol="k_2", unit="N/m", label="stiffness", tint="k", scale="log", softbounds=(0.1, 100.0),
        says="is the stiffness of the right spring. Any value above 0.",
    )  # fmt: skip
    x_0 = displacement(1.0, symbol="x_0", tint="m1", says="is where the mass is let go. Any number.")
    groups = (Group("Mass between two springs", (m, k1, k2)), Group("Start, from rest", (x_0,)))

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return walls_sheet()

    def picture(self, frame: Frame = FITTED) -> Picture:
        system = Oscillator(m=self.m, k=self.k1 + self.k2)
        case = WallsCase(system, (self.k1, self.k2), self.x_0)
        end, reach = frame.window or self.window or float(f"{4 * system.period:.2g}"), case.swing.C
        axes = framed(frame, by_name({Axes.t: time_axis(end), Axes.x: nice_axis(-reach, reach, "m", 3)}))
        return Picture(
            columns={},
            axes=axes,
            signals=Numbers.signals(case, axes),
            traces=over_time(
                end, system.omega_n, (Numbers.x,), lambda t: {Numbers.x: system.motion(self.x_0, 0.0, t).x}
            ),
            scalars=Numbers.scalars(case, axes),
            pace=pace(system.omega_n, system.omega_n),
            values=Numbers.texts(case, axes),
            live=Numbers.live(axes),
        )


def walls_sheet() -> Block:
    return column(
        words(TASK, style="task", phone=0),
        stage(*_shapes(), label="A mass between two springs, each on a wall of its own", grow=200, height=190),
        words(
            rf"Moved by $x$, it feels $-k_1 x$ and $-k_2 x$: $k = k_1 + k_2 = {Numbers.k}$ N/m, "
            rf"$\omega_n = \sqrt{{k / m}} = {Numbers.omega_n}$ rad/s.",
            phone=5,
        ),
        plot(
            X,
            x=Axes.t,
            y=Axes.x,
            title="Displacement against time",
            curves=(curve(Numbers.x, tint="m1", width="sum", label="*x*", signal=Numbers.x),),
            heading=(term(Numbers.x, "sum", "m1", formula="x(t)"),),
            cursor="time",
            grow=300,
            phone=10,
            height=260,
        ),
    )


def _shapes() -> list[Shape]:
    """The mass between its springs; the largest displacement takes 0.2 of the width."""
    x, side = REST + var(Numbers.reach) * W * var(Numbers.x), 0.1 * W
    middle = FOOT - 0.5 * side
    return [
        wall(LEFT, 0.2 * H, 0.6 * H, side="left"),
        wall(W - LEFT, 0.2 * H, 0.6 * H, side="right"),
        line(LEFT, FOOT, W - LEFT, FOOT, style="floor"),
        line(REST, 0.15 * H, REST, FOOT, tint="mute", style="eq"),
        spring(LEFT, middle, x - 0.5 * side, middle, var(Numbers.wire1)),
        spring(x + 0.5 * side, middle, W - LEFT, middle, var(Numbers.wire2)),
        box(x, FOOT, side, "*m*", tint="m1"),
        text(REST, 0.1 * H, f"*x* = {Numbers.x} {Numbers.x_unit}", tint="m1", style="t2 b"),
    ]
