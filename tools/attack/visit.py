"""A visitor's page without a browser. Each answer is checked against rules that hold for all answers."""

from __future__ import annotations

from time import process_time
from typing import Any

import numpy as np

from components.quantities.refusals import LINK_LOST, SORRY
from components.scenes import SCENES
from components.session.opening import opened
from components.state.link import Link, read_query
from tests.page.headless_page import unpacked
from tests.scenes.checks import as_arguments, check_picture
from tools.attack.extremes import ExtremeValues, Message

PASSING = ("answer", "errors", "problems")
"""The fields of an answer that concern its message alone."""


STRANGE = ("is no curve of this scene.", "is not an axis of this picture.")
"""Ends of refusals of names that a state keeps anyway, because messages may contain any names."""


class Visit:
    """A page, opened by a link. Every answer to its messages is checked."""

    def __init__(self, link: Link) -> None:
        begun = process_time()
        self.session = opened(SCENES, link)
        self.slowest = process_time() - begun
        answer = unpacked(self.session.opening())
        assert LINK_LOST not in answer["problems"], "an unexpected error"
        self.now = lasting(answer)
        if "parameters were not used" in " ".join(answer["problems"]):
            assert same(self.now, bare(link.slug)), "a refused link leaves traces"
        self.packets: list[dict[str, Any]] = []
        self.session.send = self.packets.append

    def send(self, message: Message, number: int) -> dict[str, str]:
        """Send a message and return its refusals."""
        before, begun = self.now, process_time()
        self.session.handle({**message, "number": number})
        self.slowest = max(self.slowest, process_time() - begun)
        answer = unpacked(self.packets.pop())
        assert not self.packets, "a message has two answers"
        assert answer["answer"] == number
        assert SORRY not in str({name: part for name, part in answer.items() if name != "view"}), "an unexpected error"
        if answer["type"] != "shown":
            return {}
        self.now = lasting(answer)
        if answer["errors"]:
            assert same(self.now, before), "a refused message leaves traces"
        assert same(self.now, lasting(unpacked(self.session.opening()))), "what is shown is not what was sent"
        return dict(answer["errors"])

    def leave(self) -> None:
        """End the visit. The last picture can be drawn, and its link opens the same picture."""
        check_picture(self.session.now)
        link = read_query(as_arguments(self.now["query"]), SCENES)
        again = unpacked(opened(SCENES, link).opening())
        refused = [problem for problem in again["problems"] if not problem.endswith(STRANGE)]
        assert (refused, again["query"]) == ([], self.now["query"]), "the link does not lead back"


def lasting(answer: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in answer.items() if name not in PASSING}


def same(one: Any, other: Any) -> bool:
    """Return True if two messages are equal, including every bit of their columns."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(same(one[name], other[name]) for name in one)
    if isinstance(one, np.ndarray):
        return isinstance(other, np.ndarray) and one.tobytes() == other.tobytes()
    return bool(one == other)


def bare(slug: str) -> dict[str, Any]:
    """Open a scene without values in the link."""
    return lasting(unpacked(opened(SCENES, Link(slug)).opening()))


def visit(slug: str, given: ExtremeValues, messages: list[Message]) -> float:
    """Open a link with these values, send messages, and return the CPU time of the slowest answer in s."""
    page = Visit(Link(slug, given))
    for number, message in enumerate(messages):
        page.send(message, number)
    page.leave()
    return page.slowest


def follow(arguments: dict[str, list[bytes]]) -> None:
    """Open a link as it comes from the address bar."""
    Visit(read_query(arguments, SCENES))
