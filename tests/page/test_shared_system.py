"""The shared system is kept when the scene changes; a link sets its own values."""

from __future__ import annotations

from typing import Any

from components.scenes import SCENES
from components.session.opening import opened
from components.state.link import read_query
from tests.page.headless_page import Page, change, set_values
from tests.scenes.checks import as_arguments

CHAIN = {"m1": 1.5, "m2": 0.25, "k1": 6.0, "k2": 0.1}


def go(page: Page, scene: str, **state: Any) -> dict[str, Any]:
    """Click a link of the navigation."""
    wanted = {"scene": scene, **state}
    told = page.send({"type": "open", "state": wanted, "carried": True, "number": len(page.packets) + 1})
    assert told["errors"] == {} and told["scene"] == scene
    parameters, opens = told["state"]["parameters"], SCENES[scene].opens
    assert state.get("parameters") or opens.items() <= parameters.items(), "it opens as a page of it does"
    return {name: value for name, value in parameters.items() if name not in opens}


def test_the_chain_goes_along_to_every_scene_of_it_and_back() -> None:
    page = Page(SCENES["coupled"](**CHAIN, x1_0=0.3))
    assert go(page, "modes") == CHAIN
    assert go(page, "forced") == CHAIN
    assert go(page, "accuracy") == {**CHAIN, "system": "own"}
    assert go(page, "coupled") == CHAIN
    link = read_query(as_arguments(page.opening()["query"]), SCENES)
    assert opened(SCENES, link).now.state.parameters == CHAIN, "the link says all of it"


def test_the_machine_of_the_absorber_is_another_thing_which_the_chain_passes_by() -> None:
    page = Page(SCENES["forced"](**CHAIN))
    assert go(page, "absorber") == {}
    set_values(page, m2=30.0)
    assert go(page, "modes") == CHAIN


def test_mass_and_spring_go_along_to_the_analogue_that_they_are() -> None:
    page = Page(SCENES["oscillator"](m=3.0))
    assert go(page, "energy") == {"m": 3.0}
    set_values(page, k=20.0)
    assert go(page, "analogues") == {"system": "spring", "spring_m": 3.0, "spring_k": 20.0}
    assert go(page, "coupled") == {}
    assert go(page, "oscillator") == {"m": 3.0, "k": 20.0}


def test_another_analogue_says_nothing_of_mass_and_spring() -> None:
    page = Page(SCENES["analogues"](system="circuit", spring_m=5.0))
    assert go(page, "oscillator") == {}


def test_a_scene_as_it_opens_gives_up_what_was_taken_along() -> None:
    page = Page(SCENES["coupled"](**CHAIN))
    go(page, "modes")
    assert change(page, parameters={})["state"]["parameters"] == {}
    assert go(page, "coupled") == {} and go(page, "forced") == {}


def test_a_state_that_is_opened_otherwise_is_what_it_says() -> None:
    page = Page(SCENES["coupled"](**CHAIN))
    told = page.send({"type": "open", "state": {"scene": "modes"}, "number": 1})
    assert told["state"]["parameters"] == {}
    set_values(page, **CHAIN)
    assert go(page, "coupled", parameters={"k2": 9.0}) == {**CHAIN, "k2": 9.0}


def test_what_a_scene_cannot_show_is_left_behind() -> None:
    page = Page(SCENES["coupled"](k1=0.0, k2=1e-300))
    assert go(page, "forced") == {}
    assert go(page, "modes") == {}, "and what it shows instead counts"
