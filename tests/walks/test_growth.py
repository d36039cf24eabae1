"""Question and answer have the same scale, so that the larger curve of the answer is drawn larger."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from app import SCENES
from components.language.messages import Open
from components.state.page_state import PageState, changed
from components.state.scene_sheet import plots
from components.walks.loading import load_walks
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject

CHANGED = 0.05
"""Relative change that can be seen."""
COMPARED = {
    step.id: Subject(walk.name, step, SCENES)
    for walk in load_walks(()).values()
    for step in walk.steps
    if step.reveal and step.reveal != step.state
}


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


SKETCHED = {
    step.id: Subject(walk.name, step, SCENES)
    for walk in load_walks(()).values()
    for step in walk.steps
    if isinstance(step, SketchStep) and any(cover.startswith("ticks:") for cover in step.cover)
}


@pytest.mark.parametrize("step", SKETCHED)
def test_what_a_class_has_sketched_stays_in_the_frame(step: str) -> None:
    """An axis with hidden numbers is wider than its curve; the answer keeps it."""
    subject = SKETCHED[step]
    asked = changed(subject.page_state, Open(state=subject.opening), SCENES)
    answered = changed(asked, Open(state=subject.answer, keeps=True), SCENES)
    for name in [cover.removeprefix("ticks:") for cover in asked.covered if cover.startswith("ticks:")]:
        before, after = asked.to_send[0].axes[name], answered.to_send[0].axes[name]
        assert (before.start, before.end) == (after.start, after.end)
        assert after.ticks


@pytest.mark.parametrize("step", COMPARED)
def test_what_grows_is_drawn_larger(step: str) -> None:
    subject = COMPARED[step]
    asked = changed(subject.page_state, Open(state=subject.opening), SCENES)
    answered = changed(asked, Open(state=subject.answer, keeps=True), SCENES)
    if asked.kind is not answered.kind:
        return
    before = {name: (span, share) for name, span, share in spans(asked, subject.opening.show)}
    for name, span, share in spans(answered, subject.opening.show):
        if name in before:
            grows, drawn = span / before[name][0], share / before[name][1]
            if grows > 1 - CHANGED:
                assert drawn > (1 + CHANGED if grows > 1 + 2 * CHANGED else 1 - CHANGED), (name, grows, drawn)
    assert answered.drawn.frame.scale == asked.drawn.frame.scale
