"""The steps of all walks: no text over a plot is crossed by a curve or leaves its plot, asked and answered."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser

from components.walks.loading import load_walks
from tests.browser.labels import touched
from tests.browser.waiting import passed, seek
from tests.serving.server import Server
from tools.look import shown

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


@pytest.mark.parametrize("size", [HALL, PHONE], ids=["hall", "phone"])
@pytest.mark.parametrize("name", sorted(load_walks(())))
def test_texts_over_plots_are_clear_of_curves_and_in_their_plot(
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
        for when in shown(page, place):
            passed(page)
            seek(page, 0.0)
            known = (CROWDED if size == PHONE else CROWDED_IN_HALL).get(step.id, ())
            faults = (fault.replace("\u200b", "") for fault in touched(page))
            found += [
                f"{step.id}, {when}: {one}" for one in faults if not one.startswith(tuple(f"“{k}" for k in known))
            ]
    context.close()
    assert not found, "\n".join(found)
