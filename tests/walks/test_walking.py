"""A session in a walk: the states it opens, the data it hides, its replies to answers, and the features of sketches."""

from typing import Any

import msgspec
import numpy as np
import pytest

from app import visited
from components.language.messages import HEIGHTS, Given, Sketched
from components.live_class.question_bank import QuestionBank
from components.quantities.axes import Axis
from components.scenes import SCENES
from components.state.covers import PLOT, VALUE
from components.state.scene_sheet import plots
from components.walks.cards import walk_sheet
from components.walks.features import Feature, Seen, Zero
from components.walks.loading import load_walks, steps_of
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumberStep
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
from components.walks.sketch import Ranges, Sketch, sketch, turns
from components.walks.subject import PlotAxes, Subject, place_of
from components.walks.texts import pieces
from components.walks.walk import Step
from tests.page.headless_page import Page, say

WALKS = load_walks(())
STEPS = steps_of(WALKS.values())
SKETCHES = [step for step in STEPS.values() if isinstance(step, SketchStep)]
CARDS = {card.id: (name, card) for name, walk in WALKS.items() for card in walk_sheet(walk, SCENES).steps}


@pytest.fixture
def page() -> Page:
    page = Page(SCENES["oscillator"]())
    page.session.walks = WALKS
    return page


def opened(page: Page, state: Any) -> dict[str, Any]:
    told = say(page, "open", state=msgspec.to_builtins(state))
    assert told["errors"] == {}
    return told


def given(page: Page, step: str, **answer: Any) -> dict[str, Any]:
    walk = answer.pop("walk", step.rpartition("-")[0])
    return say(page, "given", answer={"walk": walk, "step": step, **answer})


@pytest.mark.parametrize("name", STEPS)
def test_every_step_opens_covered_and_opens_up(page: Page, name: str) -> None:
    step, (walk, card) = STEPS[name], CARDS[name]
    assert not {"title", "explain", "right", "answer", "must"} & set(card.__struct_fields__)
    told = opened(page, card.opens)
    assert told["state"]["covered"] == list(step.cover)
    assert told["query"] == f"walk={walk}&step={name}"
    assert visited({"walk": [walk.encode()], "step": [name.encode()]}, WALKS).now.state == page.now.state
    view = told["view"]
    covered = {one.removeprefix(VALUE) for one in step.cover}
    assert not covered & {*view["values"], *view["live"]}
    for plot in plots(page.now.kind):
        sent = [curve.y for curve in plot.curves if curve.y in view["columns"].get(curve.source, {})]
        assert PLOT + plot.name not in step.cover or sent == []
    assert opened(page, card.reveals)["state"]["covered"] == list(step.still)
    lesson = given(page, name, walk=walk)["lesson"]
    assert lesson["right"] is None and lesson["title"] and lesson["explain"]
    assert len(lesson["follows"]) == len(step.equations)
    assert ["".join(pieces(latex)) for latex in step.equations] == list(step.equations), "where a line may end"


ANSWERED: list[tuple[str, dict[str, Any], bool | None, str]] = [
    ("d31-02", {"text": "2"}, True, ""),
    ("d31-02", {"text": "1,96"}, True, ""),
    ("d31-02", {"text": "4.0"}, False, "root of m"),
    ("d31-02", {"text": "9"}, False, ""),
    ("d31-02", {"text": "2000 ms"}, True, ""),
    ("d31-03", {"option": 0}, True, ""),
    ("d31-03", {"option": 1}, False, "same speed"),
    ("d34-08", {"value": 1.6}, True, ""),
    ("d34-08", {"value": 1.0}, False, ""),
    ("d34-08", {"value": -0.6}, True, ""),
    ("d31-02", {"text": "two"}, None, "“two” is not a number"),
    ("d31-02", {"text": "2 kg"}, None, "“2 kg” is in kg, and this is"),
    ("d31-03", {"option": 7}, None, "This question has 3 answers."),
    ("d31-99", {}, None, "no step"),
    ("d31-01", {"walk": "mine"}, None, "no step"),
]
"""A step, an answer, whether it is right or refused, and what the reply says."""


@pytest.mark.parametrize(("step", "answer", "right", "reply"), ANSWERED)
def test_an_answer_is_judged_and_gets_its_own_reply(
    page: Page, step: str, answer: dict[str, Any], right: bool | None, reply: str
) -> None:
    told = given(page, step, **answer)
    lesson = told["lesson"]
    if right is None:
        assert lesson is None and reply in told["refused"]
        return
    assert lesson["right"] is right
    if "text" in answer:
        assert lesson["truth"] == "2.00 s" and bool(lesson["reply"]) == bool(reply) and reply in lesson["reply"]
    elif "option" in answer:
        assert [verdict["right"] for verdict in lesson["verdicts"]] == [True, False, False]
        assert reply in lesson["verdicts"][answer["option"]]["reply"]
    else:
        assert len(lesson["places"]) == 2
        told = opened(page, lesson["shows"])
        assert told["state"]["step"] == "d34/d34-08" and page.now.state.parameters["x2_0"] == answer["value"]


def heights(step: SketchStep, curves: dict[str, tuple[Any, Any]] | None = None) -> dict[str, Sketched]:
    """Curves, each as its x and y, as they are sent; the true ones where none are given."""
    subject = Subject("", step, SCENES)
    pad = subject.pad(step.plot)
    (left, right), (low, high) = ((axis.place(axis.start), axis.place(axis.end)) for axis in (pad.x, pad.y))
    true = {name: (curve.x, curve.y) for name, curve in subject.true(step.plot, step.curves).items()}
    found: dict[str, Sketched] = {}
    for name, (numbers, values) in (curves or true).items():
        x = [place_of(pad.x, float(number)) for number in numbers]
        y = [1000 * (place_of(pad.y, float(value)) - low) / (high - low) for value in values]
        drawn = np.interp(np.linspace(left, right, HEIGHTS), x, np.clip(y, -100, 1100), left=np.nan, right=np.nan)
        found[name] = [None if np.isnan(height) else round(height) for height in drawn.tolist()]
    return found


def answers(step: Step, count: int) -> list[dict[str, Any]]:
    """Return so many answers of a class as they are sent, without walk and step; every second one is right."""
    subject = Subject("", step, SCENES)
    kinds: list[dict[str, Any]]
    if isinstance(step, ChoiceStep):
        kinds = [{"option": i} for i in sorted(range(len(step.options)), key=lambda i: not step.options[i].right)]
    elif isinstance(step, SketchStep):
        sketches = ({name: lowered(curve, by) for name, curve in heights(step).items()} for by in (0, 120, 300))
        kinds = [{"curves": curves} for curves in sketches]
    elif isinstance(step, PointStep):
        axis = step.on(subject)
        kinds = [{"value": place_of(axis, number)} for number in (*step.right(subject), *step.wrong(subject))]
    elif isinstance(step, NumberStep):
        kinds = [{"text": f"{number:.4g}"} for number in (*step.right(subject), *step.wrong(subject))]
    else:
        kinds = [{"text": text} for text in ("It swings", "it swings.", "No idea")]
    return [kinds[0] if i % 2 else kinds[i // 2 % len(kinds)] for i in range(count)]


def lowered(curve: Sketched, by: int) -> Sketched:
    return [None if height is None else max(height - by, -100) for height in curve]


@pytest.mark.parametrize("step", SKETCHES, ids=lambda step: step.id)
def test_a_sketch_gets_a_reply_on_its_features(page: Page, step: SketchStep) -> None:
    lesson = given(page, step.id, curves=heights(step))["lesson"]
    assert lesson["right"] is True and all(found["has"] for found in lesson["findings"]), lesson["findings"]
    assert lesson["where"] is None
    nothing = given(page, step.id, curves={step.curve: [1100, 1100, *[None] * 99]})["lesson"]
    assert nothing["right"] is False and not all(found["has"] for found in nothing["findings"])
    assert all("missed" in found["words"] for found in nothing["findings"] if not found["has"])
    assert given(page, step.id)["lesson"]["right"] is None


def test_a_wrong_answer_says_where_it_would_be_right(page: Page) -> None:
    """The covers that remain apply only in the scene of the question."""
    verdicts = given(page, "d34-12", option=1)["lesson"]["verdicts"]
    assert [bool(verdict["where"]) for verdict in verdicts] == [False, True, False, True]
    there = verdicts[3]["where"]
    assert (there["scene"], there["step"]) == ("forced", "d34/d34-12")
    assert opened(page, there)["settings"]["omega"]["value"] == there["parameters"]["omega"] == 0.77
    friction = given(page, "d34-02", option=2)["lesson"]["verdicts"][2]
    assert opened(page, friction["where"])["state"]["covered"] == []


MINE = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'
WRONG = """title = "Mine"
[[step]]
id = "one"
from = "d34-12"
cover = ["plot:z"]
options = [{ text = "a", right = true, where = "?scene=no" }, { text = "b", reply = "c" }]
"""


def test_a_session_keeps_five_walks_of_its_own_and_none_that_has_the_name_of_the_lecture_s(page: Page) -> None:
    def told(name: str, text: str = MINE) -> dict[str, Any]:
        return say(page, "walk", name=name, text=text)

    assert told("d31")["refused"] == "there is a walk “d31” here already: give the file another name."
    assert given(page, "d31-03", option=0)["lesson"]["right"]
    for text, says in (
        ("title = 1", "mine-0: "),
        (WRONG, "mine-0, step 1 (one), cover: “plot:z” is not possible: choose from"),
        (WRONG, "mine-0, step 1 (one), options[0].where: "),
    ):
        refused = told("mine-0", text)
        assert refused["sheet"] is None and says in refused["refused"]
    for i in range(5):
        answer = told(f"mine-{i}")
        assert answer["refused"] == "" and answer["sheet"]["steps"][0]["opens"]["step"] == f"mine-{i}/one"
    assert told("mine-5")["refused"].startswith("A page keeps at most 5 walks from files. Give this one the name")
    assert told("mine-3")["refused"] == ""  # mended
    lessons = [given(page, "one", walk=f"mine-{i}", option=0)["lesson"] for i in range(6)]
    assert [lesson and lesson["right"] for lesson in lessons] == [True] * 5 + [None]
    assert "mine-0" not in WALKS


@pytest.mark.parametrize(
    ("step", "answer", "judged"),
    [
        ("d31-03", {"option": 0}, (0.0, True, ())),
        ("d31-02", {"text": "2 s"}, (2.0, True, ())),
        ("d34-14", {"curves": {"Xp1": [500] * 101}}, (0.0, False, (False,) * 5)),
    ],
)
def test_an_answer_of_a_page_and_a_store_from_before_is_one(step: str, answer: dict[str, Any], judged: Any) -> None:
    """Phones send all fields, even those that do not belong to the question, and stores have kept them."""
    every = {"vote": 2, "option": None, "text": "", "value": None, "curves": {}, **answer}
    whole, bank = {"walk": step[:3], "step": step, **every}, QuestionBank(WALKS, SCENES)
    found = bank.judge(msgspec.convert(whole, Given))
    assert found.right == judged[1]
    kept = {**whole, **dict(zip(("number", "right", "has"), judged, strict=True)), "form": "another"}
    assert bank.read(msgspec.json.encode(kept)) == found


FRAME = Ranges((0.0, 2.0), (-0.2, 0.2))
T = np.linspace(0, 2, 101)
SWING = -0.16 * np.sin(2 * np.pi * T)
"""Down at first, a trough at 0.25, a zero at 0.5, a peak at 0.75; period 1."""


def feature(**fields: Any) -> Feature:
    return msgspec.convert(fields, Feature)


def drawn(y: Any, x: Any = T, frame: Ranges = FRAME) -> Sketch:
    return sketch(np.column_stack((x, y)), frame)


TROUGH = feature(f="trough", at=0.25, tol=0.06, **{"is": -0.16}, tol_y=0.03)
PEAK = feature(f="peak", at=0.75, tol=0.06, **{"is": 0.16}, tol_y=0.03)
ZERO = feature(f="zero", at=0.5, tol=0.06)
DOWN = feature(f="slope", at=0.0, **{"is": "down"})
PERIOD = feature(f="period", **{"is": 1.0}, tol=0.1)
REACH = feature(f="reach", **{"from": 0.5, "to": 1.9, "is": 0.16}, tol=0.02)
LEAST = feature(f="least", **{"is": -0.16}, tol=0.02)
ANGULAR = -0.15 * np.interp((T - 0.02) % 1, [0, 0.25, 0.75, 1], [0, 1, -1, 0])
ANGULAR += np.random.default_rng(1).uniform(-0.004, 0.004, len(T))
"""Sketches by a hand that shakes a little, draws corners, and is slightly late and low."""
FIRST, HALF = T <= 0.6, T < 1.0
YES, NO = True, False


@pytest.mark.parametrize(
    ("y", "x", "expected"),
    [
        (SWING, T, [YES] * 7),
        (SWING[::-1], T[::-1], [YES] * 7),
        (ANGULAR, T, [YES] * 7),
        (SWING[FIRST], T[FIRST], [YES, NO, YES, YES, NO, NO, NO]),  # the rest is not made up
        (SWING[HALF], T[HALF], [YES, YES, YES, YES, NO, NO, NO]),
        (SWING / 2, T, [NO, NO, YES, YES, YES, NO, NO]),
        (-SWING, T, [NO, NO, YES, NO, YES, YES, YES]),  # upside down
        (np.abs(SWING), T, [NO, YES, NO, NO, NO, YES, NO]),  # never below zero
        (0 * T, T, [NO] * 7),
        (0.19 * np.sin(2 * np.pi * 14 * T), T, [NO, NO, YES, NO, NO, NO, NO]),  # a scribble
        ([], [], [NO] * 7),
        ([1.0], [np.nan], [NO] * 7),
    ],
)
def test_a_sketch_has_its_features_in_any_style(y: Any, x: Any, expected: list[bool]) -> None:
    features = (TROUGH, PEAK, ZERO, DOWN, PERIOD, REACH, LEAST)
    assert [one.seen(drawn(y, x)).has for one in features] == expected


def test_a_feature_is_found_at_its_place_no_gap_or_edge_is_one_and_a_sum_is_of_both_curves() -> None:
    found = TROUGH.seen(drawn(SWING))
    assert (found.x, found.y) == pytest.approx((0.25, -0.16), abs=0.02)
    assert [one.seen(drawn(SWING)).number for one in (PERIOD, ZERO)] == pytest.approx([1.0, 0.5], abs=1e-3)
    gap = (T < 0.3) | (T > 0.9)
    across = drawn(SWING[gap], T[gap])
    assert across.at(0.6) is None and across.at(0.2) is not None
    assert across.at(2.04) == pytest.approx(SWING[-1])  # a hand that stops at the edge
    edge = feature(f="peak", at=0.0, tol=0.1, **{"is": 0.16}, tol_y=0.03)
    assert not edge.seen(drawn(0.16 - 0.1 * T)).has
    t = np.linspace(0, 1, 20)
    assert turns(t, np.zeros(20)) == turns(t, t) == turns(t, np.exp(-t)) == []
    both = feature(f="sum", **{"with": "V", "is": 0.0}, tol=0.02)
    sums = [both.seen(Sketch(T, SWING, FRAME, other)).has for other in (drawn(-SWING), drawn(SWING), None)]
    assert sums == [True, False, False]


@pytest.mark.parametrize("away", [0.35, 9.0])
def test_a_pole_leaves_the_frame_there_and_comes_back(away: float) -> None:
    """A curve that is out over a wide range, or everywhere, has no pole."""
    w, frame = np.linspace(0.01, 2.5, 250), Ranges((0.0, 2.5), (0.0, 5.0))
    pole = feature(f="pole", at=0.618, tol=0.07)
    assert pole.seen(drawn(1 / np.abs(w - 0.6183), w, frame)).has
    assert not pole.seen(drawn(np.where(np.abs(w - 0.65) < away, 5.0, 1.0), w, frame)).has


AXES = PlotAxes(Axis(0.0, 2.0, unit="ms", factor=1e-3), Axis(-0.2, 0.2, unit="cm", factor=0.01))


def test_a_feature_is_given_by_expressions_of_the_scenes_numbers() -> None:
    """In SI units, whatever the unit of the axis. A sketch that is right for one chain is wrong for another."""
    numbers = {"tau": 1.0, "X": 0.16}
    told = feature(f="trough", at="tau / 4", tol="0.06 * tau", **{"is": "-X"}, tol_y=3.0).worked_out(numbers, AXES)
    assert (told.at, told.tol, told.value, told.tol_y) == pytest.approx((250.0, 60.0, -16.0, 3.0))
    wide = Ranges((0.0, 2000.0), (-20.0, 20.0))
    assert told.seen(drawn(100 * SWING, 1000 * T, wide)).has
    assert not told.seen(drawn(100 * SWING, 500 * T, wide)).has
    period = feature(f="period", **{"is": "tau"}, tol=1.0).worked_out(numbers, AXES)
    assert period.measured(Seen(True, 1000.0), AXES, 3).startswith("1000")
    assert TROUGH.worked_out(numbers, AXES) is TROUGH
    names = [Zero(at=at, tol=0.1).called(AXES) for at in (1e-12, 0.5)]
    assert names == ["The zero at 0 ms", "The zero at 0.5 ms"], "no rounding errors"
    for text, says in (("tua", "does not have, tua"), ("tau +", "is not an expression"), ("-tau", "> 0")):
        with pytest.raises(ValueError, match=says):
            feature(f="zero", at=0.5, tol=text).worked_out(numbers, AXES)
