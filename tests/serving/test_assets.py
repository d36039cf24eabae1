"""Responses without a session: static files, scripts and styles, the start page, the scripts that pages may run, and
files of numbers by address.
"""

import asyncio
import gzip
import io
import re
import zipfile
from base64 import b64encode
from collections.abc import Callable
from functools import partial
from hashlib import sha256
from urllib.parse import urljoin

import brotli
import pandas as pd
import pytest
import tinycss2
from playwright.sync_api import Page, expect

from app import NO_WALKS, visited
from components.language.messages import File
from components.scenes import SCENES
from components.serving.assets import SCENES as FOLDER
from components.serving.assets import STYLES, YEAR, assets, in_text_sizes, static_files, style_sheet
from components.serving.csv_route import NumbersRoute
from components.session.exports import LinkExport, link_file
from components.session.worker import Replied
from components.state.csv_export import as_file
from tests.grids import sample
from tests.live_class.caller import until
from tests.scenes.checks import as_arguments
from tests.serving.served import FakeWorker, lecture, page_of, served, url
from tests.serving.server import Server
from tests.serving.visitor import Visitor, ask

TYPES = {".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8", ".woff": "font/woff"}
CODINGS = {
    **{"": "", "br;q=0, gzip;q=0.0": "", "br;q=0.0, GZIP;q=0.5": "gzip", "gzip": "gzip"},
    **{"gzip, deflate, br, zstd": "br", "br;q=1.0, gzip": "br"},
}
"""The encoding that is sent, by the header of a client."""


def test_files_are_compressed_without_a_change_and_one_of_another_version_is_missing(server: Server) -> None:
    for name, asset in assets().items():
        assert gzip.decompress(asset.packed["gzip"]) == brotli.decompress(asset.packed["br"]) == asset.plain
        assert asset.type == TYPES.get(name[name.rindex(".") :], asset.type), name
    name, asset = next((name, asset) for name, asset in assets().items() if name.endswith("/start.js"))
    assert assets()[name] is asset
    for accepted, coding in CODINGS.items():
        reply = ask(server.url, f"/assets/{name}", Accept_Encoding=accepted)
        assert reply.headers.get("Content-Encoding", "") == coding
        assert int(reply.headers["Content-Length"]) == len(asset.packed[coding] if coding else asset.plain)
        assert coding or reply.text == asset.plain.decode()
        assert reply.headers["Cache-Control"] == f"public, max-age={YEAR}, immutable"
        assert reply.headers["Vary"] == "Accept-Encoding"
    other = ask(server.url, "/assets/0123456789ab/start.js")
    assert (other.status, other.headers["Cache-Control"]) == (404, "no-store")
    assert "another version" in other.text


def test_where_the_page_was_leads_to_where_it_is_with_the_query(server: Server) -> None:
    for path, query in (("app", "?k2=3&x=%20"), ("app/", "?a=1")):
        reply = ask(server.url, f"/{path}{query}")
        assert reply.status == 302
        assert urljoin(urljoin(server.url, path), reply.headers["Location"]) == server.url + query


def test_the_sheet_has_every_part_once_and_what_is_not_selected_opens_no_menu_in_safari_either() -> None:
    """Safari needs the prefixed name, and a long press opens a menu there; no browser of the tests uses that rule."""
    sheet = style_sheet().decode()
    parts = [path for path in (*STYLES.glob("*.css"), *FOLDER.glob("*/*.css")) if path.name != "style.css"]
    assert all(sheet.count(in_text_sizes(path.read_text("utf-8"))) == 1 for path in parts)
    assert "@import" not in sheet and [name for name in static_files() if name.endswith(".css")] == ["style.css"]
    assert not [node for node in tinycss2.parse_stylesheet(sheet) if node.type == "error"]
    blocks = re.findall(r"\{([^{}]*[;\s{]user-select: none[^{}]*)\}", sheet)
    assert blocks and all("-webkit-user-select" in one and "-webkit-touch-callout" in one for one in blocks)


def test_lengths_grow_with_the_text_and_lines_with_their_drawing() -> None:
    sheet = "@container screen (width < 1280px) { .a { margin: -4px 0.5px; --m1: #0a3f8a; stroke-width: 2px; } }"
    grown = (
        "@container screen (width < 80rem) { .a { margin: -0.25rem 0.03125rem; --m1: #0a3f8a; stroke-width: 2px; } }"
    )
    assert in_text_sizes(sheet) == grown


@pytest.mark.parametrize(
    ("query", "opens"),
    [
        *((query, False) for query in ("", "?theme=dark", "?scene=pendulum", "?scene=coupled&scene=forced")),
        *((query, True) for query in ("?scene=coupled", "?k2=3", "?walk=d34&step=d34-02", "in a frame")),
    ],
)
def test_a_link_that_opens_no_scene_shows_the_start_page(query: str, opens: bool, server: Server) -> None:
    def arrivals() -> float:
        return float(re.findall(r"^oscillations_arrivals_total (\S+)$", ask(server.url, "/metrics").text, re.M)[0])

    before = arrivals()
    page = ask(server.url, Sec_Fetch_Dest="iframe") if query == "in a frame" else ask(server.url, f"/{query}")
    assert page.status == 200 and arrivals() == before + opens and ('id="opening"' in page.text) is opens
    assert opens or len(re.findall('class="scene-card"', page.text)) == len(SCENES)
    assert opens or page.headers["Cache-Control"] == "no-cache"


def test_walks_are_listed_and_an_unknown_scene_is_named_in_a_sentence() -> None:
    start = lecture().start
    said, plain = start.asked({"scene": [b"<b>pendulum"]}) or "", start.asked({}) or ""
    assert "scene: “&lt;b&gt;pendulum” is not a scene: choose one of oscillator, " in said
    assert "is not a scene" not in plain and 'href="?walk=d34"' in plain


@pytest.mark.parametrize("path", ["/", "/?scene=coupled", "/?class=ABCD", "/?k2=<script>a()</script>"])
def test_the_scripts_of_a_page_are_named_by_their_hash_and_nothing_else_runs(path: str, server: Server) -> None:
    reply = ask(server.url, path)
    (allowed,) = re.findall(r"script-src ([^;]*)", reply.headers["Content-Security-Policy"])
    inline = re.findall(r"<script>(.*?)</script>", reply.text, re.S)
    hashes = [f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'" for script in inline]
    assert hashes and "a()" not in inline
    assert set(allowed.split()) == {"'self'", *hashes}


@pytest.mark.browser
@pytest.mark.parametrize("slug", sample([*SCENES], 4))
def test_a_scene_needs_only_what_its_page_allows(server: Server, new_page: Callable[..., Page], slug: str) -> None:
    """A browser reports refused content on its console; a script from elsewhere is refused."""
    page = new_page(bypass_csp=False)
    page.goto(f"{server.url}?scene={slug}")
    expect(page.locator("html[data-ready=true]")).to_be_attached(timeout=30_000)
    if (about := page.locator("details.about summary")).count():
        about.click()
        expect(page.locator("details.about table").first).to_be_visible(timeout=30_000)
    page.locator("#theme").click()
    page.get_by_text("Save and share").click()
    with page.expect_download():
        page.get_by_role("button", name="CSV").click()


COUPLED = "/data.csv?scene=coupled&k2=3"


@pytest.mark.parametrize("slug", sample([*SCENES], 3))
def test_every_table_is_that_of_take_away(slug: str) -> None:
    now = visited(as_arguments(f"scene={slug}"), NO_WALKS).now
    file = as_file(now.asked, now.to_send[0], "http://here/")
    files = {"": file.content}
    if file.kind != "text/csv":
        with zipfile.ZipFile(io.BytesIO(file.content)) as packed:
            files = {f"&table={name[len(slug) + 1 : -4]}": packed.read(name) for name in packed.namelist()}
        files[""] = next(iter(files.values()))
    for query, content in files.items():
        asked = as_arguments(f"scene={slug}{query}")
        assert link_file(asked, "http://here/", SCENES, NO_WALKS).content == content


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
    page = partial(lecture().open_page, worker=worker)
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
