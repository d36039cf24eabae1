"""Upkeep of the rooms: listens to the store, counts who is here, and recovers after an outage of the store."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Awaitable
from contextlib import suppress
from secrets import token_hex
from time import monotonic, time

from components.language.class_messages import News
from components.live_class.registry import ClosedError, Registry
from components.live_class.room import SILENCE, ClassRoom
from components.live_class.store import FullError, Parts, UnreachableError

log = logging.getLogger(__name__)

AGAIN = 0.5
"""Seconds until an unavailable store is tried again."""
PATIENCE = 3
"""Attempts to find a room in the store before it counts as ended; the instructor's replica may write it back."""
TRIES = 5
"""Attempts to read a room from the store while others change it."""
FAREWELL = 1.0
"""Seconds for which a replica waits, when it shuts down, for the store to record that it has no followers."""
COUNTING = 1.0
"""Seconds between counts of the followers."""
CROWD = 500
"""Followers for each further second between counts of the answers. With fewer there is a count every second."""
SKEW = 0.2
"""Seconds by which the clocks of replicas may differ. For followers at another replica, the instructor's time is off by
this.
"""


class Upkeep:
    """The upkeep of the rooms of one registry. Start it in a running event loop."""

    def __init__(self, registry: Registry) -> None:
        self.registry = registry
        self._replica = token_hex(6)
        self._tasks: list[asyncio.Task[None]] = []
        self._round = 0
        self._named: dict[str, frozenset[str]] = {}
        """The followers here, by room, that were last sent to the store."""
        self._full = False
        self.listening = False
        self.rooms = 0
        """The number of rooms that the store has."""
        self.skew = 0.0
        """Seconds by which this machine's clock is ahead of the store's."""

    def start(self) -> None:
        self._tasks = [asyncio.create_task(self._listen()), asyncio.create_task(self._look())]

    async def end(self) -> None:
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        for room in list(self.registry.rooms.values()):
            for listener in list(room.listeners):
                listener.end()
        with suppress(TimeoutError):
            async with asyncio.timeout(FAREWELL):
                await asyncio.gather(*(self._safely(self._left(room)) for room in self.registry.rooms.values()))
        await self.registry.store.close()

    async def _left(self, room: ClassRoom) -> None:
        """Remove this replica's followers from the store. They are counted again at the replica to which they
        reconnect."""
        await self.registry.store.present(room.code, self._replica, ())

    async def _listen(self) -> None:
        back, lost = asyncio.Event(), 0.0
        while True:
            task, reason = asyncio.create_task(self._return(back, lost)), "nothing is said"
            try:
                await self.registry.store.listen(self._receive, back.set)
            except UnreachableError as error:
                reason = str(error.__cause__ or error)
            except Exception:
                log.exception("The store that replicas share could not be listened to")
            task.cancel()
            back.clear()
            if self.listening or not lost:
                log.warning("The store that replicas share is away: %s", reason)
                lost = monotonic()
            self.listening = False
            self._say(lost=True)
            await asyncio.sleep(AGAIN)

    def _receive(self, code: str, parts: Parts) -> None:
        """Pass an update on. An unreadable one, for example from another version, is ignored."""
        try:
            self.registry.receive(code, parts)
        except Exception:
            log.exception("News of a live class could not be read")

    async def _return(self, back: asyncio.Event, lost: float) -> None:
        """Load missed updates, and restore rooms that are led here if the store has lost them."""
        await back.wait()
        self.listening = True
        if lost:
            log.warning("The store that replicas share is back after %.1f s", monotonic() - lost)
        for room in list(self.registry.rooms.values()):
            await self._safely(self._restore(room))
        self._say(lost=False)

    def _say(self, lost: bool) -> None:
        for room in list(self.registry.rooms.values()):
            if room.lost != lost:
                room.change(lost=lost)

    async def _restore(self, room: ClassRoom) -> None:
        store = self.registry.store
        if room.is_led and await store.open(room.code, room.parts):
            for question, votes in room.votes.items():
                for voter, vote in votes.items():
                    await store.vote(room.code, question, voter, vote)
            await self.registry.write(room, room.parts)
        await self._save(room)
        parts = await self._looked_up(room)
        changed = {name: part for name, part in parts.items() if name != "by" and room.parts.get(name) != part}
        room.missed = 0 if parts else room.missed + 1
        if room.missed == PATIENCE:
            self.registry.receive(room.code, {})
        elif changed:
            room.deliver(changed)

    async def _save(self, room: ClassRoom) -> None:
        """Store unsaved parts. If the store has lost the room, the instructor's replica restores it first."""
        if room.unsaved:
            with suppress(ClosedError):
                await self.registry.write(room, dict(room.unsaved))

    async def _looked_up(self, room: ClassRoom) -> Parts:
        """Return the parts of a room in the store; ask again if newer ones may have arrived meanwhile."""
        for _ in range(TRIES):
            number = room.number
            parts = await self.registry.store.parts(room.code)
            if room.number == number:
                return parts
        return room.parts

    async def _look(self) -> None:
        while True:
            await asyncio.sleep(COUNTING)
            self._round += 1
            if self._round % int(SILENCE / COUNTING) == 1:
                await self._safely(self._look_at_store())
            for room in list(self.registry.rooms.values()):
                await self._safely(self._look_at(room))

    async def _safely(self, act: Awaitable[None]) -> None:
        """Check one room. An error there is logged and does not affect the others."""
        try:
            await act
        except (UnreachableError, ClosedError):
            pass
        except FullError as reason:
            if not self._full:
                log.warning("%s", reason)
            self._full = True
        except Exception:
            log.exception("A live class could not be looked after")

    async def _look_at_store(self) -> None:
        """Ask the store for the number of its rooms, and whether its clock and this machine's agree."""
        self.rooms = await self.registry.store.rooms()
        skew = time() - await self.registry.store.time()
        if abs(skew) > SKEW >= abs(self.skew):
            log.warning("This machine's clock is %+.1f s off the store's: replicas show a class different times", skew)
        self.skew = skew

    async def _look_at(self, room: ClassRoom) -> None:
        """Count the followers of a room here. Send a changed number to the store at once, an unchanged one now and
        then."""
        turn = self._round % int(SILENCE / COUNTING) == 0
        room.look()
        if not room.lost:
            await (self._restore if turn else self._save)(room)
        if turn and room.is_led:
            await self.registry.store.keep(room.code, {})
        here = await self.registry.store.present(room.code, self._replica, room.following)
        names = frozenset(room.names)
        if turn or names != self._named.get(room.code, frozenset()):
            await self.registry.store.name(room.code, self._replica, names)
            self._named[room.code] = names
        if here != room.here:
            room.change(here=here)
        elif turn:
            room.say(News(number=room.number, here=here))
        if room.recount and self._round % (1 + room.followers // CROWD) == 0:
            await self.registry.count(room)
        self._full = False
        self.registry.leave(room)
        if room.code not in self.registry.rooms:
            self._named.pop(room.code, None)
