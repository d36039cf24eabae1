"""The worker process: one job at a time, one second of CPU each, networks in turn, and failing jobs."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future
from contextlib import closing
from functools import partial

import pytest

from components.language.messages import Given
from components.scenes import SCENES
from components.serving import worker_process
from components.serving.worker_process import (
    ALLOWANCE,
    BUSY,
    FILE_TOO_LONG,
    FIT_TOO_LONG,
    GONE,
    LATE,
    OF_A_NETWORK,
    SHARED,
    USED_UP,
    WAITING,
    WALK_TOO_LONG,
    ReadingProcess,
)
from components.session.exports import LinkExport
from components.session.measured import Fitting
from components.session.session import ONE_AT_A_TIME, Session
from components.session.worker import Reading, Replied, Teaching, WorkerJob
from components.state.page_state import fitted
from components.state.wire import Packet
from tests.page.headless_page import unpacked

MINE = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'
READ = Reading("mine", MINE)
GREEDY, CALM = "192.0.2.0/24", "198.51.100.0/24"


def hanging() -> closing[ReadingProcess]:
    """A worker process in which some jobs never end. It ends with the test."""
    return closing(ReadingProcess("tests.serving.hanging"))


@pytest.fixture(scope="module")
def beside() -> Iterator[ReadingProcess]:
    one = ReadingProcess("reading")
    yield one
    one.close()


def test_a_walk_is_read_and_answered_in_a_process_of_its_own(beside: ReadingProcess) -> None:
    read = beside.ask(Reading("mine", MINE)).result(120)
    assert read.refused == "" and read.walk and read.sheet and read.sheet.steps[0].opens.step == "mine/one"
    given = Given(walk="mine", step="one", option=0)
    told = beside.ask(Teaching(given, read.walk.steps[0])).result(30)
    assert told.taught and told.taught.lesson and told.taught.lesson.right
    assert beside.ask(Reading("mine", "title = 1")).result(30).refused.startswith("mine: ")
    assert beside.pending == 0


def test_what_takes_longer_is_refused_and_the_next_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker_process, "PATIENCE", 100.0)  # for a second of CPU on a busy machine
    with hanging() as beside:
        endless = LinkExport({"scene": [b"endless"]}, "")
        asked = [beside.ask(job) for job in (READ, Reading("endless", MINE), READ, endless, READ)]
        assert [one.result(120).refused for one in asked] == ["read", WALK_TOO_LONG, "read", FILE_TOO_LONG, "read"]
        monkeypatch.setattr(worker_process, "PATIENCE", 0.2)
        assert beside.ask(Reading("asleep", MINE)).result(120).refused == LATE  # it has used no CPU time


def test_a_fit_that_takes_too_long_ends_with_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker_process, "FIT_PATIENCE", 100.0)
    with hanging() as beside:
        assert beside.ask(Fitting([], [[]], 2, 0)).result(120).refused == FIT_TOO_LONG
        monkeypatch.setattr(worker_process, "FIT_PATIENCE", 0.2)
        assert beside.ask(Fitting([], [[]], 1, 0)).result(120).refused == LATE
        assert beside.ask(READ).result(120).refused == "read"


def test_a_fit_that_waits_can_be_cancelled_and_another_one_takes_its_place(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker_process, "FIT_PATIENCE", 100.0)
    session = Session(fitted(SCENES["damped"]().value))
    sent: list[Packet] = []
    session.send = sent.append
    rows = {"type": "rows", "piece": 0, "of": 1, "t": [0.0, 1.0], "columns": [[0.0, 1.0]]}
    with hanging() as beside:
        session.worker = beside
        endless = beside.ask(Reading("endless", MINE))
        session.handle({**rows, "number": 1})
        assert beside.pending == 2 and not sent
        session.handle({**rows, "number": 1})
        assert beside.pending == 2 and not sent, "a repeated message is answered once"
        session.handle({"type": "cancel_fit", "number": 2})
        session.handle({**rows, "size": 2, "number": 3})
        assert [unpacked(one)["answer"] for one in sent] == [2]
        assert endless.result(120).refused == WALK_TOO_LONG
        beside.ask(READ).result(120)
        answers = [unpacked(one) for one in sent]
        assert [one["answer"] for one in answers] == [2, 3] and answers[1]["refused"] == FIT_TOO_LONG


def test_who_cannot_be_started_is_said() -> None:
    beside = ReadingProcess("tests.serving.no_such_module")
    assert beside.ask(Reading("mine", MINE)).result(120).refused == GONE
    beside.close()


def test_a_bounded_number_waits() -> None:
    with hanging() as beside:
        asked = [beside.ask(Reading("endless", MINE)), *(beside.ask(READ) for _ in range(WAITING + 3))]
        refused = [one.result(120).refused for one in asked]
        assert refused[0] == WALK_TOO_LONG and refused[-1] == BUSY and set(refused[1:]) == {"read", BUSY}


def test_networks_take_turns() -> None:
    done: list[str] = []

    def note(network: str, reply: Future[Replied]) -> None:
        if not reply.result().is_busy:
            done.append(network)

    with hanging() as beside:
        asked = [beside.ask(Reading("endless", MINE), GREEDY)]
        asked += [beside.ask(READ, GREEDY) for _ in range(OF_A_NETWORK + 3)]
        asked += [beside.ask(READ, other) for other in (CALM, "", CALM)]
        networks = [*[GREEDY] * (OF_A_NETWORK + 4), CALM, "", CALM]
        for network, one in zip(networks, asked, strict=True):
            one.add_done_callback(partial(note, network))
        replies = [one.result(120).refused for one in asked]
        assert replies.count(SHARED) in (3, 2) and replies[-3:] == ["read"] * 3
        assert done[:5] == [GREEDY, CALM, "", GREEDY, CALM]


def test_a_network_that_has_used_its_time_is_refused_for_a_while(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker_process, "ALLOWANCE", 2)
    with hanging() as beside:
        assert ALLOWANCE > 2
        for _ in range(2):
            beside.ask(Reading("endless", MINE), GREEDY).result(120)
        refused = beside.ask(READ, GREEDY).result(120)
        assert refused.refused == USED_UP and refused.is_busy and 0 < refused.after < 60
        assert beside.ask(READ, CALM).result(120).refused == "read"


def test_a_job_that_nobody_waits_for_is_left_out() -> None:
    with hanging() as beside:
        first, left = beside.ask(Reading("endless", MINE)), beside.ask(Reading("endless", MINE))
        last = beside.ask(READ)
        assert left.cancel() and first.result(120).refused == WALK_TOO_LONG and last.result(120).refused == "read"
        assert beside.pending == 0


class Slow:
    """A worker that replies when the test says so."""

    def __init__(self) -> None:
        self.asked: list[tuple[WorkerJob, Future[Replied]]] = []
        self.networks: list[str] = []

    def ask(self, asked: WorkerJob, network: str = "") -> Future[Replied]:
        future: Future[Replied] = Future()
        self.asked.append((asked, future))
        self.networks.append(network)
        return future


def test_a_session_has_one_job_at_a_time_and_continues_meanwhile() -> None:
    session, process, packets = Session(fitted(SCENES["coupled"]().value), scenes=SCENES), Slow(), list[Packet]()
    session.send, session.worker, session.network = packets.append, process, "192.0.2.0/24"
    for number in (1, 1, 2):  # the second is a repetition of the first by a page that has waited long
        session.handle({"type": "walk", "name": "mine", "text": MINE, "number": number})
    session.handle({"type": "set", "values": {"k2": 3.0}, "number": 3})
    refused, moved = map(unpacked, packets)
    assert (refused["answer"], refused["refused"]) == (2, ONE_AT_A_TIME)
    assert (moved["answer"], moved["errors"]) == (3, {})
    ((_, future),) = process.asked
    assert process.networks == ["192.0.2.0/24"]
    future.set_result(Replied(refused=WALK_TOO_LONG))
    told = unpacked(packets[-1])
    assert (told["answer"], told["sheet"], told["refused"]) == (1, None, WALK_TOO_LONG)
    session.handle({"type": "walk", "name": "mine", "text": MINE, "number": 4})
    session.close()
    assert process.asked[1][1].cancelled()
