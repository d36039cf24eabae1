"""Accuracy in Chromium: a visitor's own measurement, its place in the queue, its end when the visitor leaves."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.serving.server import Server, serving

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server that notices early that a visitor has left."""
    soon = ("--unused-seconds", "0.3")
    with serving(tmp_path_factory.mktemp("server") / "log", options=soon) as running:
        yield running
        assert not running.complaints(), running.log.read_text()


UNDER_WAY = re.compile("It begins|is running")
STEPPING = re.compile("(Verlet|Newmark|RK4|DOP853|Radau|LSODA) is running")
"""A method with steps is running. Methods without steps come first and have been measured."""


def test_who_leaves_makes_room_for_the_next(
    new_page: Callable[..., Page], open_scene: Open, screenshot: Callable[[Page, str], Path]
) -> None:
    first, second = (open_scene(new_page(), scene="accuracy", limit=3, system=name) for name in ("wide", "beats"))
    status = ".transport [role=status]"
    first.get_by_role("button", name="Run", exact=True).click()
    expect(first.locator(status)).to_contain_text(UNDER_WAY, timeout=30_000)
    second.get_by_role("button", name="Run", exact=True).click()
    expect(second.locator(status)).to_contain_text("1 measurement before yours")
    screenshot(second, "accuracy-waiting")
    first.close()
    expect(second.locator(status)).to_contain_text(UNDER_WAY, timeout=30_000)
    expect(second.locator(".count")).to_contain_text("of 60 s", timeout=20_000)
    expect(second.locator(status)).to_contain_text(STEPPING, timeout=30_000)
    second.get_by_role("button", name="Skip this method").click()
    second.get_by_role("button", name="Cancel").click()
    expect(second.locator(".count")).to_contain_text("methods measured here")
    expect(second.get_by_role("button", name="Run again")).to_be_visible()


NAMES = """() => {
  const stage = oscillations.page.stages.find(({under}) => under?.block.name === "work")
  const {view, frame} = stage.under, {scalars} = view
  const named = stage.shapes.filter(({spec, group}) => spec.show[0]?.endsWith("_named") && group.style.display === "")
  return named.map(({spec, parts: [text]}) => {
    const slug = spec.show[0].replace("_named", ""), {left, right, top, bottom} = stage.clear.box(text)
    const end = {x: stage.under.px(scalars[`${slug}_at`]), y: stage.under.py(scalars[`${slug}_error`])}
    const beside = Math.min(Math.abs(left - end.x), Math.abs(right - end.x))
    const off = Math.max(0, top - end.y, end.y - bottom) / (bottom - top)
    return {slug, left, right, top, bottom, stands: text.style.display === "", beside, off}
  })
}"""
"""Positions of the methods' names over the plot of errors: the distance to the ends of their lines, and the number of
lines up or down.
"""


@pytest.mark.parametrize("size", [(1280, 720), (390, 844)], ids=str)
def test_names_stand_beside_the_ends_of_their_lines(
    new_page: Callable[..., Page], open_scene: Open, size: tuple[int, int]
) -> None:
    width, height = size
    page = open_scene(new_page(width, height), scene="accuracy", view="time")
    names = page.evaluate(NAMES)
    assert {"verlet", "radau", "closed"} <= {name["slug"] for name in names}
    for i, one in enumerate(names):
        assert one["stands"] and one["beside"] < 12 and one["off"] < 3, one
        for other in names[:i]:
            apart_across = one["right"] <= other["left"] or other["right"] <= one["left"]
            assert apart_across or one["bottom"] <= other["top"] + 0.1 or other["bottom"] <= one["top"] + 0.1
