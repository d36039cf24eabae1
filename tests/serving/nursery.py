"""Servers that start at once: each is forked from a process that has already imported the project."""

from __future__ import annotations

import os
import signal
import sys
from multiprocessing import get_context
from pathlib import Path
from subprocess import TimeoutExpired
from typing import Any

START = "components.serving.__main__"
WANTED = sys.platform == "linux" and "PYTEST_VERSION" in os.environ and "COVERAGE_PROCESS_CONFIG" not in os.environ
"""Only in tests without line coverage; measurements start the server by its command."""


class Forked:
    """A forked process with the interface of subprocess.Popen."""

    def __init__(self, arguments: list[str], environment: dict[str, str], log: Path) -> None:
        forks: Any = get_context("forkserver")
        forks.set_forkserver_preload([START, "app"])
        self._process = forks.Process(target=_serve, args=(arguments, environment, log), daemon=True)
        self._process.start()
        self.pid: int = self._process.pid
        self.terminate, self.kill = self._process.terminate, self._process.kill

    def poll(self) -> int | None:
        code: int | None = self._process.exitcode
        return code

    def wait(self, timeout: float | None = None) -> int:
        self._process.join(timeout)
        if (code := self.poll()) is None:
            raise TimeoutExpired(START, timeout or 0.0)
        return code

    def send_signal(self, number: signal.Signals) -> None:
        os.kill(self.pid, number)


def _serve(arguments: list[str], environment: dict[str, str], log: Path) -> None:
    with log.open("wb") as stream:
        for standard in (1, 2):
            os.dup2(stream.fileno(), standard)
    os.environ.clear()
    os.environ.update(environment)
    sys.argv = [START, *arguments]
    from components.serving.__main__ import main

    main()
