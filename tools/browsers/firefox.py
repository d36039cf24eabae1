"""Debian's Firefox, driven by its own protocol (Marionette), because Playwright drives only a modified Firefox."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import time
from pathlib import Path
from typing import Any

from tests.serving.server import free_port
from tools.browsers.driven import LOOK, PATIENCE, DrivenWindow

EXTRA: dict[str, dict[str, object]] = {"ExecuteAsyncScript": {"sandbox": None}, "TakeScreenshot": {"full": False}}
"""What Marionette needs to know besides the arguments of WebDriver."""
NAMES = ("firefox-esr", "firefox")
AS_NARROW_AS_A_PHONE = ":root, body { min-width: 0 !important; }"
"""For Firefox's own window, which is otherwise at least 500 px wide."""


def find() -> str | None:
    """Return the path of Firefox: FIREFOX, or an installed one."""
    return os.environ.get("FIREFOX") or next(filter(None, map(shutil.which, NAMES)), None)


class Firefox(DrivenWindow):
    """A window of Firefox without a screen."""

    def __init__(self, path: str, profile: Path) -> None:
        super().__init__()
        port = free_port()
        preferences = {
            "marionette.port": port,
            "remote.prefs.recommended": True,
            "toolkit.legacyUserProfileCustomizations.stylesheets": True,
        }
        lines = (f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in preferences.items())
        (profile / "user.js").write_text("".join(lines), encoding="utf-8")
        (profile / "chrome").mkdir()
        (profile / "chrome" / "userChrome.css").write_text(AS_NARROW_AS_A_PHONE, encoding="utf-8")
        command = [path, "--headless", "--marionette", "--remote-allow-system-access", "--profile", str(profile)]
        with (profile / "log").open("w") as log:
            self._process = subprocess.Popen(command, stdout=log, stderr=log, env={**os.environ, "HOME": str(profile)})
        self._number = 0
        self._socket = self._connected(port)
        self._read()
        self.do("NewSession", capabilities={"alwaysMatch": {"acceptInsecureCerts": True}})

    def close(self) -> None:
        self._socket.close()
        self._process.terminate()
        self._process.wait(PATIENCE)

    def _connected(self, port: int) -> socket.socket:
        end = time.monotonic() + PATIENCE
        while True:
            try:
                return socket.create_connection(("127.0.0.1", port), PATIENCE)
            except OSError:
                if time.monotonic() > end or self._process.poll() is not None:
                    raise
                time.sleep(LOOK)

    def do(self, command: str, **given: object) -> Any:
        self._number += 1
        extra = EXTRA.get(command, {})
        message = json.dumps([0, self._number, f"WebDriver:{command}", {**given, **extra}]).encode()
        self._socket.sendall(b"%d:%s" % (len(message), message))
        _, _, error, value = self._read()
        if error:
            raise RuntimeError(f"{command}: {error['message']}")
        return value["value"] if isinstance(value, dict) and value.keys() == {"value"} else value

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
