"""After any error the visitor gets a sentence, nothing has changed, and the log has the error once."""

from __future__ import annotations

import decimal
import logging
from collections.abc import Callable
from typing import Any
from urllib.parse import parse_qs

import numpy as np
import pytest

from components.language.blocks import Block
from components.language.state import Frame
from components.layout.sheet import column
from components.quantities.parameters import stiffness
from components.quantities.refusals import BEYOND, LINK_LOST, SORRY, Once, in_words
from components.scene import Picture, Scene
from components.scene.frames import FITTED
from components.scenes import SCENES
from components.session.opening import opened
from components.state.link import Link, read_query
from components.state.page_state import with_values
from tests.page.headless_page import Page, unpacked
from tests.scenes.checks import EXTREME_LINKS

LOST: dict[object, int] = {}
FAULTS: dict[float, Callable[[], object]] = {
    1.0: lambda: 2.0**1024,
    2.0: lambda: 1 / 0,
    3.0: lambda: np.array([1e300]) * 1e300,
    4.0: lambda: decimal.Decimal("-1").sqrt(),
    5.0: lambda: LOST["nothing"],
    6.0: lambda: [LOST][7],
}
REFUSED, UNEXPECTED = (1.0, 2.0, 3.0, 4.0), (5.0, 6.0)


class Faulty(Scene):
    """A scene that fails if k is one of FAULTS, and whose picture cannot be sent if k is 7 or 8."""

    slug = title = headline = "faulty"
    lecture = "none"
    groups = ()
    k = stiffness(0.5, symbol="k")
    k2 = stiffness(0.5, symbol="k_2")

    @classmethod
    def sheet(cls) -> Block:
        return column()

    def picture(self, frame: Frame = FITTED) -> Picture:
        FAULTS.get(self.k, int)()
        endless = float("inf") if self.k == 7.0 else self.k
        return Picture(columns={}, axes={}, scalars={"k": endless}, values={"k": object() if self.k == 8.0 else "k"})

    def about(self, shown: Picture) -> Any:
        return FAULTS[5.0]()


def set_k(value: float, number: int = 4) -> dict[str, Any]:
    return {"type": "set", "values": {"k2": 3.0, "k": value}, "number": number}


@pytest.mark.parametrize("value", [*REFUSED, 7.0])
def test_arithmetic_beyond_doubles_is_refused_in_words(value: float) -> None:
    scene = Faulty()
    before, state = scene.shown, scene.param.values()
    for change in (lambda: scene.set({"k2": 3.0, "k": value}), lambda: setattr(scene, "k", value)):
        with pytest.raises(ValueError, match="range of doubles"):
            change()
        assert scene.shown is before
        assert scene.param.values() == state
    assert Page(scene).send(set_k(value))["errors"]["k"] == f"{BEYOND} Still drawn with 0.500."


@pytest.mark.parametrize("value", [*UNEXPECTED, 8.0])
def test_an_unexpected_error_is_answered_and_changes_nothing(value: float) -> None:
    page = Page(Faulty(k2=2.0))
    before = page.opening()
    stood, state = page.now, {"scene": "faulty", "parameters": {"k": value}}
    for said in (
        set_k(value),
        {**set_k(value), "holding": True},
        {"type": "typed", "name": "k", "text": str(value)},
        {"type": "open", "state": state},
        {"type": "open", "state": state, "carried": True},
    ):
        answer = page.send({**said, "number": 4})
        assert answer == {**before, "problems": [SORRY], "answer": 4}
        assert page.now is stood, said
    assert answer["state"]["parameters"] == {"k2": 2.0}
    assert page.send(set_k(9.0, 5))["settings"]["k"]["value"] == 9.0


def test_a_message_that_sets_nothing_is_answered_too() -> None:
    answer = Page(Faulty()).send({"type": "about", "number": 2})
    assert (answer["answer"], answer["notes"]) == (2, [SORRY])


def test_a_message_that_comes_again_is_answered_and_not_applied_again() -> None:
    page = Page(Faulty())
    message = {"type": "set", "values": {"k": 9.0}, "number": 3}
    first = page.send(message)
    page.session.now = with_values(page.now, {"k": 10.0})
    again = page.send(message)
    assert (first["answer"], again["answer"]) == (3, 3)
    assert (first["settings"]["k"]["value"], again["settings"]["k"]["value"]) == (9.0, 10.0)
    page.send(message | {"number": 4})
    assert page.scene.values["k"] == 9.0


def test_a_refusal_whose_answer_was_lost_is_sent_again() -> None:
    page = Page(Faulty())
    first, again = (page.send({"type": "typed", "name": "k", "text": "hum", "number": 5}) for _ in range(2))
    assert first == again
    assert "k" in again["errors"]


@pytest.mark.parametrize("value", [*UNEXPECTED, 8.0])
def test_a_link_that_goes_wrong_opens_the_scene_without_it(value: float) -> None:
    told = opened({"faulty": Faulty}, Link("faulty", {"k": value, "k2": 3.0}, ["hum: unknown."]))
    facts = unpacked(told.opening())
    assert facts["problems"] == ["hum: unknown.", LINK_LOST]
    assert facts["query"] == "scene=faulty"


@pytest.mark.parametrize("value", REFUSED)
def test_a_link_that_is_refused_says_why(value: float) -> None:
    facts = unpacked(opened({"faulty": Faulty}, Link("faulty", {"k": value})).opening())
    assert facts["problems"] == [f"{BEYOND} The link's parameters were not used."]


def test_the_log_has_each_place_once(caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch) -> None:
    log = logging.getLogger("components.quantities.refusals")
    monkeypatch.setattr(log, "filters", [Once()])
    page = Page(Faulty())
    for number in range(6):
        page.send(set_k((1.0, 5.0)[number % 2], number))
    assert [record.levelname for record in caplog.records] == ["WARNING", "ERROR"]
    refused, unexpected = caplog.records
    assert refused.exc_info is None
    assert unexpected.exc_info is not None
    assert "KeyError: 'nothing'" in caplog.text
    assert f"{__file__}:" in refused.getMessage()


def test_numpy_warns_of_nothing_while_a_picture_is_made() -> None:
    with np.errstate(all="warn"), pytest.raises(ValueError, match="range of doubles"), in_words():
        np.float64(1e300) * 1e300


@pytest.mark.parametrize("query", EXTREME_LINKS)
def test_a_link_to_numbers_beyond_doubles_opens_a_page_that_works(query: str) -> None:
    link = read_query({name: [text.encode() for text in given] for name, given in parse_qs(query).items()}, SCENES)
    session = opened(SCENES, link)
    facts = unpacked(session.opening())
    if facts["problems"]:
        assert facts["query"] == unpacked(opened(SCENES, Link(link.slug)).opening())["query"]
        assert "not used" in facts["problems"][0]
    else:
        assert {name: getattr(session.now.scene, name) for name in link.values} == link.values
    assert Page(session.now.scene).send({"type": "set", "values": {"m1": 3.0}, "number": 1})["errors"] == {}


@pytest.mark.parametrize(
    ("slug", "values"),
    [
        ("driven", {"kind": "base", "Y": 5e7, "omega": 4.4e-300, "k": 3.948e-149, "c": 2513000.0}),
        ("driven", {"kind": "base", "omega": 4.398, "m": 1e-06, "zeta": 2e299, "keep": "zeta"}),
        ("absorber", {"own": True, "m1": 1e152, "k1": 2.5e-295, "k2": 3.6864e10, "view": "rest"}),
    ],
)
def test_an_axis_that_doubles_cannot_have_is_refused_in_a_sentence(slug: str, values: dict[str, Any]) -> None:
    """Not in the words of Python, "cannot convert float NaN to integer"."""
    with pytest.raises(ValueError, match="the range of doubles"):
        SCENES[slug](**values)
