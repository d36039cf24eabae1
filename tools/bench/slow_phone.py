"""The frame rate of each scene on a slow phone: the first view at 390 x 844, with the processor slowed six times.

`make load` runs it; it prints a table and keeps it as build/load/slow_phone.md. Work is CPU time of the page's
main thread without slowing, so the load of the machine has little effect on it.
"""

from __future__ import annotations

from statistics import median

from playwright.sync_api import Browser, CDPSession, Page

from tests.serving.server import Server, serving
from tools.bench.load import READY
from tools.bench.scene_table import report

PHONE = {"width": 390, "height": 844}
SLOWED = 6
SECONDS = 3.0
COUNT = """() => {
  globalThis.counted = 0
  const count = () => { counted++; requestAnimationFrame(count) }
  requestAnimationFrame(count)
}"""
FOLLOWED = """grip => new Promise(done => {
  const {left, top, width, height} = grip.getBoundingClientRect()
  const [x, y] = [left + width / 2, top + height / 2], place = () => grip.getBoundingClientRect()
  const say = (type, by) => grip.dispatchEvent(new PointerEvent(type, {bubbles: true, cancelable: true, pointerId: 1,
    isPrimary: true, button: 0, buttons: 1, clientX: x + by, clientY: y + by}))
  say("pointerdown", 0)
  let by = 0, frames = []
  const next = () => {
    const before = place(), start = counted
    say("pointermove", by += 3)
    const look = () => {
      const now = place()
      if (now.left === before.left && now.top === before.top && counted < start + 60) return requestAnimationFrame(look)
      frames.push(counted - start)
      if (frames.length < 10) return next()
      say("pointerup", by)
      done(frames)
    }
    requestAnimationFrame(look)
  }
  next()
})"""
"""Drag a shape of the stage in ten moves: the number of frames after which it has followed each."""


def work(session: CDPSession, page: Page) -> float:
    """CPU time in ms of the main thread, per frame."""

    def taken() -> tuple[float, int]:
        metrics = session.send("Performance.getMetrics")["metrics"]
        return next(one["value"] for one in metrics if one["name"] == "TaskDuration"), page.evaluate("counted")

    before, first = taken()
    page.wait_for_timeout(1000 * SECONDS)
    after, last = taken()
    return 1000 * (after - before) / max(last - first, 1)


def line(browser: Browser, server: Server, slug: str) -> str:
    """A row of the table: work per frame, frames a second when slowed, frames until a drag is followed."""
    context = browser.new_context(
        viewport=PHONE, has_touch=True, is_mobile=True, device_scale_factor=2, bypass_csp=True
    )
    page = context.new_page()
    session = context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})
    page.goto(f"{server.url}?scene={slug}")
    page.wait_for_function(READY)
    page.evaluate(COUNT)
    page.wait_for_timeout(1000)
    each = work(session, page)
    session.send("Emulation.setCPUThrottlingRate", {"rate": SLOWED})
    first = page.evaluate("[counted, performance.now()]")
    page.wait_for_timeout(1000 * SECONDS)
    last = page.evaluate("[counted, performance.now()]")
    rate = 1000 * (last[0] - first[0]) / (last[1] - first[1])
    grip = page.query_selector(".grip")
    followed = f"{median(grip.evaluate(FOLLOWED)):.0f}" if grip and grip.is_visible() else ""
    context.close()
    return f"| {slug} | {each:.1f} ms | {rate:.0f} | {followed} |"


def main() -> None:
    columns = ("work per frame", "frames a second, slowed", "a drag is followed after frames")
    report("slow_phone", str(__doc__), columns, line, serving)


if __name__ == "__main__":
    main()
