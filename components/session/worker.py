"""The jobs of the worker process: walks from visitors' files, files of numbers, and fits of measured records.

Each may take longer than a visitor's change, so it must not run in the server's event loop.
"""

from __future__ import annotations

import math
import signal
from collections.abc import Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from time import process_time
from typing import BinaryIO, Protocol, TypeAlias

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from components.language.messages import File, Fitted, Given, Taught
from components.language.walk import WalkSheet
from components.quantities.refusals import SORRY, report
from components.session.exports import AboutExport, LinkExport, PageExport, about_page, link_file, page_file
from components.session.measured import Fitting, fitted
from components.state.wire import Packet
from components.walks import Walks
from components.walks.cards import walk_sheet
from components.walks.checking import problems
from components.walks.judging import reply_to
from components.walks.links import Scenes
from components.walks.registry import read_own
from components.walks.walk import Step, Walk
from physics.fit import FEW_ROWS, fit_damped

BUDGET = 1.0
"""CPU seconds for one job."""
LARGEST = 1_000_000
"""Maximum size of a walk's sheet in bytes; markup is longer than its source."""


class Reading(Struct, frozen=True, tag=True):
    """The job to read and check a walk's file."""

    name: str
    text: str


class Teaching(Struct, frozen=True, tag=True):
    """The job to judge an answer to a step of a walk that has been read."""

    given: Given
    step: Step


WorkerJob: TypeAlias = Reading | Teaching | PageExport | LinkExport | AboutExport | Fitting


class Replied(Struct, frozen=True, kw_only=True):
    """The result of a job, or the reason why there is none.

    `is_busy`: the reason is temporary, and another try is possible in `after` seconds, if known. `seconds` is the CPU
    time.
    """

    walk: Walk | None = None
    sheet: WalkSheet | None = None
    taught: Taught | None = None
    file: File | None = None
    packet: Packet | None = None
    fitted: Fitted | None = None
    refused: str = ""
    is_busy: bool = False
    after: float = 0.0
    seconds: float = 0.0


class Worker(Protocol):
    """A worker, whose jobs may come from any thread; `network` is the visitor's network, if known."""

    def ask(self, asked: WorkerJob, network: str = "") -> Future[Replied]: ...


class Here:
    """A worker that does each job at once, for tests and notebooks."""

    def __init__(self, walks: Walks, scenes: Scenes) -> None:
        self._walks, self._scenes = walks, scenes

    def ask(self, asked: WorkerJob, network: str = "") -> Future[Replied]:
        future: Future[Replied] = Future()
        future.set_result(replied(asked, self._walks, self._scenes))
        return future


def replied(asked: WorkerJob, walks: Walks, scenes: Scenes) -> Replied:
    """Return the result of a job, or a reason in words; it raises nothing."""
    try:
        return _result(asked, walks, scenes)
    except ValueError as reason:
        return Replied(refused=str(reason))
    except Exception as error:
        report(error)
        return Replied(refused=SORRY)


def _result(asked: WorkerJob, walks: Walks, scenes: Scenes) -> Replied:
    match asked:
        case Reading():
            return _read(asked, walks, scenes)
        case Teaching():
            return Replied(taught=reply_to(asked.given, asked.step, scenes))
        case PageExport():
            return Replied(packet=page_file(asked, scenes))
        case LinkExport():
            return Replied(file=link_file(asked.query, asked.page, scenes, walks))
        case AboutExport():
            return Replied(packet=about_page(asked, scenes))
        case Fitting():
            return Replied(fitted=fitted(asked))


def _read(asked: Reading, walks: Walks, scenes: Scenes) -> Replied:
    walk = read_own(asked.text, asked.name, walks, scenes)
    sheet = walk_sheet(walk, scenes)
    if len(msgspec.json.encode(sheet)) > LARGEST:
        raise ValueError(f"{asked.name}: its questions make more than {LARGEST} bytes of a page.")
    return Replied(walk=walk, sheet=sheet)


def prepare(walks: Walks, scenes: Scenes) -> None:
    """Read the built-in walks and fit a motion in advance. This fills the caches that all jobs share."""
    fit_damped(range(FEW_ROWS), [math.sin(t) for t in range(FEW_ROWS)])
    for walk in walks.values():
        list(problems(walk, scenes))
        walk_sheet(walk, scenes)


def work(walks: Walks, scenes: Scenes, come_in: BinaryIO, go_out: BinaryIO) -> None:
    """Reply to jobs until the input ends; the first message says that the process is ready."""
    send(go_out, b"")
    while message := receive(come_in):
        begun = process_time()
        with _budget():
            reply = replied(msgspec.msgpack.decode(message, type=WorkerJob), walks, scenes)
        send(go_out, msgspec.msgpack.encode(replace(reply, seconds=process_time() - begun)))


@contextmanager
def _budget() -> Iterator[None]:
    """End a job that exceeds its time. The system ends the process whatever it does."""
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
    """Return the next message; None if the other side has closed."""
    size = stream.read(4)
    if len(size) < 4:
        return None
    message = stream.read(int.from_bytes(size, "big"))
    return message if len(message) == int.from_bytes(size, "big") else None
