"""A process beside the server that reads what strangers bring: one request at a time, with little memory and time."""

from __future__ import annotations

import signal
import subprocess
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from threading import Lock, Timer

import msgspec

from components.processes import started
from components.session.worker import TOO_LONG, Errand, Replied, receive, send

WAITING = 8
"""Requests that may wait for their turn."""
PATIENCE, STARTING = 10.0, 120.0
"""Seconds until a process is given up that keeps to no budget, or that is not ready."""
OVER_BUDGET = -getattr(signal, "SIGPROF", 0)
"""The code of a process that the system has ended for that."""
SHARED = "Another walk from this network waits to be read already. Try again in a few seconds."
BUSY = f"{WAITING} walks are waiting to be read. Try again in a few seconds."
LATE = "The server had no time for this walk. Try again in a minute."
GONE = "The process that reads walks could not be started. Try again in a minute."


class ReadingProcess:
    """The process that reads, started when it is first asked for and again when it has ended."""

    def __init__(self, module: str, *arguments: str) -> None:
        self._command = (module, *arguments)
        self._process: subprocess.Popen[bytes] | None = None
        self._turn = ThreadPoolExecutor(1, "apart")
        self._lock = Lock()
        self._asked: dict[Future[Replied], str] = {}
        """The network of each request, in the order in which they came: the first is being read."""

    def __len__(self) -> int:
        """The number of requests that run or wait."""
        return len(self._asked)

    def ask(self, asked: Errand, network: str = "") -> Future[Replied]:
        """One request of a network waits at a time."""
        with self._lock:
            waiting = [*self._asked.values()][1:]
            if len(waiting) >= WAITING or (network and network in waiting):
                refused: Future[Replied] = Future()
                refused.set_result(Replied(refused=BUSY if len(waiting) >= WAITING else SHARED, is_busy=True))
                return refused
            future = self._turn.submit(self._replied, msgspec.msgpack.encode(asked))
            self._asked[future] = network
        future.add_done_callback(self._done)
        return future

    def close(self) -> None:
        self._turn.shutdown(wait=False, cancel_futures=True)
        if self._process:
            self._process.kill()
        self._turn.shutdown()
        if self._process:
            _end(self._process)

    def _done(self, future: Future[Replied]) -> None:
        with self._lock:
            del self._asked[future]

    def _replied(self, asked: bytes) -> Replied:
        """In the one thread."""
        process = self._ready()
        if process is None:
            return Replied(refused=GONE)
        reply = _answer(process, asked, PATIENCE)
        if reply:
            return msgspec.msgpack.decode(reply, type=Replied)
        _end(process)
        self._process = None
        with suppress(RuntimeError):  # the server ends
            self._turn.submit(self._ready)
        return Replied(refused=TOO_LONG if process.returncode == OVER_BUDGET else LATE)

    def _ready(self) -> subprocess.Popen[bytes] | None:
        if not self._process:
            self._process = started(*self._command)
            if _answer(self._process, None, STARTING) is None:
                _end(self._process)
                self._process = None
        return self._process


def _answer(process: subprocess.Popen[bytes], asked: bytes | None, patience: float) -> bytes | None:
    """The answer of a process to a request, or its first word; None where it ends or takes too long."""
    assert process.stdin and process.stdout
    limit = Timer(patience, process.kill)
    limit.daemon = True
    limit.start()
    try:
        if asked is not None:
            send(process.stdin, asked)  # type: ignore[arg-type]
        return receive(process.stdout)  # type: ignore[arg-type]
    except OSError:
        return None
    finally:
        limit.cancel()


def _end(process: subprocess.Popen[bytes]) -> None:
    process.kill()
    with suppress(OSError):
        process.communicate()
