"""The static files and the addresses that lead to the page."""

from __future__ import annotations

import gzip
from http.client import HTTPConnection
from urllib.parse import urljoin, urlsplit
from urllib.request import urlopen

import brotli
import pytest

from components.serving.assets import YEAR, assets, takes
from tests.attack.caller import ask
from tests.serving.server import Server


def test_files_are_compressed_once_and_are_what_they_were() -> None:
    for asset in assets().values():
        assert gzip.decompress(asset.packed["gzip"]) == brotli.decompress(asset.packed["br"]) == asset.plain
    assert assets() is assets()


def test_scripts_and_styles_have_their_type() -> None:
    types = {name.rsplit(".")[-1]: asset.type for name, asset in assets().items()}
    assert types["js"] == "text/javascript; charset=utf-8"
    assert types["css"] == "text/css; charset=utf-8"
    assert types["woff"] == "font/woff"


@pytest.mark.parametrize(
    ("accepted", "taken"),
    [("gzip, deflate", True), ("br;q=1.0, GZIP;q=0.5", True), ("", False), ("br, gzip;q=0.0", False), ("br", False)],
)
def test_a_coding_is_sent_to_who_takes_it(accepted: str, taken: bool) -> None:
    assert takes(accepted, "gzip") == taken


def test_a_file_is_kept_for_good_and_one_of_another_version_is_not_there(server: Server) -> None:
    name, asset = next((name, asset) for name, asset in assets().items() if name.endswith("/start.js"))
    reply = ask(server.url, f"/assets/{name}")
    assert reply.text == asset.plain.decode()
    assert reply.headers["Cache-Control"] == f"public, max-age={YEAR}, immutable"
    assert reply.headers["Vary"] == "Accept-Encoding"
    other = ask(server.url, "/assets/0123456789ab/start.js")
    assert (other.status, other.headers["Cache-Control"]) == (404, "no-store")
    assert "another version" in other.text


@pytest.mark.parametrize(("accepted", "coding"), [("gzip, deflate, br, zstd", "br"), ("gzip", "gzip")])
def test_a_compressed_file_says_so(server: Server, accepted: str, coding: str) -> None:
    name, asset = next((name, asset) for name, asset in assets().items() if name.endswith("/bokeh.min.js"))
    connection = HTTPConnection(urlsplit(server.url).netloc, timeout=30)
    connection.request("GET", f"/assets/{name}", headers={"Accept-Encoding": accepted})
    answer = connection.getresponse()
    assert (answer.headers["Content-Encoding"], answer.read()) == (coding, asset.packed[coding])
    connection.close()


@pytest.mark.parametrize(
    ("path", "to"), [("app", ""), ("app/", ""), ("app?k2=3&x=%20", "?k2=3&x=%20"), ("app/?a=1", "?a=1")]
)
def test_where_the_page_was_leads_to_where_it_is_with_the_query(server: Server, path: str, to: str) -> None:
    asked = urljoin(server.url, path)
    reply = ask(server.url, f"/{path}")
    assert reply.status == 302
    assert urljoin(asked, reply.headers["Location"]) == server.url + to
    with urlopen(asked, timeout=30) as page:
        assert page.url == server.url + to
