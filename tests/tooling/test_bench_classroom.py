"""The short form of `make class`: everybody has the last picture, and an update is small."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from tests.serving.server import serving
from tools.bench.classroom import CHOICE, SKETCH, answered, drawing, measured, restarted, table
from tools.bench.crowd import SETTINGS


@pytest.mark.slow
def test_a_class_has_what_its_instructor_shows(tmp_path: Path) -> None:
    with serving(tmp_path / "log", environment=SETTINGS) as server:
        figures = asyncio.run(measured(server, 20, 2.0))
        assert figures.missed == 0
        assert figures.updates >= 2
        assert figures.bytes <= 5000
        assert max(figures.reach) < float("inf")
        rows = table([figures], [("more", "1", "")]).splitlines()
        assert "20 followers" in rows[0] and all(row.count("|") == 4 for row in rows)
        asyncio.run(answered(server, 20, CHOICE, {"option": 1}))
        asyncio.run(answered(server, 20, SKETCH, drawing()))
        assert server.complaints() == []


@pytest.mark.slow
def test_a_class_whose_server_was_killed_is_measured_again(tmp_path: Path) -> None:
    figures, took = asyncio.run(restarted(tmp_path, 5, 1.0))
    assert figures.missed == 0 and max(figures.reach) < float("inf") and took > 0
    assert "5 followers, after a restart" in table([figures], [])
