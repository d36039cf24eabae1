"""The start page: it is shown if a link opens no scene, and needs no session."""

from __future__ import annotations

import re
from xml.etree.ElementTree import fromstring

import pytest

from app import SCENES, walked
from components.scene.thing import HIGH, WIDE
from components.scenes.things import THINGS
from components.serving.start import StartPage
from tests.attack.caller import ask
from tests.serving.server import Server

START = StartPage(SCENES, [{"name": "tour", "title": "A tour"}], THINGS)


def arrivals(server: Server) -> float:
    (found,) = re.findall(r"^oscillations_arrivals_total (\S+)$", ask(server.url, "/metrics").text, re.M)
    return float(found)


@pytest.mark.parametrize("query", ["", "?theme=dark", "?projector", "?scene=pendulum", "?scene=coupled&scene=forced"])
def test_it_is_shown_if_a_link_opens_no_scene_and_takes_no_place(query: str, server: Server) -> None:
    before = arrivals(server)
    page = ask(server.url, f"/{query}")
    assert page.status == 200 and arrivals(server) == before
    assert "Pull a mass and see how it oscillates" in page.text
    assert len(re.findall('class="scene-card"', page.text)) == len(SCENES)
    assert not any(heading.startswith("D3") for heading in re.findall(r"<h2[^>]*>([^<]*)", page.text))
    assert page.headers["Cache-Control"] == "no-cache"
    assert "'unsafe-inline'" not in page.headers["Content-Security-Policy"].split("style-src")[0]


@pytest.mark.parametrize("query", ["?scene=coupled", "?k2=3", "?walk=d34&step=d34-02", "in a frame"])
def test_any_other_link_and_a_frame_open_a_scene(query: str, server: Server) -> None:
    before = arrivals(server)
    page = ask(server.url, Sec_Fetch_Dest="iframe") if query == "in a frame" else ask(server.url, f"/{query}")
    assert 'id="opening"' in page.text and arrivals(server) == before + 1


def test_an_unknown_scene_is_named_in_a_sentence() -> None:
    said = START.asked({"scene": [b"<b>pendulum"]}) or ""
    assert "scene: “&lt;b&gt;pendulum” is not a scene: choose one of oscillator, " in said
    assert "is not a scene" not in (START.asked({}) or "")


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
