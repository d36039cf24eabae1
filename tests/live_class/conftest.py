"""One Valkey for all tests of classes, whose codes cost no time."""

from collections.abc import Iterator

import pytest

from components.live_class import codes
from tests.live_class.stores import Valkey, valkey_running


@pytest.fixture(scope="module")
def valkey() -> Iterator[Valkey]:
    with valkey_running() as server:
        yield server


@pytest.fixture(autouse=True)
def cheap_codes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(codes, "DEAR", {"n": 2, "r": 1, "p": 1})
