"""The opening of a page on a slow network, in a Chromium that is slowed down to it."""

from __future__ import annotations

from playwright.sync_api import Browser, Page

RATE = 1.6e6 / 8  # bytes a second
LATENCY = 150  # ms for each request

WATCH = """globalThis.seen = {}
const look = () => {
  const {page} = globalThis.oscillations ?? {}
  if (!seen.moving && page?.clock.frames > 1 && document.querySelector(".stage *")) seen.moving = performance.now()
  if (!seen.whole && document.documentElement.dataset.ready === "true") seen.whole = performance.now()
  if (!seen.whole) requestAnimationFrame(look)
}
requestAnimationFrame(look)"""
SEEN = "() => ({...seen, paint: performance.getEntriesByName('first-contentful-paint')[0].startTime})"

TURN = """slug => new Promise(done => {
  const start = performance.now(), turned = {}
  const look = () => {
    const {page} = oscillations, since = performance.now() - start
    const isThere = page.spec.slug === slug && page.clock.frames > 1
    if (isThere) turned.stands ??= since
    if (isThere && document.documentElement.dataset.ready === "true") done({...turned, whole: since})
    else requestAnimationFrame(look)
  }
  document.querySelector(`.nav nav a[data-scene=${slug}]`).click()
  requestAnimationFrame(look)
})"""
READY = "document.documentElement.dataset.ready === 'true'"


def slow_page(browser: Browser) -> Page:
    """A page with an empty cache on the slow network."""
    page = browser.new_page(viewport={"width": 1280, "height": 720}, bypass_csp=True)  # for wait_for_function
    network = page.context.new_cdp_session(page)
    conditions = {"latency": LATENCY, "downloadThroughput": RATE, "uploadThroughput": RATE, "offline": False}
    network.send("Network.enable")
    network.send("Network.emulateNetworkConditions", conditions)
    return page


def start_slowly(browser: Browser, address: str) -> tuple[float, float]:
    """The start page: milliseconds until it has been loaded, and kB as they are served."""
    page = slow_page(browser)
    sizes: list[int] = []
    page.on("requestfinished", lambda request: sizes.append(request.sizes()["responseBodySize"]))
    page.goto(address)
    loaded: float = page.evaluate("performance.getEntriesByType('navigation')[0].loadEventStart")
    page.close()
    return loaded, sum(sizes) / 1000


def opened_slowly(browser: Browser, address: str, other: str) -> dict[str, float]:
    """Return ms until a page with an empty cache paints, moves and is complete, then until another scene is drawn."""
    page = slow_page(browser)
    page.add_init_script(WATCH)
    page.goto(address, wait_until="commit")
    page.wait_for_function(READY)
    seen: dict[str, float] = page.evaluate(SEEN)
    seen["next"] = page.evaluate(TURN, other)["stands"]
    page.close()
    return seen


def turned(page: Page, slugs: list[str]) -> list[dict[str, float]]:
    """Return ms from a click in the navigation until stage, controls and numbers are drawn, and until everything is."""
    page.evaluate(TURN, slugs[-1])
    return [page.evaluate(TURN, slug) for slug in slugs]
