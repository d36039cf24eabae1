"""Refusals change nothing and give a reason. An unexpected error of any function is answered, the page is unchanged and
continues, and the log has it once.
"""

import decimal
import logging
import math
import sys
from collections.abc import Callable
from types import CodeType, FrameType
from typing import Any

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
from components.session import session
from components.session.opening import opened
from components.state.commands import RefusalError
from components.state.link import Link
from components.state.wire import packed
from tests.grids import WHOLE
from tests.page.headless_page import Page, set_values, unpacked

LONG = "x" * 100_000
NESTED: list[Any] = []
for _ in range(200):
    NESTED = [NESTED]
MASS = "−1 kg is not possible: a mass is a finite number above 0."
STILL = "Still drawn as before."
Message = dict[str, Any]


def put(**values: Any) -> Message:
    return {"type": "set", "values": values}


def typed(name: str, text: str) -> Message:
    return {"type": "typed", "name": name, "text": text}


def choose(name: str, value: Any) -> Message:
    return {"type": "choose", "name": name, "value": value}


def state(scene: str = "forced", *, carried: bool = False, **parts: Any) -> Message:
    return {"type": "open", "state": {"scene": scene, **parts}, "carried": carried}


NO_AXIS = {"kind": "base", "omega": 4.398, "m": 1e-06, "zeta": 2e299, "keep": "zeta"}
NO_TICKS = {"own": "true", "m1": 1e152, "k1": 2.5e-295, "k2": 3.6864e10, "view": "rest"}
"""Once refused in the words of Python, "cannot convert float NaN to integer"."""
ENDLESS = {"view": "formulas", "window": 1.04e-268, "m": 1e-160, "k": 5e-324}
"""A period that is 1e350 windows long: once an error, because the end of its path had no place on the time axis."""
WORDED: list[tuple[str, Message, str, str]] = [
    ("coupled", put(k2=-1.0), "k2", "−1 N/m is not possible: a stiffness is a finite number, 0 or more. Still drawn"),
    ("coupled", put(k2=3.0, m1=-1.0), "m1", f"{MASS} Still drawn with 2.00."),
    ("coupled", {**put(m1=0.0), "holding": True}, "m1", "0 kg is not possible: a mass"),
    ("forced", put(omega=1e300), "omega", ""),
    ("phugoid", put(v_0=-3.048), "v_0", "−10.0 ft/s is not possible"),
    ("phugoid", put(v_0=math.nan), "v_0", "nan ft/s is not possible"),
    ("coupled", typed("k2", "two"), "k2", "“two” is not a number: type one such as 2.5 or 1e-3. Still drawn with"),
    ("coupled", typed("name", "1"), "name", "“name” is not a parameter of this scene."),
    ("phugoid", typed("excess", "-200"), "excess", "−200 ft/s is not possible: an excess of speed is from −v₀"),
    ("coupled", choose("view", "loud"), "view", "“loud” is not possible: choose one of "),
    ("coupled", {"type": "act", "name": "nothing"}, "action", "“nothing” is not an action of this scene."),
    ("coupled", {"type": "run", "order": "start"}, "run", "“start” is not possible: there is nothing to run here."),
    ("coupled", state("nowhere"), "state", "“nowhere” is not a scene."),
    ("coupled", state(parameters={"k9": 1.0}), "state", "“k9” is not a parameter of this scene."),
    ("coupled", state(parameters={"m1": -1.0}), "state", f"m1: {MASS}"),
    ("coupled", state(parameters={"m1": "heavy"}), "state", "m1: 'heavy' is not possible"),
    ("coupled", state(parameters={"curve": "loud"}), "state", "curve: “loud” is not possible: choose one of"),
    ("coupled", state(parameters={"omega": 1e300}, carried=True), "state", ""),
    ("coupled", state(parameters={"hidden": ["x1"]}), "state", "“hidden” is not a parameter"),
    ("coupled", state(hidden=["<b>"]), "state", "“<b>” is not possible"),
    ("coupled", state("coupled", held={"m1": -1.0}), "state", f"m1: {MASS}"),
    ("coupled", state("coupled", covered=["plot:x9"]), "state", "“plot:x9” cannot be covered here."),
    ("coupled", state("coupled", frame={"ranges": {"x": [1.0, 1.0]}}), "state", "The range of “x” is from 1.0 to 1.0"),
    ("coupled", state("coupled", frame={"window": 0.0}), "state", "The window of a frame is 0.0"),
    ("coupled", state("coupled", frame={"speed": -1.0}), "state", "The speed of a frame is −1.0"),
    ("coupled", state("driven", parameters=NO_AXIS), "state", BEYOND),
    ("coupled", state("absorber", parameters=NO_TICKS), "state", BEYOND),
    ("coupled", state("oscillator", parameters=ENDLESS), "state", BEYOND),
]  # fmt: skip
"""A scene, a message, and where and how it is refused; "" for a reason of the physics."""
MALFORMED: list[Any] = [
    *(None, [], "set", {}, {"type": ["set"]}, {"type": np.arange(3)}, {"type": "unknown"}),
    *({"type": "set", "values": one} for one in (None, {5: 1.0}, {LONG: 1.0}, {f"k{i}": 1.0 for i in range(1000)})),
    *(put(k2=value) for value in (LONG, NESTED, np.arange(3), math.nan, 10**4000, True, "three")),
    *(typed(LONG, "1"), typed("k2", LONG), typed("k2", "\ud800"), {"type": "act", "name": LONG}),
    *(choose(LONG, "1"), choose("hidden", LONG), choose("hidden", NESTED), choose("energy", math.inf)),
    *({"type": "run", "order": order} for order in (LONG, "skip it")),
    *({"type": "open", "state": one} for one in (None, 3, {}, {"scene": 3}, {"scene": "coupled", "hidden": [{}]})),
]  # fmt: skip


def check_unchanged(page: Page, message: Any) -> tuple[str, str]:
    """Send a message that is refused; return where and how."""
    before, now = page.opening(), page.now
    told = page.send(message)
    assert page.now is now
    assert {**told, "errors": {}, "answer": None, "view": None} == {**before, "view": None}
    ((where, says),) = told["errors"].items()
    assert 0 < len((where + says).encode()) < 400
    return where, says


@pytest.mark.parametrize(("slug", "message", "name", "says"), WORDED)
def test_a_refused_message_says_why_and_changes_nothing(slug: str, message: Message, name: str, says: str) -> None:
    where, reason = check_unchanged(Page(SCENES[slug]()), {**message, "number": 7})
    assert where == name and reason.startswith(says) and reason.endswith(".")
    assert message["type"] != "open" or reason.endswith(STILL)


@pytest.mark.parametrize("message", MALFORMED, ids=lambda message: str(message)[:40])
def test_what_no_page_sends_is_refused_in_a_short_answer(message: Any) -> None:
    check_unchanged(Page(SCENES["coupled"]()), message)


@pytest.mark.parametrize("number", [None, math.nan, LONG, NESTED, np.arange(3), {"a": 1}, -1, 10**4000])
def test_only_a_number_is_sent_back_as_the_number_of_a_message(number: object) -> None:
    assert Page(SCENES["coupled"]()).send({**put(k2=-0.0), "number": number})["answer"] is None


LOST: dict[object, int] = {}
REFUSED: dict[float, Callable[[], object]] = {
    1.0: lambda: 2.0**1024,
    2.0: lambda: 1 / 0,
    3.0: lambda: np.array([1e300]) * 1e300,
    4.0: lambda: decimal.Decimal("-1").sqrt(),
}
UNEXPECTED: dict[float, Callable[[], object]] = {5.0: lambda: LOST["nothing"], 6.0: lambda: [LOST][7]}


class Faulty(Scene):
    """A scene that fails if k is 1 to 6, and whose picture cannot be sent if k is 7 or 8."""

    slug = title = headline = "faulty"
    lecture = "none"
    groups = ()
    k = stiffness(0.5, symbol="k")
    k2 = stiffness(0.5, symbol="k_2")

    @classmethod
    def sheet(cls) -> Block:
        return column()

    def picture(self, frame: Frame = FITTED) -> Picture:
        {**REFUSED, **UNEXPECTED}.get(self.k, int)()
        endless = float("inf") if self.k == 7.0 else self.k
        return Picture(columns={}, axes={}, scalars={"k": endless}, values={"k": object() if self.k == 8.0 else "k"})


@pytest.mark.parametrize("value", [*REFUSED, 7.0, *UNEXPECTED, 8.0])
def test_a_picture_that_cannot_be_drawn_or_sent_changes_nothing(value: float) -> None:
    """Arithmetic beyond doubles is refused in words; for an unexpected error the server apologizes."""
    page = Page(Faulty(k2=2.0))
    before, now, unexpected = page.opening(), page.now, value in (*UNEXPECTED, 8.0)
    told = {"problems": [SORRY]} if unexpected else {"errors": {"k": f"{BEYOND} Still drawn with 0.500."}}
    stated = told if unexpected else {"errors": {"state": f"{BEYOND} {STILL}"}}
    for said in (put(k=value), typed("k", str(value)), state("faulty", parameters={"k": value})):
        answer = page.send({**said, "number": 4})
        assert answer == {**before, **(stated if said["type"] == "open" else told), "answer": 4}
        assert page.now is now, said
    assert set_values(page, k=9.0)["settings"]["k"]["value"] == 9.0
    facts = unpacked(opened({"faulty": Faulty}, Link("faulty", {"k": value}, ["hum: unknown."])).opening())
    lost = LINK_LOST if unexpected else f"{BEYOND} The link's parameters were not used."
    assert (facts["problems"], facts["query"]) == (["hum: unknown.", lost], "scene=faulty")
    scene = Faulty()
    shown, held = scene.shown, scene.param.values()
    for change in (lambda: scene.set({"k2": 3.0, "k": value}), lambda: setattr(scene, "k", value)):
        if not unexpected:
            with pytest.raises(ValueError, match="range of doubles"):
                change()
        assert (scene.shown, scene.param.values()) == (shown, held)


def test_the_log_has_each_place_once(caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(logging.getLogger("components.quantities.refusals"), "filters", [Once()])
    page = Page(Faulty())
    for number in range(6):
        page.send({**put(k=(1.0, 5.0)[number % 2]), "number": number})
    refused, unexpected = caplog.records
    assert (refused.levelname, unexpected.levelname) == ("WARNING", "ERROR")
    assert refused.exc_info is None and unexpected.exc_info is not None
    assert "KeyError: 'nothing'" in caplog.text and f"{__file__}:" in refused.getMessage()


def test_numpy_warns_of_nothing_while_a_picture_is_made() -> None:
    with np.errstate(all="warn"), pytest.raises(ValueError, match="range of doubles"), in_words():
        np.float64(1e300) * 1e300


MESSAGES: dict[str, dict[str, Any]] = {
    "about": {},
    "act": {"name": ""},
    "choose": {"name": "view", "value": "roots"},
    "csv": {},
    "given": {"answer": {"walk": "", "step": ""}},
    "lead": {"code": "", "key": ""},
    "open": {"state": {"scene": "damped", "parameters": {"k": 50.0}}},
    "rows": {"piece": 0, "of": 1, "t": [], "columns": [[]]},
    "run": {"order": "cancel"},
    "set": {"values": {"k": 50.0}},
    "typed": {"name": "k", "text": "50"},
    "walk": {"name": "", "text": ""},
}
ANSWERS = (RefusalError.__init__.__code__, packed.__code__)
"""The handler has done its work when these are called."""
BROKEN = 40 if WHOLE else 6
"""Functions that fail, of each kind of message."""


def handled(page: Page, kind: str, broken: CodeType | None = None) -> tuple[list[CodeType], dict[str, Any]]:
    """Return the functions that a handler calls until its answer is known, and the answer. The one `broken` fails."""
    called: dict[CodeType, None] = {}

    def watch(frame: FrameType, event: str, argument: object) -> None:
        code = frame.f_code
        if code in ANSWERS:
            sys.setprofile(None)
        elif event == "call" and "/components/" in code.co_filename and code.co_filename != session.__file__:
            called[code] = None
            if code is broken:
                raise RuntimeError(f"{code.co_name} is broken")

    sys.setprofile(watch)
    try:
        answer = page.send({"type": kind, **MESSAGES[kind], "number": 4})
    finally:
        sys.setprofile(None)
    return list(called), answer


@pytest.mark.parametrize("kind", MESSAGES)
def test_a_failing_handler_is_reported_and_the_page_continues(kind: str) -> None:
    handled(Page(SCENES["damped"]()), kind)  # fills the caches
    called, _ = handled(Page(SCENES["damped"]()), kind)
    for broken in called[:: max(1, len(called) // BROKEN)]:
        page = Page(SCENES["damped"]())
        before = page.now
        reached, answer = handled(page, kind, broken)
        assert broken in reached
        assert (answer["answer"], SORRY in str(answer)) == (4, True), (broken, answer)
        assert page.now == before, broken
        told = set_values(page, k=77.0)
        assert (told["answer"], told["settings"]["k"]["value"]) == (2, 77.0)
