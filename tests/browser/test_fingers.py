"""A finger on a phone: no field zooms the page, and a long press selects nothing that can be dragged."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page

from tests.browser.engines import Window
from tests.browser.fixtures import READY
from tests.browser.waiting import unfold
from tests.serving.server import Server

pytestmark = pytest.mark.browser
LEAST = 16  # px; Safari on a phone zooms in to a field with smaller text, and stays there
PAGES = {"": "#code", "?scene=coupled": ".panel [name=k2]", "?walk=d34&step=d34-01": ".card input"}
"""Links, and the last field of each."""
FIELDS = """[...document.querySelectorAll("input:not([type=checkbox], [type=radio], [type=range]), select, textarea")]
  .map(one => [one.name || one.id || one.type, parseFloat(getComputedStyle(one).fontSize)])"""
SELECTED = """[...document.querySelectorAll(".block.stage, .plot-area, .drawing, .marking, [data-grab], .pill")]
  .filter(one => one.checkVisibility())
  .map(one => [one.getAttribute("class").split(" ")[0], getComputedStyle(one).webkitUserSelect])"""


@pytest.mark.parametrize("size", [(390, 844), (1280, 600)], ids=["phone", "low desk"])
def test_no_field_has_text_so_small_that_a_phone_zooms_in(
    size: tuple[int, int], new_page: Callable[..., Page], server: Server
) -> None:
    page, found = new_page(*size, has_touch=True, is_mobile=True), {}
    for link, last in PAGES.items():
        page.goto(server.url + link)
        page.wait_for_function(f"document.querySelector('{last}')")
        unfold(page)
        if "scene" in link:
            page.evaluate("document.getElementById('ask').click()")
            page.wait_for_function("document.querySelector('.asking select')")
        found |= dict(page.evaluate(FIELDS))
    assert {"class", "k2", "window", "answer", "kind"} <= found.keys()
    assert {name: size for name, size in found.items() if size < LEAST} == {}


@pytest.mark.slow
@pytest.mark.parametrize("link", ["scene=coupled", "walk=d34&step=d34-10", "walk=d34&step=d34-08"])
def test_a_long_press_on_what_can_be_dragged_selects_no_text(engine: Window, server: Server, link: str) -> None:
    engine.goto(f"{server.url}?{link}")
    engine.wait_for_function(f"{READY} && (!{'walk' in link:d} || document.querySelector('.card'))")
    kinds, found = zip(*engine.evaluate(SELECTED), strict=True)
    assert {"plot-area", {"coupled": "grip", "d34-10": "drawing", "d34-08": "marking"}[link.split("=")[-1]]} <= {*kinds}
    assert {*found} == {"none"}
