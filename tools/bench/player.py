"""The frame rate of the Panel face: the Player of each scene in a page of `panel serve app.py`, with one visitor.

`python -m tools.bench.player` prints a table and keeps it as build/load/player.md. A frame counts when the browser has
received and drawn a change. The Player asks for 20 frames a second.
"""

from __future__ import annotations

import psutil
from playwright.sync_api import Browser

from tests.serving.server import Server, serving_panel
from tools.bench.scene_table import report

SECONDS = 10.0
WARM = 1.0
PATIENCE = 120_000
COUNT = """() => {
  globalThis.drawn = 0
  let isDirty = false
  Bokeh.documents[0].on_change(({model}) => { isDirty ||= Boolean(model) && !/Player/.test(model.type) })
  const look = () => {
    if (isDirty) drawn++
    isDirty = false
    requestAnimationFrame(look)
  }
  requestAnimationFrame(look)
}"""
"""Count the animation frames before which the server has changed something other than the Player."""


def line(browser: Browser, server: Server, slug: str) -> str:
    """A row of the table: frames a second, and for one frame the CPU of server and browser and the bytes received."""
    process, here = psutil.Process(server.process.pid), psutil.Process()  # the browser is a child of this process
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    received = [0]
    page.on("websocket", lambda wire: wire.on("framereceived", lambda data: received.append(len(data))))
    page.goto(f"http://localhost:{server.port}/app?scene={slug}", timeout=PATIENCE)
    page.locator("button.play").click(timeout=PATIENCE)
    page.evaluate(COUNT)
    page.wait_for_timeout(1000 * WARM)

    def state() -> tuple[int, float, float, float, int]:
        cpu, of_all = used(process), sum(map(used, here.children(recursive=True)))
        drawn, now = page.evaluate("[drawn, performance.now()]")
        return drawn, now / 1000, cpu, of_all - cpu, sum(received)

    first = state()
    page.wait_for_timeout(1000 * SECONDS)
    frames, seconds, cpu, drawing, sent = (late - early for early, late in zip(first, state(), strict=True))
    page.close()
    each = max(frames, 1)
    costs = f"{1000 * cpu / each:.0f} ms | {1000 * drawing / each:.0f} ms | {sent / each / 1000:.1f} kB"
    return f"| {slug} | {frames / seconds:.1f} | {costs} |"


def used(process: psutil.Process) -> float:
    """CPU time that a process has used, in seconds."""
    times = process.cpu_times()
    return float(times.user + times.system)


def main() -> None:
    columns = ("frames a second", "CPU of the server per frame", "of the browser", "bytes per frame")
    report("player", str(__doc__), columns, line, serving_panel)


if __name__ == "__main__":
    main()
