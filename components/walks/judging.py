"""What is said of an answer, and what its step then teaches."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypedDict

from msgspec.structs import replace

from components.numbers import excerpt, three
from components.page.messages import Given, Taught
from components.page.state import State
from components.page.walk import Lesson, Verdict
from components.text import rich
from components.typed import typed_number
from components.walks import Walks
from components.walks.curves import axes_of, number_at, place_of, true_curves
from components.walks.findings import findings, has_all
from components.walks.links import Scenes, answer_state, scene_at, state_of_link
from components.walks.sketch import Sketch
from components.walks.texts import line
from components.walks.types import ChoiceStep, NumberStep, NumericStep, PointStep, SketchStep, Step


class Judgement(TypedDict, total=False):
    """The fields of a lesson that depend on the answer."""

    right: bool | None
    reply: str
    truth: str


def lesson_of(step: Step, given: Given, scenes: Scenes) -> Lesson:
    """The lesson with what is said of the answer; ValueError, in words, for what is no answer to such a question."""
    lesson = Lesson(
        title=rich(step.title),
        explain=rich(step.explain),
        follows=tuple(map(line, step.equations)),
        next=rich(step.next),
    )
    match step:
        case ChoiceStep():
            return _chosen(step, given, lesson, scenes)
        case NumberStep():
            number = typed_number(given.text, step.answer.unit) if given.text.strip() else None
            return replace(lesson, places=step.answer.value, **_numeric(step, number))
        case PointStep():
            return _marked(step, given, lesson, scenes)
    return _sketched(step, given, lesson, scenes)


def taught(given: Given, walks: Walks, scenes: Scenes) -> Taught:
    """What a step teaches and what is said of its answer, which is forgotten here."""
    steps = walks[given.walk].steps if given.walk in walks else ()
    step = next((step for step in steps if step.id == given.step), None)
    if step is None:
        refused = f"There is no step “{excerpt(given.step)}” in the walk “{excerpt(given.walk)}”."
        return Taught(walk=given.walk, step=given.step, lesson=None, refused=refused)
    return told_of(given, step, scenes)


def told_of(given: Given, step: Step, scenes: Scenes) -> Taught:
    """What is told of an answer to a step: a lesson, or in words why there is none."""
    try:
        lesson, refused = lesson_of(step, given, scenes), ""
    except ValueError as reason:
        lesson, refused = None, str(reason)
    return Taught(walk=given.walk, step=given.step, lesson=lesson, refused=refused)


def _chosen(step: ChoiceStep, given: Given, lesson: Lesson, scenes: Scenes) -> Lesson:
    option = given.option
    if option is not None and not 0 <= option < len(step.options):
        raise ValueError(f"This question has {len(step.options)} answers.")
    verdicts = tuple(
        Verdict(right=one.right, reply=rich(one.reply), where=_elsewhere(one.where, given, scenes))
        for one in step.options
    )
    return replace(lesson, verdicts=verdicts, right=None if option is None else step.options[option].right)


def _elsewhere(link: str, given: Given, scenes: Scenes) -> State | None:
    """Where an answer would be right; the page stays at the step."""
    return replace(state_of_link(link, scenes), step=f"{given.walk}/{given.step}") if link else None


def _numeric(step: NumericStep, value: float | None) -> Judgement:
    unit = step.answer.unit
    gap = " " if unit and unit != "°" else ""
    truth = " or ".join(f"{three(one)}{gap}{unit}" for one in step.answer.value)
    if value is None:
        return {"truth": truth}
    right = step.is_right(value)
    hit = [] if right else [miss.reply for miss in step.misses if abs(value - miss.value) <= step.answer.tol]
    return {"truth": truth, "right": right, "reply": rich(hit[0]) if hit else ""}


def _marked(step: PointStep, given: Given, lesson: Lesson, scenes: Scenes) -> Lesson:
    place, walk = given.value, given.walk
    field = axes_of(scene_at(step.state, scenes), step.plot)
    axis = field.x if step.which == "x" else field.y
    places = tuple(place_of(axis, one) for one in step.answer.value)
    number = None if place is None else number_at(axis, place)
    shows = None if number is None or not step.sets else _set(step, number * axis.factor, walk, scenes)
    return replace(lesson, places=places, shows=shows, **_numeric(step, number))


def _set(step: PointStep, value: float, walk: str, scenes: Scenes) -> State:
    """The state of the answer, with what was marked."""
    state = answer_state(walk, step, scenes)
    return replace(state, parameters={**state.parameters, step.sets: value})


def _sketched(step: SketchStep, given: Given, lesson: Lesson, scenes: Scenes) -> Lesson:
    scene = scene_at(step.state, scenes)
    field = axes_of(scene, step.plot)
    drawn = field.drawn(given.curves, step.curves)
    found = findings(step, drawn, true_curves(step, scene), field)
    if not any(given.curves.values()):
        return replace(lesson, findings=found)
    missed = {str(feature.__struct_config__.tag) for feature, one in zip(step.must, found, strict=True) if not one.has}
    return replace(lesson, findings=found, right=not missed, reply=_reply(step, drawn, missed))


def _reply(step: SketchStep, drawn: Mapping[str, Sketch], missed: set[str]) -> str:
    """The sentence of that wrong sketch which has only what this one has, and fails most of what this one fails."""
    alike = [wrong for wrong in step.wrong if missed.issuperset(wrong.fails) and has_all(step, wrong.has, drawn)]
    return rich(max(alike, key=lambda wrong: len(wrong.fails)).reply) if alike else ""
