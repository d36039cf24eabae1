"""Servers with one secret behind one address, like replicas behind a proxy. Each part can be made to fail."""

from __future__ import annotations

import asyncio
from contextlib import AbstractContextManager, suppress
from pathlib import Path
from threading import Thread
from types import TracebackType

from tests.serving.server import Server, serving

SECRET = "a secret of these tests alone"
LOOK = 0.02  # seconds between two looks at a condition


class Gate:
    """Passes connections on to the first of its targets. It can cut them or stop all data without closing."""

    def __init__(self) -> None:
        self.targets: list[int] = []
        self.held = False
        self._open: set[asyncio.StreamWriter] = set()
        self._loop = asyncio.new_event_loop()
        self._thread = Thread(target=self._loop.run_forever, daemon=True)
        self._thread.start()
        self._server = self._run(asyncio.start_server(self._serve, "127.0.0.1", 0))
        self.port: int = self._server.sockets[0].getsockname()[1]

    def cut(self) -> None:
        """End all connections; new ones are still accepted."""
        self._run(self._cut())

    def close(self) -> None:
        self.held = False
        self._server.close()
        self.cut()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    def _run(self, coroutine):  # type: ignore[no-untyped-def]
        return asyncio.run_coroutine_threadsafe(coroutine, self._loop).result(10)

    async def _cut(self) -> None:
        ended = set(self._open)
        for writer in ended:
            writer.close()
        while self._open & ended:
            await asyncio.sleep(LOOK)

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        try:
            above, onwards = await asyncio.open_connection("127.0.0.1", self.targets[0])
        except (OSError, IndexError):
            writer.close()
            return
        ends = {writer, onwards}
        self._open |= ends
        await asyncio.gather(self._pass(reader, onwards, ends), self._pass(above, writer, ends))
        self._open -= ends

    async def _pass(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, ends: set[asyncio.StreamWriter]
    ) -> None:
        with suppress(OSError):
            while data := await reader.read(65536):
                while self.held and not writer.is_closing():
                    await asyncio.sleep(LOOK)
                writer.write(data)
                await writer.drain()
        for end in ends:
            end.close()


class GatedSite:
    """Servers behind the address `url`; it begins with one server."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._running: list[tuple[AbstractContextManager[Server], Server]] = []
        self._started = 0
        self.gate = Gate()
        self.url = f"http://127.0.0.1:{self.gate.port}/"

    def __enter__(self) -> GatedSite:
        self.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        while self._running:
            self.kill()
        self.gate.close()

    def start(self) -> None:
        """Start one more server."""
        self._started += 1
        environment = {"BOKEH_SECRET_KEY": SECRET, "ALLOWED_ORIGIN": f"127.0.0.1:{self.gate.port}"}
        manager = serving(self._folder / f"log{self._started}", environment=environment)
        server = manager.__enter__()
        self._running.append((manager, server))
        self.gate.targets.append(server.port)

    def kill(self) -> None:
        """Kill the first server without a farewell to its clients."""
        manager, server = self._running.pop(0)
        self.gate.targets.remove(server.port)
        server.process.kill()
        manager.__exit__(None, None, None)
