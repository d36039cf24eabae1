"""The encoding of a message: one block of bytes, compressed once for all receivers.

It has a line of JSON and, for a picture, the numbers of its columns. A message about a scene is compressed with a
`preset_dictionary` that the browser has in the scene's sheet.
"""

from __future__ import annotations

import zlib
from base64 import b64encode
from collections.abc import Sequence
from itertools import accumulate, pairwise
from typing import TypedDict

import msgspec
import numpy as np
from numpy.typing import NDArray

from components.language.messages import BrowserMessage, ServerMessage

Steps = NDArray[np.int32]
"""Numbers of a column as integers."""
WINDOW = 2**15
"""Size in bytes of the window of deflate."""
ORDER = 4
"""Order of the differences that are sent: for smooth curves, fourth differences are small and compress well."""


class Packet(TypedDict):
    """A packed message. `sheet` is the address of the sheet with its preset dictionary, or ""."""

    sheet: str
    data: bytes


def _plain(value: object) -> float:
    """Convert NumPy's scalars, of which pictures have many, to Python's floats."""
    if isinstance(value, np.floating):
        return float(value)
    raise TypeError(f"{type(value).__name__} does not cross")


_encoder = msgspec.json.Encoder(enc_hook=_plain)


def as_json(value: object) -> bytes:
    """Return a value of a message type as JSON."""
    return _encoder.encode(value)


def packed(
    message: ServerMessage, columns: Sequence[Steps] = (), *, sheet: str = "", preset_dictionary: bytes = b""
) -> Packet:
    """Return a packed message."""
    known = (preset_dictionary,) if preset_dictionary else ()
    deflate = zlib.compressobj(6, zlib.DEFLATED, -15, zlib.DEF_MEM_LEVEL, zlib.Z_DEFAULT_STRATEGY, *known)
    data = deflate.compress(as_json(message) + b"\n" + _in_bytes(columns)) + deflate.flush()
    return {"sheet": sheet, "data": data}


def _in_bytes(columns: Sequence[Steps]) -> bytes:
    """Return the fourth differences of the columns in bytes: all first bytes, then all second ones, and so on.

    A difference d >= 0 is written as 2d, a negative one as -2d - 1.
    """
    if not columns:
        return b""
    before = np.zeros(ORDER, np.int32)  # zeros before each column, so that its first differences are defined
    differences = np.diff(np.concatenate([part for column in columns for part in (before, column)]), ORDER)
    ends = accumulate((len(column) + ORDER for column in columns), initial=-ORDER)
    whole = np.concatenate([differences[start + ORDER : end] for start, end in pairwise(ends)])
    folded = (whole << 1) ^ (whole >> 31)
    return folded.astype("<u4").view(np.uint8).reshape(-1, 4).T.tobytes()


def in_one(packet: Packet) -> bytes:
    """Return a message as the socket carries it: the address of the sheet, a line feed, the data."""
    return packet["sheet"].encode() + b"\n" + packet["data"]


def on_page(packet: Packet) -> str:
    """Return a message as text for the page's HTML."""
    return b64encode(packet["data"]).decode()


def decoded(data: object) -> BrowserMessage:
    """Return a message of the browser. Raises ValueError, with a reason, for anything that our page does not send."""
    try:
        message: BrowserMessage = msgspec.convert(data, BrowserMessage)
    except (msgspec.ValidationError, RecursionError) as error:
        raise ValueError(f"This is not a message that this page sends: {error}.") from error
    return message
