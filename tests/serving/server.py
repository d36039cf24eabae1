"""The app in a separate process on a free loopback port, started by README's command or, in tests, its function."""

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
START = ("-m", "components.serving")
SERVING = "components.serving.__main__"
PANEL = ("-m", "panel", "serve", "app.py")
WANTED = sys.platform == "linux" and "PYTEST_VERSION" in os.environ and "COVERAGE_PROCESS_CONFIG" not in os.environ
"""True to fork servers from a process that has imported the project, so that they start at once: only in tests without
line coverage; measurements start the server by its command.
"""


class Forked:
    """A forked process with the interface of subprocess.Popen."""

    def __init__(self, arguments: list[str], environment: dict[str, str], log: Path) -> None:
        forks: Any = get_context("forkserver")
        forks.set_forkserver_preload([SERVING, "app"])
        self._process = forks.Process(target=_serve, args=(arguments, environment, log), daemon=True)
        self._process.start()
        self.pid: int = self._process.pid
        self.terminate, self.kill = self._process.terminate, self._process.kill
        self.send_signal: Callable[[signal.Signals], None] = partial(os.kill, self.pid)

    def poll(self) -> int | None:
        code: int | None = self._process.exitcode
        return code

    def wait(self, timeout: float | None = None) -> int:
        self._process.join(timeout)
        if (code := self.poll()) is None:
            raise subprocess.TimeoutExpired(SERVING, timeout or 0.0)
        return code


def _serve(arguments: list[str], environment: dict[str, str], log: Path) -> None:
    with log.open("wb") as stream:
        for standard in (1, 2):
            os.dup2(stream.fileno(), standard)
    os.environ.clear()
    os.environ.update(environment)
    sys.argv = [SERVING, *arguments]
    from components.serving.__main__ import main

    main()


@dataclass(frozen=True, kw_only=True)
class Server:
    port: int
    process: subprocess.Popen[bytes] | Forked
    log: Path

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}/"

    def complaints(self) -> list[str]:
        """The lines of the log that report a problem."""
        signs = ("Traceback", "ERROR", "CRITICAL")
        lines = self.log.read_text().splitlines()
        # Bokeh only warns about a failing callback at the end of a session.
        return [line for line in lines if line.startswith(signs) or "failed with following error" in line]


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


@contextmanager
def serving(
    log: Path,
    *,
    port: int | None = None,
    options: Sequence[str] = (),
    command: Sequence[str] | None = None,
    folder: Path = ROOT,
    environment: Mapping[str, str] | None = None,
) -> Iterator[Server]:
    """Yield a server that listens, and end it. `command` replaces the default one and must listen on `port`."""
    port = port or free_port()
    arguments = ("--address", "127.0.0.1", "--port", str(port), *options)
    variables = {**os.environ, **(environment or {})}
    process: subprocess.Popen[bytes] | Forked
    if WANTED and not command and folder == ROOT:
        process = Forked(list(arguments), variables, log)
    else:
        with log.open("wb") as stream:
            process = subprocess.Popen(
                command or (sys.executable, *START, *arguments),
                cwd=folder,
                env=variables,
                stdout=stream,
                stderr=subprocess.STDOUT,
            )
    try:
        wait_until_listening(process, port, log)
        yield Server(port=port, process=process, log=log)
    finally:
        process.terminate()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


@contextmanager
def serving_panel(log: Path) -> Iterator[Server]:
    """`panel serve app.py` on a free port."""
    port = free_port()
    with serving(log, port=port, command=(sys.executable, *PANEL, "--port", str(port))) as server:
        yield server


def wait_until_listening(process: subprocess.Popen[bytes] | Forked, port: int, log: Path, limit: float = 180) -> None:
    end = time.monotonic() + limit
    while time.monotonic() < end and process.poll() is None:
        try:
            socket.create_connection(("127.0.0.1", port), timeout=1).close()
            return
        except OSError:
            time.sleep(0.05)
    raise RuntimeError(f"The server does not listen on port {port}:\n{log.read_text()}")
