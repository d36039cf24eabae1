"""Links beyond the range of doubles open pages that work; lost data is requested again."""

from __future__ import annotations

from collections.abc import Callable
from urllib.parse import parse_qsl

import pytest
from playwright.sync_api import Browser, Page, expect

from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.waiting import QUIET, played, type_in, unfold
from tests.grids import spread
from tests.scenes.checks import EXTREME_LINKS
from tests.serving.server import Server
from tools.attack.stage import faults_of

pytestmark = pytest.mark.browser
Open = Callable[..., Page]

PATIENCE = "oscillations.messages.patience = 1000"
LOSE_A_MESSAGE = """
const {wire} = oscillations.messages, {send} = wire
globalThis.said = []
wire.send = message => { if (said.push(message.number) > 1) send(message) }
"""
LOSE_AN_ANSWER = """
const {messages} = oscillations, {wire} = messages, {send} = wire
globalThis.said = []
wire.send = message => { said.push(message.number); send(message) }
messages.receive = () => { delete messages.receive }
"""
HEAR_TWICE = """
const {messages} = oscillations, {receive, handle} = messages
globalThis.heard = []
messages.receive = function (message) { receive.call(this, message); receive.call(this, message) }
messages.handle = (message, asked) => { heard.push(message.answer); handle(message, asked) }
"""

BREAKABLE = """() => {
  const lecture = oscillations, {page} = lecture
  const parts = page.parts.map((part, i) => [part, "update", `part ${i}`]).filter(([part]) => part.update)
  const stages = page.stages.map((stage, i) => [stage, "frame", `stage ${i}`])
  const plots = page.plots.map((plot, i) => [plot, "draw", `plot ${i}`])
  const others = [[page.live, "draw", "live"], [page.compare, "frame", "compare"], [lecture.undo, "record", "undo"],
    [lecture.hall, "applyStep", "hall"], [lecture.hall, "shown", "hall shown"], [lecture.address, "write", "address"],
    [lecture.walks, "shown", "walks"]]
  globalThis.counts = {}
  const all = [...parts, ...stages, ...plots, ...others]
  for (const [host, method, name] of all) {
    const act = host[method]
    host[method] = function (...given) {
      if (globalThis.broken === `${name}.`) throw Error(`The broken thing is ${name}.`)
      counts[`${name}.`] = 1
      return act.apply(this, given)
    }
  }
  return all.map(([, , name]) => `${name}.`)
}"""
"""Let every object that takes a picture count its calls in `counts`, or fail if it is `broken`; return all names."""


@pytest.mark.parametrize("query", EXTREME_LINKS)
def test_a_link_beyond_doubles_opens_a_page_that_works(page: Page, open_scene: Open, query: str) -> None:
    open_scene(page, **dict(parse_qsl(query)))
    type_in(page, "m2", "3")
    page.wait_for_function("oscillations.shown.settings.m2.value === 3")


@pytest.mark.parametrize("lose", [LOSE_A_MESSAGE, LOSE_AN_ANSWER], ids=["message", "answer"])
def test_lost_messages_are_sent_again(page: Page, open_scene: Open, lose: str) -> None:
    open_scene(page, scene="coupled")
    page.evaluate(f"() => {{ {PATIENCE}; {lose} }}")
    type_in(page, "k2", "7")
    page.wait_for_function("oscillations.shown.settings.k2.value === 7")
    lost, again = page.evaluate("said.slice(0, 2)")
    assert again == lost, "the server applies a number once"


def test_a_late_answer_is_ignored(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    page.evaluate(f"() => {{ {HEAR_TWICE} }}")
    for value in (7, 8):
        type_in(page, "k2", str(value))
        page.wait_for_function(f"oscillations.shown.settings.k2.value === {value}")
    page.wait_for_function(QUIET)
    heard = page.evaluate("heard")
    assert len(heard) == len(set(heard)) >= 2
    expect(page.locator(".notice")).to_be_hidden()


@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_extreme_pictures_are_drawn_with_numbers(page: Page, open_scene: Open, slug: str) -> None:
    open_scene(page, scene=slug)
    assert list(faults_of(page, SCENES[slug], size=12, start=1)) == []


def test_a_phase_beyond_doubles_is_drawn_somewhere(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="oscillator", window=1.7976931348623157e308, k=78.77)
    page.evaluate("oscillations.page.clock.seek(oscillations.page.clock.end)")
    assert page.evaluate("() => { const {page} = oscillations; page.draw(page.clock.t); return page.clock.t > 100 }")


def test_a_picture_that_fails_does_not_keep_the_next_from_being_shown(browser: Browser, server: Server) -> None:
    page = browser.new_page(bypass_csp=True)
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(READY)
    unfold(page)
    page.evaluate("() => { const {page} = oscillations; page.apply = () => { delete page.apply; throw Error('!') } }")
    type_in(page, "k2", "7")
    page.wait_for_function("!Object.hasOwn(oscillations.page, 'apply')")
    type_in(page, "k2", "8")
    page.wait_for_function("oscillations.shown.settings.k2.value === 8")
    assert page.evaluate("oscillations.messages.lostConnections") == 0
    page.close()


@pytest.mark.parametrize("slug", ["coupled", "accuracy"])
def test_an_exception_in_one_part_stops_no_other_and_is_reported_once(
    slug: str, browser: Browser, server: Server
) -> None:
    """Without the fixture of pages, which would fail on a logged error."""
    page = browser.new_page(bypass_csp=True)
    logged: list[str] = []
    page.on("console", lambda message: logged.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: logged.append(f"not caught: {error}"))
    page.goto(f"{server.url}?scene={slug}")
    page.wait_for_function(READY)
    page.wait_for_function("oscillations.page.print && oscillations.page.voice")  # the last parts to come
    names = page.evaluate(BREAKABLE)
    for i, name in enumerate(names):
        page.evaluate("name => Object.assign(globalThis, {broken: name, counts: {}})", name)
        page.evaluate("k1 => oscillations.send({type: 'set', values: {k1}})", 2 + i / 100)
        page.wait_for_function(QUIET)
        played(page, 2)
        counts = page.evaluate("counts")
        assert [other for other in names if other != name and not counts.get(other)] == [], name
        assert any(name in line for line in logged) and not any("not caught" in line for line in logged), name
    assert page.evaluate("[oscillations.messages.lostConnections, document.documentElement.dataset.connected]") == [
        0,
        "true",
    ]
    assert page.evaluate("oscillations.shown.settings.k1.value") == pytest.approx(2 + (len(names) - 1) / 100)
    expect(page.locator(".remark")).to_have_count(1)
    expect(page.locator(".remark")).to_contain_text(names[0])
    page.close()


def test_an_exception_of_a_button_is_reported(browser: Browser, server: Server) -> None:
    page = browser.new_page(bypass_csp=True)
    page.goto(f"{server.url}?scene=coupled")
    page.wait_for_function(READY)
    page.evaluate("() => { oscillations.page.compare.toggle = () => { throw Error('Hold is broken') } }")
    page.get_by_role("button", name="Hold").click()
    expect(page.locator(".remark")).to_contain_text("Hold is broken")
    page.close()
