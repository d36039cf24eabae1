"""A page opened without parameters shows the scene's defaults and names the scene in its address."""

from __future__ import annotations

import pytest

from app import visited
from components.scenes import SCENES
from components.state.page_state import fitted
from tests.page.headless_page import Page
from tests.scenes.checks import as_arguments

PRESETS = {"oscillator": "Pulled", "analogues": "10°", "phugoid": "Deep, 0.6"}


@pytest.mark.parametrize("slug", SCENES)
def test_a_page_without_parameters_opens_as_its_scene_declares(slug: str) -> None:
    page = visited({"scene": [slug.encode()], "projector": [b""]}, {})
    scene = page.now.scene
    assert {name: scene.values[name] for name in scene.opens} == scene.opens
    assert scene.preset() == PRESETS.get(slug, next(iter(scene.presets)))
    query = fitted(scene).query
    assert visited(as_arguments(query), {}).now.scene.values == scene.values, "its address brings it back"


@pytest.mark.parametrize("slug", SCENES)
def test_the_defaults_have_an_address_of_their_own(slug: str) -> None:
    defaults = SCENES[slug].at()
    assert visited(as_arguments(fitted(defaults).query), {}).now.scene.values == defaults.values
    one = next(iter(defaults.linked()))
    linked = visited({"scene": [slug.encode()], one: [str(defaults.values[one]).encode()]}, {}).now.scene
    assert linked.values == defaults.values, "whoever names a parameter has the others at their defaults"


def test_the_first_page_of_all_is_the_pulled_oscillator() -> None:
    scene = visited({}, {}).now.scene
    assert (scene.slug, scene.preset(), scene.view) == ("oscillator", "Pulled", "motion")  # type: ignore[attr-defined]


@pytest.mark.parametrize("slug", SCENES)
def test_a_click_in_the_navigation_opens_the_same(slug: str) -> None:
    page = Page(SCENES["coupled" if slug == "accuracy" else "accuracy"]())
    told = page.send({"type": "open", "state": {"scene": slug}, "carried": True, "number": 1})
    assert told["state"]["parameters"].items() >= SCENES[slug].opens.items()
    assert page.scene.values == visited({"scene": [slug.encode()]}, {}).now.scene.values
    assert told["state"]["hidden"] is None
    assert page.send({"type": "open", "state": {"scene": slug}, "number": 2})["state"]["parameters"] == {}, "undo"


@pytest.mark.parametrize("switched", [[], ["convergence"]])
def test_other_curves_than_the_usual_ones_are_kept_and_undone(switched: list[str]) -> None:
    page = Page(SCENES["accuracy"]())
    usual = page.scene.hidden
    told = page.send({"type": "choose", "name": "hidden", "value": switched, "number": 1})
    assert told["state"]["hidden"] == switched
    back = page.send({"type": "open", "state": told["state"] | {"hidden": None}, "number": 2})
    assert (back["state"]["hidden"], page.scene.hidden) == (None, usual)
