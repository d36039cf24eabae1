"""Curves of tables, axes that a case makes, what a hand sets, and motions that ring down, in a small scene."""

from __future__ import annotations

import numpy as np

from components.dashpot import DashpotCase, DashpotScene, keeping, parts
from components.language.blocks import Block, PlotBlock
from components.language.shapes import Along
from components.layout.controls import Group
from components.layout.grabs import grab
from components.layout.sheet import blocks, column
from components.layout.stage import W, circle
from components.paper.deferred import Attributes, deferred
from components.paper.plot_axes import TIME, axis
from components.paper.plots import Plot, along, curve, either, form_of, handle, words
from components.quantities.axes import Axis, nice_axis
from components.quantities.parameters import displacement, velocity
from components.scene.case import CaseScene, ComparedNumber
from components.scene.case_curves import BandColumns
from components.scene.traces import Columns


class DecayCase(DashpotCase):
    lasting, highest = 10.0, 1.0

    @property
    def spans(self) -> dict[str, tuple[float, float]]:
        return {"c": (0.0, 4 * self.k)}

    @property
    def bands(self) -> dict[str, BandColumns]:
        """It rings down in the first tenth of the window."""
        low, high = np.full_like(self.times, 0.25), np.full_like(self.times, 0.75)
        return {"x": BandColumns(low, high, np.zeros_like(low[len(low) // 10 :]))} if self.c > 5 else {}


value = Attributes(DecayCase)


class DecayShown(DecayCase):
    x = value(lambda c: c.free.x)
    at = value.optional(lambda c: c.c if c.c else None)
    lag = value(lambda c: 2.0)
    W = value.optional(lambda c: c.at)


c = deferred(DecayShown)
HAS_DASHPOT = form_of(c.at)
X = Plot("x", TIME, axis("m", lambda c: (-1.0, 1.0)))
RATE = Plot(
    "rate", axis("", lambda c: nice_axis(0.0, 4 * c.k, "", factor=c.k), "r"), axis("1/s", lambda c: (0.0, 9.0), "s")
)


def table(case: DecayShown, r: Axis, s: Axis) -> Columns:
    return {"c": np.array([0.0, r.end]), "rate": np.array([s.start, s.end])}


def paper() -> Block:
    hand = grab("Damping", along("x", RATE.x, RATE.across, least=0.0, c=c.at), inside=RATE)
    return column(
        RATE.block(
            curve(RATE.in_frame(c, "rates", table), words="the rate", columns=("c", "rate"), dot=(c.at, c.lag)),
            title="Rates",
            over=[circle(RATE.x(c.at), RATE.y(0), 5, grab=hand), circle(0.5 * W, RATE.y(0), 5)],
            handles=(handle(c.lag, parameter="c", label="Damping"),),
        ),
        words(f"{c.W} J"),
        X.block(curve(c.x, words=either(c.at, shown="damped"), fast="ringing"), title="x"),
    )


class Decays(DashpotScene, CaseScene):
    slug, title, headline = "decays", "Decays", "A dashpot takes the same share of every swing"
    m, k, c, zeta = parts(1.0, 40.0, 2.0, hangs=False)
    keep = keeping()
    x_0, v_0 = displacement(0.1, symbol="x_0", says="is here."), velocity(0.0, symbol="v_0", says="is here.")
    groups = Group("Dashpot", (m, k, c, zeta, keep), form=HAS_DASHPOT), Group("Start", (x_0, v_0))
    case, paper = DecayShown, staticmethod(paper)
    compared = (ComparedNumber("lag", "φ", "rad", angle=True),)


def plots() -> list[PlotBlock]:
    return [one for one in blocks(Decays.sheet()) if isinstance(one, PlotBlock)]


def test_a_curve_of_a_table_has_its_columns_and_its_dot() -> None:
    curve, picture = plots()[0].curves[0], Decays().shown
    assert (curve.source, curve.x, curve.y, curve.group) == ("rates", "c", "rate", "rate")
    assert picture.columns["rates"]["c"].tolist() == [0.0, picture.axes["r"].end]
    assert picture.scalars[curve.signal_x] == 2.0 / 40.0 and picture.scalars[curve.signal] == 2.0
    assert curve.signal_x not in Decays(c=0.0).shown.scalars, "no dot"


def test_a_hand_sets_a_parameter_along_an_axis() -> None:
    shape, _ = plots()[0].shapes
    assert shape.grab and isinstance(way := shape.grab.ways[0], Along)
    assert (way.parameter, way.moves, way.axis, way.least, shape.grab.inside) == ("c", "at", "r", 0.0, "rate")
    assert plots()[0].handles[0].text == "lag" and Decays().shown.values["lag"] == "2.00"


def test_conditions_show_headings_and_controls() -> None:
    damped, free = Decays(), Decays(c=0.0)
    group = Decays.groups[0]
    assert group.stands(damped.shown.forms) and not group.stands(free.shown.forms)
    assert [scene.shown.forms["x"] for scene in (damped, free)] == ["shown", ""]
    assert damped.shown.spans == {"c": (0.0, 160.0)} and damped.readouts()[0].angle


def test_a_motion_rings_down_to_a_line() -> None:
    picture = Decays(c=8.0).shown
    ringing, late, t = picture.columns["ringing"], picture.columns["late"], picture.traces["time"].t
    assert picture.traces["time"].names == () and not picture.columns["band"]
    assert len(ringing["t"]) + len(late["t"]) == len(t) + 1 and ringing["t"][-1] == late["t"][0]
    assert set(ringing["x_lo"]) == {0.25} and set(ringing["x_hi"]) == {0.75} and not late["x"].any()
    assert Decays().shown.traces["time"].names == ("x",)


def test_a_missing_text_hides_no_shape_that_uses_the_width_of_its_stage() -> None:
    assert Decays(c=0.0).shown.values["W"] == "" and plots()[0].shapes[1].show == ()
