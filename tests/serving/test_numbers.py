"""Files of numbers by address: equal to those of a page, readable by pandas and curl, and limited in rate."""

from __future__ import annotations

import asyncio
import io
import zipfile
from functools import partial

import pandas as pd
import pytest

from app import NO_WALKS, visited, walked
from components.language.messages import File
from components.scenes import SCENES
from components.serving.csv_route import NumbersRoute
from components.session.exports import LinkExport, link_file
from components.session.worker import Replied
from components.state.csv_export import as_file
from tests.attack.caller import ask
from tests.grids import sample
from tests.scenes.checks import as_arguments
from tests.serving.served import FakeWorker, page_of, served, until, url
from tests.serving.server import Server
from tests.serving.visitor import Visitor

COUPLED = "/data.csv?scene=coupled&k2=3"


def link_table(query: str) -> bytes:
    return link_file(as_arguments(query), "http://here/", SCENES, NO_WALKS).content


def files_of(query: str) -> dict[str, bytes]:
    """Return the files that a page saves, by the names of their tables."""
    now = visited(as_arguments(query), NO_WALKS).now
    file = as_file(now.asked, now.to_send[0], "http://here/")
    if file.kind == "text/csv":
        return {"": file.content}
    with zipfile.ZipFile(io.BytesIO(file.content)) as packed:
        prefix = f"{now.kind.slug}-"
        return {name.removeprefix(prefix).removesuffix(".csv"): packed.read(name) for name in packed.namelist()}


@pytest.mark.parametrize("slug", sample([*SCENES], 3))
def test_every_table_is_that_of_take_away(slug: str) -> None:
    query = f"scene={slug}"
    files = files_of(query)
    assert link_table(query) == next(iter(files.values()))
    for name, content in files.items():
        assert link_table(f"{query}&table={name}") == content


def test_pandas_reads_the_numbers_of_an_address_and_the_file_says_where_it_is_from(server: Server) -> None:
    reply = ask(server.url, COUPLED)
    table = pd.read_csv(io.StringIO(reply.text), comment="#")
    scene = SCENES["coupled"](k2=3.0)
    assert list(table) == list(scene.frame())
    assert table["x1 [m]"].to_list() == scene.sources["time"].data["x1"].tolist()
    assert f"# {server.url}?scene=coupled&k2=3&view=motion" in reply.text
    assert reply.headers["Content-Type"].startswith("text/csv")
    assert reply.headers["Content-Disposition"] == 'attachment; filename="coupled.csv"'
    covered = ask(server.url, f"{COUPLED}&cover=plot:energy").text
    assert "T1 [J]" in reply.text and "x1 [m]" in covered and "[J]" not in covered
    assert ask(server.url, "/data.csv?walk=d34&step=d34-07").text.startswith("# Oscillations")


@pytest.mark.parametrize(
    ("query", "sentence"),
    [
        ("scene=coupled&k2=many", "“many” is not a number"),
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


async def test_a_worker_does_the_long_jobs_for_the_network_that_asks() -> None:
    """The event loop continues meanwhile; the job of a client who leaves is cancelled."""
    worker = FakeWorker()
    page = partial(walked([]).open_page, worker=worker)
    async with served(page, extensions=[NumbersRoute(worker, 9)]) as server:
        waits = asyncio.create_task(page_of(server, COUPLED))
        await until(lambda: len(worker.jobs) == 1)
        assert (await page_of(server, "/liveness")).status == 200
        assert worker.jobs == [(LinkExport({"scene": [b"coupled"], "k2": [b"3"]}, url(server)), "127.0.0.0/24")]
        worker.replies[0].set_result(Replied(file=File(answer=None, name="a.csv", kind="text/csv", content=b"here")))
        assert (await waits).text == "here"
        _, writer = await asyncio.open_connection("127.0.0.1", server.port)
        writer.write(f"GET {COUPLED} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\n".encode())
        await until(lambda: len(worker.jobs) == 2)
        writer.close()
        await until(worker.replies[1].cancelled)
        visitor = await Visitor.arrive(url(server), "scene=coupled")
        told = asyncio.create_task(visitor.send({"type": "csv", "page": "http://here/"}))
        await until(lambda: len(worker.jobs) == 3)
        worker.replies[2].set_result(Replied(refused="read"))
        assert "read" in (await told)["errors"]["message"]
        await visitor.depart()
