"""A scene made of a case and its paper, tested with a small scene: mass, spring and dashpot, drawn in two plots."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from components.dashpot import DashpotCase, DashpotScene, apparatus, keeping, parts
from components.language.blocks import Block
from components.layout.controls import Group
from components.layout.sheet import blocks, column, row, stage
from components.layout.stage import H, T, W, line, text
from components.paper.deferred import Attributes, deferred
from components.paper.plot_axes import TIME, axis
from components.paper.plots import Plot, along, curve, drag, either, layer, stack, words
from components.quantities.parameters import displacement, velocity
from components.scene.case import CaseScene, ComparedNumber, example
from physics.sampling import periods


class FrictionCase(DashpotCase):
    @property
    def lasting(self) -> float:
        return periods(self.one.omega_n, 4)

    @property
    def highest(self) -> float:
        return 2 * self.one.omega_n

    @property
    def kind(self) -> str:
        return "swings" if self.one.zeta < 1 else "creeps"


value = Attributes(FrictionCase)


class FrictionShown(FrictionCase):
    x = value(lambda c: c.free.x)
    V = value(lambda c: 0.5 * c.k * c.free.x**2)
    T = value(lambda c: 0.5 * c.m * c.free.v**2)
    E = V + T
    tau_d = value.optional(lambda c: 2 * np.pi / c.one.omega_d if c.kind == "swings" else None)


c = deferred(FrictionShown)
X = Plot("x", TIME, axis("m", lambda c: (-c.free.reach(c.end), c.free.reach(c.end)), room=1.25, count=2))
ENERGY = Plot("energy", TIME, axis("J", lambda c: (0.0, c.free.E_0 or 1.0), "E", room=1.08, whole=True))


def paper() -> Block:
    y, hand = X.y(c.x), drag("Mass, start", along("y", X.y, X.up, x_0=c.x, rate="v_0"))
    mass = apparatus(0.5 * W, y, 56, 0.5 * H, 0.15 * H, 2.5, hand)
    period = text(2, 40, f"{c.tau_d} s", "start")
    layers = stack(layer(c.V, "V", legend=f"V = {c.V}"), layer(c.T, "T", top=c.E, legend=f"T = {c.T}"))
    return row(
        stage(*mass, line(0.5 * W, y, X.x(T), y), text(2, 16, f"*x* = {c.x:+} {X.unit}"), period, label="A mass"),
        column(
            X.block(curve(c.x, "sum", "m1", legend="x(t)", fast="band", dot=True), title="Displacement"),
            ENERGY.block(*layers, title="Energy: potential and kinetic"),
            words(rf"$\zeta = {c.one.zeta}$", either(c.kind, swings=f"It swings in {c.tau_d} s.", creeps="It creeps.")),
        ),
    )


class Friction(DashpotScene, CaseScene):
    slug, title, lecture, points = "friction", "Friction", "D32", "free vibration with a dashpot"
    headline = "A dashpot takes the same share of every swing"
    equations = ("m x'' + c x' + k x = 0",)
    examples = (example("Light", "Each swing keeps half.", c=1.257), example("Heavy", "It creeps.", c=40.0))
    m, k, c, zeta = parts(1.0, 39.48, 1.257, k_may_be_0=False)
    keep = keeping()
    x_0 = displacement(0.1, symbol="x_0", tint="m1", softbounds=(-0.3, 0.3), says="is where it starts.")
    v_0 = velocity(0.0, symbol="v_0", tint="m1", softbounds=(-3.0, 3.0), says="is how fast it starts.")
    groups = Group("Mass, spring, dashpot", (m, k, c, zeta, keep)), Group("Start", (x_0, v_0))
    case, paper = FrictionShown, staticmethod(paper)
    compared = (ComparedNumber("tau_d", "τ_d", "s"),)


def test_what_is_missing_is_neither_drawn_nor_compared() -> None:
    light, heavy = Friction(), Friction(c=40.0)
    assert light.shown.values["tau_d"] == "1.01" and heavy.shown.values["tau_d"] == ""
    assert [scene.shown.scalars["has_tau_d"] for scene in (light, heavy)] == [1.0, 0.0]
    assert [shape.show for shape in shapes() if "has_tau_d" in shape.show] == [("has_tau_d",)]
    assert [scene.shown.forms["kind"] for scene in (light, heavy)] == ["swings", "creeps"]
    assert [len(scene.readouts()) for scene in (light, heavy)] == [1, 0]


def shapes() -> Iterator[object]:
    return (shape for block in blocks(Friction.sheet()) for shape in getattr(block, "shapes", ()))


def test_a_fast_motion_is_a_band_and_its_energies_are_means() -> None:
    picture = Friction(c=0.01, window=1e4).shown
    assert picture.traces["time"].names == ()
    assert list(picture.columns["band"]) == ["t", "x_lo", "x_hi"] and list(picture.columns["time"]) == [
        "zero",
        "V",
        "E",
    ]
    assert picture.columns["time"]["V"] == pytest.approx(picture.columns["time"]["E"] / 2, rel=1e-14)
    assert picture.columns["band"]["x_hi"][0] == pytest.approx(0.1, rel=1e-3)


def test_a_number_that_is_none_must_be_optional() -> None:
    class Broken(FrictionShown):
        lost = value(lambda c: None)

    broken = deferred(Broken)

    class BrokenScene(Friction):
        case, paper = Broken, staticmethod(lambda: X.block(curve(broken.lost), title="Nothing"))

    with pytest.raises(TypeError, match="lost is None: make it an optional attribute"):
        BrokenScene()


def test_a_number_may_not_have_the_name_of_one_of_the_page() -> None:
    class Quick(FrictionShown):
        speed = value(lambda c: c.v_0)

    with pytest.raises(ValueError, match="Quick: the page has a live number “speed” of its own: choose another name"):

        class QuickScene(Friction):
            case = Quick


def test_an_attribute_may_not_have_the_name_of_a_parameter() -> None:
    """The field would hide it."""

    class Shown(FrictionCase):
        m = value(lambda c: 2.0, "kg", "twice the mass")

    with pytest.raises(TypeError, match="Shown: m is a parameter: give the attribute another name"):

        class Hidden(DashpotScene, CaseScene):
            case = Shown


@pytest.mark.parametrize("order", [(True, False), (False, True)])
def test_a_picture_does_not_depend_on_papers_built_before_it(order: tuple[bool, bool]) -> None:
    """Two papers share the time axis; one of them also shows its unit, and a length relative to its end."""
    shown = {uses: _timed(uses).at().shown for uses in order}
    assert (shown[True].scalars["t_share"], shown[True].values["t_unit"]) == (1 / shown[True].axes["t"].end, "s")
    assert not shown[False].scalars and not shown[False].values


def _timed(uses_time: bool) -> type[Friction]:
    class Timed(FrictionShown):
        pass

    x = deferred(Timed).x

    class TimedScene(Friction):
        case = Timed
        paper = staticmethod(
            lambda: column(
                X.block(curve(x), title="x", over=[line(0, 0, 90 * TIME.share, 0)] if uses_time else []),
                *([words(f"in {TIME.unit_text}")] if uses_time else []),
            )
        )

    return TimedScene
