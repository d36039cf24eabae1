"""The check of a walk against the scenes: every link opens, every name exists, every answer can be given."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial

from components.layout.sheet import in_force
from components.layout.text import rich
from components.layout.views import parts
from components.quantities.formatting import excerpt
from components.scene import Scene
from components.state.covers import coverable
from components.walks.cards import ASKS, asked, sentences
from components.walks.claims import untrue
from components.walks.giveaways import giveaways
from components.walks.leaks import leaks
from components.walks.links import Scenes, page_state_at
from components.walks.questions.question import refused
from components.walks.subject import Subject
from components.walks.texts import line, live_names
from components.walks.types import BaseStep
from components.walks.variants import numbers_drawn, numbers_text, strange_spans, variants_of
from components.walks.walk import Step, Walk

MOST_WORDS = 60
"""Maximum length of an explanation, in words."""


def problems(walk: Walk, scenes: Scenes) -> Iterator[str]:
    """Return the problems of a walk: sentences that name its step and field."""
    for i, sentence in enumerate(walk.end):
        yield from (f"{walk.name}, {problem}" for problem in refused(f"end[{i}]", partial(rich, sentence)))
    for trial in walk.trials:
        if trial.scene not in scenes:
            yield f"{walk.name}, trial: “{excerpt(trial.scene)}” is not a scene: choose one of {', '.join(scenes)}."
    for i, step in enumerate(walk.steps, 1):
        yield from problems_of(walk.name, i, step, scenes)


def shortcomings(walk: Walk, scenes: Scenes) -> Iterator[str]:
    """Return the shortcomings of a walk that works: sentences that name its step and field."""
    for i, step in enumerate(walk.steps, 1):
        for doubt in (*_doubts(step, Subject(walk.name, step, scenes)), *_doubts_of_variants(walk.name, step, scenes)):
            yield f"{walk.name}, step {i} ({step.id}), {doubt}"
    yield from giveaways(walk, scenes)
    yield from leaks(walk, scenes)


def _doubts(step: Step, subject: Subject) -> Iterator[str]:
    if not step.cover and step.judges:
        yield "cover: nothing is hidden, so students can read the answer."
    if (words := len(step.explain.split())) > MOST_WORDS:
        yield f"explain: it has {words} words, at most {MOST_WORDS} are allowed."
    if not any(map(ASKS.search, sentences(step.question))):
        yield "question: no sentence ends with a question mark, or begins with Sketch or Mark."
    yield from _lost_parts(step, subject)
    yield from untrue(step, subject)
    yield from step.doubts(subject)


def _lost_parts(step: Step, subject: Subject) -> Iterator[str]:
    """Return the controls that would hide a part that the step lists."""
    after = page_state_at(step.shown, subject.scenes)
    listed = _listed(step, after.scene)
    for name in step.controls:
        values = getattr(after.kind.param[name], "objects", ()) if listed else ()
        for value in values:
            if lost := ", ".join(sorted(listed - _listed(step, after.scene.changed({name: value})))):
                yield f"controls: with “{name}” at {value}, {lost} of show is not shown: leave it out."


def _listed(step: Step, scene: Scene) -> set[str]:
    """Return the parts in the list of a step that a scene shows."""
    return {block.part for block in in_force(scene.sheet(), scene.shown.forms) if block.part in step.show}


def _doubts_of_variants(walk: str, step: Step, scenes: Scenes) -> Iterator[str]:
    for seed, one in variants_of(step):
        for doubt in one.doubts(Subject(walk, one, scenes, seed)):
            yield f"vary: with {numbers_text(numbers_drawn(step, seed))}: {doubt}"
            return


def problems_of(walk: str, place: int, step: Step, scenes: Scenes) -> Iterator[str]:
    """Return the problems of a step of a walk, numbered from 1."""
    for problem in _of_step(walk, step, scenes):
        yield f"{walk}, step {place} ({step.id}), {problem}"


def _of_step(walk: str, step: Step, scenes: Scenes) -> Iterator[str]:
    yield from _of_texts(step)
    subject = Subject(walk, step, scenes)
    found = [*_in_scene(step, subject)] or [*strange_spans(step, subject.page_state.kind)]
    yield from found or _of_variants(walk, step, scenes)


def _of_variants(walk: str, step: Step, scenes: Scenes) -> Iterator[str]:
    """Return the first problem of a step with numbers that a student may get."""
    for seed, one in variants_of(step):
        for problem in _in_scene(one, Subject(walk, one, scenes, seed)):
            yield f"vary: with {numbers_text(numbers_drawn(step, seed))}: {problem}"
            return


def _in_scene(step: Step, subject: Subject) -> Iterator[str]:
    field = "state"
    try:
        before = subject.page_state
        field = "reveal" if step.reveal else "state"
        after = page_state_at(step.shown, subject.scenes)
    except ValueError as reason:
        yield f"{field}: {reason}"
        return
    yield from _unknown("cover", step.cover, coverable(before.kind, before.shown))
    yield from _unknown("show", step.show, parts(before.kind.sheet()))
    yield from (f"still: “{excerpt(name)}” is not in cover." for name in step.still if name not in step.cover)
    if step.judges and step.cover and set(step.cover) == set(step.still):
        yield "still: the answer shows nothing that was covered."
    yield from _unknown("controls", step.controls, after.kind.parameters())
    yield from _unknown("explain", sorted({*live_names(step.explain)}), {*after.shown.values, *after.shown.live})
    if step.derive and not step.equations:
        yield "derive: there are no formulas in follows to show."
    yield from refused("question", lambda: rich(asked(step, subject)))
    yield from step.problems(subject)


def _unknown(field: str, names: Iterable[str], possible: Iterable[str]) -> Iterator[str]:
    """Return a sentence on the impossible names in a field, with all possible ones."""
    possible = sorted(possible)
    if wrong := [f"“{excerpt(name)}”" for name in names if name not in possible]:
        are = "is" if len(wrong) == 1 else "are"
        yield f"{field}: {', '.join(wrong)} {are} not possible: choose from {', '.join(possible)}."


def _of_texts(step: BaseStep) -> Iterator[str]:
    for field, text in step.sentences():
        if field == "question":
            continue  # it uses numbers of its scene
        yield from refused(field, partial(rich, text))
        if field != "explain" and any(live_names(text)):
            yield f"{field}: live numbers are allowed in explain only."
    for i, latex in enumerate(step.equations):
        yield from refused(f"follows, line {i + 1}", partial(line, latex))
