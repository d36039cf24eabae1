"""The start page: it is shown if a link opens no scene, and needs no session."""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree.ElementTree import fromstring

import pytest

from app import SCENES, walked
from components.scene.thing import HIGH, WIDE
from components.scenes.things import THINGS
from components.serving.start import StartPage
from tests.attack.caller import ask
from tests.serving.server import Server, serving

START = StartPage(SCENES, [{"name": "tour", "title": "A tour"}], THINGS)


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with serving(tmp_path_factory.mktemp("start") / "log") as running:
        yield running


@pytest.mark.parametrize("query", ["", "?theme=dark", "?projector", "?scene=pendulum", "?scene=coupled&scene=forced"])
def test_it_is_shown_if_a_link_opens_no_scene(query: str, server: Server) -> None:
    page = ask(server.url, f"/{query}")
    assert page.status == 200
    assert "Pull a mass and see how it oscillates" in page.text
    assert len(re.findall('class="scene-card"', page.text)) == len(SCENES)
    assert not any(heading.startswith("D3") for heading in re.findall(r"<h2[^>]*>([^<]*)", page.text))
    assert page.headers["Cache-Control"] == "no-cache"
    assert "'unsafe-inline'" not in page.headers["Content-Security-Policy"].split("style-src")[0]


@pytest.mark.parametrize("query", ["?scene=coupled", "?k2=3", "?walk=d34&step=d34-02", "?scene=oscillator"])
def test_any_other_link_goes_where_it_went(query: str, server: Server) -> None:
    assert 'id="opening"' in ask(server.url, f"/{query}").text


def test_a_frame_shows_a_scene(server: Server) -> None:
    assert 'id="opening"' in ask(server.url, Sec_Fetch_Dest="iframe").text


def test_it_is_sent_compressed_to_a_browser_that_takes_it(server: Server) -> None:
    plain = ask(server.url, "/")
    zipped = ask(server.url, "/", Accept_Encoding="br, gzip")
    assert (plain.headers.get("Content-Encoding"), zipped.headers["Content-Encoding"]) == (None, "gzip")
    assert int(zipped.headers["Content-Length"]) < 20_000 < int(plain.headers["Content-Length"])


def test_what_is_no_scene_is_said(server: Server) -> None:
    said = ask(server.url, "/?scene=<b>pendulum").text
    assert "scene: “&lt;b&gt;pendulum” is not a scene: choose one of oscillator, " in said
    assert "is not a scene" not in ask(server.url, "/").text


def test_it_takes_no_place(server: Server) -> None:
    def figure(name: str) -> float:
        found = re.search(rf"^{name} (\S+)$", ask(server.url, "/metrics").text, re.M)
        assert found, name
        return float(found[1])

    before = figure("oscillations_arrivals_total")
    for _ in range(20):
        assert ask(server.url, "/").status == 200
    assert figure("oscillations_arrivals_total") == before
    ask(server.url, "/?scene=coupled")
    assert figure("oscillations_arrivals_total") == before + 1


@pytest.mark.parametrize("slug", SCENES)
def test_each_scene_has_a_picture_whose_parts_move_in_the_frame(slug: str) -> None:
    picture = fromstring(f"<svg>{THINGS[slug]()}</svg>")
    moves = picture.findall(".//animateTransform")
    assert moves
    for move in moves:
        rows = [[float(number) for number in row.split()] for row in move.attrib["values"].split(";")]
        assert len({len(row) for row in rows}) == 1
        assert move.attrib["type"] != "translate" or all(0 <= x <= WIDE and 0 <= y <= HIGH for x, y in rows)


def test_the_lectures_own_walks_are_listed() -> None:
    page = walked([]).start.asked({}) or ""
    assert re.findall(r'href="\?walk=([\w-]+)"', page) == ["tour", "tour", "d31", "d32-33", "d34", "waves"]


def test_the_page_is_small() -> None:
    assert len(START.asked({}) or "") < 65_000
