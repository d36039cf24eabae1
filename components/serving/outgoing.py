"""A message of Bokeh's on its way out: header, metadata, content and buffers in one piece.

Bokeh writes each of these frames on its own and waits for it: five packets and as many turns of the event loop.
"""

from __future__ import annotations

import json
import struct
from typing import Any

from bokeh.protocol.message import Message

TEXT, BINARY = 0x81, 0x82
"""The first byte of a frame that is a whole message."""


def framed(message: Message[Any]) -> bytes:
    """What a WebSocket carries of the message, as it goes over the line."""
    parts: list[str | bytes] = [message.header_json, message.metadata_json, message.content_json]
    for buffer in message._buffers:
        parts += [json.dumps(buffer.ref), buffer.to_bytes()]
    return b"".join(map(frame, parts))


def frame(part: str | bytes) -> bytes:
    """One frame of a server's (RFC 6455, 5.2): whole, not masked."""
    kind, data = (TEXT, part.encode()) if isinstance(part, str) else (BINARY, part)
    size = len(data)
    if size < 126:
        return struct.pack("!BB", kind, size) + data
    if size < 2**16:
        return struct.pack("!BBH", kind, 126, size) + data
    return struct.pack("!BBQ", kind, 127, size) + data
