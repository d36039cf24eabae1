"""The states of property tests: pages open in them, and their links restore them."""

from __future__ import annotations

import pytest
from hypothesis import Phase, given, settings
from msgspec.structs import replace

from components.scenes import SCENES
from components.session.links import page_state_of
from components.state.link import Link, read_query
from tests.grids import tries
from tests.scenes.checks import as_arguments
from tests.states import links, special, state_of

scenes = pytest.mark.parametrize("slug", SCENES)


@scenes
def test_the_address_of_any_state_brings_it_back(slug: str) -> None:
    @settings(max_examples=tries(60))
    @given(links(SCENES[slug]))
    def leads_back(link: Link) -> None:
        now = state_of(link)
        read = read_query(as_arguments(now.query), SCENES)
        assert read.problems == []
        again, refused = page_state_of(SCENES[slug], read)
        assert (refused, again.query) == ([], now.query)
        assert replace(again.state, frame=None) == replace(now.state, frame=None)

    leads_back()


@pytest.mark.parametrize("slug", ["damped", "driven", "modes", "coupled", "forced", "absorber"])
def test_resonance_critical_damping_and_equality_are_drawn(slug: str) -> None:
    """The examples include each relation of a scene, set by the link and not by a default."""
    kind, drawn = SCENES[slug], set[int]()

    @settings(max_examples=400, phases=[Phase.generate])
    @given(links(kind))
    def look(link: Link) -> None:
        own = {**kind.parameters(), **link.values}
        for number, related in enumerate(special(own)):
            if related.items() <= own.items() and link.values.keys() >= related.keys():
                drawn.add(number)

    look()
    assert drawn == set(range(len(list(special({**kind.parameters()})))))
