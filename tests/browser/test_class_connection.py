"""A phone that follows a class over a real connection: slow, asleep, behind a buffering proxy; after a reload."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.between import between
from tests.browser.classroom import LED, draw, joined, taught
from tests.browser.fixtures import READY, another_version
from tests.browser.tabs import calm_context
from tests.browser.waiting import passed
from tests.live_class.caller import call
from tests.serving.server import Server

pytestmark = pytest.mark.browser

ERROR = "() => [Math.abs(oscillations.timing.now - Date.now()), oscillations.timing.bound]"
"""The server's clock is that of this machine, as is the browser's; it is sent in whole ms."""
SHOWN = "document.querySelector('.class-bar .within').textContent"
Phone = Callable[[str, str], Page]


class Room:
    """A class that is led by plain requests."""

    def __init__(self, url: str) -> None:
        self.url = url
        self.opened = call(url, "/class", "POST").json
        self.code = self.opened["code"]

    def order(self, type: str, **order: object) -> None:
        path = f"/class/{self.code}/lead"
        assert call(self.url, path, "POST", {"type": type, **order}, self.opened["key"]).status == 204


@pytest.fixture
def phone(browser: Browser) -> Iterator[Phone]:
    """A phone's page at its own address."""
    contexts = []

    def go(url: str, code: str) -> Page:
        context = calm_context(browser, {"width": 390, "height": 844}, bypass_csp=True)
        contexts.append(context)
        page = context.new_page()
        page.goto(f"{url}?class={code}")
        return page

    yield go
    for context in contexts:
        context.close()


def jitter(middle: float, spread: float) -> Callable[[], float]:
    """Seconds, evenly spread, the same in every run."""
    drawn = random.Random(17)
    return lambda: drawn.uniform(middle - spread, middle + spread)


@pytest.mark.slow
@pytest.mark.parametrize(("delay", "most"), [(lambda: 0.0, 33), (jitter(0.1, 0.08), 100)], ids=["loopback", "slow"])
def test_the_bound_of_the_clock_holds_its_error(
    server: Server, phone: Phone, delay: Callable[[], float], most: float
) -> None:
    room = Room(server.url)
    with between(server.port, delay) as proxy:
        page = phone(proxy.url, room.code)
        page.wait_for_function("globalThis.oscillations?.timing")
        page.evaluate("oscillations.timing.measured")
        for _ in range(5):
            error, bound = page.evaluate(ERROR)
            assert error <= bound + 1
            assert bound <= most
            page.evaluate("oscillations.timing.measure()")
        told = page.evaluate(SHOWN)
        assert told.startswith("clock within ") and int(told.split()[2]) <= most
        page.close()


COUNT = "sessionStorage.setItem('loads', 1 + Number(sessionStorage.getItem('loads')))"
LOADS = "sessionStorage.getItem('loads')"
VERSION = "document.documentElement.dataset.version[0]"
HEARD = "globalThis.oscillations?.news?.number"


def test_a_phone_of_another_version_loads_the_page_anew_and_not_again_at_once(server: Server, phone: Phone) -> None:
    page = phone(server.url, Room(server.url).code)
    page.wait_for_function(HEARD)
    page.add_init_script(COUNT)
    page.route(f"{server.url}?*", another_version)
    page.reload(wait_until="commit")  # the page reloads, perhaps before all of this one is loaded
    page.wait_for_function(f"{LOADS} === '2' && {HEARD}")
    passed(page)  # it would have happened by now
    assert page.evaluate(f"[{LOADS}, {VERSION}]") == ["2", "x"]
    page.unroute(f"{server.url}?*", another_version)
    page.reload(wait_until="commit")
    page.wait_for_function(f"{LOADS} === '3' && {HEARD}")
    page.evaluate("sessionStorage.removeItem('class-renewed')")
    with page.expect_response(re.compile("/events")):  # a stream of the same version again
        page.evaluate("oscillations.stream.control.abort()")
    passed(page)  # it would have happened by now
    assert page.evaluate(LOADS) == "3"
    assert page.evaluate(VERSION) != "x"


@pytest.mark.slow
def test_a_proxy_that_holds_streams_back_is_asked_instead(server: Server, phone: Phone) -> None:
    room = Room(server.url)
    with between(server.port, holds=True) as proxy:
        page = phone(proxy.url, room.code)
        page.wait_for_function("globalThis.oscillations?.news?.number")
        assert page.evaluate("oscillations.stream.by === 'now'")
        room.order("put", walk="d31", step="d31-03")
        page.wait_for_function("oscillations.news.question?.step === 'd31-03'")
        expect(page.locator(".class-bar")).to_contain_text("Following")
        room.order("end")
        expect(page.get_by_role("heading", name="The class is over.")).to_be_visible()


def test_a_proxy_that_lets_streams_through_again_is_noticed(server: Server, phone: Phone) -> None:
    room = Room(server.url)
    page = phone(server.url, room.code)
    page.wait_for_function("globalThis.oscillations?.news?.number")
    page.evaluate("Object.assign(oscillations.stream, {polls: true, trial: 0}); dispatchEvent(new Event('online'))")
    page.wait_for_function("oscillations.stream.by === 'events' && oscillations.stream.heardAt > 0")
    room.order("put", walk="d31", step="d31-03")
    page.wait_for_function("oscillations.news.question?.step === 'd31-03'")


HIDDEN = """hidden => {
  Object.defineProperty(document, "hidden", {value: hidden, configurable: true})
  document.dispatchEvent(new Event("visibilitychange"))
}"""
"""A headless browser's page is always visible."""


def test_a_phone_that_wakes_has_what_was_shown_meanwhile(
    server: Server, phone: Phone, window: Callable[[str, int, int], Page]
) -> None:
    lecture, code = taught(window, "scene=coupled")
    with between(server.port) as proxy:
        page = phone(proxy.url, code)
        page.wait_for_function(f"{READY} && Boolean(oscillations.clock.lead)")
        lecture.wait_for_function(f"{LED}.news.here === 1")
        page.evaluate(HIDDEN, True)
        lecture.wait_for_function(f"{LED}.news.here === 0")  # a phone in a pocket is not counted
        proxy.silence()  # its open streams are dead when it wakes
        lecture.evaluate("oscillations.open({scene: 'forced'})")
        lecture.wait_for_function("oscillations.page.spec.slug === 'forced'")
        assert page.evaluate("oscillations.page.spec.slug") == "coupled"
        page.evaluate(HIDDEN, False)
        page.wait_for_function("oscillations.page.spec.slug === 'forced'", timeout=5000)
        expect(page.locator(".class-bar")).to_contain_text("Following")
        page.close()


RESENT = "oscillations.asked.given && oscillations.asked.delivery.isTaken(oscillations.asked.name)"
"""True if the server has the answer that the phone kept and sends again after a while."""


def test_a_phone_that_is_loaded_anew_has_its_answers(window: Callable[[str, int, int], Page]) -> None:
    lecture, code = taught(window, "walk=d34&step=d34-14")
    page = joined(window, code)
    draw(page, lambda x: 0.2 + 0.6 * x)
    expect(page.get_by_text("You can change it")).to_be_visible()
    drawn = page.evaluate("oscillations.asked.card.question.pad.sent")
    page.reload()
    page.wait_for_function(f"{READY} && oscillations.asked?.card && oscillations.asked.given")
    again = page.evaluate("oscillations.asked.card.question.pad.sent")
    assert again == drawn and len(again["Xp1"]) == 101
    expect(page.get_by_text("You can change it")).to_be_visible()
    page.wait_for_function(RESENT)  # otherwise it meets the next question, and is refused
    lecture.evaluate("oscillations.walks.walk.go(7)")  # d34-08, a point
    page.wait_for_function("oscillations.asked?.card?.question.marker")
    page.locator(".pill-mark").press("ArrowRight")
    expect(page.get_by_text("You can change it")).to_be_visible()
    marked = page.evaluate("oscillations.asked.card.question.marker.value")
    page.reload()
    page.wait_for_function("globalThis.oscillations?.asked?.card?.question.marker")
    assert page.evaluate("oscillations.asked.card.question.marker.value") == marked
    page.wait_for_function(RESENT)
    assert page.evaluate("Object.keys(localStorage).filter(key => key.startsWith('class-')).length") == 1
    lecture.evaluate("oscillations.classes.led.end()")
    expect(page.get_by_role("heading", name="The class is over.")).to_be_visible()
    assert page.evaluate("Object.keys(localStorage).filter(key => key.startsWith('class-')).length") == 0
