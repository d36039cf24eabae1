"""A page without a browser: sends messages to a session and reads its answers."""

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any, TypeVar

import msgspec

from components.language.messages import AnyServerMessage
from components.language.picture import PagePicture
from components.scene import Picture, Scene
from components.scene.face import SceneFace
from components.scenes import SCENES
from components.session.session import Session
from components.state.encoding import view_of
from components.state.page_state import PageState, fitted
from components.state.scene_sheet import column_axes, preset_dictionary, sheet_address
from components.state.wire import Packet, as_json, packed
from tests.page import scripts

PICTURE = 200_000
"""Calls of functions for a picture, which blocks the event loop: about 50 ms of CPU."""
Result = TypeVar("Result")


def counted(work: Callable[[], Result]) -> tuple[Result, int]:
    """Return a function's result and how many functions it called, in Python and in C: the same on every machine."""
    calls = 0

    def count(frame: FrameType, event: str, argument: Any) -> None:
        nonlocal calls
        calls += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        return work(), calls
    finally:
        sys.setprofile(before)


def value_of(scene: Scene | SceneFace) -> Scene:
    """Return the immutable scene that a face shows, or the scene itself."""
    return scene.value if isinstance(scene, SceneFace) else scene


def picture_wire(scene: Scene | SceneFace | PageState) -> dict[str, Any]:
    """Return the picture as unpacked by the browser: nested lists and dicts, columns as arrays."""
    kind = scene.kind if isinstance(scene, PageState) else type(value_of(scene))
    view, numbers = view_of(scene.shown, column_axes(kind))
    msgspec.json.decode(as_json(view), type=PagePicture)
    return dict(scripts.unpacked(packed({"view": view}, numbers))["view"])  # type: ignore[arg-type]


class Page:
    """A session and all packets that it has sent."""

    def __init__(self, shown: Scene | SceneFace | Session) -> None:
        if not isinstance(shown, Session):
            scene = value_of(shown)
            shown = Session(fitted(scene), scenes={**SCENES, scene.slug: type(scene)})
        self.session = shown
        self.packets: list[Packet] = []
        self.session.send = self.packets.append

    @property
    def now(self) -> PageState:
        return self.session.now

    @property
    def scene(self) -> Scene:
        return self.now.scene

    @property
    def shown(self) -> Picture:
        return self.now.shown

    def send(self, data: object) -> dict[str, Any]:
        """Send a message and return the answer."""
        before = len(self.packets)
        self.session.handle(data)
        assert len(self.packets) == before + 1, "every message has one answer"
        return unpacked(self.packets[-1])

    def opening(self) -> dict[str, Any]:
        return unpacked(self.session.opening())


def unpacked(packet: Packet) -> dict[str, Any]:
    """Return a message as the browser decodes it. A number that is not finite would be null and is an error."""
    known = _preset_dictionary(packet["sheet"])
    msgspec.json.decode(scripts.text_of(packet, known), type=AnyServerMessage)
    return scripts.unpacked(packet, known)


def _preset_dictionary(sheet: str) -> bytes:
    """Return the preset dictionary in the sheet at an address."""
    kinds = (*SCENES.values(), *Scene.__subclasses__())
    named = [scene for scene in kinds if f"/{vars(scene).get('slug')}." in sheet]
    return next((preset_dictionary(scene) for scene in named if sheet_address(scene) == sheet), b"")


def say(page: Page, kind: str, **message: Any) -> dict[str, Any]:
    """Send a message of a kind under the next number, and return the answer."""
    return page.send({"type": kind, **message, "number": len(page.packets) + 1})


def change(page: Page, **to: Any) -> dict[str, Any]:
    """Open another state of the current scene."""
    return say(page, "open", state=msgspec.to_builtins(page.now.state) | to)


def set_values(page: Page, **values: float | None) -> dict[str, Any]:
    return say(page, "set", values=values)
