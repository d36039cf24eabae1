"""Ways to lose the connection to the server. After reconnecting, every value that was set last is shown."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from random import Random

from bokeh.util.token import generate_jwt_token, generate_session_id
from playwright.sync_api import Page, expect

from components.quantities.formatting import tidy
from components.scenes import SCENES
from tests.browser.fixtures import READY
from tests.browser.waiting import unfold
from tools.reconnect.site import SECRET, GatedSite

LINK = "?scene=coupled&hidden=x1_slow&cover=plot:x2"
NUMBERS = ("omega_minus", "omega_plus")
"""Live numbers of the picture that depend on the values set below."""
FIRST_WITH_EXPIRED = """globalThis.WebSocket = class extends WebSocket {
  constructor(address, [name, token]) {
    super(address, [name, globalThis.expired ?? token])
    delete globalThis.expired
  }
}"""
CONNECTED = "document.documentElement.dataset.connected === '{}'"
SETTLED = "oscillations.messages.wire && !oscillations.messages.behind && !oscillations.messages.left.length"


@dataclass
class LostVisit:
    """A page, and the values that were set last."""

    page: Page
    site: GatedSite
    random: Random
    seconds: float = 0.0
    """Seconds for which the connection stays lost."""
    values: dict[str, float] = field(default_factory=dict)

    def change(self) -> None:
        """Set some values, one of them twice, by sliders and by typing."""
        for name in ("m1", "k2"):
            slider = self.page.locator(f"input[name={name}-slider]")
            for _ in range(2):
                slider.fill(str(self.random.random()))
            self.values[name] = float(self.page.locator(f"input[name={name}]").input_value())
        self.values["k1"] = round(self.random.uniform(1, 9), 3)
        field = self.page.locator("input[name=k1]")
        field.fill(str(self.values["k1"]))
        field.press("Enter")
        field.blur()

    def is_connected(self, now: bool) -> None:
        self.page.wait_for_function(CONNECTED.format("true" if now else "false"), timeout=90_000)

    def check(self) -> None:
        """Check that state, control and picture show every value, and that hidden items are still hidden."""
        self.is_connected(True)
        self.page.wait_for_function(SETTLED, timeout=90_000)
        state = self.page.evaluate("oscillations.messages.state")
        assert {name: state["parameters"].get(name) for name in self.values} == self.values
        assert (state["hidden"], state["covered"]) == (["x1_slow"], ["plot:x2"])
        for name, value in self.values.items():
            expect(self.page.locator(f"input[name={name}]")).to_have_value(tidy(value))
            shown = self.page.locator(f"input[name={name}-slider]")
            expect(shown).to_have_attribute("aria-valuetext", re.compile(f"^{re.escape(tidy(value))} "))
        wanted = SCENES["coupled"](**self.values).shown.values
        for name in NUMBERS:
            expect(self.page.locator(f"[data-value={name}]").first).to_have_text(wanted[name])
        expect(self.page.locator(".control.waits")).to_have_count(0)
        expect(self.page.get_by_text("Covered. What do you expect?")).to_be_visible()

    def rest(self) -> None:
        self.page.wait_for_timeout(1000 * self.seconds)


def killed(visit: LostVisit) -> None:
    """Kill the server and start it again."""
    visit.site.kill()
    visit.is_connected(False)
    visit.change()
    visit.site.start()


def offline(visit: LostVisit) -> None:
    """Take the browser offline for some time."""
    visit.page.context.set_offline(True)
    visit.is_connected(False)
    visit.change()
    visit.rest()
    visit.page.context.set_offline(False)


def silent(visit: LostVisit) -> None:
    """Let nothing through any more, without an error on the socket."""
    visit.page.evaluate("oscillations.messages.patience = 300")
    visit.site.gate.held = True
    visit.change()
    visit.is_connected(False)
    visit.rest()
    visit.site.gate.cut()
    visit.site.gate.held = False


def suspended(visit: LostVisit) -> None:
    """Suspend the tab and replace the server meanwhile."""
    browser = visit.page.context.new_cdp_session(visit.page)
    browser.send("Page.setWebLifecycleState", {"state": "frozen"})
    visit.site.kill()
    visit.site.start()
    visit.rest()
    browser.send("Page.setWebLifecycleState", {"state": "active"})
    visit.change()


def dropped(visit: LostVisit) -> None:
    """Drop the session while the server continues to run."""
    visit.site.gate.cut()
    visit.change()


def worker(visit: LostVisit) -> None:
    """Kill one of two replicas."""
    visit.site.start()
    visit.site.kill()
    visit.change()


LOSSES: Mapping[str, Callable[[LostVisit], None]] = {
    "server killed and restarted": killed,
    "offline": offline,
    "silence": silent,
    "tab suspended": suspended,
    "session dropped": dropped,
    "worker killed": worker,
}


def visit(page: Page, site: GatedSite, loss: Callable[[LostVisit], None], seed: int, seconds: float = 0.0) -> None:
    """Set values before, during and after a lost connection."""
    found = LostVisit(page, site, Random(seed), seconds)
    page.goto(site.url + LINK)
    page.wait_for_function(READY)
    unfold(page)
    found.is_connected(True)
    found.change()
    loss(found)
    found.check()
    found.change()
    found.check()


def too_late(page: Page, site: GatedSite, seed: int) -> None:
    """Let the page's token expire before its socket opens."""
    session = generate_session_id(SECRET.encode(), signed=True)
    expired = generate_jwt_token(session, SECRET.encode(), signed=True, expiration=-1)
    page.add_init_script(f"globalThis.expired = {expired!r}\n{FIRST_WITH_EXPIRED}")
    found = LostVisit(page, site, Random(seed))
    page.goto(site.url + LINK)
    page.wait_for_function(READY)
    unfold(page)
    found.change()
    found.check()
