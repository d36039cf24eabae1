"""A walk against the scenes: every link opens, every name is there, every answer can be given."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

from components.covers import coverable
from components.numbers import excerpt
from components.scene import Scene
from components.text import rich
from components.walks.curves import axes_of, place_of, true_curves
from components.walks.links import Scenes, scene_at
from components.walks.sketch import seen
from components.walks.texts import line, live_names
from components.walks.types import BaseStep, ChoiceStep, NumericStep, PointStep, SketchStep, Walk


def problems(walk: Walk, scenes: Scenes) -> Iterator[str]:
    """What is wrong with a walk: sentences that name its step and field."""
    for i, step in enumerate(walk.steps, 1):
        for problem in _of_step(step, scenes):
            yield f"{walk.name}, step {i} ({step.id}), {problem}"


def _of_step(step: BaseStep, scenes: Scenes) -> Iterator[str]:
    yield from _of_texts(step)
    opened: list[Scene] = []
    for field in ("state", "shown"):
        try:
            opened.append(scene_at(getattr(step, field), scenes))
        except ValueError as reason:
            yield f"{'reveal' if field == 'shown' and step.reveal else 'state'}: {reason}"
            return
    before, after = opened
    known = coverable(type(before), before.shown)
    yield from (f"cover: “{excerpt(name)}” cannot be covered here." for name in step.cover if name not in known)
    yield from (f"controls: “{excerpt(name)}” is not a parameter." for name in step.controls if name not in after.param)
    spoken = set(live_names(step.explain))
    yield from (
        f"explain: there is no live number “{excerpt(name)}”."
        for name in sorted(spoken - {*after.shown.values, *after.shown.live})
    )
    yield from _of_question(step, before, scenes)


def _of_texts(step: BaseStep) -> Iterator[str]:
    for field, text in step.sentences():
        yield from _refused(field, partial(rich, text))
        if field != "explain" and any(live_names(text)):
            yield f"{field}: live numbers can stand in explain only."
    for i, latex in enumerate(step.equations):
        yield from _refused(f"follows, line {i + 1}", partial(line, latex))


def _refused(field: str, act: Callable[[], object]) -> Iterator[str]:
    try:
        act()
    except ValueError as reason:
        yield f"{field}: {reason}."


def _of_question(step: BaseStep, scene: Scene, scenes: Scenes) -> Iterator[str]:
    if isinstance(step, ChoiceStep):
        if sum(option.right for option in step.options) != 1:
            yield "options: exactly one must be right."
        lost = (i for i, option in enumerate(step.options) if not option.right and not option.reply)
        yield from (f"options[{i}].reply: a wrong answer needs a reply." for i in lost)
        for i, option in enumerate(step.options):
            if option.where:
                yield from _refused(f"options[{i}].where", partial(scene_at, option.where, scenes))
    if isinstance(step, NumericStep):
        yield from _of_number(step)
    if isinstance(step, PointStep):
        yield from _of_point(step, scene)
    if isinstance(step, SketchStep):
        yield from _of_sketch(step, scene)


def _of_number(step: NumericStep) -> Iterator[str]:
    for i, miss in enumerate(step.misses):
        if any(abs(miss.value - right) <= step.answer.tol for right in step.answer.value):
            yield f"misses[{i}].is: {miss.value:g} is within the tolerance of the right answer."


def _of_point(step: PointStep, scene: Scene) -> Iterator[str]:
    if step.sets and step.sets not in scene.linked():
        yield f"sets: “{excerpt(step.sets)}” is not a parameter."
    try:
        field = axes_of(scene, step.plot)
    except ValueError as reason:
        yield f"axis: {reason}."
        return
    axis = field.x if step.which == "x" else field.y
    low, high = sorted((axis.place(axis.start), axis.place(axis.end)))
    for value in (*step.answer.value, *(miss.value for miss in step.misses)):
        if not low <= place_of(axis, value) <= high:
            yield f"answer: {value:g} lies outside the axis."


def _of_sketch(step: SketchStep, scene: Scene) -> Iterator[str]:
    try:
        true = true_curves(step, scene)
    except ValueError as reason:
        yield f"curve: {reason}."
        return
    for i, feature in enumerate(step.must):
        curve = feature.on or step.curve
        if curve not in true:
            yield f"must[{i}].on: “{excerpt(curve)}” is not drawn."
        elif not seen(feature, true[curve]).has:
            yield f"must[{i}]: the scene's own curve does not have this feature."
    kinds = {str(feature.__struct_config__.tag) for feature in step.must}
    for i, wrong in enumerate(step.wrong):
        strange = [feature.on for feature in wrong.has if (feature.on or step.curve) not in true]
        yield from (f"wrong[{i}].has: “{excerpt(on)}” is not drawn." for on in strange)
        yield from (f"wrong[{i}].fails: “{kind}” is not in must." for kind in wrong.fails if kind not in kinds)
