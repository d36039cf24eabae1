"""Each kind of question is one class in Python and one in JavaScript, listed in one place each."""

from __future__ import annotations

import re
from typing import get_args

import msgspec
import pytest

from components.language.messages import Given
from components.live_class.question_bank import QuestionBank
from components.scenes import SCENES
from components.walks.loading import load_walks
from components.walks.walk import Step
from tests.serving.server import ROOT

KINDS = {str(kind.__struct_config__.tag): kind for kind in get_args(Step)}
SCRIPTS = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in ROOT.glob("static/**/*.js")}


def test_both_sides_have_the_same_kinds() -> None:
    (found,) = re.findall(r"export const KINDS = \{(.*)\}", SCRIPTS["static/questions/kinds.js"])
    assert [entry.partition(":")[0].strip() for entry in found.split(",")] == list(KINDS)


@pytest.mark.parametrize(
    ("walk", "step", "answer", "judged"),
    [
        ("d31", "d31-03", {"option": 0}, {"number": 0.0, "right": True, "has": []}),
        ("d31", "d31-02", {"text": "2 s"}, {"number": 2.0, "right": True, "has": []}),
        ("d34", "d34-08", {"value": 1.6}, {"number": 0.0, "right": True, "has": []}),
        ("d34", "d34-14", {"curves": {"Xp1": [500] * 101}}, {"number": 0.0, "right": False, "has": [False] * 5}),
    ],
)
def test_an_answer_of_a_page_and_a_store_from_before_is_one(
    walk: str, step: str, answer: dict[str, object], judged: dict[str, object]
) -> None:
    """Phones send all fields, even those that do not belong to the question, and stores have kept them."""
    whole = {"walk": walk, "step": step, "vote": 2, "option": None, "text": "", "value": None, "curves": {}, **answer}
    bank = QuestionBank(load_walks(()), SCENES)
    found = bank.judge(msgspec.json.decode(msgspec.json.encode(whole), type=Given))
    assert found.right == judged["right"]
    kept = bank.read(msgspec.json.encode({**whole, **judged, "form": "another"}))
    assert kept == found
