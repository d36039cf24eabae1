"""A class in Chromium next to its raw clients: two phones that record what they show and when, and an instructor."""

from __future__ import annotations

import time
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from typing import Any

from playwright.async_api import Browser, Page, async_playwright

from tests.live_class.caller import Class
from tools.bench.between import between
from tools.bench.network import READY
from tools.browsers.chromium import find

COUNT = 2
PHONE = {"width": 390, "height": 844}
HALL = {"width": 1920, "height": 1080}
RECORD = """() => {
  globalThis.seen = {values: [], clocks: []}
  document.addEventListener("oscillations:painted",
    () => seen.values.push([Date.now(), oscillations.shown.settings.k2?.value]))
  let at = oscillations.news.clock?.at
  const look = () => {
    requestAnimationFrame(look)
    const {clock} = oscillations.news
    if (clock && clock.at !== at) seen.clocks.push([Date.now(), clock.t])
    at = clock?.at
  }
  look()
}"""
WAKE = """() => new Promise(woken => {
  const begun = Date.now(), {number} = oscillations.news
  const look = () => oscillations.news.number === number || oscillations.bar.away
    ? setTimeout(look, 5) : requestAnimationFrame(() => woken(Date.now() - begun))
  Object.defineProperty(document, "hidden", {value: false, configurable: true})
  document.dispatchEvent(new Event("visibilitychange"))
  look()
})"""
SLEEP = 'Object.defineProperty(document, "hidden", {value: true, configurable: true})'
SKETCHED = """count => new Promise(seen => {
  const look = () => {
    const shown = document.querySelector("canvas.class-sketches")?.getAttribute("aria-label")
    if (shown?.startsWith(`${count} `)) requestAnimationFrame(() => requestAnimationFrame(() => seen(Date.now())))
    else requestAnimationFrame(look)
  }
  look()
})"""


@asynccontextmanager
async def chromium() -> AsyncIterator[Browser | None]:
    """Yield Chromium, or None if it is not installed."""
    path = find()
    if path is None:
        print("No Chromium: what is seen on screens is left out.")
        yield None
        return
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=path)
        yield browser
        await browser.close()


async def follow(browser: Browser, url: str, code: str, until: str = READY) -> Page:
    page = await (await browser.new_context(viewport=PHONE, bypass_csp=True)).new_page()  # type: ignore[arg-type]
    await page.goto(f"{url}?class={code}")
    await page.wait_for_function(until)
    return page


class Phones:
    """Phones that look on."""

    def __init__(self, pages: list[Page]) -> None:
        self._pages = pages

    @classmethod
    async def join(cls, browser: Browser | None, room: Class) -> Phones:
        pages = [await follow(browser, room.url, room.code) for _ in range(COUNT)] if browser else []
        for page in pages:
            await page.evaluate(RECORD)
        return cls(pages)

    async def waits(self, sent: Mapping[float, float], kind: str) -> list[float]:
        """Return the seconds from each sent item, by kind and time, until it was visible."""
        seen: list[list[float]] = [one for page in self._pages for one in await page.evaluate(f"seen.{kind}")]
        return [at / 1000 - sent[value] for at, value in seen if value in sent]

    async def leave(self) -> None:
        for page in self._pages:
            await page.context.close()


async def woken(browser: Browser, room: Class, port: int, times: int) -> list[float]:
    """Return the seconds until a phone that slept, and lost its connections, shows the current state."""
    waits = []
    with between(port) as proxy:
        visitor = Class(proxy.url, room.opened)
        page = await follow(browser, visitor.url, room.code, "globalThis.oscillations?.news?.number")
        for turn in range(times):
            await page.evaluate(SLEEP)
            proxy.silence()
            await room.order("clock", t=float(turn), rate=0.0, end=20.0, at=1000 * time.time())
            await page.wait_for_timeout(1500)
            waits.append(await page.evaluate(WAKE) / 1000)
        await page.context.close()
    return waits


@asynccontextmanager
async def taught(browser: Browser, url: str, walk: str, step: str) -> AsyncIterator[tuple[Page, Class]]:
    """An instructor's page that asks a step of a walk, and the votes are looked at."""
    page = await (await browser.new_context(viewport=HALL, bypass_csp=True)).new_page()  # type: ignore[arg-type]
    await page.goto(f"{url}?walk={walk}&step={step}&projector")
    await page.wait_for_function(f"{READY} && document.querySelector('.card')")
    await page.keyboard.press("t")
    await page.wait_for_function("oscillations.classes.led?.votes.card")
    opened: dict[str, Any] = await page.evaluate("oscillations.classes.led.room")
    await page.wait_for_function("oscillations.classes.led.votes.tally")
    await page.keyboard.press("PageDown")
    yield page, Class(url, opened)
    await page.context.close()
