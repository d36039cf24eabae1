"""Every message of the browser while its handler fails: the visitor gets an error, and the page is unchanged."""

from __future__ import annotations

from typing import Any, get_args

import pytest

from components.language.messages import BrowserMessage
from components.quantities.refusals import SORRY
from components.scenes import SCENES
from tests.page.headless_page import Page

TIMES = [0.1 * i for i in range(40)]
STATE = "components.session.session.changed"
ANSWER = {"walk": "d31", "step": "d31-03", "option": 0}
HANDLERS: dict[str, tuple[dict[str, Any], str]] = {
    "set": ({"values": {"k": 50.0}}, STATE),
    "typed": ({"name": "k", "text": "50"}, STATE),
    "act": ({"name": "fit"}, STATE),
    "choose": ({"name": "view", "value": "roots"}, STATE),
    "open": ({"state": {"scene": "damped", "parameters": {"k": 50.0}}}, STATE),
    "run": ({"order": "start"}, "tests.page.test_faulty_handlers.Working.obey"),
    "given": ({"answer": ANSWER}, "components.session.session.taught"),
    "walk": ({"name": "mine.toml", "text": "title = 1"}, "components.session.worker.read_own"),
    "lead": ({"code": "ABCD", "key": "key"}, "tests.page.test_faulty_handlers.Working.lead"),
    "csv": ({"page": "http://here/"}, "components.session.worker.page_file"),
    "about": ({}, "components.session.worker.about_page"),
    "rows": ({"piece": 0, "of": 1, "t": TIMES, "columns": [TIMES]}, "components.session.worker.fitted"),
}
"""For each kind of message: an example, and the function that fails when it arrives."""
NOTHING_FAILS = {"cancel_fit"}
"""Its handler calls no function of another module."""


class Working:
    """Background work and a class that can be led, in place of those of the session."""

    def obey(self, order: str, scene: object) -> None:
        """Fail only if a test says so."""

    def lead(self, code: str, key: str) -> None:
        """Fail only if a test says so."""

    def close(self) -> None:
        """There is nothing to close."""


def fail(*given: object, **named: object) -> None:
    raise RuntimeError("The handler is broken")


def test_every_message_has_a_handler_that_can_fail() -> None:
    assert HANDLERS.keys() | NOTHING_FAILS == {kind.__struct_config__.tag for kind in get_args(BrowserMessage)}


@pytest.mark.parametrize("kind", HANDLERS)
def test_a_failing_handler_is_reported_and_the_page_continues(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    page = Page(SCENES["damped"]())
    if kind == "run":
        monkeypatch.setattr(page.session, "running", Working())
    if kind == "lead":
        monkeypatch.setattr(page.session, "lead", lambda code, key: Working().lead(code, key))
    stood, (said, broken) = page.now, HANDLERS[kind]
    with monkeypatch.context() as patch:
        patch.setattr(broken, fail)
        answer = page.send({"type": kind, **said, "number": 4})
    assert (answer["answer"], SORRY in str(answer)) == (4, True), answer
    assert page.now == stood
    monkeypatch.setattr(page.session, "running", None)
    told = page.send({"type": "set", "values": {"k": 77.0}, "number": 5})
    assert (told["answer"], told["settings"]["k"]["value"]) == (5, 77.0)
