"""Hold: a second picture in the frame of the current one, with a table that compares their numbers."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
import pytest

from components.quantities.axes import TIME_AXIS
from components.scene.picture import frame_of
from components.scenes import SCENES
from components.session.opening import opened
from components.state.encoding import COARSE, span
from components.state.link import read_query
from components.state.scene_sheet import column_axes
from tests.page.headless_page import Page, change, set_values, unpacked
from tests.scenes.checks import as_arguments, moved

scenes = pytest.mark.parametrize("slug", SCENES)


def hold(page: Page) -> dict[str, Any]:
    return change(page, held=msgspec.to_builtins(page.now.state)["parameters"])


def ledger(told: dict[str, Any]) -> dict[str, tuple[str, str, str]]:
    return {row["symbol"]: (row["held"], row["now"], row["ratio"]) for row in told["held"]["ledger"]}


@scenes
def test_the_compared_picture_is_the_earlier_one_in_the_current_frame(slug: str) -> None:
    page = Page(SCENES[slug]())
    told = hold(page)
    assert told["errors"] == {} and told["state"]["held"] == {}
    assert (told["held"]["columns"], told["held"]["values"]) == ({}, {}), "nothing has changed yet"
    value = moved(SCENES[slug])
    told = set_values(page, **value)
    assert told["errors"] == {} and set(told["held"]["values"]) >= set(value)
    assert page.now.drawn.beside
    wanted = SCENES[slug]().picture(frame_of(page.now.drawn.beside))
    axes = column_axes(SCENES[slug])
    for source, columns in told["held"]["columns"].items():
        for name, column in columns.items():
            axis = page.shown.axes[axes[source].get(name, TIME_AXIS)]
            low, high = span(axis.ruler)
            true = np.clip(axis.places(wanted.sources[source][name]), low, high)
            assert np.allclose(np.clip(column, low, high), true, rtol=1e-6, atol=0.51 * (high - low) / COARSE)


def test_the_ledger_says_what_became_of_each_number_and_what_is_the_same() -> None:
    page = Page(SCENES["oscillator"]())
    hold(page)
    told = set_values(page, m=4.0)
    rows = [(row["held"], row["now"], row["unit"], row["ratio"]) for row in told["held"]["ledger"]]
    assert rows[:3] == [
        ("1.00", "4.00", "kg", "× 4"),
        ("6.28", "3.14", "rad/s", "× ½"),
        ("1.00", "2.00", "s", "× 2"),
    ]
    assert rows[4] == ("2.48", "2.77", "rad", "+0.291")
    assert [row[3] for row in rows[5:]] == ["same", "same", "same"]


def test_what_is_held_outlasts_every_view_preset_and_undo() -> None:
    page = Page(SCENES["coupled"]())
    hold(page)
    set_values(page, k2=3.0)
    for name, word in (("energy", "modes"), ("view", "forces"), ("view", "formulas"), ("energy", "parts")):
        told = page.send({"type": "choose", "name": name, "value": word, "number": len(page.packets) + 1})
        assert told["errors"] == {} and told["state"]["held"] == {} and told["held"]["columns"]
    told = change(page, frame=None, parameters={"m1": 1.0})
    assert told["state"]["held"] == {} and told["preset"] is None
    assert told["held"]["values"] == {"m1": 2.0}


def test_the_frame_has_room_for_both_and_fits_both() -> None:
    page = Page(SCENES["oscillator"](v_0=-3.0))
    hold(page)
    told = change(page, frame=None, parameters={"x_0": 0.01, "v_0": 0.0})
    high = page.shown.axes["x"].end
    assert np.abs(told["held"]["columns"]["time"]["x"]).max() < high
    assert told["state"]["frame"] is None, "nothing more would fit"
    set_values(page, x_0=0.02)
    assert page.shown.axes["x"].end == high
    change(page, held=None, frame=None)
    assert page.shown.axes["x"].end < 0.1 * high


def test_hidden_parts_of_the_compared_picture_are_not_sent() -> None:
    page = Page(SCENES["coupled"]())
    hold(page)
    set_values(page, k2=3.0)
    told = change(page, covered=["plot:x2", "value:omega_minus"])
    assert "x1" in told["held"]["columns"]["time"] and "x2_slow" not in told["held"]["columns"]["time"]
    assert told["held"]["signals"]["x2"]["value"] == {"terms": [[0.0, []]]}, "it rests where it starts"
    assert ledger(told)['<span class="v">ω</span><sub>−</sub>'] == ("1.00", "?", "?")


def test_a_number_shown_under_several_names_is_hidden_by_each() -> None:
    page = Page(SCENES["modes"]())
    hold(page)
    covers = ["value:fast_omega", "value:now_ratio_slow"]
    told = change(page, parameters={"view": "solve", "k2": 3.0}, covered=covers)
    hidden = [(row["tint"], row["unit"]) for row in told["held"]["ledger"] if row["now"] == "?"]
    assert sorted(hidden) == [("fast", "rad/s"), ("slow", "")]


def test_a_link_names_what_it_cannot_hold() -> None:
    link = read_query(as_arguments("scene=coupled&held.view=forces&held.k2=x&held=here"), SCENES)
    assert [problem.partition(":")[0] for problem in link.problems] == [
        "“view” is not a parameter of this scene.", "k2", "held",
    ]  # fmt: skip
    assert link.held is None
    told = unpacked(opened(SCENES, read_query(as_arguments("scene=coupled&held.k2=5"), SCENES)).opening())
    assert told["held"]["values"] == {"k2": 5.0}
