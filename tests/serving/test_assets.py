"""The static files and the addresses that lead to the page."""

from __future__ import annotations

import gzip
from urllib.parse import urljoin

import brotli
import pytest

from components.serving.assets import YEAR, assets, takes
from tests.attack.caller import ask
from tests.serving.server import Server

TYPES = {".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8", ".woff": "font/woff"}


def test_files_have_their_type_and_are_compressed_once_without_a_change() -> None:
    suffixes = {name: name[name.rindex(".") :] for name in assets()}
    assert set(suffixes.values()) >= TYPES.keys()
    for name, asset in assets().items():
        assert gzip.decompress(asset.packed["gzip"]) == brotli.decompress(asset.packed["br"]) == asset.plain
        assert asset.type == TYPES.get(suffixes[name], asset.type), name
    assert assets() is assets()


@pytest.mark.parametrize(
    ("accepted", "taken"),
    [("gzip, deflate", True), ("br;q=1.0, GZIP;q=0.5", True), ("", False), ("br, gzip;q=0.0", False), ("br", False)],
)
def test_a_coding_is_sent_to_who_takes_it(accepted: str, taken: bool) -> None:
    assert takes(accepted, "gzip") == taken


def test_a_file_is_kept_for_good_and_one_of_another_version_is_missing(server: Server) -> None:
    name, asset = next((name, asset) for name, asset in assets().items() if name.endswith("/start.js"))
    for accepted, coding in (("", ""), ("gzip, deflate, br, zstd", "br"), ("gzip", "gzip")):
        reply = ask(server.url, f"/assets/{name}", Accept_Encoding=accepted)
        assert reply.headers.get("Content-Encoding", "") == coding
        assert int(reply.headers["Content-Length"]) == len(asset.packed[coding] if coding else asset.plain)
        assert coding or reply.text == asset.plain.decode()
        assert reply.headers["Cache-Control"] == f"public, max-age={YEAR}, immutable"
        assert reply.headers["Vary"] == "Accept-Encoding"
    other = ask(server.url, "/assets/0123456789ab/start.js")
    assert (other.status, other.headers["Cache-Control"]) == (404, "no-store")
    assert "another version" in other.text


@pytest.mark.parametrize(
    ("path", "to"), [("app", ""), ("app/", ""), ("app?k2=3&x=%20", "?k2=3&x=%20"), ("app/?a=1", "?a=1")]
)
def test_where_the_page_was_leads_to_where_it_is_with_the_query(server: Server, path: str, to: str) -> None:
    reply = ask(server.url, f"/{path}")
    assert reply.status == 302
    assert urljoin(urljoin(server.url, path), reply.headers["Location"]) == server.url + to
