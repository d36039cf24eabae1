"""The work that one greedy client of `make attack` causes, counted without a clock."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from components.quantities.refusals import SORRY
from components.scenes import SCENES
from components.serving.worker_process import ReadingProcess
from components.session.opening import opened
from components.session.session import Session
from components.session.worker import Reading
from components.state.link import Link
from physics import transient
from physics.transient import DRAWING, EXACT, DampedModes, Effort
from tests.page.headless_page import unpacked
from tools.attack.greedy import GREEDY

WALKS = [name for name, message in GREEDY.items() if message["type"] == "walk"]
CHANGES = [name for name in GREEDY if name not in WALKS]


@pytest.fixture(scope="module")
def process() -> Iterator[ReadingProcess]:
    one = ReadingProcess("reading")
    yield one
    one.close()


def page() -> tuple[Session, list[dict[str, Any]]]:
    """The page of the greedy client, and all packets that it receives."""
    session, packets = opened(SCENES, Link("absorber", {"damping": "added"})), list[dict[str, Any]]()
    session.send = lambda packet: packets.append(unpacked(packet))
    return session, packets


@pytest.mark.parametrize("name", WALKS)
def test_a_huge_walk_is_read_in_the_worker_or_gets_a_reason(process: ReadingProcess, name: str) -> None:
    reply = process.ask(Reading("mine", GREEDY[name]["text"])).result(120)
    assert (reply.sheet is None) == bool(reply.refused) and process.pending == 0
    assert reply.refused != SORRY and (not reply.refused or reply.refused.endswith("."))


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
