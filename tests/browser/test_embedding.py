"""The lecture in frames of pages of another origin, and the snippets of docs/embedding.md, unchanged."""

import re
from collections.abc import Callable, Iterator
from functools import partial
from html import unescape
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.waiting import UNFOLD
from tests.serving.server import ROOT, Server

pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]

PAGE = (ROOT / "docs" / "embedding.md").read_text(encoding="utf-8")
FRAME, LISTENER, SLIDE = re.findall(r"```html\n(.*?)```", PAGE, re.S)


@pytest.fixture
def shown(quiet: Callable[..., Page], framed: Server, tmp_path: Path) -> Iterator[Callable[[str], Page]]:
    """Shows a page of another origin."""

    def visit(html: str) -> Page:
        html = f"<!DOCTYPE html><title>A course</title>{html}".replace("https://lecture.example/", framed.url)
        (tmp_path / "course.html").write_text(html, encoding="utf-8")
        page = quiet(height=900, reduced_motion="reduce")
        page.goto(f"http://127.0.0.1:{served.server_port}/course.html")
        return page

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(SimpleHTTPRequestHandler, directory=tmp_path)) as served:
        Thread(target=served.serve_forever, daemon=True).start()
        yield visit
        served.shutdown()


def test_a_frame_reports_its_height_takes_no_focus_and_copies_its_link(shown: Callable[[str], Page]) -> None:
    """If a page may not copy, it shows the link instead."""
    low = FRAME.replace('height="760"', 'height="500"')
    page = shown(f"<label>Name <input></label>{low}{LISTENER}")
    name, frame = page.get_by_label("Name"), page.frames[1]
    name.focus()
    frame.wait_for_function(READY)
    expect(frame.locator("h1")).to_have_text("Every free motion is a slow mode plus a fast mode")
    assert frame.evaluate("oscillations.shown.state.parameters.k2") == 3
    page.wait_for_function("document.querySelector('iframe').height !== '500'")
    frame.wait_for_function("document.documentElement.scrollHeight <= innerHeight + 1")
    expect(name).to_be_focused()
    frame.get_by_text("Save and share").click()
    frame.get_by_role("button", name="Copy link").click()
    expect(frame.get_by_role("button", name="Copied")).to_be_visible()
    name.press("ControlOrMeta+v")
    expect(name).to_have_value(re.compile(r"\?scene=coupled&k2=3(&|$)"))
    out = frame.get_by_role("link", name="Open in a tab")
    out.focus()
    expect(out).to_have_attribute("href", re.compile(r"^\?scene=coupled&k2=3(&|$)"))
    expect(out).to_have_attribute("target", "_blank")
    name.focus()
    frame.evaluate("oscillations.open({scene: 'modes'})")
    expect(frame.locator("h1")).to_have_text(SCENES["modes"].headline)
    expect(name).to_be_focused()
    page.evaluate("document.querySelector('iframe').width = 420")
    frame.wait_for_function("innerWidth === 420 && document.documentElement.scrollHeight <= innerHeight + 1")
    frame.evaluate("document.execCommand = () => false")
    frame.evaluate(UNFOLD)
    frame.get_by_role("button", name="Copy link").click()
    field = frame.get_by_role("textbox", name="Link", exact=True)
    expect(field).to_have_value(re.compile(r"\?scene=modes"))
    expect(field).to_be_focused()
    assert field.evaluate("one => one.selectionEnd - one.selectionStart === one.value.length")


def test_a_slide_shows_a_scene_for_the_last_row(framed: Server, quiet: Callable[..., Page]) -> None:
    (address,) = re.findall(r'data-background-iframe="https://lecture.example/([^"]+)"', SLIDE)
    page = quiet()
    page.goto(framed.url + unescape(address))
    expect(page.locator("h1")).to_have_text(SCENES["forced"].headline)
    assert page.evaluate("location.search") == "?scene=forced&view=response&projector"
