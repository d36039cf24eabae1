"""The encoding of a message: one block of bytes, compressed once for all receivers.

It has a line of JSON and, for a picture, the numbers of its columns. A message about a scene is compressed with the
scene's `usual` text as preset dictionary, which the browser has in its sheet.
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

from components.language.messages import Said, Told

Steps = NDArray[np.int32]
"""Numbers of a column, in whole steps of a range."""
WINDOW = 2**15
"""Bytes that deflate looks back."""
ORDER = 4
"""Neighbours on a curve differ little, their differences less, and so on: fourth differences are sent."""


class Packet(TypedDict):
    """A message, packed. `sheet` is the address of the sheet whose usual text it refers to, or ""."""

    sheet: str
    data: bytes


def _plain(value: object) -> float:
    """NumPy's scalars, which pictures are full of, as Python's."""
    if isinstance(value, np.floating):
        return float(value)
    raise TypeError(f"{type(value).__name__} does not cross")


_encoder = msgspec.json.Encoder(enc_hook=_plain)


def as_json(value: object) -> bytes:
    """Anything of the page language as the browser reads it."""
    return _encoder.encode(value)


def packed(told: Told, columns: Sequence[Steps] = (), *, sheet: str = "", usual: bytes = b"") -> Packet:
    """A message made ready; `usual` is the text in the sheet."""
    known = (usual,) if usual else ()
    deflate = zlib.compressobj(6, zlib.DEFLATED, -15, zlib.DEF_MEM_LEVEL, zlib.Z_DEFAULT_STRATEGY, *known)
    data = deflate.compress(as_json(told) + b"\n" + _in_bytes(columns)) + deflate.flush()
    return {"sheet": sheet, "data": data}


def _in_bytes(columns: Sequence[Steps]) -> bytes:
    """Four times as many bytes as there are numbers: all first bytes of the fourth differences, all second ones, and so
    on. A difference d >= 0 is 2d, one below is -2d - 1."""
    if not columns:
        return b""
    before = np.zeros(ORDER, np.int32)  # each column begins as if it came from 0
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


def decoded(data: object) -> Said:
    """A message of the browser; ValueError, in words, for what our page does not send."""
    try:
        said: Said = msgspec.convert(data, Said)
    except (msgspec.ValidationError, RecursionError) as error:
        raise ValueError(f"This is not a message that this page sends: {error}.") from error
    return said
