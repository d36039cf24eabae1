"""Walks from strangers' files: what is asked of them, and done where it takes nobody else's time."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from typing import BinaryIO, Protocol, TypeAlias

import msgspec
from msgspec import Struct

from components.language.messages import Given, Taught
from components.language.walk import WalkSheet
from components.quantities.refusals import SORRY, report
from components.walks import Walks
from components.walks.cards import walk_sheet
from components.walks.checking import problems
from components.walks.judging import told_of
from components.walks.links import Scenes
from components.walks.registry import read_own
from components.walks.walk import Step, Walk

BUDGET = 1.0
"""Seconds of a processor for one request."""
LARGEST = 1_000_000
"""Bytes of a sheet: markup is longer than what it is made of."""
TOO_LONG = f"Checking this walk takes more than {BUDGET:g} s here: give it fewer steps, links and formulas."


class Reading(Struct, frozen=True, tag=True):
    """A walk's file, to be read and checked."""

    name: str
    text: str


class Teaching(Struct, frozen=True, tag=True):
    """An answer to a step of a walk that has been read."""

    given: Given
    step: Step


Errand: TypeAlias = Reading | Teaching


class Replied(Struct, frozen=True, kw_only=True):
    """A walk and its sheet, what a step teaches, or why there is neither: if others come first, now only."""

    walk: Walk | None = None
    sheet: WalkSheet | None = None
    taught: Taught | None = None
    refused: str = ""
    is_busy: bool = False


class Apart(Protocol):
    """A reader of strangers' files: it takes requests from any thread, from `network`, if that is known."""

    def ask(self, asked: Errand, network: str = "") -> Future[Replied]: ...


class Here:
    """A reader that does at once what is asked: where there is nobody who would wait."""

    def __init__(self, walks: Walks, scenes: Scenes) -> None:
        self._walks, self._scenes = walks, scenes

    def ask(self, asked: Errand, network: str = "") -> Future[Replied]:
        future: Future[Replied] = Future()
        future.set_result(replied(asked, self._walks, self._scenes))
        return future


def replied(asked: Errand, walks: Walks, scenes: Scenes) -> Replied:
    """The reply, whatever happens."""
    try:
        if isinstance(asked, Teaching):
            return Replied(taught=told_of(asked.given, asked.step, scenes))
        walk = read_own(asked.text, asked.name, walks, scenes)
        sheet = walk_sheet(walk, scenes)
        if len(msgspec.json.encode(sheet)) > LARGEST:
            raise ValueError(f"{asked.name}: its questions make more than {LARGEST} bytes of a page.")
        return Replied(walk=walk, sheet=sheet)
    except ValueError as reason:
        return Replied(refused=str(reason))
    except Exception as error:
        report(error)
        return Replied(refused=SORRY)


def prepare(walks: Walks, scenes: Scenes) -> None:
    """Read the lecture's own walks, so that no file pays for what all scenes work out once."""
    for walk in walks.values():
        list(problems(walk, scenes))
        walk_sheet(walk, scenes)


def work(walks: Walks, scenes: Scenes, come_in: BinaryIO, go_out: BinaryIO) -> None:
    """Reply to requests until there are no more; the first word says that all is ready."""
    send(go_out, b"")
    while message := receive(come_in):
        with _budget():
            reply = msgspec.msgpack.encode(replied(msgspec.msgpack.decode(message, type=Errand), walks, scenes))
        send(go_out, reply)


@contextmanager
def _budget() -> Iterator[None]:
    """The system ends a process whose time is over, whatever it does."""
    timed = hasattr(signal, "setitimer")
    if timed:
        signal.setitimer(signal.ITIMER_PROF, BUDGET)
    yield
    if timed:
        signal.setitimer(signal.ITIMER_PROF, 0)


def send(stream: BinaryIO, message: bytes) -> None:
    stream.write(len(message).to_bytes(4, "big") + message)
    stream.flush()


def receive(stream: BinaryIO) -> bytes | None:
    """The next message; None where the other side has gone."""
    size = stream.read(4)
    if len(size) < 4:
        return None
    message = stream.read(int.from_bytes(size, "big"))
    return message if len(message) == int.from_bytes(size, "big") else None
