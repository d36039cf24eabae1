"""Check each message of a page while it is decoded, before Bokeh joins its frames and deserialises it.

Bokeh trusts everything in a message: the number of buffers, compressed bytes, arrays of any type, models to create. Our
page needs none of that. It asks for the document, says that it is ready, and sends our component's messages:
a message is three frames (header, metadata, content), a message of ours is JSON in Bokeh's encoding.
"""

from __future__ import annotations

from typing import Annotated, Any, Generic, Literal, TypeVar

import msgspec
from bokeh.protocol.message import Message
from bokeh.protocol.messages.patch_doc import patch_doc
from bokeh.protocol.messages.pull_doc_req import pull_doc_req
from msgspec import Meta, Struct

MOST_BYTES = 64 * 1024
"""Size limit of a frame, which Tornado enforces, and of a message."""

T = TypeVar("T")


class ViolationError(Exception):
    """Raised for a message that our page never sends. The socket is then closed with the code and the reason."""

    def __init__(self, reason: str, code: int = 1008) -> None:
        super().__init__(reason)
        self.reason = reason
        self.code = code


class Header(Struct, frozen=True, forbid_unknown_fields=True):
    msgid: Annotated[str, Meta(min_length=1, max_length=64)]
    msgtype: Literal["PULL-DOC-REQ", "PATCH-DOC"]
    num_buffers: Literal[0] = 0


class Nothing(Struct, frozen=True, forbid_unknown_fields=True):
    """An empty object: the metadata of a message, and the content of a PULL-DOC-REQ."""


class NonFinite(Struct, frozen=True, forbid_unknown_fields=True, tag_field="type", tag="number"):
    """A number that JSON cannot express, in Bokeh's encoding."""

    value: Literal["nan", "+inf", "-inf"]


class Map(Struct, Generic[T], frozen=True, forbid_unknown_fields=True, tag_field="type", tag="map"):
    entries: list[tuple[str, T]] = []


# Maximum nesting of our messages. Without a limit, recursive types would let a few bytes exhaust the stack.
Level0 = None | bool | int | float | str | NonFinite
Level1 = Level0 | list[Level0] | Map[Level0]
Level2 = Level0 | list[Level1] | Map[Level1]
Level3 = Level0 | list[Level2] | Map[Level2]
Level4 = Level0 | list[Level3] | Map[Level3]
Level5 = Level0 | list[Level4] | Map[Level4]


class ModelReference(Struct, frozen=True, forbid_unknown_fields=True):
    id: Annotated[str, Meta(max_length=64)]


class Ready(Struct, frozen=True, forbid_unknown_fields=True, tag_field="name", tag="document_ready"):
    class Values(Struct, frozen=True, forbid_unknown_fields=True, tag_field="type", tag="map"):
        entries: Annotated[list[None], Meta(max_length=0)] = []

    type: Literal["event"]
    values: Values


class DataEvent(Struct, frozen=True, forbid_unknown_fields=True, tag_field="name", tag="from_browser"):
    """A message of our component (components/session/panel_bridge.py)."""

    class Values(Struct, frozen=True, forbid_unknown_fields=True, tag_field="type", tag="map"):
        entries: tuple[tuple[Literal["model"], ModelReference], tuple[Literal["data"], Level5]]

    type: Literal["event"]
    values: Values


class Event(Struct, frozen=True, forbid_unknown_fields=True):
    kind: Literal["MessageSent"]
    msg_type: Literal["bokeh_event"]
    msg_data: Ready | DataEvent


class Patch(Struct, frozen=True, forbid_unknown_fields=True):
    events: Annotated[list[Event], Meta(min_length=1, max_length=1)]

    @property
    def model(self) -> str | None:
        """The id of the model that the message is for."""
        said = self.events[0].msg_data
        return said.values.entries[0][1].id if isinstance(said, DataEvent) else None


class Incoming:
    """Assembles the messages of one socket from their frames."""

    def __init__(self) -> None:
        self._frames: list[str] = []

    def take(self, frame: str | bytes) -> Message[Any] | None:
        """Return the message that the frame completes, as Bokeh's object. Raises ViolationError for messages not from
        our page."""
        if not isinstance(frame, str):
            raise ViolationError("Binary frames are not for this page.", 1003)
        self._frames.append(frame)
        if sum(map(len, self._frames)) > MOST_BYTES:
            raise ViolationError("This message is too long.", 1009)
        if len(self._frames) < 3:
            return None
        frames, self._frames = self._frames, []
        return read(*frames)


def read(header_json: str, metadata_json: str, content_json: str) -> Message[Any]:
    """Return a message of our page. Bokeh gets the object decoded here instead of the text, which it might parse
    differently.
    """
    try:
        header = msgspec.json.decode(header_json, type=Header)
        msgspec.json.decode(metadata_json, type=Nothing)
        if header.msgtype == "PULL-DOC-REQ":
            msgspec.json.decode(content_json, type=Nothing)
            return pull_doc_req(_plain(header), {}, {})
        return patch_doc(_plain(header), {}, _plain(msgspec.json.decode(content_json, type=Patch)))
    except (msgspec.DecodeError, RecursionError) as error:
        raise ViolationError("This message does not belong to this page.") from error


def _plain(value: Struct) -> Any:
    return msgspec.to_builtins(value)
