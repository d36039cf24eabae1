"""Safari's engine in Debian: WebKitGTK, driven by its WebDriver in a window under Xvfb."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import time
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

from tests.serving.server import free_port
from tools.browsers.driven import LOOK, PATIENCE, DrivenWindow

PYTHON = "/usr/bin/python3"
"""The system's Python, for which Debian has the bindings of GTK."""
WINDOW = Path(__file__).with_name("webkit_window.py")
BINDINGS = "import gi; gi.require_version('WebKit2', '4.1'); from gi.repository import WebKit2"
COMMANDS = {
    "NewSession": ("POST", ""),
    "Navigate": ("POST", "/url"),
    "Refresh": ("POST", "/refresh"),
    "SetWindowRect": ("POST", "/window/rect"),
    "SetTimeouts": ("POST", "/timeouts"),
    "ExecuteAsyncScript": ("POST", "/execute/async"),
    "PerformActions": ("POST", "/actions"),
    "TakeScreenshot": ("GET", "/screenshot"),
}


def find() -> str | None:
    """The path of its driver, if the display and the bindings are installed too."""
    driver = shutil.which("WebKitWebDriver")
    if not driver or not shutil.which("Xvfb") or not Path(PYTHON).exists():
        return None
    return driver if subprocess.run([PYTHON, "-c", BINDINGS], capture_output=True).returncode == 0 else None


class WebKit(DrivenWindow):
    """A window of WebKitGTK."""

    def __init__(self, driver: str, folder: Path) -> None:
        super().__init__()
        self._screen, display = _screen()
        port = free_port()
        # WebKit's sandbox does not start for root.
        sandbox = {} if os.geteuid() else {"WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS": "1"}
        variables = {**os.environ, **sandbox, "DISPLAY": display, "HOME": str(folder)}
        with (folder / "log").open("w") as log:
            self._process = subprocess.Popen(
                [driver, f"--port={port}"], stdout=log, stderr=log, env=variables, start_new_session=True
            )
        self._line = HTTPConnection("127.0.0.1", port, timeout=2 * PATIENCE)
        _wait_until_listening(self._line, self._process)
        self._session = ""
        options = {"binary": PYTHON, "args": [str(WINDOW)]}
        capabilities = {"alwaysMatch": {"webkitgtk:browserOptions": options}}
        self._session = self.do("NewSession", capabilities=capabilities)["sessionId"]
        self.do("SetTimeouts", script=1000 * PATIENCE)

    def do(self, command: str, **given: object) -> Any:
        method, path = COMMANDS[command]
        path = f"/session/{self._session}{path}" if self._session else "/session"
        self._line.request(method, path, json.dumps(given) if method == "POST" else None)
        value = json.load(self._line.getresponse())["value"]
        if isinstance(value, dict) and "error" in value:
            raise RuntimeError(f"{command}: {value['error']}: {value['message']}")
        return value

    def close(self) -> None:
        """The driver's group of processes includes the window and its helpers."""
        self._line.close()
        os.killpg(self._process.pid, signal.SIGTERM)
        self._process.wait(PATIENCE)
        self._screen.terminate()
        self._screen.wait(PATIENCE)


def _screen() -> tuple[subprocess.Popen[bytes], str]:
    """An invisible screen, and its name."""
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "2560x1440x24", "-nolisten", "tcp"]
    process = subprocess.Popen(command, pass_fds=[writing], stderr=subprocess.DEVNULL)
    os.close(writing)
    with os.fdopen(reading) as numbers:
        return process, f":{numbers.readline().strip()}"


def _wait_until_listening(line: HTTPConnection, process: subprocess.Popen[bytes]) -> None:
    end = time.monotonic() + PATIENCE
    while True:
        try:
            return line.connect()
        except OSError:
            if time.monotonic() > end or process.poll() is not None:
                raise
            time.sleep(LOOK)
