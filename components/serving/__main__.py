"""The start command: `python -m components.serving [--port 8000]`, in the folder of app.py."""

from __future__ import annotations

import asyncio
import gc
import logging
import os
import signal
import sys
import webbrowser
from contextlib import suppress
from functools import partial
from pathlib import Path

import segno

from components.live_class.routes import LiveClass
from components.live_class.store import MemoryStore, Store
from components.serving.csv_route import NumbersRoute
from components.serving.logs import set_up
from components.serving.server import Server
from components.serving.settings import Settings, misspelt, read_settings
from components.serving.worker_process import ReadingProcess
from components.walks.loading import WalkError

log = logging.getLogger(__name__)

WARM_UP = 20.0
"""Seconds from the start of the server to the start of the worker process, so that its first user does not wait."""


def store_at(url: str) -> Store:
    """Return the store of live classes at an address. The client of a shared store is imported only if one is used."""
    if not url:
        return MemoryStore()
    from components.live_class.shared_store import SharedStore

    return SharedStore(url)


def tell(settings: Settings, port: int) -> str:
    """Print the address of the lecture in a terminal, with a QR code for phones. Return its address on this machine."""
    address = f"http://{'localhost' if settings.everywhere else settings.address}:{port}/"
    log.info("The lecture is at %s", address)
    if known := settings.known_at(port):
        log.info("Phones type %s", known)
        if sys.stderr.isatty():
            segno.make(known, micro=False).terminal(sys.stderr, border=2, compact=True)
    elif settings.everywhere:
        log.warning("This machine is in no network that it knows of: PUBLIC_URL names the address that phones type")
    return address


async def serve(settings: Settings) -> None:
    """Serve until the process is asked to end."""
    # Importing all scenes takes seconds. The first line of the log does not wait for it.
    from app import FIGURES, walked

    folders = [settings.walks] if settings.walks else []
    lecture, worker = walked(map(Path, folders)), ReadingProcess("reading", *folders)
    lecture.bank.worker = worker
    store = store_at(settings.store)
    live_class = LiveClass(store, lecture.bank, settings.class_passphrase, settings.bokeh_secret_key)
    numbers = NumbersRoute(worker, settings.arrivals)
    open_page = partial(lecture.open_page, lead=live_class.lead, worker=worker)
    figures = {**FIGURES, "readings": ("Jobs of the worker process that run or wait", lambda: worker.pending)}
    server = Server(open_page, settings, figures, lecture.files, [live_class, numbers], lecture.start)
    asyncio.get_running_loop().call_later(WARM_UP, worker.warm)
    asked: asyncio.Queue[float] = asyncio.Queue()
    for name, notice in ((signal.SIGTERM, settings.notice_seconds), (signal.SIGINT, 0.0)):
        with suppress(NotImplementedError):  # on Windows Ctrl+C arrives as an exception
            asyncio.get_running_loop().add_signal_handler(name, asked.put_nowait, notice)
    gc.collect()
    gc.freeze()  # garbage collection of these objects blocked the event loop for 0.1 s
    address = tell(settings, server.port)
    if settings.show:
        webbrowser.open(address)
    await server.end(await asked.get())
    worker.close()
    log.info("The lecture has ended")


def main() -> None:
    try:
        settings = read_settings(sys.argv[1:], os.environ)
    except ValueError as refusal:
        sys.exit(str(refusal))
    set_up(settings.log_format, settings.log_visitors)
    log.info("The server starts")
    for line in misspelt(os.environ):
        log.warning(line)
    try:
        asyncio.run(serve(settings))
    except WalkError as refusal:
        sys.exit(f"WALKS: {refusal}")
    except OSError as error:
        sys.exit(f"The server cannot listen at {settings.address}, port {settings.port}: {error.strerror}.")
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
