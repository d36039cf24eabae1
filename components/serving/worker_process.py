"""The worker process of the server: one job at a time, with limited memory and processor time.

Networks take turns, so that one with many jobs does not delay another. Each has an allowance of CPU time per minute.
"""

from __future__ import annotations

import signal
import subprocess
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from threading import Lock, Timer

import msgspec

from components.processes import started
from components.serving.visitors import Rate
from components.session.measured import Fitting
from components.session.worker import BUDGET, Reading, Replied, Teaching, WorkerJob, receive, send

WAITING, OF_A_NETWORK = 64, 16
"""Maximum number of waiting jobs: of all networks, and of one."""
ALLOWANCE = 20
"""CPU seconds that one network may use in a minute, also in a single burst."""
PATIENCE, STARTING = 20.0, 120.0
"""Seconds until a process is ended: for a job that takes too long, and for a process that does not become ready."""
FIT_PATIENCE = 5.0
"""The same for a fit, because a visitor waits for it."""
OVER_BUDGET = -getattr(signal, "SIGPROF", 0)
"""The exit code of a process that the system has ended for exceeding its limits."""
SHARED = "Too many requests from your network are waiting. Try again in a few seconds."
BUSY = "Too many requests are waiting. Try again in a few seconds."
USED_UP = "Your network has used its computing time on this server. Try again in a few seconds."
LATE = "The server had no time for this. Try again in a minute."
GONE = "The server could not start the process that does this. Try again in a minute."
WALK_TOO_LONG = f"Checking this walk takes more than {BUDGET:g} s here: give it fewer steps, links and formulas."
FILE_TOO_LONG = (
    f"These numbers take more than {BUDGET:g} s to compute here: choose another time window or other values."
)
FIT_TOO_LONG = f"This fit takes more than {BUDGET:g} s here: choose a file with fewer rows."
SOON = 2.0
"""Seconds after which a refused request may be repeated."""


@dataclass(frozen=True, eq=False)
class _Waiting:
    """A waiting job."""

    job: WorkerJob
    network: str
    reply: Future[Replied] = field(default_factory=Future)


class ReadingProcess:
    """The worker process. It starts with the first job, and again if it has ended."""

    def __init__(self, module: str, *arguments: str) -> None:
        self._command = (module, *arguments)
        self._process: subprocess.Popen[bytes] | None = None
        self._turn = ThreadPoolExecutor(1, "worker")
        self._lock = Lock()
        self._line: list[_Waiting] = []
        self._running: _Waiting | None = None
        self._used = Rate(ALLOWANCE)
        self._served: list[str] = []
        """The waiting networks that have had a turn, the latest last."""

    @property
    def pending(self) -> int:
        """The number of jobs that run or wait."""
        return len(self._line) + (self._running is not None)

    def ask(self, asked: WorkerJob, network: str = "") -> Future[Replied]:
        """Queue a job. A job without a network belongs to the server; only the length of the line limits it."""
        waiting = _Waiting(asked, network)
        with self._lock:
            refused = self._refusal(network)
            if not refused:
                self._line.append(waiting)
        if refused:
            waiting.reply.set_result(refused)
        else:
            self._turn.submit(self._work)
        return waiting.reply

    def warm(self) -> None:
        """Start the process now, so that the first job does not wait for it."""
        self._turn.submit(self._ready)

    def close(self) -> None:
        self._turn.shutdown(wait=False, cancel_futures=True)
        for waiting in self._line:
            waiting.reply.cancel()
        if self._process:
            self._process.kill()
        self._turn.shutdown()
        if self._process:
            _end(self._process)

    def _refusal(self, network: str) -> Replied | None:
        if len(self._line) >= WAITING:
            return Replied(refused=BUSY, is_busy=True, after=SOON)
        if not network:
            return None
        if sum(one.network == network for one in self._line) >= OF_A_NETWORK:
            return Replied(refused=SHARED, is_busy=True, after=SOON)
        if seconds := self._used.wait(network):
            return Replied(refused=USED_UP, is_busy=True, after=seconds)
        return None

    def _work(self) -> None:
        """Do one of the waiting jobs, in the only thread."""
        with self._lock:
            self._line = [one for one in self._line if not one.reply.cancelled()]
            if not self._line:
                return
            chosen = self._next()
        running = chosen.reply.set_running_or_notify_cancel()
        replied = self._replied(chosen.job) if running else Replied()
        with self._lock:
            self._used.charge(chosen.network, replied.seconds)
            self._running = None
        if running:
            chosen.reply.set_result(replied)

    def _next(self) -> _Waiting:
        """Take the first job of the network that has waited longest for a turn."""
        chosen = min(self._line, key=lambda one: self._served.index(one.network) if one.network in self._served else -1)
        self._line.remove(chosen)
        self._running = chosen
        waiting = {one.network for one in self._line} - {chosen.network}
        self._served = [*(one for one in self._served if one in waiting), chosen.network]
        return chosen

    def _replied(self, job: WorkerJob) -> Replied:
        process = self._ready()
        if process is None:
            return Replied(refused=GONE)
        patience = FIT_PATIENCE if isinstance(job, Fitting) else PATIENCE
        reply = _answer(process, msgspec.msgpack.encode(job), patience)
        if reply:
            return msgspec.msgpack.decode(reply, type=Replied)
        _end(process)
        self._process = None
        with suppress(RuntimeError):  # the server is shutting down
            self._turn.submit(self._ready)
        return Replied(refused=_over(job) if process.returncode == OVER_BUDGET else LATE, seconds=BUDGET)

    def _ready(self) -> subprocess.Popen[bytes] | None:
        if not self._process:
            self._process = started(*self._command)
            if _answer(self._process, None, STARTING) is None:
                _end(self._process)
                self._process = None
        return self._process


def _over(job: WorkerJob) -> str:
    """Return the sentence for a job that exceeded its budget."""
    if isinstance(job, Fitting):
        return FIT_TOO_LONG
    return WALK_TOO_LONG if isinstance(job, Reading | Teaching) else FILE_TOO_LONG


def _answer(process: subprocess.Popen[bytes], asked: bytes | None, patience: float) -> bytes | None:
    """Return the answer of a process to a request, or its first message; None if it exits or takes too long."""
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
