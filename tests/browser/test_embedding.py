"""The lecture in frames of pages of another origin, and the snippets of docs/embedding.md, unchanged."""

from __future__ import annotations

import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import panel
import pytest
from playwright.sync_api import Browser, Page, expect

from components.scenes.modes import ModesScene
from tests.browser.fixtures import READY, elsewhere
from tests.browser.waiting import UNFOLD, turned
from tests.serving.server import ROOT, Server, free_port

pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]

PAGE = (ROOT / "docs" / "embedding.md").read_text(encoding="utf-8")
FRAME, LISTENER, SLIDE = re.findall(r"```html\n(.*?)```", PAGE, re.S)
(HUB,) = re.findall(r"```python\n(.*?)```", PAGE, re.S)
REVEAL = (Path(panel.__file__).parent / "dist" / "bundled" / "reveal.js@4.5.0" / "dist" / "reveal.min.js").read_text()
PATIENCE = 240.0
"""Seconds in which a busy machine starts Jupyter, and this the lecture."""
CONNECTED = "document.documentElement.dataset.connected === 'true'"


@pytest.fixture
def opened(browser: Browser) -> Iterator[Callable[[str], Page]]:
    context = browser.new_context(viewport={"width": 1280, "height": 900}, bypass_csp=True, reduced_motion="reduce")

    def visit(address: str) -> Page:
        page = context.new_page()
        page.goto(address)
        return page

    yield visit
    context.close()


def test_a_frame_reports_its_height_takes_no_focus_and_copies_its_link(
    framed: Server, opened: Callable[[str], Page]
) -> None:
    """If a page may not copy, it shows the link instead."""
    low = FRAME.replace('height="760"', 'height="500"')
    html = f"<!DOCTYPE html><title>A course</title><label>Name <input></label>{low}{LISTENER}"
    with elsewhere(html.replace("https://lecture.example/", framed.url)) as address:
        page = opened(address)
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
        expect(frame.locator("h1")).to_have_text(ModesScene.headline)
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


def test_a_slide_shows_a_scene_for_the_last_row(framed: Server, opened: Callable[[str], Page]) -> None:
    slides = f'<div class="reveal"><div class="slides"><section>One</section>{SLIDE}</div></div>'
    look = "{position: absolute; inset: 0; width: 100%; height: 100%}"
    start = f"<style>.backgrounds, .slide-background, iframe {look}</style>"
    scripts = f"<script>{REVEAL}</script><script>Reveal.initialize()</script>"
    html = f"<!DOCTYPE html><title>Slides</title>{start}{slides}{scripts}"
    with elsewhere(html.replace("https://lecture.example/", framed.url)) as address:
        page = opened(address)
        page.wait_for_function("Reveal.isReady()")
        page.evaluate("Reveal.next()")
        page.wait_for_function("document.querySelector('.backgrounds iframe[src]')")
        frame = page.locator(".backgrounds iframe").element_handle().content_frame()
        assert frame
        frame.wait_for_url(f"{framed.url}**")
        frame.wait_for_function(READY)
        assert frame.evaluate("[oscillations.shown.scene, location.search]") == [
            "forced",
            "?scene=forced&view=response&projector",
        ]


@contextmanager
def hub(folder: Path) -> Iterator[str]:
    """A Jupyter server with the configuration of the page; the address of the lecture behind it."""
    port = free_port()
    config = HUB.replace('"python"', repr(sys.executable)).replace("/srv/oscillations", str(ROOT))
    config = config.replace("hub.example:8000", f"localhost:{port},hub.example:{port}")
    config = config.replace('"timeout": 60', f'"timeout": {PATIENCE:g}')
    more = "c.ServerApp.token = c.IdentityProvider.token = ''\nc.ServerApp.allow_remote_access = True\n"
    (folder / "jupyter_server_config.py").write_text(config + more)
    command = [sys.executable, "-m", "jupyter_server", "--no-browser", "--allow-root", f"--port={port}"]
    variables = {"HOME": str(folder), "PATH": str(Path(sys.executable).parent), "JUPYTER_CONFIG_DIR": str(folder)}
    log = (folder / "log").open("wb")
    process = subprocess.Popen(command, cwd=folder, env=variables, stdout=log, stderr=log)
    address, end = f"http://localhost:{port}/oscillations/", time.monotonic() + PATIENCE
    try:
        while True:
            try:
                urlopen(address).close()
                break
            except OSError:
                assert time.monotonic() < end and process.poll() is None, (folder / "log").read_text()
                time.sleep(0.2)
        yield address
    finally:
        process.terminate()
        process.wait()
        log.close()


@pytest.mark.slow
def test_behind_the_real_proxy_of_jupyter_a_page_connects_if_its_name_is_known(
    tmp_path: Path, opened: Callable[[str], Page]
) -> None:
    with hub(tmp_path) as address:
        page = opened(f"{address}?scene=coupled")
        page.wait_for_function(READY)
        page.wait_for_function(CONNECTED)
        page.evaluate("oscillations.send({type: 'set', values: {k2: 3}})")
        page.wait_for_function("oscillations.shown.state.parameters.k2 === 3")
        assert page.url == f"{address}?scene=coupled&k2=3" or page.url.startswith(f"{address}?scene=coupled")
        page.get_by_role("link", name="Forced").first.click()
        page.wait_for_function("oscillations.shown.scene === 'forced'")
        port = address.split("/")[2].rpartition(":")[2]
        with urlopen(Request(address, headers={"Host": f"hub.example:{port}"})) as answer:
            assert answer.status == 200
        with pytest.raises(HTTPError, match="403"):
            urlopen(Request(address, headers={"Host": f"other.example:{port}"}))


def test_a_page_that_is_no_frame_needs_no_way_out(desk: Page) -> None:
    turned(desk, "coupled", {})
    expect(desk.get_by_role("link", name="Open in a tab")).to_have_count(0)
