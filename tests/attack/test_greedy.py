"""The work that one greedy client of `make attack` causes, counted without a clock."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future
from decimal import Decimal
from typing import Any

import numpy as np
import pytest

from components.quantities.refusals import SORRY
from components.scenes import SCENES
from components.serving.worker_process import ReadingProcess
from components.session.opening import opened
from components.session.session import ONE_AT_A_TIME, Session
from components.session.worker import Replied, WorkerJob
from components.state.link import Link
from physics import sinusoids, transient
from physics.precision import exact
from physics.transient import DRAWING, EXACT, DampedModes, Effort
from tests.page.headless_page import unpacked
from tools.attack.extremes import ExtremeValues
from tools.attack.greedy import GREEDY

WALKS = [name for name, message in GREEDY.items() if message["type"] == "walk"]
ABSORBER: ExtremeValues = {"damping": "added"}
CHANGES = [name for name in GREEDY if name not in WALKS]


@pytest.fixture(scope="module")
def process() -> Iterator[ReadingProcess]:
    one = ReadingProcess("reading")
    yield one
    one.close()


class DelayedWorker:
    """A worker that counts jobs and delays each reply until it is fetched."""

    def __init__(self, process: ReadingProcess) -> None:
        self.process = process
        self.replies: list[Future[Replied]] = []
        self.delayed: Future[Replied] = Future()

    def ask(self, asked: WorkerJob, network: str = "") -> Future[Replied]:
        self.replies.append(self.process.ask(asked, network))
        return self.delayed

    def fetch(self) -> Replied:
        reply = self.replies[0].result(120)
        self.delayed.set_result(reply)
        return reply


def page(slug: str = "absorber", values: ExtremeValues = ABSORBER) -> tuple[Session, list[dict[str, Any]]]:
    """The page of the greedy client, and all packets that it receives."""
    session, packets = opened(SCENES, Link(slug, values)), list[dict[str, Any]]()
    session.send = lambda packet: packets.append(unpacked(packet))
    return session, packets


@pytest.mark.parametrize("name", WALKS)
def test_a_huge_walk_is_read_once_in_the_worker_and_gets_a_reason(process: ReadingProcess, name: str) -> None:
    """While a walk is being read, it may be sent again any number of times."""
    session, packets = page()
    session.worker = apart = DelayedWorker(process)
    delayed: list[Any] = []
    session.later = delayed.append
    for number in (1, *[1] * 20, *range(2, 22)):
        session.handle({**GREEDY[name], "number": number})
    assert len(apart.replies) == 1
    assert [(one["answer"], one["refused"]) for one in packets] == [(number, ONE_AT_A_TIME) for number in range(2, 22)]
    reply = apart.fetch()
    assert (reply.sheet is None) == bool(reply.refused)
    assert reply.refused != SORRY and (not reply.refused or reply.refused.endswith("."))
    (answer,) = delayed
    answer()
    assert packets[-1]["answer"] == 1 and process.pending == 0


@pytest.mark.parametrize("name", CHANGES)
def test_a_change_takes_a_bounded_number_of_digits(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The change is drawn, or it is refused with a reason and nothing changes."""
    motions: list[list[int]] = []
    motion, expansion = DampedModes.motion, transient.expansion

    def moved(modes: DampedModes, t: Any, effort: Effort = EXACT) -> Any:
        assert effort is DRAWING, "a picture has no time for more"
        motions.append([])
        return motion(modes, t, effort)

    def expanded(driven: Any, digits: int) -> Any:
        motions[-1].append(digits)
        return expansion(driven, digits)

    session, packets = page()
    monkeypatch.setattr(DampedModes, "motion", moved)
    monkeypatch.setattr(transient, "expansion", expanded)
    for number in (1, 2, 3):
        motions[:] = [[]]
        session.handle({**GREEDY[name], "values": {**GREEDY[name]["values"], "x2_0": number / 1e3}, "number": number})
        assert packets[-1]["answer"] == number and SORRY not in packets[-1]["problems"]
        assert all(" Still drawn " in said for said in packets[-1]["errors"].values())
        assert motions != [[]] and len(motions) < 6
        assert max(map(sum, motions)) <= DRAWING.work + 2 * DRAWING.digits


class Rate:
    """A frequency that counts how often it is reduced."""

    def __init__(self, rate: Decimal, reduced: list[int]) -> None:
        self.rate, self.reduced = rate, reduced

    def as_integer_ratio(self) -> tuple[int, int]:
        above, below = self.rate.as_integer_ratio()
        reduced = self.reduced

        class Above(int):
            def __lshift__(self, count: int) -> int:
                reduced.append(count)
                return int(self) << count

        return Above(above), below


def test_a_far_window_reduces_a_frequency_once_for_each_binary_exponent(monkeypatch: pytest.MonkeyPatch) -> None:
    reduced, points, exponents = list[int](), list[int](), list[int]()
    remainders = exact.remainders

    def counted(rate: Decimal, t: Any, whole: int) -> list[int]:
        points.append(len(t))
        exponents.append(len(set(np.frexp(t)[1].tolist())))
        return remainders(Rate(rate, reduced), t, whole)  # type: ignore[arg-type]

    for module in (exact, sinusoids):
        monkeypatch.setattr(module, "remainders", counted, raising=False)
    session, packets = page("forced", {})
    session.handle({**GREEDY["an enormous window"], "number": 1})
    assert packets[-1]["answer"] == 1
    assert len(reduced) == sum(exponents) and 10 * sum(exponents) < sum(points)
