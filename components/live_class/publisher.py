"""The publisher: sends pictures of an instructor's session to the class, encoded once for all followers, at a limited
rate.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable

from components.language.class_messages import SentPicture
from components.live_class.registry import ClosedError, Registry
from components.live_class.store import FullError, UnreachableError
from components.state.wire import Packet

log = logging.getLogger(__name__)

SPAN = 0.2
"""Seconds between two sent pictures. Of the pictures in between, only the newest is sent."""
AGAIN = 1.0
"""Seconds until a failed picture is sent again."""


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
        """Stop publishing; a picture that waits for the store is dropped."""
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
        """Publish a picture. Return False if the room is unknown here and the store unavailable; try again then."""
        try:
            room = await self._registry.led(self._code, self._key)
            await self._registry.show(room, SentPicture(**make()))
        except UnreachableError:
            return False
        except (ClosedError, FullError):
            pass  # the room's own news informs the instructor's page; the upkeep handles a full store
        except Exception:
            log.exception("A picture could not be made ready for a class")
        return True
