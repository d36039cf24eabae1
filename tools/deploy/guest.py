"""A visitor without a browser. Like the page, it reconnects when its server is gone and restores its values."""

from __future__ import annotations

import asyncio
from http.client import HTTPConnection, HTTPException
from time import monotonic
from typing import Any
from urllib.parse import urlsplit

from tests.serving.visitor import Visitor, token_of

PATIENCE = 30.0
AGAIN = 0.1
"""Seconds until the next attempt to reconnect."""


class ReturningVisitor:
    """Opens a scene and changes one value; `cookies` says whether the client keeps the proxy's cookie."""

    def __init__(self, url: str, cookies: bool) -> None:
        self.url = url
        self.cookies = cookies
        self.answer: dict[str, Any] = {}
        self.longest = 0.0
        """Longest time in s that a change took."""
        self.returns = 0
        self._headers: dict[str, str] = {}
        self._token = ""
        self._visitor: Visitor | None = None

    async def arrive(self, query: str) -> None:
        await self._load(query)
        await self._connect()

    async def change(self, values: dict[str, float]) -> None:
        """Set values, even if the server disappears in between."""
        begun = monotonic()
        while monotonic() - begun < PATIENCE:
            try:
                visitor = self._visitor or await self._reconnected()
                self.answer = await visitor.send({"type": "set", "values": values})
                self.longest = max(self.longest, monotonic() - begun)
                return
            except (ConnectionError, TimeoutError):
                await self.leave()
                await asyncio.sleep(AGAIN)
        raise TimeoutError("nobody answers any more")

    async def leave(self) -> None:
        """Close the connection; also called after it was lost."""
        if self._visitor:
            await self._visitor.depart()
        self._visitor = None

    async def _reconnected(self) -> Visitor:
        """Open a session on any replica and restore the state that the page has kept."""
        visitor = await self._connect()
        self.returns += 1
        if self.answer:
            await visitor.send({"type": "open", "state": self.answer["state"]})
        return visitor

    async def _connect(self) -> Visitor:
        self._visitor = await Visitor.connect(self.url, self._token, self._headers)
        return self._visitor

    async def _load(self, query: str) -> None:
        page, cookie = await asyncio.to_thread(_page, self.url, query)
        self._token = token_of(page)
        if self.cookies and cookie:
            self._headers = {"Cookie": cookie.partition(";")[0]}


def _page(url: str, query: str) -> tuple[str, str]:
    """Return the page and the cookie that came with it."""
    connection = HTTPConnection(urlsplit(url).netloc, timeout=PATIENCE)
    try:
        connection.request("GET", f"/?{query}")
        answer = connection.getresponse()
        return answer.read().decode(), answer.headers.get("Set-Cookie", "")
    except HTTPException as error:
        raise ConnectionError(str(error)) from error
    finally:
        connection.close()
