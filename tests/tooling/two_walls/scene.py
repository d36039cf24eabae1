"""Two walls: a mass between two springs, each of which is fixed to a wall. Their stiffnesses add."""

from __future__ import annotations

from functools import cached_property

from components.language.blocks import Block
from components.language.expressions import Number
from components.layout.controls import Group
from components.layout.sheet import column, stage
from components.layout.stage import H, Shape, W, box, line, spring, text, wall, wire
from components.layout.views import View, in_views
from components.paper.deferred import Attributes, deferred
from components.paper.plot_axes import TIME, axis
from components.paper.plots import Plot, PlotValue, along, curve, drag, layer, stack, words
from components.quantities.parameters import displacement, mass, positive
from components.scene.case import Case, CaseScene, ComparedNumber, example
from physics.free_oscillation import FreeOscillation
from physics.oscillator import Oscillator
from physics.sampling import periods

AVERAGED = "The energies change too fast to be drawn in this window: they are averages over a cycle."


class WallsCase(Case):
    """A mass between two springs, released at rest, in SI units."""

    m: float
    k1: float
    k2: float
    x_0: float

    @cached_property
    def free(self) -> FreeOscillation:
        return FreeOscillation(oscillator=Oscillator(m=self.m, k=self.k1 + self.k2), x_0=self.x_0, v_0=0.0)

    @property
    def lasting(self) -> float:
        return periods(self.free.oscillator.omega_n, 4)

    @property
    def highest(self) -> float:
        return 2 * self.free.oscillator.omega_n

    def notes(self) -> tuple[str, ...]:
        return () if self.is_line(self.highest) else (AVERAGED,)


value = Attributes(WallsCase)


class WallsShown(WallsCase):
    """Everything that the paper shows. Motions come first: their order is that of the columns in a file."""

    x = value(lambda c: c.free.x)
    V1 = value(lambda c: 0.5 * c.k1 * c.free.x**2)
    V2 = value(lambda c: 0.5 * c.k2 * c.free.x**2)
    k = value(lambda c: c.k1 + c.k2, "N/m", "stiffness of both springs together")
    omega_n = value(lambda c: c.free.oscillator.omega_n, "rad/s", "natural frequency")
    E = value(lambda c: c.free.E, "J", "energy")
    wire1 = value(lambda c: wire(c.k1))
    wire2 = value(lambda c: wire(c.k2))


c = deferred(WallsShown)
X = Plot("x", TIME, axis("m", lambda c: (-abs(c.x_0), abs(c.x_0)), room=1.25, count=2))
ENERGY = Plot("energy", TIME, axis("J", lambda c: (0.0, c.free.E), "E", room=1.08, whole=True))


def paper() -> Block:
    x = curve(c.x, "sum", "m1", label="*x*", legend="x(t)", fast="band", dot=True)
    layers = stack(layer(c.V1, "V", legend=f"V_1 = {c.V1}"), layer(c.V2, "T", legend=f"+ V_2 = {c.V2}"))
    formulas = rf"$k = k_1 + k_2 = {c.k}$ N/m, $\omega_n = \sqrt{{k / m}} = {c.omega_n}$ rad/s"
    return column(
        stage(*mass_and_springs(), label="A mass between two springs, each fixed to a wall", height=150),
        in_views(X.block(x, title="Displacement against time", phone=10), "motion"),
        in_views(ENERGY.block(*layers, title="Energy of both springs against time", phone=10), "energy"),
        words(formulas, name="formulas", phone=15),
    )


def place(x: PlotValue) -> Number:
    """The pixel of a displacement across the stage: it needs no plot beside it, so it is the same on a phone."""
    return 0.5 * W + 0.2 * W * X.share(x)


def mass_and_springs() -> list[Shape]:
    left, right, foot, side = 0.03 * W, 0.97 * W, 0.8 * H, 44
    x, middle = place(c.x), foot - 0.5 * side
    hand = drag("Mass, start", along("x", place, X.up, x_0=c.x))
    return [
        wall(left, 0.2 * H, 0.6 * H, side="left"),
        wall(right, 0.2 * H, 0.6 * H, side="right"),
        line(left, foot, right, foot, style="floor"),
        line(place(0), 0.15 * H, place(0), foot, tint="mute", style="eq"),
        spring(left, middle, x - 0.5 * side, middle, c.wire1),
        spring(x + 0.5 * side, middle, right, middle, c.wire2),
        box(x, foot, side, "*m*", tint="m1", grab=hand),
        text(place(0), 0.1 * H, f"*x* = {c.x:+} {X.unit}", tint="m1", style="t2 b halo"),
    ]


EQUAL = {"m": 1.0, "k1": 2.0, "k2": 2.0, "x_0": 1.0}
SAYS = "is the stiffness of the {} spring. Any value above 0."


class Walls(CaseScene):
    slug, title, lecture, points = "walls", "Two walls", "Beyond the slides", "springs side by side"
    headline = "Between two walls the stiffnesses of both springs add"
    equations = ("m x'' + (k1 + k2) x = 0",)
    examples = (
        example("Equal", "Each spring gives half of the force.", EQUAL),
        example("One does nearly all", "The soft spring hardly changes the period.", EQUAL, k1=40.0, k2=0.4),
        example("Soft", "With a quarter of the stiffness the period is twice as long.", EQUAL, k1=0.5, k2=0.5),
    )
    m = mass(1.0, symbol="m", tint="m1")
    k1, k2 = (
        positive(
            2.0, symbol=symbol, unit="N/m", label="stiffness", tint="k", scale="log", softbounds=(0.1, 100.0),
            says=SAYS.format(side),
        )
        for symbol, side in (("k_1", "left"), ("k_2", "right"))
    )  # fmt: skip
    x_0 = displacement(1.0, symbol="x_0", tint="m1", says="is where the mass starts. Any number.")
    groups = (Group("Mass between two springs", (m, k1, k2)), Group("Start, at rest", (x_0,)))
    views = (
        View(
            "Motion", "Change one spring, then exchange both: what does the mass feel of it?", keys=(k1, k2),
            names=("stage", "plot:x"),
        ),
        View("Energy", "Make one spring stiffer: which of them stores more of the energy?", keys=(k1, k2),
            names=("stage", "plot:energy"),
        ),
    )  # fmt: skip
    case, paper = WallsShown, staticmethod(paper)
    compared = (ComparedNumber("omega_n", "ω_n", "rad/s"),)
