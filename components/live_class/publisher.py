"""The publisher: from an instructor's session to the class, made ready once for all who follow, and not too often."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable

from components.language.room import SentPicture
from components.live_class.registry import ClosedError, Registry
from components.live_class.store import AwayError, FullError
from components.state.wire import Packet

log = logging.getLogger(__name__)

SPAN = 0.2
"""Seconds between pictures, of which the newest counts."""
AGAIN = 1.0
"""Seconds until one is tried again."""


class Publisher:
    """The publisher of one session, for the room that it leads."""

    def __init__(self, registry: Registry, code: str, key: str) -> None:
        self._registry = registry
        self._code = code
        self._key = key
        self._make: Callable[[], Packet] | None = None
        self._task: asyncio.Task[None] | None = None

    def __call__(self, make: Callable[[], Packet]) -> None:
        self._make = make
        if self._task is None:
            self._task = asyncio.create_task(self._run())

    def end(self) -> None:
        """End the publishing: nothing more is told, not even what waits for a store that is away."""
        self._make = None
        if self._task:
            self._task.cancel()

    async def _run(self) -> None:
        try:
            while make := self._make:
                self._make = None
                is_shown = await self._show(make)
                if not is_shown:
                    self._make = self._make or make
                await asyncio.sleep(SPAN if is_shown else AGAIN)
        finally:
            self._task = None

    async def _show(self, make: Callable[[], Packet]) -> bool:
        """False where the room is not known here, and the store away: it is to be tried again."""
        try:
            room = await self._registry.led(self._code, self._key)
            await self._registry.show(room, SentPicture(**make()))
        except AwayError:
            return False
        except (ClosedError, FullError):
            pass  # the instructor's page is told by the room's own news; a full store is looked after
        except Exception:
            log.exception("A picture could not be made ready for a class")
        return True
