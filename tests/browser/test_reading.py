"""The numbers at the pointer over a plot are those of the motion itself."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from components.quantities.formatting import short
from components.scenes import SCENES
from tests.page.scripts import played

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
POINT = """([name, share]) => {
  const plot = oscillations.plots.find(({block}) => block.name === name), {frame} = plot
  const box = plot.host.getBoundingClientRect(), x = Math.round(box.x + frame.left + share * frame.width)
  return {x, y: box.y + frame.top + frame.height / 2, place: plot.valueAt({clientX: x, clientY: 0})}
}"""


@pytest.mark.parametrize("share", [0.2, 0.55, 0.93])
def test_a_motion_is_read_as_it_is(page: Page, open_scene: Open, share: float) -> None:
    open_scene(page, scene="coupled")
    point = page.evaluate(POINT, ["x1", share])
    page.mouse.move(point["x"], point["y"])
    picture = SCENES["coupled"]().shown
    x1 = float(played(picture, point["place"])["x1"])
    expect(page.locator(".reading:visible span").last).to_have_text(f"x1 {short(x1)} {picture.axes['x'].full_unit}")
