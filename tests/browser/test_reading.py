"""The numbers at the pointer over a plot: those of the motion itself, else as many digits as a column has."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from components.quantities.numbers import short
from components.scenes import SCENES
from components.state.encoding import COARSE
from tests.browser.script_page import Scripts
from tests.page.playing import played

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
POINT = """([name, share]) => {
  const plot = oscillations.plots.find(({block}) => block.name === name), {frame} = plot
  const box = plot.host.getBoundingClientRect(), x = Math.round(box.x + frame.left + share * frame.width)
  return {x, y: box.y + frame.top + frame.height / 2, place: plot.valueAt({clientX: x, clientY: 0})}
}"""


@pytest.fixture(scope="module")
def scripts(browser: Browser) -> Iterator[Scripts]:
    running = Scripts(browser, ("paper/reading",))
    yield running
    running.context.close()
    assert running.faults == []


def test_no_digit_is_shown_that_is_not_known(scripts: Scripts) -> None:
    step = 30 / COARSE  # 0.00046
    cases = [
        (12.3456, step, "12.3"),
        (-0.123456, step, "−0.123"),
        (0.0123456, step, "0.012"),
        (-0.00234, step, "−0.002"),
        (0.0003, step, "0"),
        (0.0, step, "0"),
        (2.3456, 0.03, "2.3"),
        (2.3456, 0.0, "2.35"),
        (0.000123456, 0.0, "1.23·10⁻⁴"),
    ]
    assert scripts.each("reading.honest", (case[:2] for case in cases)) == [text for *_, text in cases]


@pytest.mark.parametrize("share", [0.2, 0.55, 0.93])
def test_a_motion_is_read_as_it_is(page: Page, open_scene: Open, share: float) -> None:
    open_scene(page, scene="coupled")
    point = page.evaluate(POINT, ["x1", share])
    page.mouse.move(point["x"], point["y"])
    picture = SCENES["coupled"]().shown
    x1 = float(played(picture, point["place"])["x1"])
    expect(page.locator(".reading:visible span").last).to_have_text(f"x1 {short(x1)} {picture.axes['x'].full_unit}")
