"""One Valkey for all tests of classes, whose codes cost no time."""

import sys
from collections.abc import Iterator
from contextlib import closing

import pytest

from components.live_class import codes
from tests.live_class.served import Valkey


@pytest.fixture(scope="module")
def running() -> Iterator[Valkey]:
    if sys.platform == "win32":
        pytest.skip("no Valkey here")
    with closing(Valkey()) as server:
        yield server


@pytest.fixture
def valkey(running: Valkey) -> Valkey:
    return running.emptied()


@pytest.fixture(params=["memory", "valkey"])
def url(request: pytest.FixtureRequest) -> str:
    """The address of each kind of store, "" for one in memory."""
    return str(request.getfixturevalue("valkey").url) if request.param == "valkey" else ""


@pytest.fixture(autouse=True)
def cheap_codes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(codes, "DEAR", {"n": 2, "r": 1, "p": 1})
