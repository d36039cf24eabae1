"""Messages on their way out are framed as Tornado frames them."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest
from bokeh.core.serialization import Buffer
from bokeh.protocol.messages.ok import ok
from bokeh.util.serialization import make_globally_unique_id
from tornado.websocket import WebSocketProtocol13

from components.serving.outgoing import frame, framed


def of_tornado(*parts: str | bytes) -> bytes:
    written: list[bytes] = []
    server = SimpleNamespace(
        FIN=WebSocketProtocol13.FIN,
        mask_outgoing=False,
        _wire_bytes_out=0,
        stream=SimpleNamespace(write=written.append),
    )
    for part in parts:
        text = isinstance(part, str)
        data = part.encode() if isinstance(part, str) else part
        WebSocketProtocol13._write_frame(cast(Any, server), True, 1 if text else 2, data)
    return b"".join(written)


@pytest.mark.parametrize("size", [0, 1, 125, 126, 2**16 - 1, 2**16])
def test_frames_of_every_size(size: int) -> None:
    assert frame("x" * size) == of_tornado("x" * size)
    assert frame(b"x" * size) == of_tornado(b"x" * size)
    assert frame("ü" * size) == of_tornado("ü" * size)


def test_a_message_is_its_frames_one_after_the_other() -> None:
    message = ok.create("a request")
    name, data = make_globally_unique_id(), bytes(range(256))
    message.add_buffers(Buffer(name, data))
    parts = (message.header_json, message.metadata_json, message.content_json, f'{{"id": "{name}"}}', data)
    assert framed(message) == of_tornado(*parts)
