"""Answers on a phone: the picture is first, and the own curve is under the names of a plot."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page

from tests.browser.halls import TAUGHT
from tests.serving.server import Server

pytestmark = pytest.mark.browser
CARD = "document.documentElement.dataset.ready === 'true' && document.querySelector('.card')"


@pytest.fixture
def open_step(server: Server, new_page: Callable[..., Page]) -> Callable[[str], Page]:
    def go(step: str) -> Page:
        page = new_page(390, 844)
        page.goto(f"{server.url}?walk={step.rpartition('-')[0]}&step={step}")
        page.wait_for_function(CARD)
        return page

    return go


@pytest.mark.parametrize("step", ["d34-19", "d34-20", "d34-21"])
def test_on_a_phone_an_answer_without_a_stage_on_top_begins_with_its_picture(
    step: str, open_step: Callable[[str], Page]
) -> None:
    page = open_step(step)
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function(TAUGHT)
    page.wait_for_function(
        """() => [".block.plot", ".block.stage", ".transport", ".card"]
          .map(kind => [...document.querySelectorAll(kind)].find(one => one.checkVisibility()))
          .map(one => one.getBoundingClientRect().top)
          .every((top, i, all) => !i || top > all[i - 1])"""
    )


def test_names_over_a_plot_are_above_the_own_curve(open_step: Callable[[str], Page]) -> None:
    page = open_step("d34-14")
    pad = page.locator(".drawing")
    pad.scroll_into_view_if_needed()
    box = pad.bounding_box()
    assert box
    page.mouse.move(box["x"] + 15, box["y"] + 20)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] - 15, box["y"] + 20, steps=20)
    page.mouse.up()
    page.evaluate("oscillations.walks.walk.show(true)")
    page.wait_for_function(TAUGHT)
    page.add_style_tag(content="* { pointer-events: auto !important }")
    uppermost = """() => {
      const flag = [...document.querySelectorAll(".plot-area .flag")].find(flag => flag.checkVisibility())
      flag.scrollIntoView({block: "center"})
      const {left, top, width, height} = flag.getBoundingClientRect()
      const found = document.elementsFromPoint(left + width / 2, top + height - 3)
      return found.findIndex(one => flag.contains(one)) < found.findIndex(one => one.closest(".drawing"))
    }"""
    assert page.evaluate(uppermost)
