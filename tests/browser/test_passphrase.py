"""A server on which only instructors open classes: the page asks for their passphrase in words."""

from __future__ import annotations

import re
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, expect

from tests.browser.classroom import CONNECTED, LED
from tests.browser.fixtures import READY
from tests.browser.tabs import calm_context
from tests.serving.server import serving

pytestmark = pytest.mark.browser
PHRASE = "swinging über springs"


def test_who_opens_a_class_is_asked_for_the_passphrase_and_the_qr_code_lets_phones_in(
    tmp_path: Path, browser: Browser
) -> None:
    with serving(tmp_path / "log", environment={"CLASS_PASSPHRASE": PHRASE}) as server:
        desk = calm_context(browser, {"width": 1280, "height": 800}, bypass_csp=True)
        page = desk.new_page()
        page.goto(f"{server.url}?scene=coupled")
        page.wait_for_function(CONNECTED)
        page.keyboard.press("t")
        dialog = page.get_by_role("dialog", name="Passphrase")
        expect(dialog.get_by_role("heading")).to_have_text("Opening a class here needs the instructors' passphrase.")
        dialog.get_by_label("Passphrase").fill("another one")
        page.keyboard.press("Enter")
        expect(dialog.get_by_role("heading")).to_have_text(re.compile("^This is not the instructors' passphrase"))
        dialog.get_by_role("button", name="Cancel").click()
        expect(page.get_by_text("No class was opened.")).to_be_visible()
        page.keyboard.press("t")
        dialog.get_by_label("Passphrase").fill(PHRASE)
        dialog.get_by_role("button", name="Open the class").click()
        page.wait_for_function(LED)
        pocket = calm_context(browser, {"width": 390, "height": 844}, bypass_csp=True)
        phone = pocket.new_page()
        asked: list[str] = []
        phone.on("request", lambda request: asked.append(request.headers.get("authorization", "")))
        address = page.evaluate(f"{LED}.room.address")
        phone.goto(f"{server.url}{urlsplit(address).path[1:]}?{urlsplit(address).query}")
        phone.wait_for_function(f"{READY} && Boolean(oscillations.clock.lead)")
        assert f"Bearer {address.partition('join=')[2]}" in asked
        pocket.close()
        desk.close()
        assert not server.complaints()
