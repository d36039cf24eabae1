"""Two replicas behind the real proxy on loopback, like compose.yaml but without containers."""

from __future__ import annotations

import shutil
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path

from tests.serving.server import ROOT, Server, free_port, serving

SECRET = "a secret of more than thirty-two letters"
COOKIE_SECRET = "another of more than thirty-two letters"
COPIED = ("app.py", "reading.py", "components", "physics", "static")


class DeployedSite:
    """The lecture at `url`; its replicas end and start one by one."""

    front: Server
    """The proxy."""

    def __init__(self, folder: Path, replicas: int, more: Mapping[str, str]) -> None:
        self.folder = folder
        self._more = more
        self.ports = [free_port() for _ in range(replicas)]
        self.port = free_port()
        self._running: dict[int, tuple[Server, ExitStack]] = {}

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}/"

    def start(self, number: int, code: Path = ROOT) -> None:
        """Start a replica that is not running, with the code in a folder."""
        stack = ExitStack()
        log = self.folder / f"replica-{number}-{time.monotonic_ns()}.log"
        environment = {
            "BOKEH_SECRET_KEY": SECRET,
            "ALLOWED_ORIGIN": f"127.0.0.1:{self.port}",
            "TRUSTED_PROXIES": "127.0.0.1",
            "ARRIVALS": "100000",
            **self._more,
        }
        running = serving(log, port=self.ports[number], folder=code, environment=environment)
        self._running[number] = stack.enter_context(running), stack

    def kill(self, number: int) -> None:
        """Kill a replica without warning, like a machine that fails."""
        server, stack = self._running.pop(number)
        server.process.kill()
        stack.close()

    def end(self, number: int) -> None:
        """End a replica as a container engine does."""
        self._running.pop(number)[1].close()

    def complaints(self) -> list[str]:
        return [line for server, _ in self._running.values() for line in server.complaints()]

    def close(self) -> None:
        for number in list(self._running):
            self.end(number)


def caddy() -> str:
    """Return the path of the proxy's program, which comes with a package for tests."""
    return str(Path(sys.executable).with_name("caddy"))


def behind_caddy(site: DeployedSite) -> tuple[Sequence[str], Mapping[str, str]]:
    """Return the proxy of compose.yaml, with the variables of the Caddyfile."""
    command = (caddy(), "run", "--config", str(ROOT / "Caddyfile"), "--adapter", "caddyfile")
    return command, {
        "SITE": f"http://127.0.0.1:{site.port}",
        "COOKIE_SECRET": COOKIE_SECRET,
        "UPSTREAMS": " ".join(f"127.0.0.1:{port}" for port in site.ports),
        "XDG_DATA_HOME": str(site.folder),
        "XDG_CONFIG_HOME": str(site.folder),
    }


@contextmanager
def deployed(folder: Path, codes: Sequence[Path] = (ROOT, ROOT), **more: str) -> Iterator[DeployedSite]:
    """Yield a running site; each replica has the code of a folder. `more` are settings of all of them."""
    site = DeployedSite(folder, len(codes), more)
    command, environment = behind_caddy(site)
    try:
        for number, code in enumerate(codes):
            site.start(number, code)
        with serving(folder / "proxy.log", port=site.port, command=command, environment=environment) as site.front:
            yield site
    finally:
        site.close()


def upgraded(folder: Path) -> Path:
    """Copy the code and change a static file."""
    folder.mkdir()
    for name in COPIED:
        source = ROOT / name
        copy = shutil.copytree if source.is_dir() else shutil.copy
        copy(source, folder / name)
    with (folder / "static" / "main.js").open("a", encoding="utf-8") as script:
        script.write("// of a later version\n")
    return folder
