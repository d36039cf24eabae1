"""The contents of a remote control: the question, its answers so far, and the next action of the first screen."""

from __future__ import annotations

from msgspec.structs import replace

from components.language.class_messages import DescribeScreen, RemoteView
from components.live_class.registry import Registry
from components.live_class.room import ClassRoom


async def remote_view(registry: Registry, room: ClassRoom) -> RemoteView:
    """Return the contents of a remote control, without single numbers and sketches, of which there can be thousands."""
    put, screen = room.question, room.part("screen", DescribeScreen)
    view = RemoteView(number=room.number, question=put, here=room.here, screen=screen)
    tally = await registry.tally(room)
    if tally is None:
        return view
    bank = registry.bank_of(room)
    return replace(
        view,
        tally=replace(tally, now=replace(tally.now, numbers=(), sketches=()), before=None),
        lesson=bank.unanswered(put.walk, put.step),
        judges=bank.judges(put.walk, put.step),
        notes=bank.notes(put.walk, put.step),
    )
