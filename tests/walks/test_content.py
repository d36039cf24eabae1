"""Every step of the lecture's walks against its scene and the physics: links, names, numbers, sketches and claims."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from decimal import Decimal
from typing import Any

import numpy as np
import pytest

from components.language.messages import Given
from components.layout.text import rich
from components.quantities.formatting import three
from components.scene import Scene
from components.scene.traces import Floats
from components.scenes import SCENES
from components.state.scene_sheet import plots
from components.walks.checking import problems, shortcomings
from components.walks.expressions import numbers_of as scene_numbers
from components.walks.features import Period
from components.walks.links import page_state_at
from components.walks.loading import load_walks, steps_of
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumericStep
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject, place_of
from components.walks.texts import FORMULA
from components.walks.walk import Step
from tests.walks.answers import heights
from tests.walks.facts import ANSWERS, PERIODS, STATED, WRONG, home

WALKS = load_walks(())
STEPS = steps_of(WALKS.values())
NUMBER = re.compile(r"(?<![\w.{_^])[−-]?\d+(?:\.\d+)?(?![\w.]*[}])")
NAME = re.compile(r"(?:(?:[Ss]lides?|[Mm]ass|[Ss]pring|[Rr]ows?) |√)$")
INDEX = re.compile(r"_(?:\{[^}]*\}|\w)|\{\w+\}|\*")
every_step = pytest.mark.parametrize("step", STEPS.values(), ids=STEPS)
every_sketch = pytest.mark.parametrize(
    "step", [step for step in STEPS.values() if isinstance(step, SketchStep)], ids=lambda step: step.id
)


@pytest.mark.parametrize("name", WALKS)
def test_a_walk_has_neither_problems_nor_shortcomings(name: str) -> None:
    """It opens, everything that it names is there, and no step shows what a later one asks for."""
    assert [*problems(WALKS[name], SCENES), *shortcomings(WALKS[name], SCENES)] == []


@pytest.mark.parametrize("name", WALKS)
def test_no_step_draws_the_curve_that_a_later_one_asks_for(name: str) -> None:
    """Curves over time are left out: each step has its own motion."""
    earlier: list[tuple[type[Scene], Step]] = []
    for step in WALKS[name].steps:
        scene = page_state_at(step.state, SCENES).kind
        plot = getattr(step, "plot", "") or getattr(step, "axis", "").partition(".")[0]
        asked = f"plot:{plot}"
        shown = [one.id for kind, one in earlier if kind is scene and asked in set(one.show) - set(one.still)]
        assert plot in {one.name for one in plots(scene) if one.time} or not shown, (step.id, shown)
        earlier.append((scene, step))


@pytest.mark.parametrize(
    "step", [step for step in STEPS.values() if isinstance(step, NumericStep)], ids=lambda step: step.id
)
def test_answers_and_misses_are_what_the_physics_says(step: NumericStep) -> None:
    right, misses = ANSWERS[step.id]
    tolerance, subject = step.answer.tolerance, Subject("", step, SCENES)
    assert step.answer.quantities, "what is true is a quantity of the scene"
    assert list(step.right(subject)) == pytest.approx(right, abs=0.1 * tolerance)
    assert list(step.wrong(subject)) == pytest.approx(misses, abs=0.15 * tolerance)


def known_numbers(step: Step) -> tuple[set[float], set[float], set[str]]:
    """The parameters, the other numbers, and the live values of the scenes of a step and of its replies."""
    replies = step.options if isinstance(step, ChoiceStep) else step.wrong if isinstance(step, SketchStep) else ()
    parameters, numbers, live = set[float](), set[float](), set[str]()
    for link in (step.state, step.shown, *(reply.where for reply in replies)):
        page = page_state_at(link, SCENES) if link else None
        if page:
            parameters |= {v for v in page.scene.values.values() if isinstance(v, float)}
            numbers |= set(scene_numbers(page.scene).values())
        if page and link in (step.state, step.shown):
            for text in page.shown.values.values():
                live.update(re.findall(r"−?\d+(?:\.\d+)?(?!\d|·)", text))
    return parameters, numbers, live


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
    """Parameters are repeated exactly, live values digit for digit, other numbers to their last digit and 2 %."""
    parameters, numbers, live = known_numbers(step)
    stated, used = STATED.get(step.id, []), set[float]()
    for text in numbers_of(step):
        number, place = float(text.replace("−", "-")), 0.5000001 * 10.0 ** -len(text.partition(".")[2])
        facts = {one for one in stated if abs(one - number) <= place}
        close = any(abs(one - number) <= min(place, 0.02 * abs(number)) for one in numbers)
        assert facts or close or text in live or number in parameters, text
        used |= facts
    assert used == set(stated), "each is in the texts"


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


def judged(step: SketchStep, draw: Callable[[Any], Any]) -> tuple[bool | None, str, set[str]]:
    """Return whether a sketch is right, the reply to it, and the kinds of the features that it lacks."""
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
    missed = {one.kind for one, found in zip(step.must, lesson.findings, strict=True) if not found.has}
    return lesson.right, lesson.reply, missed


def level(step: SketchStep, height: float) -> Callable[[Any], Any]:
    return lambda x: dict.fromkeys(step.curves, 0 * x + height)


@every_sketch
def test_a_wrong_sketch_gets_its_reply_and_no_other(step: SketchStep) -> None:
    assert all(wrong.has for wrong in step.wrong)
    for described, draw in zip(step.wrong, WRONG[step.id], strict=True):
        right, reply, missed = judged(step, draw)
        assert (right, reply) == (False, rich(described.reply)), described.draws
        assert missed >= set(described.fails), described.draws
    low, high = Subject("", step, SCENES).axes(step.plot).frame.y
    for share in (0.5, 0.75, 0.97):
        assert judged(step, level(step, low + share * (high - low)))[:2] == (False, ""), share


def drawn(scene: Scene, name: str = "x") -> Floats:
    """A curve of its picture, over time."""
    return scene.shown.sources["time"][name]


def climbs_and_stays(scene: Scene) -> bool:
    x = drawn(scene)
    return bool(x[0] < 0 and np.all(np.diff(x) > 0) and -0.01 * abs(x[0]) < x[-1] <= 0)


def never_crosses(scene: Scene) -> bool:
    x = drawn(scene)
    return bool(np.all(x > 0) and x[-1] < 0.35 * x[0])


def crosses_again(scene: Scene) -> bool:
    x = drawn(scene)
    return int(np.sum(np.signbit(x[1:]) != np.signbit(x[:-1]))) > 1


def lag(scene: Scene) -> float:
    return next(one.value for one in scene.readouts() if one.name == "phi")


def dies(scene: Scene) -> bool:
    motions = [abs(drawn(scene, name)) for name in ("x1", "x2")]
    return all(x[-len(x) // 8 :].max() < 0.2 * x.max() for x in motions)


def has_odd_powers(scene: Scene) -> bool:
    shown = scene.shown
    return shown.forms["braked"] == "shown" and shown.values["p3"] != "+ 0.00" != shown.values["p1"]


CLAIMS: list[tuple[str, int | None, Callable[[Scene], Any]]] = [
    ("d34-13", None, lambda scene: scene.shown.values["Xp2"] == "+1.00"),  # as far as spring 1 gives way
    ("d31-15", 1, climbs_and_stays),
    ("d32-33-05", 0, never_crosses),
    ("d32-33-05", 1, crosses_again),
    ("d32-33-04", 1, lambda scene: home(0.83) < home(scene.values["zeta"]) < home(3.0)),
    ("d32-33-06", 1, lambda scene: scene.shown.forms["holds"] == "spring"),
    ("d32-33-06", 2, lambda scene: scene.shown.forms["holds"] == "inertia"),
    ("d32-33-07", 1, lambda scene: lag(scene) < 0.1),
    ("d32-33-07", 2, lambda scene: abs(lag(scene) - math.pi / 2) < 1e-3),
    ("d32-33-07", 3, lambda scene: float(scene.shown.values["M"]) < 0.003),
    ("d34-02", 2, dies),
    ("d34-06", 2, has_odd_powers),
    ("waves-01", 2, lambda scene: {2.0, 4.0, 6.0} <= {*scene.shown.columns["silent"]["silent_j"].tolist()}),
]
"""A step, one of its replies or none, and what is true of the picture of the reply or the step."""


@pytest.mark.parametrize(("step", "i", "is_true"), CLAIMS)
def test_what_a_step_says_is_true_of_its_picture(step: str, i: int | None, is_true: Callable[[Scene], Any]) -> None:
    one = STEPS[step]
    replies = one.options if isinstance(one, ChoiceStep) else one.wrong if isinstance(one, SketchStep) else ()
    assert is_true(page_state_at(one.state if i is None else replies[i].where, SCENES).scene)
