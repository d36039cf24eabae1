"""A visitor's own numbers: a step asks each visitor with different numbers, and a class with those of its file."""

from __future__ import annotations

import math

import pytest
from playwright.sync_api import Page, expect

from tests.browser.classroom import LED, Open, joined

pytestmark = pytest.mark.browser
ASKED = "globalThis.oscillations?.walks?.walk?.card && oscillations.walks.walk.numbers"
CLASS = f"{ASKED} === 0 && oscillations.shown.state.step === 'd31/d31-02'"


def stiffness(page: Page) -> float:
    page.wait_for_function(f"{ASKED} > 0")
    return float(page.evaluate("oscillations.shown.settings.k.value"))


def test_a_visitor_has_numbers_that_stay_and_a_class_those_of_the_file(window: Open) -> None:
    page = window("walk=d31&step=d31-02", 1280, 720)
    k = stiffness(page)
    query = page.evaluate("location.search")
    assert query.startswith("?walk=d31&step=d31-02&seed=")
    expect(page.locator(".card .given").first).to_contain_text(f"{2 * math.pi / math.sqrt(k):.3g}"[:4])
    page.get_by_label("Your answer").fill(f"{4 * math.pi / math.sqrt(k):.2f}")
    page.get_by_role("button", name="Show the answer", exact=True).click()
    page.wait_for_function("oscillations.walks.walk.lesson?.right")
    page.reload()
    assert stiffness(page) == k and page.evaluate("location.search") == query
    page.evaluate("oscillations.walks.walk.go(2)")
    page.wait_for_function("oscillations.shown.state.step === 'd31/d31-03'")
    page.evaluate("oscillations.walks.walk.go(1)")
    assert stiffness(page) == k, "the same visitor has the same numbers"

    page.evaluate("oscillations.classes.begin()")
    page.wait_for_function(LED)
    page.wait_for_function(CLASS)
    expect(page.locator(".card .given").first).to_contain_text("1.00 s")
    phone = joined(window, page.evaluate(f"{LED}.room.code"))
    phone.wait_for_function("oscillations.asked.card?.step === undefined && oscillations.asked.question?.step")
    expect(phone.locator(".card .given")).to_contain_text("1.00 s")
    page.evaluate("oscillations.walks.walk.go(2)")
    page.wait_for_function("oscillations.shown.state.step === 'd31/d31-03'")
    page.evaluate("oscillations.walks.walk.go(1)")
    page.wait_for_function(CLASS)
    page.reload()
    page.wait_for_function(f"{LED} && {CLASS}")
