"""The headers of our pages."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable
from hashlib import sha256

import pytest
from playwright.sync_api import Browser, Page, expect

from components.scenes import SCENES
from components.serving.assets import assets
from tests.attack.caller import ask
from tests.grids import spread
from tests.serving.server import Server


@pytest.mark.parametrize(
    "path", ["/", "/nowhere", "/app", "/data.csv", "/data.csv?k2=many", "/liveness", f"/assets/{next(iter(assets()))}"]
)
def test_every_answer_has_the_headers_and_names_no_version(server: Server, path: str) -> None:
    headers = ask(server.url, path).headers
    assert headers["X-Content-Type-Options"] == "nosniff"
    assert headers["Referrer-Policy"] == "no-referrer"
    assert headers["Content-Security-Policy"].endswith("frame-ancestors 'self'")
    assert {"default-src 'none'", "base-uri 'none'"} <= set(headers["Content-Security-Policy"].split("; "))
    assert headers["Permissions-Policy"].startswith("camera=(), ")
    assert "Server" not in headers


@pytest.mark.parametrize("path", ["/", "/?scene=coupled", "/?class=ABCD"])
def test_the_scripts_of_a_page_are_named_by_their_hash_and_nothing_else_runs(path: str, server: Server) -> None:
    reply = ask(server.url, path)
    (allowed,) = re.findall(r"script-src ([^;]*)", reply.headers["Content-Security-Policy"])
    inline = re.findall(r"<script>(.*?)</script>", reply.text, re.S)
    hashes = [f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'" for script in inline]
    assert hashes
    assert set(allowed.split()) == {"'self'", *hashes}


def test_what_a_link_says_is_no_script_of_the_page(server: Server) -> None:
    plain, said = (
        ask(server.url, path).headers["Content-Security-Policy"]
        for path in ("/?scene=oscillator", "/?k2=<script>a()</script>")
    )
    assert len(plain.split("'sha256-")) == len(said.split("'sha256-"))


@pytest.mark.browser
@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_a_scene_needs_nothing_that_its_page_does_not_allow(
    server: Server, new_page: Callable[..., Page], slug: str
) -> None:
    """A browser reports refused content on its console."""
    page = new_page(bypass_csp=False)
    page.goto(f"{server.url}?scene={slug}")
    expect(page.locator("html[data-ready=true]")).to_be_attached(timeout=30_000)
    about = page.locator("details.about summary")
    if about.count():
        about.click()
        expect(page.locator("details.about table").first).to_be_visible()
    page.locator("#theme").click()
    page.get_by_text("Save and share").click()
    with page.expect_download():
        page.get_by_role("button", name="CSV").click()


@pytest.mark.browser
def test_a_script_from_elsewhere_is_refused(server: Server, browser: Browser) -> None:
    page = browser.new_page()
    page.goto(f"{server.url}?scene=oscillator")
    page.evaluate(
        "document.body.append(Object.assign(document.createElement('script'), {textContent: 'globalThis.ran = 1'}))"
    )
    assert page.evaluate("globalThis.ran") is None
    page.close()
