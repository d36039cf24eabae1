"""The scripts that our pages may run, and the files that a browser fetches for them."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable
from hashlib import sha256

import pytest
from playwright.sync_api import Page, expect

from components.scenes import SCENES
from tests.attack.caller import ask
from tests.grids import sample
from tests.serving.server import Server


@pytest.mark.parametrize("path", ["/", "/?scene=coupled", "/?class=ABCD", "/?k2=<script>a()</script>"])
def test_the_scripts_of_a_page_are_named_by_their_hash_and_nothing_else_runs(path: str, server: Server) -> None:
    reply = ask(server.url, path)
    (allowed,) = re.findall(r"script-src ([^;]*)", reply.headers["Content-Security-Policy"])
    inline = re.findall(r"<script>(.*?)</script>", reply.text, re.S)
    hashes = [f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'" for script in inline]
    assert hashes and "a()" not in inline
    assert set(allowed.split()) == {"'self'", *hashes}


@pytest.mark.browser
@pytest.mark.parametrize("slug", sample([*SCENES], 4))
def test_a_scene_needs_nothing_that_its_page_does_not_allow(
    server: Server, new_page: Callable[..., Page], slug: str
) -> None:
    """A browser reports refused content on its console; a script from elsewhere is refused."""
    page = new_page(bypass_csp=False)
    page.goto(f"{server.url}?scene={slug}")
    expect(page.locator("html[data-ready=true]")).to_be_attached(timeout=30_000)
    about = page.locator("details.about summary")
    if about.count():
        about.click()
        expect(page.locator("details.about table").first).to_be_visible(timeout=30_000)
    page.locator("#theme").click()
    page.get_by_text("Save and share").click()
    with page.expect_download():
        page.get_by_role("button", name="CSV").click()
