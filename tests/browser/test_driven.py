"""The page of the driven mass: its headings have room, and a screen reader announces the drawn curves."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page

from tests.browser.descriptions import described

pytestmark = pytest.mark.browser
SIZES = ((1280, 720), (1366, 768), (1920, 1080))
WIDEST = ({}, {"omega": 0.2}, {"omega": 1e6}, {"omega": 0.0123, "k": 12345, "c": 1e-5}, {"omega": 6.282, "c": 0})
BEYOND = """heads => heads.filter(head => head.offsetParent).map(head =>
  Math.max(...[...head.querySelectorAll("*")].map(part => part.getBoundingClientRect().right))
  - head.getBoundingClientRect().right)"""


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_the_heading_of_x_ends_within_its_plot(
    size: tuple[int, int], page: Page, open_scene: Callable[..., Page]
) -> None:
    width, height = size
    page.set_viewport_size({"width": width, "height": height})
    for values in WIDEST:
        open_scene(page, scene="driven", view="motion", **values)
        first, *_ = page.locator(".plot .head").evaluate_all(BEYOND)
        assert first <= 0, values


def test_a_slow_push_is_heard_as_a_line_and_a_quick_one_stays_in_its_frame(
    page: Page, open_scene: Callable[..., Page]
) -> None:
    open_scene(page, scene="driven", view="motion", omega=0.2)
    slow = described(page, "x")
    assert "x: from " in slow and "highest 0.0507 m" in slow
    seconds, low, high = map(
        float, re.findall(r"x: up to (\S+) s too fast .* between (\S+) m and (\S+) m", slow.replace("−", "-"))[0]
    )
    assert 1 < seconds < 5 and -0.01 < low < 0 < high < 0.05
    open_scene(page, scene="driven", view="motion", omega="1e6")
    assert "too fast" not in described(page, "x") and "outside the frame" not in described(page, "x")
