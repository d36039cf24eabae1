"""The server's half of the connection: Bokeh adds little to a message."""

from __future__ import annotations

from bokeh.document import Document
from bokeh.document.events import DocumentPatchedEvent
from bokeh.protocol import Protocol

from components.scenes.coupled import Coupled
from components.session.panel_bridge import SceneView
from components.session.session import Session
from components.state.page_state import fitted
from components.state.wire import in_one

MOST_AROUND = 195
"""Bytes of a Bokeh message around one of ours: header 60, metadata 2, content 103, header of the buffer 15."""


def test_bokeh_adds_little_to_a_message() -> None:
    document, events = Document(), list[DocumentPatchedEvent]()
    session = Session(fitted(Coupled().value))
    SceneView(session).get_root(document)
    document.on_change(events.append)
    send, packets = session.send, []
    session.send = lambda packet: (packets.append(packet), send(packet))  # type: ignore[func-returns-value]
    session.handle({"type": "set", "values": {"k2": 3.0}, "number": 1})
    ((packet,), (event,)) = packets, events
    message = Protocol().create("PATCH-DOC", [event])
    (buffer,) = message.buffers
    assert bytes(buffer.data) == in_one(packet)
    parts = (message.header_json, message.metadata_json, message.content_json, f'{{"id": "{buffer.id}"}}')
    assert sum(map(len, parts)) <= MOST_AROUND
