"""Question and answer have the same scale, so that the larger curve of the answer is drawn larger."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from components.language.messages import Open
from components.scenes import SCENES
from components.state.page_state import PageState, changed
from components.state.scene_sheet import plots
from components.walks.loading import load_walks, steps_of
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject

CHANGED = 0.05
"""Relative change that can be seen."""
STEPS = steps_of(load_walks(()).values())
COMPARED = [name for name, step in STEPS.items() if step.reveal and step.reveal != step.state]
TICKS = {name: [cover[6:] for cover in step.cover if cover.startswith("ticks:")] for name, step in STEPS.items()}
SKETCHED = [name for name, step in STEPS.items() if isinstance(step, SketchStep) and TICKS[name]]


def asked_and_answered(step: str) -> tuple[PageState, PageState]:
    subject = Subject("", STEPS[step], SCENES)
    asked = changed(subject.page_state, Open(state=subject.opening), SCENES)
    return asked, changed(asked, Open(state=subject.answer, keeps=True), SCENES)


def spans(page: PageState, shown: tuple[str, ...]) -> Iterator[tuple[str, float, float]]:
    """The span of each curve that a step shows: its name, in SI units and as a share of its axis."""
    picture = page.shown
    for plot in plots(page.kind):
        axis = picture.axes.get(plot.y)
        for curve in plot.curves if axis and (not shown or f"plot:{plot.name}" in shown) else ():
            y = picture.sources.get(curve.source, {}).get(curve.y, np.array([]))
            y = y[np.isfinite(y)]
            if axis and not axis.log and y.size and np.ptp(y) > 0:
                share = np.ptp(axis.places(y)) / abs(axis.place(axis.end) - axis.place(axis.start))
                yield f"{plot.name}.{curve.y}", float(np.ptp(y)), float(share)


@pytest.mark.parametrize("step", SKETCHED)
def test_what_a_class_has_sketched_stays_in_the_frame(step: str) -> None:
    """An axis with hidden numbers is wider than its curve; the answer keeps it."""
    asked, answered = asked_and_answered(step)
    for name in TICKS[step]:
        before, after = asked.to_send[0].axes[name], answered.to_send[0].axes[name]
        assert (before.start, before.end) == (after.start, after.end)
        assert after.ticks


@pytest.mark.parametrize("step", COMPARED)
def test_what_grows_is_drawn_larger(step: str) -> None:
    asked, answered = asked_and_answered(step)
    if asked.kind is not answered.kind:
        return
    show = STEPS[step].show
    before = {name: (span, share) for name, span, share in spans(asked, show)}
    for name, span, share in spans(answered, show):
        if name in before:
            grows, drawn = span / before[name][0], share / before[name][1]
            if grows > 1 - CHANGED:
                assert drawn > (1 + CHANGED if grows > 1 + 2 * CHANGED else 1 - CHANGED), (name, grows, drawn)
    assert answered.drawn.frame.scale == asked.drawn.frame.scale
