"""The app in a separate process on a free loopback port, started by README's command."""

import os
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
START = ("-m", "components.serving")
PANEL = ("-m", "panel", "serve", "app.py")


@dataclass(frozen=True, kw_only=True)
class Server:
    port: int
    process: subprocess.Popen[bytes]
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
    arguments = (sys.executable, *START, "--address", "127.0.0.1", "--port", str(port), *options)
    variables = {**os.environ, **(environment or {})}
    with log.open("wb") as stream:
        process = subprocess.Popen(
            command or arguments, cwd=folder, env=variables, stdout=stream, stderr=subprocess.STDOUT
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


def wait_until_listening(process: subprocess.Popen[bytes], port: int, log: Path, limit: float = 180) -> None:
    end = time.monotonic() + limit
    while time.monotonic() < end and process.poll() is None:
        try:
            socket.create_connection(("127.0.0.1", port), timeout=1).close()
            return
        except OSError:
            time.sleep(0.05)
    raise RuntimeError(f"The server does not listen on port {port}:\n{log.read_text()}")
