"""Browser tabs that tests use one after the other: a page in a used tab loads in half the time."""

from __future__ import annotations

from typing import Any, NoReturn

import pytest
from playwright.sync_api import Browser, BrowserContext, ConsoleMessage

LASTING = ("add_init_script", "expose_function", "expose_binding")
"""Methods of a page with a lasting effect. A tab that tests share refuses them."""
EMPTY = '<!DOCTYPE html><link rel="icon" href="data:,">'
CALMER = """{
  const real = requestAnimationFrame
  const waiting = new Map()
  let last = 0, count = 0
  const pump = now => {
    if (++count % 3) return real(pump)
    const due = [...waiting.values()]
    waiting.clear()
    for (const act of due) try { act(now) } catch (fault) { reportError(fault) }
  }
  globalThis.requestAnimationFrame = act => {
    if (!waiting.size) real(pump)
    waiting.set(++last, act)
    return last
  }
  globalThis.cancelAnimationFrame = id => waiting.delete(id)
}"""
"""Draw only every third frame: without a graphics card a playing picture takes more than one core."""
FORGET = "() => { localStorage.clear(); sessionStorage.clear() }"


def calm_context(browser: Browser, size: dict[str, int], **options: Any) -> BrowserContext:
    """A visitor whose pages draw less often."""
    context = browser.new_context(viewport=size, **options)
    context.add_init_script(CALMER)
    return context


class Tab:
    """A page in its own context: one visitor."""

    def __init__(self, browser: Browser, size: dict[str, int], options: dict[str, Any]) -> None:
        self.context = calm_context(browser, size, **options)
        self.page = self.context.new_page()
        self.faults: list[str] = []
        self.page.on("console", lambda message: self.faults.extend(_console_fault(message)))
        self.page.on("pageerror", lambda error: self.faults.append(f"page error: {error}"))

    def close(self) -> None:
        self.context.close()


class Tabs:
    """Free tabs, by the options of their contexts."""

    def __init__(self, browser: Browser) -> None:
        self.browser = browser
        self.free: dict[str, list[Tab]] = {}

    def take(self, size: dict[str, int], options: dict[str, Any]) -> Tab:
        free = self.free.setdefault(str(sorted(options.items())), [])
        if not free:
            tab = Tab(self.browser, size, options)
            for name in LASTING:
                setattr(tab.page, name, _refused)
            return tab
        tab = free.pop()
        tab.page.set_viewport_size(size)
        return tab

    def give_back(self, tab: Tab, options: dict[str, Any], home: str) -> None:
        """Remove everything of the last test except the browser's cache."""
        if tab.page.is_closed() or len(tab.context.pages) > 1:
            return tab.close()
        tab.page.unroute_all()
        asked = {name: options.get(name, "null") for name in ("reduced_motion", "color_scheme")}
        tab.page.emulate_media(media="null", **asked)
        tab.context.set_offline(False)
        tab.page.route(home, lambda route: route.fulfill(body=EMPTY, content_type="text/html"))
        tab.page.goto(home)
        tab.page.evaluate(FORGET)
        tab.page.unroute(home)
        tab.faults.clear()
        self.free[str(sorted(options.items()))].append(tab)


def _refused(*_: Any, **__: Any) -> NoReturn:
    pytest.fail("What is asked for here would last in a tab that other tests use: take new_page(fresh=True).")


def _console_fault(message: ConsoleMessage) -> list[str]:
    return [f"console: {message.text} {message.location}"] if message.type == "error" else []
