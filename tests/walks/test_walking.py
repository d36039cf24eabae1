"""A session in a walk: the states it opens, the data it hides, and its replies to answers."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from app import visited
from components.language.messages import Given
from components.live_class.question_bank import QuestionBank
from components.scenes import SCENES
from components.state.scene_sheet import plots
from components.walks.cards import walk_sheet
from components.walks.links import page_state_at
from components.walks.loading import load_walks
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject
from tests.page.headless_page import Page, unpacked
from tests.walks.strokes import heights

WALKS = load_walks(())
SHEETS = {name: walk_sheet(walk, SCENES) for name, walk in WALKS.items()}
STEPS = [(name, i) for name, walk in WALKS.items() for i in range(len(walk.steps))]


@pytest.fixture
def page() -> Page:
    page = Page(SCENES["oscillator"]())
    page.session.walks = WALKS
    return page


def opened(page: Page, state: Any) -> dict[str, Any]:
    plain = {"scene": state.scene, "parameters": state.parameters, "covered": list(state.covered), "step": state.step}
    return page.send({"type": "open", "state": plain, "number": len(page.packets) + 1})


def answering(walk: str, step: str, number: int, **answer: Any) -> dict[str, Any]:
    return {"type": "given", "answer": {"walk": walk, "step": step, **answer}, "number": number}


def given(page: Page, step: str, **answer: Any) -> dict[str, Any]:
    told = page.send(answering(step.rpartition("-")[0], step, 1000 + len(page.packets), **answer))
    assert told["type"] == "taught", told.get("errors")
    return told


@pytest.mark.parametrize(("name", "place"), STEPS)
def test_every_step_opens_covered_and_opens_up(page: Page, name: str, place: int) -> None:
    step, card = WALKS[name].steps[place], SHEETS[name].steps[place]
    told = opened(page, card.opens)
    assert told["errors"] == {} and told["state"]["covered"] == list(step.cover)
    assert told["query"] == f"walk={name}&step={step.id}"
    view, whole = told["view"], page.shown
    for cover in step.cover:
        kind, _, what = cover.partition(":")
        if kind == "value":
            assert what not in view["values"] and what not in view["live"]
        elif kind == "plot":
            (plot,) = (plot for plot in plots(type(page.scene)) if plot.name == what)
            drawn = [(curve.source, curve.y) for curve in plot.curves]
            assert not any(column in view["columns"].get(source, {}) for source, column in drawn) or not drawn
        elif kind == "ticks":
            ruler, axis = view["axes"][what], whole.axes[what].ruler
            assert abs(ruler["end"] - ruler["start"]) > 1.2 * abs(axis.end - axis.start)
    told = opened(page, card.reveals)
    assert told["errors"] == {} and told["state"]["covered"] == list(step.still)
    lesson = given(page, step.id)["lesson"]
    assert lesson["right"] is None and lesson["title"] and lesson["explain"]
    assert len(lesson["follows"]) == len(step.equations)


def test_answers_are_not_sent_before(page: Page) -> None:
    for sheet in SHEETS.values():
        for card in sheet.steps:
            assert not {"title", "explain", "right", "answer", "must"} & set(card.__struct_fields__)


def test_a_choice_gets_the_sentence_that_is_its_own(page: Page) -> None:
    lesson = given(page, "d31-03", option=1)["lesson"]
    assert lesson["right"] is False
    assert [verdict["right"] for verdict in lesson["verdicts"]] == [True, False, False]
    assert "same speed" in lesson["verdicts"][1]["reply"]
    assert given(page, "d31-03", option=0)["lesson"]["right"] is True
    assert given(page, "d31-03", option=7)["refused"] == "This question has 3 answers."


@pytest.mark.parametrize(
    ("text", "right", "reply"),
    [
        ("2", True, ""),
        ("1,96", True, ""),
        ("4.0", False, "root of m"),
        ("0.5", False, "trade places"),
        ("9", False, ""),
        ("4/2", True, ""),
        ("2 s", True, ""),
        ("2000 ms", True, ""),
        ("sqrt(4) s", True, ""),
        ("1 + 3 s", False, "root of m"),
    ],
)
def test_a_number_is_right_within_its_tolerance(page: Page, text: str, right: bool, reply: str) -> None:
    lesson = given(page, "d31-02", text=text)["lesson"]
    assert (lesson["right"], lesson["truth"]) == (right, "2.00 s")
    assert reply in lesson["reply"] and bool(lesson["reply"]) == bool(reply)


@pytest.mark.parametrize(("text", "says"), [("two", "“two” is not a number"), ("2 kg", "“2 kg” is in kg, and this is")])
def test_what_is_no_number_is_refused_in_words(page: Page, text: str, says: str) -> None:
    told = given(page, "d31-02", text=text)
    assert told["lesson"] is None and told["refused"].startswith(says)


def test_a_class_reads_a_number_as_its_page_does() -> None:
    bank = QuestionBank(WALKS, SCENES)

    def vote(text: str) -> Given:
        return Given(walk="d34", step="d34-01", vote=1, text=text)

    for text in ("-4 N", "−12/3", "-4000 mN"):
        assert bank.judge(vote(text)).right and bank.lesson(vote(text)).right
    with pytest.raises(ValueError, match="this is in N"):
        bank.judge(vote("-4 m"))
    judged = [bank.judge(vote(text)) for text in ("-6 N", "1/2", "2,5")]
    assert bank.counted("d34", "d34-01", judged).numbers == (-6.0, 0.5, 2.5)


@pytest.mark.parametrize(
    ("step", "place", "right"), [("d34-08", 1.6, True), ("d34-08", 1.0, False), ("d34-08", -0.6, True)]
)
def test_a_point_is_a_place_on_the_axis(page: Page, step: str, place: float, right: bool) -> None:
    lesson = given(page, step, value=place)["lesson"]
    assert lesson["right"] is right and len(lesson["places"]) == 2


@pytest.mark.parametrize("place", [1.6, -0.9])
def test_what_was_marked_is_what_is_played(page: Page, place: float) -> None:
    shows = page.send(answering("d34", "d34-08", 1, value=place))["lesson"]["shows"]
    told = page.send({"type": "open", "state": shows, "number": 2})
    assert told["errors"] == {} and told["state"]["step"] == "d34/d34-08"
    assert page.now.state.parameters["x2_0"] == place


@pytest.mark.parametrize(
    "step", [s for w in WALKS.values() for s in w.steps if isinstance(s, SketchStep)], ids=lambda s: s.id
)
def test_a_sketch_gets_a_reply_on_its_features(page: Page, step: SketchStep) -> None:
    lesson = given(page, step.id, curves=heights(step))["lesson"]
    assert lesson["right"] is True and all(found["has"] for found in lesson["findings"]), lesson["findings"]
    nothing = given(page, step.id, curves={step.curve: [1100, 1100, *[None] * 99]})["lesson"]
    assert nothing["right"] is False and not all(found["has"] for found in nothing["findings"])
    assert all("missed" in found["words"] for found in nothing["findings"] if not found["has"])
    assert given(page, step.id)["lesson"]["right"] is None


def test_a_wrong_answer_says_where_it_would_be_right(page: Page) -> None:
    verdicts = given(page, "d34-12", option=1)["lesson"]["verdicts"]
    assert [bool(verdict["where"]) for verdict in verdicts] == [False, True, False, True]
    there = verdicts[3]["where"]
    assert (there["scene"], there["step"]) == ("forced", "d34/d34-12")
    assert there["parameters"] == {"k1": 2.0, "omega": 0.77, "view": "motion"}
    shown = page.send({"type": "open", "state": there, "number": 99})
    assert shown["settings"]["omega"]["value"] == 0.77 and shown["errors"] == {}


def test_a_reply_to_a_sketch_or_a_number_leads_to_its_case(page: Page) -> None:
    (step,) = (step for step in WALKS["d34"].steps if step.id == "d34-15")
    assert isinstance(step, SketchStep)
    even = [(float(t), -2.0 * math.cos(t)) for t in np.linspace(0, 25, 201)]
    lesson = given(page, "d34-15", curves=heights(step, {"x1": even}))["lesson"]
    assert "with friction" in lesson["reply"] and lesson["where"]["step"] == "d34/d34-15"
    shown = page.send({"type": "open", "state": lesson["where"], "number": 99})
    assert shown["errors"] == {} and shown["state"]["scene"] == lesson["where"]["scene"]
    assert given(page, "d34-15", curves=heights(step))["lesson"]["where"] is None


def test_what_is_still_covered_is_so_in_its_own_scene_alone(page: Page) -> None:
    (_, _, friction, _) = given(page, "d34-02", option=2)["lesson"]["verdicts"]
    shown = page.send({"type": "open", "state": friction["where"], "number": 99})
    assert shown["errors"] == {} and shown["state"]["covered"] == []


def test_an_answer_to_no_step_is_refused(page: Page) -> None:
    assert "no step" in given(page, "d31-99")["refused"]
    assert "no step" in Page(SCENES["coupled"]()).send(answering("d31", "d31-01", 1))["refused"]


def test_a_session_runs_a_walk_of_its_own(page: Page) -> None:
    text = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'
    told = page.send({"type": "walk", "name": "mine", "text": text, "number": 1})
    assert told["refused"] == "" and told["sheet"]["steps"][0]["opens"]["step"] == "mine/one"
    assert page.send(answering("mine", "one", 2, option=0))["lesson"]["right"]
    told = page.send({"type": "walk", "name": "mine2", "text": "title = 1", "number": 3})
    assert told["sheet"] is None and told["refused"].startswith("mine2: ")
    wrong = """title = "Mine"
[[step]]
id = "one"
from = "d34-12"
cover = ["plot:z"]
options = [{ text = "a", right = true, where = "?scene=no" }, { text = "b", reply = "c" }]
"""
    refused = page.send({"type": "walk", "name": "mine3", "text": wrong, "number": 4})["refused"]
    assert "mine3, step 1 (one), cover: “plot:z” is not possible: choose from" in refused
    assert "mine3, step 1 (one), options[0].where: " in refused
    assert "mine" not in WALKS


def test_a_session_keeps_five_walks_of_its_own_and_none_that_has_the_name_of_the_lecture_s(page: Page) -> None:
    text = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'

    def refusal(name: str) -> str:
        said = {"type": "walk", "name": name, "text": text, "number": 1 + len(page.packets)}
        return str(page.send(said)["refused"])

    assert refusal("d31") == "there is a walk “d31” here already: give the file another name."
    assert given(page, "d31-03", option=0)["lesson"]["right"]
    assert [refusal(f"mine-{i}") for i in range(5)] == [""] * 5
    assert refusal("mine-5").startswith("A page keeps at most 5 walks from files. Give this one the name")
    assert refusal("mine-3") == ""  # mended
    known = [page.send(answering(f"mine-{i}", "one", 100 + i, option=0))["lesson"] is not None for i in range(6)]
    assert known == [True] * 5 + [False]


def test_a_page_can_open_at_a_step() -> None:
    session = visited({"walk": [b"d34"], "step": [b"7"]}, WALKS)
    assert (session.now.state.step, session.now.state.covered) == ("d34/d34-07", SHEETS["d34"].steps[6].opens.covered)
    (problem,) = unpacked(visited({"walk": [b"d34"], "step": [b"99"]}, WALKS).opening())["problems"]
    assert problem.startswith("step: the walk d34 has no step “99”")


def test_what_is_called_true_of_a_turning_point_is_the_motions() -> None:
    """Not the nearest point that is drawn: to a millionth of the period."""
    steps = {step.id: step for walk in WALKS.values() for step in walk.steps}
    for name, of, turns in (("d31-04", "x", (0.5, 1.0)), ("d31-06", "v", (0.25, 0.75))):
        step = steps[name]
        assert isinstance(step, SketchStep)
        has = page_state_at(step.state, SCENES).scene.values
        omega_n = math.sqrt(has["k"] / has["m"])
        phase = math.atan2(has["v_0"] / omega_n, has["x_0"])  # x = C cos(omega_n t - phase)
        expected = [(2 * math.pi * turn + phase) / omega_n for turn in turns]
        (curve,) = Subject("", step, SCENES).true(step.plot, step.curves).values()
        low, high = np.argmin(curve.y), np.argmax(curve.y)
        found = sorted(float(curve.x[i]) % (2 * math.pi / omega_n) for i in (low, high))
        np.testing.assert_allclose(found, sorted(t % (2 * math.pi / omega_n) for t in expected), rtol=1e-6)
        C = math.hypot(has["x_0"], has["v_0"] / omega_n) * (omega_n if of == "v" else 1.0)
        np.testing.assert_allclose([curve.y[low], curve.y[high]], [-C, C], rtol=1e-7)
