"""A session in a walk: the states it opens, the data it hides, and its replies to answers."""

from __future__ import annotations

from typing import Any

import msgspec
import pytest

from app import visited
from components.language.messages import Given
from components.live_class.question_bank import QuestionBank
from components.scenes import SCENES
from components.state.covers import PLOT, VALUE
from components.state.scene_sheet import plots
from components.walks.cards import walk_sheet
from components.walks.loading import load_walks, steps_of
from components.walks.questions.sketch import SketchStep
from tests.page.headless_page import Page, say
from tests.walks.answers import heights

WALKS = load_walks(())
STEPS = steps_of(WALKS.values())
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
    view, whole = told["view"], page.shown
    covered = {one.removeprefix(VALUE) for one in step.cover}
    assert not covered & {*view["values"], *view["live"]}
    for plot in plots(page.now.kind):
        sent = [curve.y for curve in plot.curves if curve.y in view["columns"].get(curve.source, {})]
        assert PLOT + plot.name not in step.cover or sent == []
    for axis in [cover.removeprefix("ticks:") for cover in step.cover if cover.startswith("ticks:")]:
        asked, own = view["axes"][axis], whole.axes[axis].ruler
        assert abs(asked["end"] - asked["start"]) > 1.2 * abs(own.end - own.start)
    assert opened(page, card.reveals)["state"]["covered"] == list(step.still)
    lesson = given(page, name, walk=walk)["lesson"]
    assert lesson["right"] is None and lesson["title"] and lesson["explain"]
    assert len(lesson["follows"]) == len(step.equations)


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


@pytest.mark.parametrize("step", [s for s in STEPS.values() if isinstance(s, SketchStep)], ids=lambda step: step.id)
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
    ("walk", "step", "answer", "judged"),
    [
        ("d31", "d31-03", {"option": 0}, {"number": 0.0, "right": True, "has": []}),
        ("d31", "d31-02", {"text": "2 s"}, {"number": 2.0, "right": True, "has": []}),
        ("d34", "d34-14", {"curves": {"Xp1": [500] * 101}}, {"number": 0.0, "right": False, "has": [False] * 5}),
    ],
)
def test_an_answer_of_a_page_and_a_store_from_before_is_one(
    walk: str, step: str, answer: dict[str, object], judged: dict[str, object]
) -> None:
    """Phones send all fields, even those that do not belong to the question, and stores have kept them."""
    whole = {"walk": walk, "step": step, "vote": 2, "option": None, "text": "", "value": None, "curves": {}, **answer}
    bank = QuestionBank(WALKS, SCENES)
    found = bank.judge(msgspec.json.decode(msgspec.json.encode(whole), type=Given))
    assert found.right == judged["right"]
    kept = bank.read(msgspec.json.encode({**whole, **judged, "form": "another"}))
    assert kept == found
