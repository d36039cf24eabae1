"""The encoding of a message: one block of bytes, deflated once, whoever hears it.

Inside stand a line of JSON and, where it shows a picture, the columns (components/places.py). A message about a
scene refers to the scene's `usual` text, which the browser has in its sheet: what it repeats of that costs next to
nothing.
"""

from __future__ import annotations

import zlib
from base64 import b64encode
from collections.abc import Sequence
from typing import TypedDict

import msgspec
import numpy as np

from components.page.messages import Said, Told
from components.places import Steps, encoded

WINDOW = 2**15
"""Bytes that deflate looks back."""


class Packet(TypedDict):
    """A message as Bokeh sends it. `sheet` is the address of the sheet whose usual text it refers to, or ""."""

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
    data = deflate.compress(as_json(told) + b"\n" + encoded(columns)) + deflate.flush()
    return {"sheet": sheet, "data": data}


def on_page(packet: Packet) -> str:
    """A message as text that can stand in a page."""
    return b64encode(packet["data"]).decode()


def decoded(data: object) -> Said:
    """A message of the browser; ValueError, in words, for what our page does not send."""
    try:
        said: Said = msgspec.convert(data, Said)
    except (msgspec.ValidationError, RecursionError) as error:
        raise ValueError(f"This is not a message that this page sends: {error}.") from error
    return said
