"""The steps of all walks can be read, asked and answered: in a hall from the last row, and on a phone. `make walk
ARGS=--look` reports the same for a walk from a file.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from components.walks.loading import load_walks, read_walk, steps_of
from tests.browser.waiting import passed, seek
from tests.grids import sample
from tests.serving.server import ROOT, Server, serving
from tools.look import faults, faults_of, shown

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(600)]
HALL, PHONE = (853, 480), (390, 844)
CROWDED = {
    "d32-33-01": ("period τd", "peak x1", "x2"),
    "d32-33-02": ("x2",),
    "d32-33-03": ("peak x1", "x2"),
    "d34-02": ("ω− 1.00", "fast mode −1.00", "slow mode +2.00"),
    "d34-09": ("same start",),
    "d34-16": ("25.5", "0.00"),
    "d34-17": ("√(k2/m2)",),
    "tour-02": ("dashed: small swings",),
    "tour-05": ("25.5", "0.00"),
}
"""Texts by step that have no place on a phone that is clear of all curves. Their halo keeps them readable."""
CROWDED_IN_HALL = {"d31-07": ("same start",)}
"""The same in the hall, where the time is below it."""
TOUCHED = r"""() => {
  const isSeen = part => part.checkVisibility({opacityProperty: true, visibilityProperty: true}) &&
    part.getBoundingClientRect().width > 1
  const AIR = 0.25 // of the height of a line, above and below its letters
  const lettersOf = part => {
    const {left, right, top, bottom, height} = part.getBoundingClientRect()
    return {left: left + 1, right: right - 1, top: top + AIR * height, bottom: bottom - AIR * height}
  }
  const named = part => part.textContent.trim().replace(/\s+/g, " ")
  const plots = oscillations.page.plots.filter(({host, absent, box}) => !absent && box && isSeen(host))
  const linesOf = plot => {
    const {left, top} = plot.host.getBoundingClientRect(), {frame} = plot, scale = plot.over.getScreenCTM().a
    const at = (x, y) => [left + scale * plot.px(x), top + scale * plot.py(y)]
    const within = ([x, y]) => x >= left + scale * frame.left && x <= left + scale * (frame.left + frame.width) &&
      y >= top + scale * frame.top && y <= top + scale * (frame.top + frame.height)
    return plot.block.curves.flatMap(curve => {
      const {[curve.x]: xs, [curve.y]: ys} = plot.view.columns[curve.source] ?? {}
      if (!ys?.length || plot.hidden.has(curve.group) || curve.width === "none") return []
      const points = []
      for (let i = 0; i < ys.length; i++) {
        const end = at(xs[i], ys[i]), start = i ? at(xs[i - 1], ys[i - 1]) : end
        const count = Math.min(Math.ceil(Math.hypot(end[0] - start[0], end[1] - start[1]) / 2), 200) || 1
        for (let n = 1; n <= count; n++) {
          const share = n / count
          const point = [start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])]
          if (within(point)) points.push(point)
        }
      }
      return [{name: `${plot.block.name}.${curve.y}`, points}]
    })
  }
  const lines = plots.flatMap(linesOf)
  const faults = []
  const texts = [...document.querySelectorAll(".plot-area :is(.over text, .flag, .stage text), .block.stage text")]
  for (const text of texts.filter(isSeen)) {
    if (!named(text)) continue
    const box = lettersOf(text)
    for (const {name, points} of lines) {
      const over = points.filter(([x, y]) => x > box.left && x < box.right && y > box.top && y < box.bottom)
      if (over.length) faults.push(`“${named(text)}” is crossed by ${name}`)
    }
    if (!text.closest(".plot-area")) continue
    const {top, bottom} = text.closest(".block").getBoundingClientRect()
    const paper = text.closest(".paper").getBoundingClientRect()
    const {left, right} = paper.width ? paper : {left: 0, right: innerWidth}
    const far = Math.max(left - box.left, box.right - right, top - box.top, box.bottom - bottom)
    if (far > 1) faults.push(`“${named(text)}” is ${far.toFixed()} px outside its plot`)
  }
  return faults
}"""
"""Texts over plots that a curve crosses, or that are outside their plot."""


FLAT = """title = "Too flat"
[[step]]
id = "flat"
from = "d32-33-04"
state = "?scene=damped&zeta=1&frame.x=-2,2"
"""


@pytest.mark.parametrize("size", [HALL, PHONE], ids=["hall", "phone"])
@pytest.mark.parametrize("name", sample(sorted(load_walks(()))))
def test_every_step_can_be_read_with_its_texts_clear_of_curves_and_in_their_plot(
    name: str, size: tuple[int, int], server: Server, browser: Browser
) -> None:
    walk, found = load_walks(())[name], list[str]()
    # Playwright's waiting for an expression is an eval, which the page forbids.
    context = browser.new_context(
        viewport={"width": size[0], "height": size[1]},
        bypass_csp=True,
        reduced_motion="reduce",
        has_touch=size == PHONE,
    )
    page = context.new_page()
    page.goto(f"{server.url}?walk={name}" + ("&projector" if size == HALL else ""))
    for place, step in enumerate(walk.steps):
        known = (CROWDED if size == PHONE else CROWDED_IN_HALL).get(step.id, ())
        for when in shown(page, place):
            here = list(faults_of(page, size[1])) if size == HALL else []
            passed(page)
            seek(page, 0.0)
            touched = (fault.replace("\u200b", "") for fault in page.evaluate(TOUCHED))
            here += [fault for fault in touched if not fault.startswith(tuple(f"“{one}" for one in known))]
            found += [f"{step.id}, {when}: {fault}" for fault in here]
    context.close()
    assert not found, "\n".join(found)


def test_pictures_of_each_step_are_next_to_its_problems(tmp_path: Path) -> None:
    """In its own process, because this one already has a Playwright."""
    (tmp_path / "flat.toml").write_text(FLAT.replace("[[step]]", "[[step]]\ncover = []", 1), encoding="utf-8")
    command = [sys.executable, "-m", "tools.walk", "flat.toml", "--pictures"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    told = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert told.returncode == 1, told.stderr
    folder = tmp_path / "build" / "walk" / "flat"
    names = {f"01-flat-{when}-{size}.png" for when in ("question", "answer") for size in ("hall", "phone")}
    assert {one.name for one in folder.glob("*.png")} == names
    page = (folder / "index.html").read_text(encoding="utf-8")
    assert all(f'src="{name}"' in page for name in names) and "cover: nothing is hidden" in page
    assert "build/walk/flat/index.html has its pictures" in told.stdout


def test_a_curve_that_is_too_flat_is_reported_with_its_step_and_size(tmp_path: Path, browser: Browser) -> None:
    (tmp_path / "flat.toml").write_text(FLAT, encoding="utf-8")
    walk = read_walk(FLAT, "flat", steps_of(load_walks(()).values()))
    with serving(tmp_path / "log", environment={"WALKS": str(tmp_path)}) as server:
        found = list(faults(walk, browser, server.url))
    for size in ("1280 x 720", "853 x 480"):
        start = f"flat, step 1 (flat), question at {size}: plot x: its curves use "
        assert [fault for fault in found if fault.startswith(start) and fault.endswith("10% are the least.")]
