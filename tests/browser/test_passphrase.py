"""A server on which only instructors open classes: the page asks for their passphrase in words."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.browser.classroom import CONNECTED, LED, opening
from tests.browser.fixtures import READY
from tests.serving.server import serving

pytestmark = pytest.mark.browser
PHRASE = "swinging über springs"


def test_who_opens_a_class_is_asked_for_the_passphrase_and_the_qr_code_lets_phones_in(
    tmp_path: Path, browser: Browser
) -> None:
    environment = {"CLASS_PASSPHRASE": PHRASE}
    with serving(tmp_path / "log", environment=environment) as server, opening(browser, server.url) as window:
        page = window("scene=coupled", 1280, 800)
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
        code, address = page.evaluate(f"[{LED}.room.code, {LED}.room.address]")
        phone, word = window("", 390, 844), address.partition("join=")[2]
        with phone.expect_request(lambda request: request.headers.get("authorization") == f"Bearer {word}"):
            phone.goto(f"{server.url}?class={code}&join={word}")
        phone.wait_for_function(f"{READY} && Boolean(oscillations.clock.lead)")
        assert not server.complaints()
