"""A visitor's page without a browser: what it is told is held against what every answer must keep to."""

from __future__ import annotations

from time import process_time
from typing import Any

import numpy as np

from components.quantities.refusals import LINK_LOST, SORRY
from components.scenes import SCENES
from components.session.opening import opened
from components.state.link import Link, read_query
from tests.attack.extremes import Message, Values
from tests.page.headless_page import unpacked
from tests.scenes.checks import as_arguments, check_picture

PASSING = ("answer", "errors", "problems")
"""The fields of an answer that are about its message alone."""


STRANGE = ("is no curve of this scene.", "is not an axis of this picture.")
"""BrowserMessage of names that a state keeps all the same: messages put anything there."""


class Visit:
    """A page, opened by a link; every message it sends is checked as it is answered."""

    def __init__(self, link: Link) -> None:
        begun = process_time()
        self.session = opened(SCENES, link)
        self.slowest = process_time() - begun
        told = unpacked(self.session.opening())
        assert LINK_LOST not in told["problems"], "an unexpected error"
        self.now = lasting(told)
        if "parameters were not used" in " ".join(told["problems"]):
            assert same(self.now, bare(link.slug)), "a refused link leaves traces"
        self.packets: list[dict[str, Any]] = []
        self.session.send = self.packets.append

    def say(self, message: Message, number: int) -> dict[str, str]:
        """Send a message; what of it is refused."""
        before, begun = self.now, process_time()
        self.session.handle({**message, "number": number})
        self.slowest = max(self.slowest, process_time() - begun)
        told = unpacked(self.packets.pop())
        assert not self.packets, "a message has two answers"
        assert told["answer"] == number
        assert SORRY not in str({name: part for name, part in told.items() if name != "view"}), "an unexpected error"
        if told["type"] != "shown":
            return {}
        self.now = lasting(told)
        if told["errors"]:
            assert same(self.now, before), "a refused message leaves traces"
        assert same(self.now, lasting(unpacked(self.session.opening()))), "what is shown is not what was sent"
        return dict(told["errors"])

    def leave(self) -> None:
        """End the visit: the last picture can be drawn, and its link brings it back."""
        check_picture(self.session.now)
        link = read_query(as_arguments(self.now["query"]), SCENES)
        again = unpacked(opened(SCENES, link).opening())
        refused = [problem for problem in again["problems"] if not problem.endswith(STRANGE)]
        assert (refused, again["query"]) == ([], self.now["query"]), "the link does not lead back"


def lasting(told: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in told.items() if name not in PASSING}


def same(one: Any, other: Any) -> bool:
    """Whether two messages are equal, their columns to the last bit."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(same(one[name], other[name]) for name in one)
    if isinstance(one, np.ndarray):
        return isinstance(other, np.ndarray) and one.tobytes() == other.tobytes()
    return bool(one == other)


def bare(slug: str) -> dict[str, Any]:
    """A scene without a link."""
    return lasting(unpacked(opened(SCENES, Link(slug)).opening()))


def visit(slug: str, given: Values, deeds: list[Message]) -> float:
    """Open a link with these values and do these things; how long the slowest answer took, in s of this process."""
    page = Visit(Link(slug, given))
    for number, message in enumerate(deeds):
        page.say(message, number)
    page.leave()
    return page.slowest


def follow(arguments: dict[str, list[bytes]]) -> None:
    """Open a link as it comes from the address."""
    Visit(read_query(arguments, SCENES))
