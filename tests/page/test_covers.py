"""Hidden parts are not sent: neither the curves nor their motions nor anything derived from them."""

from __future__ import annotations

import json
from typing import Any

import pytest

from components.scenes import SCENES
from components.state.covers import PLOT, VALUE
from components.state.scene_sheet import plots
from tests.page.headless_page import Page

scenes = pytest.mark.parametrize("slug", SCENES)


def covering(page: Page, *covered: str) -> dict[str, Any]:
    state = {"scene": page.scene.slug, "covered": list(covered)}
    return page.send({"type": "open", "state": state, "number": len(page.packets) + 1})


def test_a_covered_plot_takes_its_motion_along() -> None:
    page = Page(SCENES["coupled"]())
    before = page.opening()
    told = covering(page, "plot:x2")
    view = told["view"]
    assert told["errors"] == {} and told["state"]["covered"] == ["plot:x2"]
    left = set(before["view"]["signals"]) - set(view["signals"])
    assert {"x2_slow", "x2_fast"} <= left <= set(view["left_out"])
    assert view["signals"]["x2"] == {"kind": "derived", "value": {"terms": [[0.0, []]]}}, (
        "the mass rests where it starts"
    )
    assert {"x1", "x1_slow"} <= set(view["signals"])
    assert "x2" not in view["live"]
    assert "x2_slow" in before["view"]["columns"]["time"] and "x2_slow" not in view["columns"]["time"]
    assert view["columns"]["time"].keys() >= {"t", "x1", "x1_slow"}
    told = page.send({"type": "set", "values": {"k2": 3.0}, "number": 70})
    assert told["state"]["covered"] == ["plot:x2"] and "x2" in told["view"]["left_out"]
    assert "hidden parts" in page.send({"type": "about", "number": 72})["notes"][0]
    told = covering(page)
    assert told["view"]["signals"].keys() == before["view"]["signals"].keys() and told["view"]["left_out"] == []


def test_a_covered_number_is_not_sent() -> None:
    page = Page(SCENES["coupled"]())
    told = covering(page, "value:omega_minus", "value:omega_minus")
    view = told["view"]
    assert told["state"]["covered"] == ["value:omega_minus"]
    assert "omega_minus" not in view["values"] and view["left_out"] == ["omega_minus"]


def test_a_covered_plot_takes_the_numbers_of_its_heading_along() -> None:
    page = Page(SCENES["damped"]())
    assert {"C", "phi"} <= page.shown.values.keys()
    view = covering(page, PLOT + "x")["view"]
    assert {"C", "phi"} <= set(view["left_out"]) and not {"C", "phi"} & view["values"].keys()
    assert "omega_d" in view["values"]  # which the equation shows too


@scenes
def test_every_plot_and_number_can_be_covered(slug: str) -> None:
    page = Page(SCENES[slug]())
    picture = page.shown
    for cover in (*(PLOT + plot.name for plot in plots(SCENES[slug])), *(VALUE + name for name in picture.values)):
        told = covering(page, cover)
        assert (told["errors"], told["state"]["covered"]) == ({}, [cover])
        spoken = json.dumps([signal for signal in told["view"]["signals"].values() if signal["kind"] == "derived"])
        lost = set(told["view"]["left_out"]) - told["view"]["signals"].keys()  # a text may be sent, but not its motion
        assert not any(f'"{name}"' in spoken for name in lost)


def test_what_is_nothing_to_cover_is_refused() -> None:
    page = Page(SCENES["coupled"]())
    told = covering(page, "plot:x9")
    assert told["errors"]["state"] == "“plot:x9” cannot be covered here. Still drawn as before."
    assert told["state"]["covered"] == []
