"""Views of the scenes: what each shows, sends and links to; and a scene made of a case and its paper."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace as replace_in

from components.language.blocks import Block, PlotBlock
from components.language.messages import Choose, Open
from components.language.state import State
from components.layout.sheet import column, in_force
from components.layout.stage import line
from components.layout.views import KEYS, View, shown_blocks
from components.paper.deferred import Attributes, deferred
from components.paper.plot_axes import TIME, axis
from components.paper.plots import Plot, curve, words
from components.quantities.motion import derived
from components.scene.case import CaseScene
from components.scenes import SCENES
from components.scenes.damped import Damped
from components.scenes.damped.case import DampedCase, DampedShown
from components.state.link import read_query
from components.state.page_state import PageState, changed, fitted, page_state_in, with_values
from components.state.scene_sheet import scene_sheet
from components.state.sent_picture import drawn_on, sent_picture
from components.state.states import state_in
from tests.scenes.checks import as_arguments, changes

VIEWS = [(slug, view.slug) for slug, scene in SCENES.items() for view in scene.views]
views = pytest.mark.parametrize(("slug", "view"), VIEWS)


def opened(query: str) -> PageState:
    """The page of a link, which has no problems."""
    link = read_query(as_arguments(query), SCENES)
    assert not link.problems
    return page_state_in(SCENES[link.slug], state_in(link))


OLD = [
    *(("oscillator", "motion"), ("oscillator&m=2", "formulas"), ("oscillator&view=swing&m=2", "motion")),
    *(("energy&m=2", "energy"), ("damped&c=2", "motion"), ("driven&omega=3", "response"), ("coupled&k2=3", "motion")),
    *(("coupled&view=constants", "formulas"), ("modes", "hunt"), ("modes&m2=3", "guess")),
    *(("modes&task=hunt&x1_0=0.5", "hunt"), ("modes&task=solve", "solve"), ("modes&task=sweep&swept=m1", "sweep")),
    *(("forced&k1=2", "response"), ("forced&view=amplitudes", "response"), ("analogues&system=circuit", "roles")),
    *(("phugoid&excess=0.1", "period"), ("phugoid&show=period", "period"), ("phugoid&show=exchange", "energy")),
    *(("absorber&m2=20", "goals"), ("absorber&played=particular", "goals")),
    *(("absorber&played=rest&x1_0=0.01", "rest"), ("accuracy", "drift"), ("accuracy&system=wide", "time")),
    *((f"accuracy&view={view}", view) for view in ("time", "growth", "length", "digits", "stability")),
]
"""Links older than views, and the view that each opens; some name none."""


@pytest.mark.parametrize(("query", "view"), OLD)
def test_an_old_link_opens_the_matching_view(query: str, view: str) -> None:
    now = opened(f"scene={query}")
    assert now.scene.values["view"] == view
    assert now.show == ()


OTHER_MOTIONS = {"modes"}
"""Scenes whose views show different motions, each with a separate file."""


@views
def test_a_page_of_one_view_shows_what_the_whole_picture_shows_there(slug: str, view: str) -> None:
    kind = SCENES[slug]
    whole = fitted(kind.at({"view": view}))
    assert f"view={view}" in whole.query and opened(whole.query).scene.key == whole.scene.key
    check_file(whole, whole if slug in OTHER_MOTIONS else fitted(kind.at()))
    page = replace(page_state_in(kind, whole.state), in_view=True)
    check_parts(page, next(one for one in kind.views if one.slug == view))
    whole, page = (with_values(now, next(changes(kind))) for now in (whole, page))
    part = page.drawn.picture
    one, other = sent_picture(page, part), sent_picture(replace(page, drawn=whole.drawn), whole.shown)
    assert page.drawn.frame == whole.drawn.frame and page.query == whole.query
    assert one.values == other.values and one.forms == other.forms and one.scalars == other.scalars
    assert {**one.signals, "zero": derived(0.0)} == {**other.signals, "zero": derived(0.0)}
    for source, columns in drawn_on(page).items():
        for name in columns.keys() & other.sources.get(source, {}).keys():
            assert np.array_equal(one.sources[source][name], other.sources[source][name])
    assert read_aloud(whole, view).items() <= part.values.items()
    covered = changed(page, Open(state=replace_in(page.state, covered=("next",)), keeps=True), SCENES)
    assert covered.drawn.picture.values == whole.shown.values, "what depends on a change is looked up in all views"


def check_file(now: PageState, first: PageState) -> None:
    """A view sends only its curves, with what they need; a file has those of all views."""
    columns = {source: list(found) for source, found in now.shown.sources.items()}
    assert columns == {source: list(found) for source, found in first.shown.sources.items()}
    sent = sent_picture(now, now.shown)
    for source, traces in sent.traces.items():
        assert set(traces.names) <= drawn_on(now).get(source, {}).keys()
        assert traces.needed <= sent.signals.keys()


def check_parts(page: PageState, view: View) -> None:
    """A view has a task and parts that no other view of its scene has, and the forms that show these parts."""
    shown = {one.slug: frozenset(map(id, shown_blocks(page.kind.sheet(), one.slug))) for one in page.kind.views}
    assert shown[view.slug] and [one.task for one in page.kind.views].count(view.task) == 1
    sent = sent_picture(page, page.drawn.picture)
    assert set(view.names) - {KEYS} <= {block.part for block in in_force(page.kind.sheet(), sent.forms)}


def read_aloud(now: PageState, view: str) -> dict[str, str]:
    """The texts of the numbers that descriptions of a view read aloud."""
    plots = [one.says for one in shown_blocks(now.kind.sheet(), view) if isinstance(one, PlotBlock)]
    sentences = " ".join(text for spoken in (scene_sheet(now.kind).spoken, *plots) for text in spoken.values())
    return {name: now.shown.values[name] for name in re.findall(r"{(\w+)}", sentences) if name in now.shown.values}


def test_a_list_of_parts_replaces_the_view_until_a_tab_is_pressed() -> None:
    state = State(scene="damped", show=("stage", "plot:P"))
    now = changed(fitted(SCENES["oscillator"]().value), Open(state=state), SCENES)
    assert "show=stage,plot:P" in now.query
    assert drawn_on(now)["time"].keys() == {"t", "P", "zero"}
    assert opened(now.query).show == now.show
    now = changed(now, Choose(name="view", value="roots"), SCENES)
    assert now.show == ()
    assert "roots" in drawn_on(now) or "locus" in drawn_on(now)


value = Attributes(DampedCase)
X = Plot("x", TIME, axis("m", lambda c: (-1.0, 1.0)))


def variant(shown: type[Any], *shapes: Block) -> type[CaseScene]:
    """The damped scene with another case, and these blocks as its paper."""

    class Variant(Damped):
        case, paper, views, groups = shown, staticmethod(lambda: column(*shapes)), (), ()

    return Variant


def test_an_author_is_told_of_a_number_that_is_none_or_has_a_name_that_is_taken() -> None:
    broken, quick, doubled = (
        type("Wrong", (DampedShown,), {name: value(lambda c, n=number: n)})
        for name, number in (("lost", None), ("speed", 1.0), ("m", 2.0))
    )
    with pytest.raises(TypeError, match="lost is None: make it an optional attribute"):
        variant(broken, X.block(curve(deferred(broken).lost), title="Nothing")).at().picture()
    with pytest.raises(ValueError, match="Wrong: the page has a live number “speed” of its own: choose another name"):
        variant(quick)
    with pytest.raises(TypeError, match="Wrong: m is a parameter: give the attribute another name"):
        variant(doubled)


@pytest.mark.parametrize("order", [(True, False), (False, True)])
def test_a_picture_does_not_depend_on_papers_built_before_it(order: tuple[bool, bool]) -> None:
    """Two papers share the time axis; one of them also shows its unit, and a length relative to its end."""

    def timed(uses_time: bool) -> type[CaseScene]:
        shown = type("Timed", (DampedShown,), {})
        over = [line(0, 0, 90 * TIME.share, 0)] if uses_time else []
        text = [words(f"in {TIME.unit_text}")] if uses_time else []
        return variant(shown, X.block(curve(deferred(shown).x), title="x", over=over), *text)

    shown = {uses: timed(uses).at().shown for uses in order}
    assert (shown[True].scalars["t_share"], shown[True].values["t_unit"]) == (1 / shown[True].axes["t"].end, "s")
    assert not shown[False].scalars and not shown[False].values
