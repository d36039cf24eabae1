"""Numbers by address: what a page takes away, for pandas and for curl, and for nobody more than is good."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import pandas as pd
import pytest

from app import NO_WALKS, visited
from components.scenes import SCENES
from components.session.exports import link_file
from components.state.csv_export import as_file
from tests.attack.caller import ask
from tests.scenes.checks import as_arguments
from tests.serving.server import Server, serving

scenes = pytest.mark.parametrize("slug", SCENES)
COUPLED = "/data.csv?scene=coupled&k2=3"


def link_table(query: str) -> bytes:
    return link_file(as_arguments(query), "http://here/", SCENES, NO_WALKS).content


def files_of(query: str, page: str) -> dict[str, bytes]:
    """The files that a page takes away, by the names of their tables."""
    now = visited(as_arguments(query), NO_WALKS).now
    file = as_file(now.asked, now.told[0], page)
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
    assert f"# {server.url}?scene=coupled&k2=3.0".removesuffix(".0") in reply.text
    assert reply.headers["Content-Type"].startswith("text/csv")
    assert reply.headers["Content-Disposition"] == 'attachment; filename="coupled.csv"'
    assert ask(server.url, COUPLED, "HEAD").text == ""


def test_what_is_covered_stays_out(server: Server) -> None:
    assert "e1 [J]" in ask(server.url, COUPLED).text
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
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(server: Server, query: str, sentence: str) -> None:
    reply = ask(server.url, f"/data.csv?{query}")
    assert reply.refused and reply.status == 400
    assert sentence in reply.text


def test_a_network_asks_for_as_many_tables_as_it_opens_pages(tmp_path: Path) -> None:
    with serving(tmp_path / "log", options=("--arrivals", "3")) as running:
        replies = [ask(running.url, COUPLED) for _ in range(5)]
        assert [reply.status for reply in replies] == [200, 200, 200, 429, 429]
        assert int(replies[-1].headers["Retry-After"]) >= 1
        assert ask(running.url).status == 200, "pages are counted by themselves"
        assert ask(running.url, "/data.csv?" + "x" * 9000).status == 414
        assert ask(running.url, COUPLED, Host="elsewhere.example").status == 403
