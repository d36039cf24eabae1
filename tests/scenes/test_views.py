"""Views of the scenes: what each shows, sends and links to."""

import re
from dataclasses import replace

import numpy as np
import pytest
from msgspec.structs import replace as replace_in

from components.language.blocks import PlotBlock
from components.language.messages import Choose, Open
from components.language.state import State
from components.layout.sheet import in_force
from components.layout.views import KEYS, View, shown_blocks
from components.quantities.motion import derived
from components.scenes import SCENES
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
