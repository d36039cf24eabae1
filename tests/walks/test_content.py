"""Every step of the lecture's walks against its scene and the physics: links, names, answers, numbers, sketches."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from decimal import Decimal
from typing import Any

import numpy as np
import pytest

from components.language.messages import Given
from components.layout.text import rich
from components.quantities.formatting import three
from components.scenes import SCENES
from components.state.sent_picture import sent_picture
from components.walks.cards import walk_sheet
from components.walks.checking import problems, shortcomings
from components.walks.features import Period
from components.walks.links import page_state_at
from components.walks.loading import load_walks, steps_of
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumericStep
from components.walks.questions.sketch import SketchStep
from components.walks.sketch import Sketch, sketch
from components.walks.subject import Subject, place_of
from components.walks.texts import FORMULA
from components.walks.walk import Step
from tests.walks.drawings import WRONG
from tests.walks.facts import ANSWERS, PERIODS, STATED
from tests.walks.strokes import heights

WALKS = load_walks(())
STEPS = steps_of(WALKS.values())
SLIDES = {*(f"D31-{i}" for i in range(1, 11)), *(f"D34-{i}" for i in range(1, 9)), "D34-N1", "D34-N2"}
MOST_WORDS = {"title": 8, "question": 30, "explain": 45}
NUMBER = re.compile(r"(?<![\w.{_^])[−-]?\d+(?:\.\d+)?(?![\w.]*[}])")
NAME = re.compile(r"(?:(?:[Ss]lides?|[Mm]ass|[Ss]pring|[Rr]ows?) |√)$")
INDEX = re.compile(r"_(?:\{[^}]*\}|\w)|\{\w+\}|\*")
every_step = pytest.mark.parametrize("step", STEPS.values(), ids=STEPS)
every_sketch = pytest.mark.parametrize(
    "step", [step for step in STEPS.values() if isinstance(step, SketchStep)], ids=lambda step: step.id
)


@pytest.mark.parametrize("name", WALKS)
def test_a_step_shows_nothing_that_a_later_one_asks_for(name: str) -> None:
    assert list(shortcomings(WALKS[name], SCENES)) == []


@every_step
def test_the_right_answer_is_as_long_as_the_others(step: Step) -> None:
    if isinstance(step, ChoiceStep):
        lengths = {right: [len(one.text) for one in step.options if one.right is right] for right in (True, False)}
        assert 0.6 * max(lengths[False]) <= lengths[True][0] <= 1.2 * max(lengths[False]) + 3


@pytest.mark.parametrize("name", WALKS)
def test_a_walk_opens_and_everything_it_names_is_there(name: str) -> None:
    assert list(problems(WALKS[name], SCENES)) == []


@every_step
def test_a_step_states_the_scale_of_a_stage_only_with_a_stage(step: Step) -> None:
    page = replace(page_state_at(step.state, SCENES), show=step.show)
    said = page.shown.to_scale in sent_picture(page, page.shown).notes
    has_stage = any(name.partition(":")[0] == "stage" for name in step.show)
    assert said == bool(has_stage and page.shown.to_scale)


def test_every_slide_has_its_step() -> None:
    assert {slide for step in STEPS.values() for slide in step.slides} == SLIDES
    assert [len(WALKS[name].steps) for name in ("d31", "d32-33", "d34", "waves", "tour")] == [16, 14, 21, 6, 5]
    assert [step.id for step in WALKS["d34"].steps] == [f"d34-{i:02}" for i in range(1, 22)]
    assert sum(step.planned for step in WALKS["tour"].steps) == 10


def test_a_lecture_has_a_shorter_walk_and_ends_in_five_sentences() -> None:
    assert [step.id[-2:] for step in WALKS["d34"].steps if step.core] == ["02", "08", "10", "12", "14", "16"]
    assert [step.id[-2:] for step in WALKS["d32-33"].steps if step.core] == ["01", "04", "06", "10"]
    for name in ("d31", "d32-33", "d34", "waves"):
        assert len(WALKS[name].end) == 5 and all(words(sentence) <= 30 for sentence in WALKS[name].end)
    assert walk_sheet(WALKS["d34"], SCENES).end[1].startswith("Every free motion")


def words(text: str) -> int:
    return sum(any(sign.isalnum() or sign in "{}½²" for sign in word) for word in text.split())


@every_step
def test_a_step_is_short(step: Step) -> None:
    assert all(words(getattr(step, field)) <= most for field, most in MOST_WORDS.items())
    if not step.id.startswith("tour"):
        assert 3 <= len(step.equations) <= 6
    if isinstance(step, ChoiceStep):
        assert all(words(option.text) <= 12 for option in step.options)


@every_step
def test_a_state_keeps_the_values_of_its_link(step: Step) -> None:
    for link in (step.state, step.shown):
        page = page_state_at(link, SCENES)
        for name, value in re.findall(r"[?&](\w+)=([-\d.e]+)(?=&|$)", link):
            assert page.scene.values[name] == float(value)


@pytest.mark.parametrize(
    "step", [step for step in STEPS.values() if isinstance(step, NumericStep)], ids=lambda step: step.id
)
def test_answers_and_misses_are_what_the_physics_says(step: NumericStep) -> None:
    right, misses = ANSWERS[step.id]
    tolerance, subject = step.answer.tolerance, Subject("", step, SCENES)
    assert step.answer.quantities, "what is true is a quantity of the scene"
    assert list(step.right(subject)) == pytest.approx(right, abs=0.1 * tolerance)
    assert list(step.wrong(subject)) == pytest.approx(misses, abs=0.15 * tolerance)


def known_numbers(step: Step) -> tuple[set[float], set[str]]:
    """The numbers of the scene: parameters, to be repeated exactly, and live values, digit for digit."""
    parameters: set[float] = set()
    live: set[str] = set()
    for link in (step.state, step.shown):
        page = page_state_at(link, SCENES)
        parameters |= {v for v in page.scene.values.values() if isinstance(v, float)}
        for text in page.shown.values.values():
            live.update(re.findall(r"−?\d+(?:\.\d+)?(?!\d|·)", text))
    return parameters, live


def numbers_of(step: Step) -> Iterator[str]:
    """The numbers in the sentences of a step, without slide numbers, mass numbers and coefficients of formulas."""
    for _, sentence in step.sentences():
        text = INDEX.sub("", FORMULA.sub("", sentence))
        for match in NUMBER.finditer(text):
            after = text[match.end() : match.end() + 1]
            coefficient = after.isalpha() and match[0] in ("2", "3", "4")
            if not (NAME.search(text[: match.start()]) or coefficient or match[0] == "0"):
                yield match[0]


@every_step
def test_every_number_in_a_text_is_the_scenes_or_the_physics(step: Step) -> None:
    parameters, live = known_numbers(step)
    stated = STATED.get(step.id, {})
    for text in numbers_of(step):
        assert text in stated or text in live or float(text.replace("−", "-")) in parameters, text


@pytest.mark.parametrize("name", STATED)
def test_what_is_stated_is_so(name: str) -> None:
    for text, value in STATED[name].items():
        decimals = len(text.partition(".")[2])
        assert abs(float(text.replace("−", "-")) - value) <= 0.5000001 * 10.0**-decimals, text


def missed(step: SketchStep, curves: dict[str, Sketch]) -> set[str]:
    must = step.told(step.must, Subject("", step, SCENES))
    return {feature.kind for feature, found in zip(must, step.seen(must, curves), strict=True) if not found}


DRAWN = 2e-3
"""Of a number, by which one that is read off a drawn curve may be off: a beat turns a little before it swings."""


def half_of_its_last_digit(stated: float) -> float:
    return 0.5 * 10.0 ** int(Decimal(repr(stated)).as_tuple().exponent)


@every_sketch
def test_a_feature_states_what_the_true_curve_has(step: SketchStep) -> None:
    """To the last written digit; for an expression, to the accuracy of a drawn curve."""
    subject = Subject("", step, SCENES)
    curves = subject.true(step.plot, step.curves)
    for written, feature in zip(step.must, step.told(step.must, subject), strict=True):
        found = feature.seen(curves[feature.on or step.curve])
        assert found.has
        number = PERIODS[step.id] if isinstance(feature, Period) else found.number
        for name, true in (("value", number), ("at", found.x)):
            stated = getattr(feature, name, None)
            if stated is not None and true is not None:
                told = isinstance(getattr(written, name), str)
                off = DRAWN * abs(true) if told else half_of_its_last_digit(stated)
                assert abs(true - stated) <= off, (feature, true)
                assert not isinstance(feature, Period) or three(stated) == three(true), "it is said to be the true one"


def judged(step: SketchStep, draw: Callable[[Any], Any]) -> tuple[bool | None, str]:
    """Return whether a sketch is right, and the reply to it."""
    subject = Subject("", step, SCENES)
    axes = subject.axes(step.plot)
    x = np.linspace(*axes.frame.x, 201)
    drawn = draw(x)
    curves = drawn if isinstance(drawn, dict) else {step.curve: drawn}
    places = {
        name: [(place_of(axes.x, float(a)), place_of(axes.y, float(b))) for a, b in zip(x, y, strict=True)]
        for name, y in curves.items()
    }
    lesson = step.lesson(Given(walk="", step=step.id, curves=heights(step, places)), subject)
    return lesson.right, lesson.reply


def level(step: SketchStep, height: float) -> Callable[[Any], Any]:
    return lambda x: dict.fromkeys(step.curves, 0 * x + height)


@every_sketch
def test_a_wrong_sketch_gets_its_reply_and_no_other(step: SketchStep) -> None:
    assert all(wrong.has for wrong in step.wrong)
    for described, draw in zip(step.wrong, WRONG[step.id], strict=True):
        assert judged(step, draw) == (False, rich(described.reply)), described.draws
    low, high = Subject("", step, SCENES).axes(step.plot).frame.y
    for share in (0.5, 0.75, 0.97):
        assert judged(step, level(step, low + share * (high - low))) == (False, ""), share


@every_sketch
def test_a_wrong_sketch_fails_what_it_is_said_to_fail(step: SketchStep) -> None:
    frame = Subject("", step, SCENES).axes(step.plot).frame
    x = np.linspace(*frame.x, 401)
    assert len(WRONG[step.id]) == len(step.wrong)
    for described, draw in zip(step.wrong, WRONG[step.id], strict=True):
        drawn: Any = draw(x)
        heights = drawn if isinstance(drawn, dict) else {step.curve: drawn}
        plain = {name: sketch(np.column_stack((x, y)), frame) for name, y in heights.items()}
        curves = {
            name: sketch(np.column_stack((one.x, one.y)), frame, *(plain[other] for other in plain if other != name))
            for name, one in plain.items()
        }
        assert missed(step, curves) >= set(described.fails), described.draws
