"""Hidden parts are not sent, nor anything derived from them: covers of a question, and everything that follows from a
change that is to be predicted.
"""

import json
import re
from collections.abc import Collection, Iterator
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from components.language.blocks import StageBlock
from components.language.shapes import Begin
from components.layout.sheet import blocks
from components.quantities.axes import round_ticks
from components.quantities.formatting import three
from components.scene import Picture, Scene
from components.scenes import SCENES
from components.state.covers import NEXT, PLOT, STAGE, VALUE, without
from components.state.csv_export import tables
from components.state.page_state import PageState
from components.state.scene_sheet import plots
from components.state.wire import as_json
from components.walks.links import page_state_at
from components.walks.loading import load_walks, steps_of
from tests.grids import sample
from tests.page.headless_page import Page, change, picture_wire, say, set_values
from tests.page.scripts import played
from tests.scenes.checks import changes

NUMBER = re.compile(r"[0-9][0-9.]*")
"""Digits of a number in a text."""
scenes = pytest.mark.parametrize("slug", SCENES)
STAGED = [(step.state, step.cover) for step in steps_of(load_walks(()).values()).values() if STAGE in step.cover]
STAGED += [(f"?scene=modes&view={view}", (STAGE,)) for view in ("solve", "roots")]


@scenes
def test_a_covered_plot_or_number_is_not_sent_and_all_others_are(slug: str) -> None:
    page, kind = Page(SCENES[slug]()), SCENES[slug]
    whole, picture = change(page, covered=[NEXT])["view"], page.shown
    for cover in (*(PLOT + plot.name for plot in plots(kind)), *(VALUE + name for name in picture.values)):
        told = change(page, covered=[cover, cover])
        assert (told["errors"], told["state"]["covered"]) == ({}, [cover])
        view, left_out = told["view"], set(told["view"]["left_out"])
        assert view["values"].keys() == whole["values"].keys() - left_out
        spoken = json.dumps([signal for signal in view["signals"].values() if signal["kind"] == "derived"])
        assert not any(f'"{name}"' in spoken for name in left_out - view["signals"].keys())  # its motion may be sent
        names = {cover, *(PLOT + name for name in kind.covered_with.get(cover.removeprefix(PLOT), ()))}
        (hidden, motions), (others, shown) = (drawn(kind, names, is_hidden=has) for has in (True, False))
        assert {one for one in hidden if is_sent(view, *one)} <= others | {("time", "t")}  # times alone tell nothing
        assert all(is_sent(view, *one) is is_sent(whole, *one) for one in others)
        for name in (motions - shown) & whole["signals"].keys():
            assert view["signals"].get(name) != whole["signals"][name], name


def drawn(scene: type[Scene], covered: Collection[str], *, is_hidden: bool) -> tuple[set[tuple[str, str]], set[str]]:
    """Return the columns and the motions of the curves of covered plots, or of the others."""
    curves = [curve for plot in plots(scene) if (PLOT + plot.name in covered) is is_hidden for curve in plot.curves]
    motions = {name for one in curves for name in (one.signal, one.signal_x) if name}
    return {(one.source, name) for one in curves for name in (one.x, one.y)}, motions


def is_sent(view: dict[str, Any], source: str, name: str) -> bool:
    return name in view["columns"].get(source, {})


def begun(scene: PageState) -> Iterator[tuple[str, float]]:
    """The bodies of the stage and their initial positions from the parameters, in the unit of their axis."""
    for block in blocks(scene.kind.sheet()):
        for shape in block.shapes if isinstance(block, StageBlock) else ():
            for begin in shape.grab.start if shape.grab else ():
                if isinstance(begin, Begin) and begin.of in scene.shown.signals:
                    axis = scene.shown.axes.get(begin.axis)
                    if axis:
                        yield begin.of, axis.place(float(scene.scene.values[begin.parameter])) * begin.size


@pytest.mark.parametrize(("link", "covered"), STAGED)
def test_of_a_covered_stage_nothing_but_the_start_of_a_body_is_sent(link: str, covered: tuple[str, ...]) -> None:
    """The motions of modes begin at their amplitudes, and nobody can drag them."""
    scene = page_state_at(link, SCENES)
    left, _ = without(scene.kind, scene.shown, covered)
    starts = dict(begun(scene))
    for name in (name for name, signal in left.signals.items() if signal != scene.shown.signals[name]):
        rests = [played(left, t)[name] for t in (0.0, 0.3)]
        assert rests == pytest.approx([starts.get(name, 0.0)] * 2, rel=1e-12, abs=1e-12), name


@scenes
def test_a_covered_axis_is_wider_and_begins_at_0_where_it_did(slug: str) -> None:
    page = page_state_at(f"?scene={slug}", SCENES)
    for name, axis in page.shown.axes.items():
        wide = without(page.kind, page.shown, (f"ticks:{name}",))[0].axes[name]
        outwards = 1 if axis.end > axis.start else -1
        assert outwards * (wide.end - axis.end) > 0, name
        assert (outwards * (axis.start - wide.start) > 0) == (axis.start != 0), name


@scenes
def test_no_number_that_follows_from_a_change_is_in_any_message(slug: str) -> None:
    for values in sample(list(changes(SCENES[slug]))):
        page = Page(SCENES[slug]())
        axes = (replace(axis, ticks=round_ticks(axis), labels=()) for axis in page.shown.axes.values())
        rulers = [json.loads(as_json(axis.ruler)) for axis in axes]  # they replace those of the total
        seen = numbers([change(page, covered=[NEXT], held={}), csv_of(page, page.shown), rulers])
        told = set_values(page, **values)
        assert told["errors"] == {} and told["state"]["before"] == {}, values
        ((name, value),) = values.items()
        default = SCENES[slug].param[name].default
        ratio = three(value / default) if default else ""  # as the comparison writes it
        by_hand = [one for one in told["settings"].values() if isinstance(one["value"], float)]
        set_to = [(one["value"], one["text"], three(one["value"] / one["size"])) for one in by_hand]
        given = numbers([set_to, told["state"]["parameters"], told["query"], ratio])
        outcome = numbers([picture_wire(page.now), csv_of(page, page.shown)]) - seen - given
        assert outcome, f"nothing follows from {values}"
        assert outcome & numbers([told, csv_of(page, page.now.to_send[0])]) == set(), values


def csv_of(page: Page, picture: Picture) -> list[list[Any]]:
    return [[table.name, table.head, table.rows] for table in tables(page.now.kind, picture)]


def numbers(told: Any) -> set[float | str]:
    """Return all sent numbers, and those in texts by their digits; without one-digit numbers, which round axes have."""
    if isinstance(told, dict):
        return numbers(list(told.values()))
    if isinstance(told, np.ndarray):
        return set(told.tolist())
    if isinstance(told, (list, tuple)):
        return set().union(*map(numbers, told))
    if isinstance(told, str):
        return {digits for digits in NUMBER.findall(told) if len(digits.strip("0.")) > 1}
    return {told, abs(told)} if isinstance(told, float) and len(f"{told:g}".strip("-0.")) > 1 else set()


def test_what_is_revealed_one_by_one_stays_so_a_view_is_no_change_and_a_preset_is_one() -> None:
    page = Page(SCENES["coupled"]())
    change(page, covered=[NEXT])
    assert say(page, "choose", name="view", value="forces")["state"]["covered"] == [NEXT]
    told = set_values(page, k2=5.0)
    assert {"plot:x1", "plot:x2", "value:omega_minus", "stage"} <= set(told["state"]["covered"])
    left = [name for name in told["state"]["covered"] if name not in (NEXT, "plot:x1")]
    assert change(page, covered=left)["state"]["covered"] == left
    assert set_values(page, k2=6.0)["state"]["covered"] == left
    page = Page(SCENES["oscillator"]())
    change(page, covered=[NEXT])
    assert {"plot:x", "value:tau"} <= set(change(page, parameters={"m": 4.0}, frame=None)["state"]["covered"])


def test_a_hidden_axis_keeps_its_range_and_its_own_numbers_give_nothing_away() -> None:
    """The axis of the energies ends at their total. When hidden, it has round numbers of the frame, which stays."""
    pages = [Page(SCENES["damped"](view="energy")) for _ in range(2)]
    for page in pages:
        before = change(page, covered=[NEXT])["view"]["axes"]["E"]
    told, other = (set_values(page, x_0=x) for page, x in zip(pages, (0.002, 0.07), strict=True))
    assert "numbers:E" in told["state"]["covered"]
    assert pages[0].shown.axes["E"].seen != pages[1].shown.axes["E"].seen
    axis = told["view"]["axes"]["E"]
    assert axis == other["view"]["axes"]["E"] and (axis["start"], axis["end"]) == (before["start"], before["end"])
