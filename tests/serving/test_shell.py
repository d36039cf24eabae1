"""The page around a scene: the requests of a browser, and versions that are not mixed with cached files."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, Request

from components.serving import shell
from components.serving.assets import assets
from components.serving.shell import library, version
from tests.serving.server import ROOT

MOST = 20
"""Requests until a scene is drawn, described and ready for printing."""


def test_every_address_of_the_page_is_served() -> None:
    for address in (f"assets/{version()}/start.js", f"assets/{version()}/style.css", library()):
        assert address.removeprefix("assets/") in assets()


def test_the_table_of_browsers_is_true_of_what_the_page_asks_them() -> None:
    page = (Path(shell.__file__).parent / "page.html").read_text(encoding="utf-8")
    table = re.findall(
        r"^\| (.+?) \|.*\| (\d+) \| (\d+) \| ([\d.]+) \|$", (ROOT / "docs/browsers.md").read_text(), re.M
    )
    *features, (all_of_it, *newest) = table
    assert [name for name, *_ in features] == re.findall(r'^        "(.+)": ', page, re.M)
    versions = [
        max((row[i] for row in features), key=lambda text: [int(n) for n in text.split(".")]) for i in (1, 2, 3)
    ]
    assert (all_of_it, newest) == ("all of it", versions)
    assert "Chrome or Edge {}, Firefox {}, Safari {} or a newer one".format(*versions) in page


@pytest.mark.browser
def test_scripts_and_styles_are_asked_for_once_and_by_names_that_change_with_their_content(
    page: Page, open_scene: Callable[..., Page]
) -> None:
    asked: list[Request] = []
    page.on("request", lambda request: asked.append(request))
    open_scene(page, scene="coupled")
    page.wait_for_function("oscillations.page.print")
    scripts = [one.url for one in asked if one.resource_type in ("script", "stylesheet")]
    assert len(scripts) == len(set(scripts)) > 2
    assert [url for url in scripts if not re.search(r"/assets/[0-9a-f]{12}/", url)] == []
    assert len(asked) < MOST
    # Scripts for screen readers and printing come after everything is drawn, others on demand.
    assert not any(f"/{name}.js" in url for name in ("about", "picker", "run_bar", "take") for url in scripts)
