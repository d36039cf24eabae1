"""The worker process: one job at a time, one second of CPU each, networks in turn, and failing jobs."""

import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import Future
from contextlib import closing
from threading import Event

import msgspec
import pytest

from components.scenes import SCENES
from components.serving import worker_process as own
from components.serving.worker_process import ReadingProcess
from components.session import worker as jobs
from components.session.exports import LinkExport
from components.session.measured import Fitting
from components.session.session import ONE_AT_A_TIME, Session
from components.session.worker import Reading, Replied, WorkerJob
from components.state.page_state import fitted
from components.state.wire import Packet
from components.walks import Walks
from components.walks.links import Scenes
from tests.page.headless_page import unpacked
from tests.serving.served import FakeWorker

MINE = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'
READ, ENDLESS = Reading("mine", MINE), Reading("endless", MINE)
ASLEEP, SLOW_FIT = Reading("asleep", MINE), Fitting([], [[]], 1, 0)
GREEDY, CALM = "192.0.2.0/24", "198.51.100.0/24"


@pytest.mark.slow
def test_the_system_ends_a_job_that_uses_more_than_its_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(own, "PATIENCE", 100.0)  # for a second of CPU on a busy machine
    with closing(ReadingProcess("tests.serving.test_worker_process")) as beside:
        asked = [beside.ask(job) for job in (READ, ENDLESS, READ)]
        assert [one.result(120).refused for one in asked] == ["read", own.WALK_TOO_LONG, "read"]


def hangs(asked: WorkerJob, walks: Walks, scenes: Scenes) -> Replied:
    """Read nothing; the walk “endless” never ends."""
    while asked == ENDLESS:
        pass
    return Replied(refused="read")


def test_a_process_that_cannot_start_is_named() -> None:
    with closing(ReadingProcess("tests.serving.no_such_module")) as beside:
        assert beside.ask(READ).result(120).refused == own.GONE


GATE, BEGAN = Event(), Event()
"""A fake process finishes its jobs when the gate is open, and says when it has begun one."""


class FakeProcess:
    """A process that reads each walk, is ended for any other job by the system, and does not finish one asleep."""

    def __init__(self) -> None:
        self._out, self._killed, self.returncode = b"\0\0\0\0", Event(), -9
        self.stdin = self.stdout = self
        self.kill, self.communicate = self._killed.set, str

    def write(self, message: bytes) -> None:
        job = msgspec.msgpack.decode(message[4:], type=WorkerJob)
        BEGAN.set()
        if job in (ASLEEP, SLOW_FIT):
            self._killed.wait(60)
        elif GATE.wait(60) and job == READ:
            done = msgspec.msgpack.encode(Replied(refused="read"))
            self._out += len(done).to_bytes(4, "big") + done
        else:
            self.returncode = own.OVER_BUDGET

    def read(self, size: int) -> bytes:
        taken, self._out = self._out[:size], self._out[size:]
        return taken

    def flush(self) -> None:
        """Do nothing."""


@pytest.fixture
def worker(monkeypatch: pytest.MonkeyPatch) -> Iterator[ReadingProcess]:
    """A worker with fake processes."""
    monkeypatch.setattr(own, "started", lambda *_: FakeProcess())
    GATE.clear()
    BEGAN.clear()
    with closing(ReadingProcess("fake")) as one:
        yield one
        GATE.set()


def asked_after(worker: ReadingProcess, job: WorkerJob, networks: Sequence[str]) -> list[Future[Replied]]:
    """Ask for a job of the first network and, when the process has it, for the reading of a walk of each other one."""
    replies = [worker.ask(job, networks[0])]
    assert BEGAN.wait(60)
    return [*replies, *(worker.ask(READ, network) for network in networks[1:])]


def results(*asked: Future[Replied]) -> list[str]:
    return [one.result(60).refused for one in asked]


def test_a_job_that_takes_too_long_is_refused_in_words(worker: ReadingProcess, monkeypatch: pytest.MonkeyPatch) -> None:
    GATE.set()
    asked = [worker.ask(job) for job in (READ, ENDLESS, LinkExport({}, ""), Fitting([], [[]], 2, 0), READ)]
    assert results(*asked) == ["read", own.WALK_TOO_LONG, own.FILE_TOO_LONG, own.FIT_TOO_LONG, "read"]
    for patience, job in (("FIT_PATIENCE", SLOW_FIT), ("PATIENCE", ASLEEP)):
        monkeypatch.setattr(own, patience, 0.05)
        assert results(worker.ask(job)) == [own.LATE]


def test_a_bounded_number_waits_and_a_waiting_job_can_be_cancelled(worker: ReadingProcess) -> None:
    asked = asked_after(worker, READ, [""] * (own.WAITING + 4))
    assert asked.pop(1).cancel()
    GATE.set()
    assert results(*asked) == ["read"] * own.WAITING + [own.BUSY] * 3 and worker.pending == 0


def test_networks_take_turns(worker: ReadingProcess) -> None:
    done, networks = list[Future[Replied]](), [*[GREEDY] * (own.OF_A_NETWORK + 4), CALM, "", CALM]
    asked = asked_after(worker, ENDLESS, networks)
    for one in asked:
        one.add_done_callback(done.append)
    GATE.set()
    assert results(*asked) == [own.WALK_TOO_LONG, *["read"] * own.OF_A_NETWORK, *[own.SHARED] * 3, *["read"] * 3]
    order = [networks[asked.index(one)] for one in done if not one.result().is_busy]
    assert order[:5] == [GREEDY, CALM, "", GREEDY, CALM]


def test_a_network_that_has_used_its_time_must_wait(worker: ReadingProcess, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(own, "ALLOWANCE", 2)
    GATE.set()
    with closing(ReadingProcess("fake")) as other:
        assert results(other.ask(ENDLESS, GREEDY)) == results(other.ask(ENDLESS, GREEDY)) == [own.WALK_TOO_LONG]
        refused = other.ask(READ, GREEDY).result(60)
        assert refused.refused == own.USED_UP and refused.is_busy and 0 < refused.after < 60
        assert results(other.ask(READ, CALM)) == ["read"]


def test_a_session_has_one_job_at_a_time_which_it_can_cancel_and_continues_meanwhile() -> None:
    session, sent, fake = Session(fitted(SCENES["damped"]().value), scenes=SCENES), list[Packet](), FakeWorker()
    session.send, session.worker, session.network = sent.append, fake, CALM
    fit = {"type": "rows", "piece": 0, "of": 1, "t": [0.0, 1.0], "columns": [[0.0, 1.0]], "size": 2}
    for number in (1, 1):  # a repeated message is answered once
        session.handle({**fit, "number": number})
        assert len(fake.jobs) == 1 and not sent
    session.handle({"type": "walk", "name": "mine", "text": MINE, "number": 2})
    session.handle({"type": "set", "values": {"zeta": 0.5}, "number": 3})
    session.handle({"type": "cancel_fit", "number": 4})
    session.handle({**fit, "number": 5})
    fake.replies[1].set_result(Replied(refused=own.FIT_TOO_LONG))
    session.handle({**fit, "number": 6})
    session.close()
    answers = [(told["answer"], told.get("refused")) for told in map(unpacked, sent)]
    assert [number for number, _ in answers] == [2, 3, 4, 5]
    assert (answers[0][1], answers[3][1]) == (ONE_AT_A_TIME, own.FIT_TOO_LONG)
    assert [one.cancelled() for one in fake.replies] == [True, False, True]
    assert [network for _, network in fake.jobs] == [CALM] * 3


if __name__ == "__main__":
    jobs.replied = hangs
    jobs.work({}, {}, sys.stdin.buffer, sys.stdout.buffer)
