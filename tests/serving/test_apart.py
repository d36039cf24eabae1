"""Strangers' walks are read beside the server: in a second, one at a time, and whatever they do to their process."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future

import pytest

from components.language.messages import Given
from components.scenes import SCENES
from components.serving import apart
from components.serving.apart import BUSY, GONE, LATE, SHARED, WAITING, ReadingProcess
from components.session.session import ONE_AT_A_TIME, Session
from components.session.worker import TOO_LONG, Errand, Reading, Replied, Teaching
from components.state.standing import fitted
from components.state.wire import Packet
from tests.page.told import unpacked

MINE = 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'


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
    assert len(beside) == 0


def test_what_takes_longer_is_refused_and_the_next_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    beside = ReadingProcess("tests.serving.hanging")
    monkeypatch.setattr(apart, "PATIENCE", 100.0)  # for a second of a processor, on a busy machine
    try:
        asked = [beside.ask(Reading(name, MINE)) for name in ("mine", "endless", "mine")]
        assert [one.result(120).refused for one in asked] == ["read", TOO_LONG, "read"]
        monkeypatch.setattr(apart, "PATIENCE", 0.2)
        assert beside.ask(Reading("asleep", MINE)).result(120).refused == LATE  # it has used no time of its own
    finally:
        beside.close()


def test_who_cannot_be_started_is_said() -> None:
    beside = ReadingProcess("tests.serving.no_such_module")
    assert beside.ask(Reading("mine", MINE)).result(120).refused == GONE
    beside.close()


def test_few_wait(beside: ReadingProcess) -> None:
    asked = [beside.ask(Reading("mine", MINE)) for _ in range(WAITING + 3)]
    refused = [one.result(60).refused for one in asked]
    assert set(refused) == {"", BUSY} and refused[0] == "" and refused[-1] == BUSY


def test_one_of_a_network_waits_and_others_come_in() -> None:
    """Nine sessions of one network once held all places. What has no network is the server's own."""
    beside = ReadingProcess("tests.serving.hanging")
    try:
        asked = [beside.ask(Reading("endless", MINE), "192.0.2.0/24")]
        asked += [beside.ask(Reading("mine", MINE), "192.0.2.0/24") for _ in range(WAITING + 1)]
        asked += [beside.ask(Reading("mine", MINE), other) for other in ("198.51.100.0/24", "", "")]
        assert len(beside) == 5
        replies = [one.result(120).refused for one in asked]
        assert replies == [TOO_LONG, "read", *[SHARED] * WAITING, "read", "read", "read"]
        assert beside.ask(Reading("mine", MINE), "192.0.2.0/24").result(60).refused == "read"
    finally:
        beside.close()


class Slow:
    """Replies when it is told to."""

    def __init__(self) -> None:
        self.asked: list[tuple[Errand, Future[Replied]]] = []
        self.networks: list[str] = []

    def ask(self, asked: Errand, network: str = "") -> Future[Replied]:
        future: Future[Replied] = Future()
        self.asked.append((asked, future))
        self.networks.append(network)
        return future


def test_a_session_asks_for_one_at_a_time_and_goes_on_meanwhile() -> None:
    session, apart, packets = Session(fitted(SCENES["coupled"]()), scenes=SCENES), Slow(), list[Packet]()
    session.send, session.apart, session.network = packets.append, apart, "192.0.2.0/24"
    for number in (1, 1, 2):  # the second is the first, said again by a page that has waited long
        session.hear({"type": "walk", "name": "mine", "text": MINE, "number": number})
    session.hear({"type": "set", "values": {"k2": 3.0}, "number": 3})
    refused, moved = map(unpacked, packets)
    assert (refused["answer"], refused["refused"]) == (2, ONE_AT_A_TIME)
    assert (moved["answer"], moved["errors"]) == (3, {})
    ((_, future),) = apart.asked
    assert apart.networks == ["192.0.2.0/24"]
    future.set_result(Replied(refused=TOO_LONG))
    told = unpacked(packets[-1])
    assert (told["answer"], told["sheet"], told["refused"]) == (1, None, TOO_LONG)
    session.hear({"type": "walk", "name": "mine", "text": MINE, "number": 4})
    session.close()
    assert apart.asked[1][1].cancelled()
