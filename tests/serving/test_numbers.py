"""Files of numbers by address: equal to those of a page, readable by pandas and curl, and limited in rate."""

from __future__ import annotations

import asyncio
import io
import zipfile
from concurrent.futures import Future
from functools import partial
from pathlib import Path
from typing import Any

import pandas as pd
import pytest
from tornado.httpclient import AsyncHTTPClient

from app import NO_WALKS, SHEETS, visited, walked
from components.language.messages import File
from components.scenes import SCENES
from components.serving.csv_route import NumbersRoute
from components.serving.server import Server as Serving
from components.serving.settings import Settings
from components.serving.worker_process import ReadingProcess
from components.session.exports import LinkExport, link_file
from components.session.worker import Replied, WorkerJob
from components.state.csv_export import as_file
from tests.attack.caller import ask
from tests.scenes.checks import as_arguments
from tests.serving.server import Server, serving
from tests.serving.visitor import Visitor

scenes = pytest.mark.parametrize("slug", SCENES)
COUPLED = "/data.csv?scene=coupled&k2=3"


def link_table(query: str) -> bytes:
    return link_file(as_arguments(query), "http://here/", SCENES, NO_WALKS).content


def files_of(query: str, page: str) -> dict[str, bytes]:
    """Return the files that a page saves, by the names of their tables."""
    now = visited(as_arguments(query), NO_WALKS).now
    file = as_file(now.asked, now.to_send[0], page)
    if file.kind == "text/csv":
        return {"": file.content}
    with zipfile.ZipFile(io.BytesIO(file.content)) as packed:
        prefix = f"{now.kind.slug}-"
        return {name.removeprefix(prefix).removesuffix(".csv"): packed.read(name) for name in packed.namelist()}


@scenes
def test_every_table_is_that_of_take_away(slug: str) -> None:
    query = f"scene={slug}"
    files = files_of(query, "http://here/")
    assert link_table(query) == next(iter(files.values()))
    for name, content in files.items():
        assert link_table(f"{query}&table={name}") == content


def test_pandas_reads_the_numbers_of_an_address(server: Server) -> None:
    table = pd.read_csv(f"{server.url}data.csv?scene=coupled&k2=3", comment="#")
    scene = SCENES["coupled"](k2=3.0)
    assert list(table) == list(scene.frame())
    assert table["x1 [m]"].to_list() == scene.sources["time"].data["x1"].tolist()


def test_the_file_says_where_it_is_from(server: Server) -> None:
    reply = ask(server.url, COUPLED)
    assert f"# {server.url}?scene=coupled&k2=3&view=motion" in reply.text
    assert reply.headers["Content-Type"].startswith("text/csv")
    assert reply.headers["Content-Disposition"] == 'attachment; filename="coupled.csv"'
    assert ask(server.url, COUPLED, "HEAD").text == ""


def test_what_is_covered_stays_out(server: Server) -> None:
    assert "T1 [J]" in ask(server.url, COUPLED).text
    reply = ask(server.url, f"{COUPLED}&cover=plot:energy")
    assert reply.status == 200 and "x1 [m]" in reply.text and "[J]" not in reply.text
    whole = ask(server.url, "/data.csv?walk=d34&step=d34-07").text
    assert whole.startswith("# Oscillations")


@pytest.mark.parametrize(
    ("query", "sentence"),
    [
        ("scene=coupled&k2=many", "“many” is not a number"),
        ("scene=coupled&k2=-1", "not possible: a stiffness"),
        ("scene=nowhere", "“nowhere”"),
        ("scene=coupled&k9=1", "k9"),
        ("scene=coupled&table=more", "“more” is not a table of these numbers: choose one of time, modes."),
        ("scene=coupled&cover=plot:nothing", "“plot:nothing” cannot be covered here."),
        ("scene=oscillator&m=1e308&k=1e308&x_0=1e308&v_0=1e308", "The link"),
        ("scene=driven&omega=1e150", "takes more digits of arithmetic than are allowed"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(server: Server, query: str, sentence: str) -> None:
    reply = ask(server.url, f"/data.csv?{query}")
    assert reply.refused and reply.status == 400
    assert reply.headers["Content-Type"] == "text/plain; charset=utf-8"
    assert sentence in reply.text and "<" not in reply.text


def test_a_window_too_short_for_its_points_is_no_fault(server: Server) -> None:
    """The power of `driven` once divided by the time between two points, which is 0 here; the server answered 500."""
    query = "kind=unbalance&F_0=1e100&omega=11.729809191764284&k=1e-300&c=33.108882784528554&keep=zeta&x_0=-1e-100"
    reply = ask(server.url, f"/data.csv?scene=driven&window=5e-324&{query}")
    assert reply.status == 400 and "range of doubles" in reply.text


class Worker:
    """A worker that holds jobs and their replies."""

    def __init__(self) -> None:
        self.jobs: list[tuple[WorkerJob, str, Future[Replied]]] = []

    def ask(self, asked: WorkerJob, network: str = "") -> Future[Replied]:
        self.jobs.append((asked, network, Future()))
        return self.jobs[-1][-1]


async def test_the_worker_makes_the_file_for_the_network_that_asks() -> None:
    """The event loop continues meanwhile; the job of a client who leaves is cancelled."""
    worker = Worker()
    running = Serving(
        lambda document: None, Settings(address="127.0.0.1", port=0), extensions=[NumbersRoute(worker, 9)]
    )
    client, url = AsyncHTTPClient(), f"http://127.0.0.1:{running.port}"
    waits = client.fetch(f"{url}{COUPLED}")
    while not worker.jobs:
        await asyncio.sleep(0.01)
    assert (await client.fetch(f"{url}/liveness")).code == 200
    ((job, network, reply),) = worker.jobs
    assert job == LinkExport({"scene": [b"coupled"], "k2": [b"3"]}, f"{url}/") and network == "127.0.0.0/24"
    reply.set_result(Replied(file=File(answer=None, name="coupled.csv", kind="text/csv", content=b"here")))
    assert (await waits).body == b"here"
    _, writer = await asyncio.open_connection("127.0.0.1", running.port)
    writer.write(f"GET {COUPLED} HTTP/1.1\r\nHost: 127.0.0.1:{running.port}\r\n\r\n".encode())
    while len(worker.jobs) < 2:
        await asyncio.sleep(0.01)
    writer.close()
    while not worker.jobs[1][-1].cancelled():
        await asyncio.sleep(0.01)
    waits = client.fetch(f"{url}{COUPLED}", raise_error=False)
    while len(worker.jobs) < 3:
        await asyncio.sleep(0.01)
    worker.jobs[2][-1].set_result(Replied(refused="Later.", is_busy=True, after=1.5))
    refused = await waits
    assert (refused.code, refused.headers["Retry-After"], refused.body) == (429, "2", b"Later.\n")
    await running.end()


def test_a_network_asks_for_as_many_tables_as_it_opens_pages(tmp_path: Path) -> None:
    with serving(tmp_path / "log", options=("--arrivals", "3")) as running:
        replies = [ask(running.url, COUPLED) for _ in range(5)]
        assert [reply.status for reply in replies] == [200, 200, 200, 429, 429]
        assert int(replies[-1].headers["Retry-After"]) >= 1
        assert ask(running.url).status == 200, "pages are counted by themselves"
        assert ask(running.url, "/data.csv?" + "x" * 9000).status == 414
        assert ask(running.url, COUPLED, Host="elsewhere.example").status == 403


@pytest.mark.parametrize("message", [{"type": "csv", "page": "http://here/"}, {"type": "about"}], ids=["csv", "about"])
async def test_a_page_gives_long_jobs_to_a_worker_that_is_idle(message: dict[str, Any]) -> None:
    """A worker without jobs was once treated as missing."""
    worker = ReadingProcess("tests.serving.hanging")
    running = Serving(
        partial(walked([]).open_page, worker=worker), Settings(address="127.0.0.1", port=0), sheets=SHEETS
    )
    visitor = await Visitor.arrive(f"http://127.0.0.1:{running.port}/", "scene=coupled")
    told = await visitor.send(message)
    assert "read" in (told["errors"]["message"] if message["type"] == "csv" else told["notes"][0])
    await visitor.depart()
    await running.end()
    worker.close()
