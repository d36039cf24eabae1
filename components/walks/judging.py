"""Judging: the lesson that an answer to a step of a walk receives."""

from __future__ import annotations

from components.language.messages import Given, Taught
from components.quantities.formatting import excerpt
from components.walks import Walks
from components.walks.links import Scenes
from components.walks.subject import Subject
from components.walks.variants import varied
from components.walks.walk import Step


def taught(given: Given, walks: Walks, scenes: Scenes) -> Taught:
    """Return the lesson of a step with the comment on the visitor's answer, which is not stored here."""
    steps = walks[given.walk].steps if given.walk in walks else ()
    step = next((step for step in steps if step.id == given.step), None)
    if step is None:
        refused = f"There is no step “{excerpt(given.step)}” in the walk “{excerpt(given.walk)}”."
        return Taught(walk=given.walk, step=given.step, lesson=None, refused=refused)
    return reply_to(given, step, scenes)


def reply_to(given: Given, step: Step, scenes: Scenes) -> Taught:
    """Return the reply to an answer, with the student's numbers of the step: a lesson, or a refusal."""
    try:
        step = varied(step, given.seed)
        lesson, refused = step.lesson(given, Subject(given.walk, step, scenes, given.seed)), ""
    except ValueError as reason:
        lesson, refused = None, str(reason)
    return Taught(walk=given.walk, step=given.step, lesson=lesson, refused=refused)
