"""A TCP proxy between a browser and the server. It can delay data, hold back streams, or fall silent."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

NONE = 0.0
PAUSE = 0.1
STREAM = b"text/event-stream"


class Between:
    """Serve at `url`, in its own thread. Each piece takes `delay()` seconds; the order is kept."""

    def __init__(self, port: int, delay: Callable[[], float], holds: bool) -> None:
        self._port = port
        self._delay = delay
        self._holds = holds
        self._silent: list[list[bool]] = []
        self._ends: list[asyncio.StreamWriter] = []
        self._loop = asyncio.new_event_loop()
        self._started = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self.port = 0

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}/"

    def silence(self) -> None:
        """Let all connections receive nothing more, not even an end, as after a phone's sleep. New connections work."""
        for silent in self._silent:
            silent[0] = True

    def start(self) -> None:
        self._thread.start()
        self._started.wait(10)

    def stop(self) -> None:
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(10)

    def _run(self) -> None:
        server = self._loop.run_until_complete(asyncio.start_server(self._join, "127.0.0.1", 0))
        self.port = server.sockets[0].getsockname()[1]
        self._started.set()
        self._loop.run_forever()
        # Closing asyncio.Server leaves connections open that it accepted in the same turn (Server._attach), so it stops
        # listening first.
        self._loop.remove_reader(server.sockets[0])
        while tasks := asyncio.all_tasks(self._loop):
            for end in self._ends:
                end.transport.abort()
            self._loop.run_until_complete(asyncio.wait(tasks, timeout=PAUSE))
        server.close()
        self._loop.close()

    async def _join(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        there, back = await asyncio.open_connection("127.0.0.1", self._port)
        silent = [False]
        self._silent.append(silent)
        self._ends += [writer, back]
        ways = self._carry(reader, back, [False]), self._carry(there, writer, silent)
        await asyncio.wait([asyncio.create_task(way) for way in ways], return_when=asyncio.FIRST_COMPLETED)
        for end in (back, writer):
            end.close()
            with suppress(ConnectionError):
                await end.wait_closed()
            self._ends.remove(end)

    async def _carry(self, source: asyncio.StreamReader, sink: asyncio.StreamWriter, silent: list[bool]) -> None:
        """Forward until the source ends. It is read on while earlier data is on its way."""
        on_its_way: asyncio.Queue[tuple[float, bytes]] = asyncio.Queue()
        sending = asyncio.create_task(self._send(on_its_way, sink, silent))
        data = b"begun"
        while data:
            try:
                data = await source.read(65536)
            except ConnectionError:
                data = b""
            silent[0] |= self._holds and STREAM in data
            on_its_way.put_nowait((self._loop.time() + self._delay(), data))
        await sending

    async def _send(
        self, on_its_way: asyncio.Queue[tuple[float, bytes]], sink: asyncio.StreamWriter, silent: list[bool]
    ) -> None:
        while True:
            due, data = await on_its_way.get()
            await asyncio.sleep(max(0.0, due - self._loop.time()))
            if not data:
                return
            if not silent[0]:
                sink.write(data)


@contextmanager
def between(port: int, delay: Callable[[], float] = lambda: NONE, holds: bool = False) -> Iterator[Between]:
    """Behave like a proxy that buffers responses if `holds`: nothing of a stream of events gets through."""
    proxy = Between(port, delay, holds)
    proxy.start()
    try:
        yield proxy
    finally:
        proxy.stop()
