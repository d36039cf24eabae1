"""The server's side of a page: it answers every message of a browser and forgets visitors who have left."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from bokeh.document import Document
from bokeh.document.events import DocumentPatchedEvent
from bokeh.protocol import Protocol

from components.scenes.coupled import Coupled
from components.session.panel_bridge import SceneView
from components.session.session import Session
from components.state.page_state import fitted
from components.state.wire import in_one
from tests.page.headless_page import Page

LONG = "x" * 100_000
MOST_AROUND = 195
"""Bytes of a Bokeh message around one of ours: header 60, metadata 2, content 103, header of the buffer 15."""
NESTED: list[Any] = []
for _ in range(200):
    NESTED = [NESTED]


@pytest.mark.parametrize(
    "message",
    [
        None,
        [],
        "set",
        {},
        {"type": ["set"]},
        {"type": np.arange(3)},
        {"type": "set", "values": None},
        {"type": "set", "values": {5: 1.0}},
        {"type": "set", "values": {LONG: 1.0}},
        {"type": "set", "values": {f"k{i}": 1.0 for i in range(1000)}},
        {"type": "set", "values": {"k2": LONG}},
        {"type": "set", "values": {"k2": NESTED}},
        {"type": "set", "values": {"k2": np.arange(3)}},
        {"type": "set", "values": {"k2": math.nan}},
        {"type": "set", "values": {"k2": 10**4000}},
        {"type": "typed", "name": LONG, "text": "1"},
        {"type": "typed", "name": "k2", "text": LONG},
        {"type": "typed", "name": "k2", "text": "\ud800"},
        {"type": "act", "name": LONG},
        {"type": "choose", "name": LONG, "value": "1"},
        {"type": "choose", "name": "hidden", "value": LONG},
        {"type": "choose", "name": "hidden", "value": NESTED},
        {"type": "choose", "name": "energy", "value": math.inf},
        {"type": "run", "order": LONG},
    ],
    ids=lambda message: str(message)[:40],
)
def test_what_the_page_would_not_send_is_refused_in_a_short_answer(message: object) -> None:
    page = Page(Coupled())
    before = page.shown
    answer = page.send(message)
    assert page.shown is before
    (error,) = answer["errors"].items()
    assert 0 < len("".join(error).encode()) < 400


@pytest.mark.parametrize("number", [None, math.nan, LONG, NESTED, np.arange(3), {"a": 1}, -1, 10**4000])
def test_only_a_number_is_sent_back_as_the_number_of_a_message(number: object) -> None:
    page = Page(Coupled())
    assert page.send({"type": "set", "values": {"k2": -0.0}, "number": number})["answer"] is None
    assert page.send({"type": "set", "values": {"k2": 3.0}, "number": 7})["answer"] == 7


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
