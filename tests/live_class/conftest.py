"""One Valkey for all tests of classes."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.live_class.stores import Valkey, valkey_running


@pytest.fixture(scope="module")
def valkey() -> Iterator[Valkey]:
    with valkey_running() as server:
        yield server
