"""Debian's Firefox, driven by its own protocol (Marionette): Playwright drives only a Firefox that it has changed."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import time
from base64 import b64decode
from pathlib import Path
from types import TracebackType
from typing import Any

from tests.serving.server import free_port

NAMES = ("firefox-esr", "firefox")
PATIENCE = 60.0
LOOK = 0.1  # seconds


def find() -> str | None:
    """Its path: FIREFOX, or what the machine has."""
    return os.environ.get("FIREFOX") or next(filter(None, map(shutil.which, NAMES)), None)


class Firefox:
    """A window without a screen; `evaluate` and `wait_for_function` are as Playwright has them."""

    def __init__(self, path: str, profile: Path) -> None:
        port = free_port()
        preferences = {"marionette.port": port, "remote.prefs.recommended": True}
        lines = (f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in preferences.items())
        (profile / "user.js").write_text("".join(lines), encoding="utf-8")
        command = [path, "--headless", "--marionette", "--remote-allow-system-access", "--profile", str(profile)]
        with (profile / "log").open("w") as log:
            self._process = subprocess.Popen(command, stdout=log, stderr=log, env={**os.environ, "HOME": str(profile)})
        self._number = 0
        self._socket = self._connected(port)
        self._read()
        self._do("WebDriver:NewSession", capabilities={"alwaysMatch": {"acceptInsecureCerts": True}})

    def __enter__(self) -> Firefox:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._socket.close()
        self._process.terminate()
        self._process.wait(PATIENCE)

    def goto(self, address: str) -> None:
        self._do("WebDriver:Navigate", url=address)

    def size(self, width: int, height: int) -> None:
        """Of what a page is seen in."""
        for _ in range(2):
            inner = self.evaluate("[outerWidth - innerWidth, outerHeight - innerHeight]")
            self._do("WebDriver:SetWindowRect", width=width + inner[0], height=height + inner[1])

    def evaluate(self, script: str, given: object = None) -> Any:
        """The value of an expression; what it promises is waited for, a function is called."""
        body = f"""const [given, done] = arguments
        Promise.resolve().then(() => {{
          const value = ({script})
          return typeof value === "function" ? value(given) : value
        }}).then(value => done([value ?? null]), error => done([null, String(error)]))"""
        value, *error = self._do("WebDriver:ExecuteAsyncScript", script=body, args=[given], sandbox=None)["value"]
        if error:
            raise RuntimeError(error[0])
        return value

    def wait_for_function(self, script: str) -> None:
        end = time.monotonic() + PATIENCE
        while not self.evaluate(f"Boolean({script})"):
            if time.monotonic() > end:
                raise TimeoutError(script)
            time.sleep(LOOK)

    def screenshot(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b64decode(self._do("WebDriver:TakeScreenshot", full=False)["value"]))

    def _connected(self, port: int) -> socket.socket:
        end = time.monotonic() + PATIENCE
        while True:
            try:
                return socket.create_connection(("127.0.0.1", port), PATIENCE)
            except OSError:
                if time.monotonic() > end or self._process.poll() is not None:
                    raise
                time.sleep(LOOK)

    def _do(self, command: str, **given: object) -> Any:
        self._number += 1
        message = json.dumps([0, self._number, command, given]).encode()
        self._socket.sendall(b"%d:%s" % (len(message), message))
        _, _, error, value = self._read()
        if error:
            raise RuntimeError(f"{command}: {error['message']}")
        return value

    def _read(self) -> Any:
        """A message: its length, a colon, and JSON."""
        head = b""
        while not head.endswith(b":"):
            head += self._some(1)
        message = b""
        while len(message) < int(head[:-1]):
            message += self._some(int(head[:-1]) - len(message))
        return json.loads(message)

    def _some(self, most: int) -> bytes:
        some = self._socket.recv(most)
        if not some:
            raise ConnectionError("Firefox has closed its line.")
        return some
