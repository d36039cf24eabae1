"""A phone while it waits and after the answer: its answer, the number of answers, the votes, its own reply."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser.classroom import Open, joined, taught
from tests.browser.waiting import clicked

pytestmark = pytest.mark.browser
WAITS = ".card-body > .hint[role=status]"


@pytest.mark.parametrize("size", [(390, 844), (844, 390)])
def test_a_choice(size: tuple[int, int], window: Open) -> None:
    lecture, code = taught(window, "walk=d31&step=d31-03&projector")
    phone, other = joined(window, code, *size), joined(window, code)
    for one, option in ((phone, 1), (other, 0)):
        one.wait_for_function("oscillations.asked.card")
        one.locator(f".answers [data-option='{option}']").click()
    expect(phone.locator(WAITS)).to_contain_text("Sent: Longer: the distance is longer. You can change it until")
    expect(phone.locator(WAITS)).to_contain_text("2 of 2 have answered.")
    for _ in range(2):
        clicked(lecture)
    expect(phone.locator(WAITS)).to_have_text("1 of 2 is right.")
    expect(phone.locator(".answers .vote-count")).to_have_count(3)
    assert phone.locator(".answers .vote-count").all_inner_texts().count("1") == 2
    expect(phone.locator(".answers [data-option='1']")).to_contain_text("your answer")
    expect(phone.locator(".answers [data-option='1'] .line")).not_to_be_empty()
    expect(phone.locator(".card .try")).to_have_count(0)  # there is no slider
    own = phone.get_by_role("link", name="Try it on your own")
    own.click()
    expect(phone.get_by_role("slider").first).to_be_visible()
    expect(phone.get_by_role("link", name="Back to the lecture")).to_be_visible()
