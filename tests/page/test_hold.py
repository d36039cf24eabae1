"""Hold: a second picture in the frame of the current one, with a table that compares their numbers."""

from typing import Any

import msgspec
import numpy as np
import pytest

from components.quantities.axes import TIME_AXIS
from components.scene.picture import frame_of
from components.scenes import SCENES
from components.state.encoding import COARSE, span
from components.state.link import read_query
from components.state.scene_sheet import column_axes
from tests.page.headless_page import Page, change, set_values, unpacked
from tests.scenes.checks import as_arguments, by_link, changes

scenes = pytest.mark.parametrize("slug", SCENES)


def hold(page: Page) -> dict[str, Any]:
    return change(page, held=msgspec.to_builtins(page.now.state)["parameters"])


def ledger(told: dict[str, Any]) -> list[dict[str, str]]:
    return list(told["held"]["ledger"])


@scenes
def test_the_compared_picture_is_the_earlier_one_in_the_current_frame(slug: str) -> None:
    page = Page(SCENES[slug]())
    told = hold(page)
    assert told["errors"] == {} and told["state"]["held"] == {}
    assert (told["held"]["columns"], told["held"]["values"]) == ({}, {}), "nothing has changed yet"
    value = next(changes(SCENES[slug]))
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


def test_the_ledger_says_what_became_of_each_number_and_hides_it_by_each_of_its_names() -> None:
    page = Page(SCENES["oscillator"]())
    hold(page)
    rows = [tuple(row[part] for part in ("held", "now", "unit", "ratio")) for row in ledger(set_values(page, m=4.0))]
    assert rows[:3] == [("1.00", "4.00", "kg", "× 4"), ("6.28", "3.14", "rad/s", "× ½"), ("1.00", "2.00", "s", "× 2")]
    assert rows[4] == ("2.48", "2.77", "rad", "+0.291")
    assert [row[3] for row in rows[5:]] == ["same", "same", "same"]
    page = Page(SCENES["modes"]())
    hold(page)
    covers = ["value:fast_omega", "value:now_ratio_slow"]
    told = change(page, parameters={"view": "solve", "k2": 3.0}, covered=covers)
    hidden = [(row["tint"], row["unit"], row["ratio"]) for row in ledger(told) if row["now"] == "?"]
    assert sorted(hidden) == [("fast", "rad/s", "?"), ("slow", "", "?")]


def test_a_link_names_what_it_cannot_hold() -> None:
    link = read_query(as_arguments("scene=coupled&held.view=forces&held.k2=x&held=here"), SCENES)
    assert [problem.partition(":")[0] for problem in link.problems] == [
        "“view” is not a parameter of this scene.", "k2", "held",
    ]  # fmt: skip
    assert link.held is None
    told = unpacked(by_link("scene=coupled&held.k2=5").opening())
    assert told["held"]["values"] == {"k2": 5.0}
