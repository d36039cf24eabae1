"""The lecture in a frame of a course page on another origin."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import ExitStack

import pytest
from playwright.sync_api import Browser, Page, expect

from components.scenes.modes import ModesScene
from tests.browser.fixtures import READY, elsewhere
from tests.browser.waiting import UNFOLD
from tests.serving.server import Server

pytestmark = pytest.mark.browser

Open = Callable[..., Page]
COURSE = """<!DOCTYPE html><title>A course</title><link rel="icon" href="data:,"><label>Name <input></label>
<iframe src="{}" width="{}" height="400" title="Oscillations"></iframe>
<script>told = []; addEventListener("message", ({{data}}) => {{
  told.push(data)
  document.querySelector("iframe").height = data.height
}})</script>"""


@pytest.fixture
def course(browser: Browser, framed: Server) -> Iterator[Callable[[int], Page]]:
    """A page of another origin with the lecture in a frame of that width."""
    context = browser.new_context(viewport={"width": 1280, "height": 900}, bypass_csp=True, reduced_motion="reduce")
    with ExitStack() as pages:

        def make(width: int) -> Page:
            page = context.new_page()
            page.goto(pages.enter_context(elsewhere(COURSE.format(f"{framed.url}?scene=coupled", width))))
            page.get_by_label("Name").focus()
            page.frames[1].wait_for_function(READY)
            return page

        yield make
        context.close()


@pytest.mark.parametrize("width", [1200, 420])
def test_the_frame_tells_its_height_and_takes_no_focus(course: Callable[[int], Page], width: int) -> None:
    page = course(width)
    page.wait_for_function("told.some(({type, height}) => type === 'oscillations:height' && height > 300)")
    assert page.evaluate("document.activeElement.localName") == "input"
    frame = page.frames[1]
    frame.evaluate("oscillations.open({scene: 'modes'})")
    expect(frame.locator("h1")).to_have_text(ModesScene.headline)
    assert page.evaluate("document.activeElement.localName") == "input"
    frame.wait_for_function("document.documentElement.scrollHeight <= innerHeight + 1")


def test_a_link_is_copied_in_a_frame_and_leads_into_a_tab(course: Callable[[int], Page]) -> None:
    page = course(1200)
    frame = page.frames[1]
    frame.evaluate("oscillations.send({type: 'set', values: {k2: 3}})")
    frame.wait_for_function("oscillations.shown.state.parameters.k2 === 3")
    frame.get_by_text("Save and share").click()
    frame.get_by_role("button", name="Copy link").click()
    expect(frame.get_by_role("button", name="Copied")).to_be_visible()
    page.get_by_label("Name").press("ControlOrMeta+v")
    expect(page.get_by_label("Name")).to_have_value(re.compile(r"\?scene=coupled&k2=3(&|$)"))
    out = frame.get_by_role("link", name="Open in a tab")
    out.focus()
    expect(out).to_have_attribute("href", re.compile(r"^\?scene=coupled&k2=3(&|$)"))
    expect(out).to_have_attribute("target", "_blank")


def test_where_nothing_may_be_copied_the_link_is_shown(course: Callable[[int], Page]) -> None:
    page = course(1200)
    frame = page.frames[1]
    frame.evaluate("document.execCommand = () => false")
    frame.evaluate(UNFOLD)
    frame.get_by_role("button", name="Copy link").click()
    field = frame.get_by_role("textbox", name="Link", exact=True)
    expect(field).to_have_value(re.compile(r"\?scene=coupled&view=motion$"))
    expect(field).to_be_focused()
    assert field.evaluate("one => one.selectionEnd - one.selectionStart === one.value.length")


def test_a_page_that_is_no_frame_needs_no_way_out(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    expect(page.get_by_role("link", name="Open in a tab")).to_have_count(0)
