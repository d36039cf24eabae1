"""The cost of a visitor: the server's CPU and memory, bytes, time to repaint, frames, the first load.

`make load` starts a server on a free loopback port, visits it by raw WebSockets and in Chromium, prints
a table and keeps it as build/load/load.md. Counts are options; the run ends after --limit seconds.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import platform
import signal
import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from statistics import median

import psutil
from playwright.sync_api import Browser, Page, Response, WebSocket, sync_playwright

from tests.serving.server import ROOT, Server, free_port, serving
from tests.serving.visitor import Visitor
from tools.bench.network import opened_slowly, start_slowly, turned
from tools.browsers.chromium import find

REPORT = ROOT / "build" / "load" / "load.md"
EMPTY_LOG = REPORT.with_name("empty.log")
EMPTY = "tools/bench/empty_page.py"
PARAMETER = "k2"
OTHERS = ["forced", "oscillator", "phugoid", "modes", "energy"]
READY = "document.documentElement.dataset.ready === 'true'"
IDLE = 0.3  # seconds for what the server does after it has answered

MOVE_SLIDER = """([selector, share]) => new Promise(painted => {
  const slider = document.querySelector(selector), low = +slider.min, high = +slider.max
  const start = performance.now()
  document.addEventListener("oscillations:painted", () => painted(performance.now() - start), {once: true})
  slider.value = low + share * (high - low)
  slider.dispatchEvent(new Event("input", {bubbles: true}))
})"""

COUNT_FRAMES = """seconds => new Promise(counted => {
  let frames = 0
  const observer = new MutationObserver(() => frames++)  // called once a frame, however much has moved
  observer.observe(document.querySelector(".stage"), {attributes: true, childList: true, subtree: true})
  setTimeout(() => { observer.disconnect(); counted(frames / seconds) }, 1000 * seconds)
})"""


@dataclass(frozen=True)
class LoadRow:
    """One line of the table; `unit` formats a figure, `aim` is what is hoped for."""

    name: str
    figures: Sequence[float]
    unit: str
    aim: str = ""

    def __str__(self) -> str:
        def show(value: float) -> str:
            return self.unit.format(value)

        spread = f"{show(min(self.figures))} to {show(max(self.figures))}"
        return f"| {self.name} | {show(median(self.figures))} | {spread} | {self.aim} |"


async def measure_sessions(server: Server, query: str, batches: int, size: int, aims: bool = True) -> list[LoadRow]:
    """CPU and memory for each session opened, in batches that stay open."""
    process = psutil.Process(server.process.pid)
    visitors = [await Visitor.arrive(server.url, query) for _ in range(size)]  # warms up
    cpu, memory = [], []
    for _ in range(batches):
        await asyncio.sleep(IDLE)
        before, held = busy(process), process.memory_info().rss
        visitors += [await Visitor.arrive(server.url, query) for _ in range(size)]
        await asyncio.sleep(IDLE)
        cpu.append(1000 * (busy(process) - before) / size)
        memory.append((process.memory_info().rss - held) / size / 1e6)
    for visitor in visitors:
        await visitor.depart()
    page = "a session" if aims else "an empty page of Panel's"
    return [
        LoadRow(f"open {page}: server CPU", cpu, "{:.0f} ms", "40 ms" if aims else ""),
        LoadRow(f"open {page}: server memory", memory, "{:.2f} MB", "0.25 MB" if aims else ""),
    ]


async def measure_changes(server: Server, query: str, batches: int, size: int) -> list[LoadRow]:
    """CPU, bytes and messages for each move of a slider of one open session."""
    process = psutil.Process(server.process.pid)
    visitor = await Visitor.arrive(server.url, query)
    cpu, kilobytes, patches = [], [], []
    for batch in range(batches + 1):
        await asyncio.sleep(IDLE)
        before, sent, messages = busy(process), visitor.bytes, visitor.patches
        for step in range(size):
            await visitor.move(PARAMETER, 1 + (batch * size + step) / 100)
        await asyncio.sleep(IDLE)
        cpu.append(1000 * (busy(process) - before) / size)
        kilobytes.append((visitor.bytes - sent) / size / 1000)
        patches.append((visitor.patches - messages) / size)
    await visitor.depart()
    return [  # the first batch warms up
        LoadRow("one slider change: server CPU", cpu[1:], "{:.1f} ms", "5 ms"),
        LoadRow("one slider change: bytes to the browser", kilobytes[1:], "{:.1f} kB", "20 kB"),
        LoadRow("one slider change: messages to the browser", patches[1:], "{:.2g}", "1"),
    ]


def measure_first_load(browser: Browser, address: str, repeats: int) -> list[LoadRow]:
    """Requests and bytes until the page is drawn, each time with an empty cache."""
    requests, plain, served = [], [], []
    for _ in range(repeats):
        answers: list[Response] = []
        frames: list[bytes] = []
        page = browser.new_page(bypass_csp=True)  # for wait_for_function
        page.on("response", lambda answer, to=answers: to.append(answer))
        page.on(
            "websocket",
            lambda socket, to=frames: socket.on("framereceived", lambda f: to.append(as_bytes(f))),
        )
        page.goto(address)
        page.wait_for_function(READY)
        bodies = [answer.body() for answer in answers if answer.url.startswith("http")]
        requests.append(len(bodies) + bool(frames))
        plain.append(total([*bodies, *frames]))
        sent = sum(answer.request.sizes()["responseBodySize"] for answer in answers if answer.url.startswith("http"))
        served.append(sent / 1e6 + total(frames))
        page.close()
    return [
        LoadRow("first load: requests", requests, "{:.0f}", "20"),
        LoadRow("first load: bytes, unpacked", plain, "{:.2f} MB"),
        LoadRow("first load: bytes, as served", served, "{:.2f} MB", "1 MB"),
    ]


def measure_repaint(page: Page, repeats: int) -> list[LoadRow]:
    """Measure the time from the input event of a slider to the repaint of its picture."""
    selector = f'input[type=range][name="{PARAMETER}-slider"]'
    times = []
    for step in range(repeats + 3):
        times.append(page.evaluate(MOVE_SLIDER, [selector, 0.3 + 0.4 * step / (repeats + 3)]))
        page.wait_for_timeout(150)
    return [LoadRow("slider to repaint in Chromium", times[3:], "{:.0f} ms", "60 ms")]  # the first three warm up


def measure_playing(page: Page, messages: list[object], repeats: int, seconds: float = 3) -> list[LoadRow]:
    """Frames a second of the stage while it plays, and messages in either direction meanwhile."""
    play = page.get_by_role("button", name="Play", exact=True)
    if play.count():
        play.click()
    page.wait_for_timeout(500)
    frames, sent = [], []
    for _ in range(repeats):
        before = len(messages)
        frames.append(page.evaluate(COUNT_FRAMES, seconds))
        sent.append(len(messages) - before)
    return [
        LoadRow("playing: frames a second", frames, "{:.0f}", "60"),
        LoadRow("playing: messages either way", sent, "{:.0f}", "0"),
    ]


def measure_start(browser: Browser, url: str, repeats: int) -> list[LoadRow]:
    """The start page with an empty cache at 1.6 Mbit/s and 150 ms."""
    loaded, sizes = zip(*(start_slowly(browser, url) for _ in range(repeats)), strict=True)
    return [
        LoadRow("start page: bytes, as served", sizes, "{:.0f} kB", "200 kB"),
        LoadRow("start page: loaded at 1.6 Mbit/s, 150 ms", [one / 1000 for one in loaded], "{:.1f} s", "1.0 s"),
    ]


def measure_slow_network(browser: Browser, address: str, repeats: int) -> list[LoadRow]:
    """A page with an empty cache at 1.6 Mbit/s and 150 ms, and then another scene."""
    seen = [opened_slowly(browser, address, OTHERS[0]) for _ in range(repeats)]
    aims = {"paint": ("first paint", 1.5), "moving": ("the stage moves", 2.5), "whole": ("all is drawn", 6.0)}
    aims["next"] = ("the next scene is drawn", 1.0)
    return [
        LoadRow(f"1.6 Mbit/s, 150 ms: {what}", [one[name] / 1000 for one in seen], "{:.1f} s", f"{aim:.1f} s")
        for name, (what, aim) in aims.items()
    ]


def measure_turns(page: Page, repeats: int) -> list[LoadRow]:
    """Measure changes of scene within a session whose sheets have been fetched before."""
    turned(page, OTHERS)
    turns = [turn for _ in range(repeats) for turn in turned(page, OTHERS)]
    return [
        LoadRow("new scene: stage and controls are drawn", [one["stands"] for one in turns], "{:.0f} ms", "150 ms"),
        LoadRow("change of scene: plots as well", [one["whole"] for one in turns], "{:.0f} ms"),
    ]


def measure_browser(address: str, options: argparse.Namespace) -> list[LoadRow]:
    path = find()
    if path is None:
        print("No Chromium: what a browser measures is left out.")
        return []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path)
        rows = measure_first_load(browser, address, min(3, options.batches))
        page = browser.new_page(viewport={"width": 1280, "height": 720}, bypass_csp=True)
        messages: list[object] = []
        page.on("websocket", lambda socket: listen(socket, messages))
        page.goto(address)
        page.wait_for_function(READY)
        page.wait_for_timeout(1000)
        pause = page.get_by_role("button", name="Pause", exact=True)
        if pause.count():
            pause.click()
        rows += measure_repaint(page, options.changes)
        rows += measure_playing(page, messages, min(5, options.batches))
        rows += measure_turns(page, min(3, options.batches))
        rows += measure_slow_network(browser, address, min(3, options.batches))
        rows += measure_start(browser, address.partition("?")[0], min(3, options.batches))
        browser.close()
    return rows


def listen(socket: WebSocket, messages: list[object]) -> None:
    socket.on("framesent", lambda frame: messages.append(frame))
    socket.on("framereceived", lambda frame: messages.append(frame))


def busy(process: psutil.Process) -> float:
    """CPU seconds used so far; they advance in steps of 10 ms, hence the batches."""
    times = process.cpu_times()
    return float(times.user + times.system)


def as_bytes(frame: str | bytes) -> bytes:
    return frame.encode() if isinstance(frame, str) else frame


def total(parts: Iterable[bytes]) -> float:
    return sum(map(len, parts)) / 1e6


def machine() -> str:
    packages = ", ".join(f"{name} {version(name)}" for name in ("panel", "bokeh", "numpy"))
    return f"{os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}, {packages}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--query", default="scene=coupled", help="the link to open (default: %(default)s)")
    parser.add_argument("--batches", type=int, default=5, help="batches a median is taken over (%(default)s)")
    parser.add_argument("--sessions", type=int, default=10, help="sessions opened in a batch (%(default)s)")
    parser.add_argument("--changes", type=int, default=40, help="slider changes in a batch (%(default)s)")
    parser.add_argument("--limit", type=int, default=300, help="seconds after which the run stops (%(default)s)")
    options = parser.parse_args()
    if hasattr(signal, "alarm"):  # not on Windows
        signal.signal(signal.SIGALRM, stop)
        signal.alarm(options.limit)
    REPORT.parent.mkdir(parents=True, exist_ok=True)
    with panel_serving(EMPTY_LOG) as server:
        floor = asyncio.run(measure_sessions(server, "", options.batches, options.sessions, aims=False))
    with serving(REPORT.parent / "server.log") as server:
        rows = asyncio.run(measure_sessions(server, options.query, options.batches, options.sessions))
        rows += asyncio.run(measure_changes(server, options.query, options.batches, options.changes))
        rows += measure_browser(f"{server.url}?{options.query}", options)
    report([*rows, *floor], options.query)


@contextmanager
def panel_serving(log: Path) -> Iterator[Server]:
    """An empty page, served as Panel does it."""
    port = free_port()
    at = ("--index", "empty_page", "--port", str(port), "--allow-websocket-origin", f"127.0.0.1:{port}")
    with serving(log, port=port, command=(sys.executable, "-m", "panel", "serve", EMPTY, *at)) as server:
        yield server


def stop(*_: object) -> None:
    raise TimeoutError("the measurement has reached its --limit")


def report(rows: Sequence[LoadRow], query: str) -> None:
    head = f"`/?{query}`, {time.strftime('%Y-%m-%d')}: {machine()}"
    table = ["| what | median | from, to | aim |", "|---|---|---|---|", *map(str, rows)]
    text = "\n".join([head, "", *table, ""])
    REPORT.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
