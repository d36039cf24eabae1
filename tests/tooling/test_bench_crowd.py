"""Short forms of `make load` and `make soak`: visitors of every scene come, drag and go, and leave nothing behind."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from components.scenes import SCENES
from tests.serving.server import Server
from tools.bench.crowd import arrive, depart, drag, dragged, p95, replicas
from tools.bench.soak import soak, still_open

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]  # two servers start


@pytest.fixture(scope="module")
def servers(tmp_path_factory: pytest.TempPathFactory) -> Iterator[list[Server]]:
    with replicas(2, tmp_path_factory.mktemp("replicas"), UNUSED_SECONDS="2") as running:
        yield running
        assert [server.complaints() for server in running] == [[], []]


async def test_visitors_of_every_scene_come_drag_and_go(servers: list[Server]) -> None:
    for slug, scene in SCENES.items():
        seconds, visitors = await arrive(servers, f"scene={slug}", 2)
        waits = await drag(visitors, dragged(scene), rate=20, seconds=0.1)
        assert seconds > 0 and len(waits) >= 2 and 0 < p95(waits) <= max(waits)
        assert all(visitor.traffic.bytes for visitor in visitors)
        await depart(visitors)


def test_a_round_of_visitors_leaves_no_session_behind(servers: list[Server]) -> None:
    held = soak(servers[0], rounds=2, sessions=9)
    assert len(held) == 2 and held[0] > 10
    assert still_open(servers[0]) == 0
