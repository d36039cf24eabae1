"""Measurements of the steps of a walk in a hall, in a real browser: `make walk FILE=my-walk.toml ARGS=--look`.

A step has to be read from the last row: at most one stage and two plots, each with numbers at both axes and as high as
`LEAST` says, as a share of the window.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page, sync_playwright

from components.walks.loading import load_walks
from components.walks.walk import Walk
from tests.browser.fixtures import READY
from tests.browser.looks import LAID, TAUGHT, in_hall
from tests.serving.server import serving
from tools.browsers.chromium import find

SIZES = ((1280, 720), (853, 480))
LEAST = {"a plot beside another": 0.25, "the only plot": 0.35, "the stage": 0.17}
"""The least heights of stages and plots with their axes, as shares of the window's height."""
USED = 0.1
"""The least share of a plot's height that its curves must use, if none is hidden and the axes need not have one
scale."""
MEASURED = """() => {
  const stands = part => part.checkVisibility() && part.getBoundingClientRect().height > 1
  const high = part => part.getBoundingClientRect().height / innerHeight
  const drawn = ({host, svg}) => {
    const boxes = [...svg.children].filter(stands).map(part => part.getBoundingClientRect())
    const [top, bottom] = [Math.min(...boxes.map(box => box.top)), Math.max(...boxes.map(box => box.bottom))]
    return Math.max(high(host), (bottom - top) / innerHeight)
  }
  const {covered, held} = oscillations.shown.state
  const used = ({block, view, y, hidden, host}) => {
    const isPart = host.matches(".sketched") || covered.some(name => name.startsWith(`curve:${block.name}.`))
    const columns = block.curves.filter(({group}) => !hidden.has(group))
      .map(({source, y}) => view.columns[source]?.[y] ?? []).filter(({length}) => length > 1)
    if (isPart || held || block.square || !columns.length) return 1
    const places = columns.flatMap(column => [...column]).filter(Number.isFinite)
      .map(value => (value - y.start) / (y.end - y.start))
    return Math.min(1, Math.max(...places)) - Math.max(0, Math.min(...places))
  }
  const plots = oscillations.page.plots.filter(({host, absent}) => !absent && stands(host))
  return {
    stages: oscillations.page.stages.filter(({host}) => host.matches(".block") && stands(host)).map(drawn),
    plots: plots.map(plot => ({
      name: plot.block.name,
      high: high(plot.host.parentElement),
      used: used(plot),
      across: plot.figure.numbered ? [...plot.abscissae.values()].filter(Boolean).length : 0,
      up: plot.labels.scale.childElementCount,
      plain: plot.block.plain,
    })),
  }
}"""


def look(walk: Walk, path: Path) -> Iterator[str]:
    """Serve a walk, built in or from a file, and yield its faults."""
    with served(walk, path) as (browser, url):
        yield from faults(walk, browser, url)


@contextmanager
def served(walk: Walk, path: Path) -> Iterator[tuple[Browser, str]]:
    """A browser, and the address of a server that has the walk."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        environment = {"ARRIVALS": "1000000", "SESSIONS": "100000"}
        if walk.name not in load_walks(()):
            (Path(folder) / path.name).write_text(path.read_text("utf-8"), "utf-8")
            environment["WALKS"] = folder
        browser = playwright.chromium.launch(executable_path=find())
        with serving(Path(folder) / "log", environment=environment) as server:
            yield browser, server.url


def faults(walk: Walk, browser: Browser, url: str) -> Iterator[str]:
    """Yield a sentence for each fault of each step, asked and answered, of a walk that is served."""
    for width, height in SIZES:
        # Playwright's waiting for an expression is an eval, which the page forbids.
        context = browser.new_context(
            viewport={"width": width, "height": height}, bypass_csp=True, reduced_motion="reduce"
        )
        page = context.new_page()
        page.goto(f"{url}?walk={walk.name}&projector")
        for place, step in enumerate(walk.steps):
            for when in shown(page, place):
                where = f"{walk.name}, step {place + 1} ({step.id}), {when} at {width} x {height}"
                yield from (f"{where}: {fault}" for fault in faults_of(page, height))
        context.close()


def shown(page: Page, place: int) -> Iterator[str]:
    """Show the question of a step, then its answer."""
    page.wait_for_function(f"{READY} && oscillations.walks.walk")
    page.evaluate("place => oscillations.walks.walk.go(place)", place)
    page.wait_for_function(
        f"place => oscillations.walks.walk?.place === place && !oscillations.walks.walk.lesson && {READY} && {LAID}",
        arg=place,
    )
    yield "question"
    if page.evaluate("!oscillations.walks.walk.step.poll"):
        page.evaluate("oscillations.walks.walk.show(true)")
        page.wait_for_function(TAUGHT)
    yield "answer"


def faults_of(page: Page, height: int) -> Iterator[str]:
    """Return a sentence for each fault of the page: of its layout and type, then of what is drawn."""
    yield from (re.sub("^.*? Show: ", "", fault) for fault in in_hall(page, height, ""))
    measured: dict[str, Any] = page.evaluate(MEASURED)
    stages, plots = measured["stages"], measured["plots"]
    if len(stages) > 1 or len(plots) > 2:
        counts = f"{len(stages)} stage{'s' * (len(stages) != 1)} and {len(plots)} plots"
        yield f"{counts} are shown; one stage and two plots are the most."
    for high in stages:
        yield from _low("the stage", "the stage", high, height)
    kind = "the only plot" if len(plots) == 1 else "a plot beside another"
    for plot in plots:
        yield from _low(f"plot {plot['name']}", kind, plot["high"], height)
        if plot["used"] < USED:
            yield f"plot {plot['name']}: its curves use {plot['used']:.0%} of its height, {USED:.0%} are the least."
        if not plot["plain"] and min(plot["across"], plot["up"]) < 2:
            yield f"plot {plot['name']} has {plot['across']} numbers across and {plot['up']} upwards; 2 are the least."


def _low(name: str, kind: str, high: float, height: int) -> Iterator[str]:
    if high < LEAST[kind] - 0.005:
        least = f"{LEAST[kind] * height:.0f} px, {LEAST[kind]:.0%} of the window"
        yield f"{name} is {high * height:.0f} px high; the least for {kind} is {least}."
