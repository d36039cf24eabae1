"""The page around a scene: what a browser asks for, and that a new version is not mixed with what it has kept."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, Request

from components.serving.assets import STATIC, assets
from components.serving.shell import library, preloaded, version


def test_every_address_of_the_page_is_served() -> None:
    for address in (*preloaded(), library()):
        assert address.removeprefix("assets/") in assets()


def test_every_import_of_a_module_is_served() -> None:
    names = {
        (path.parent / imported).resolve().relative_to(STATIC).as_posix()
        for path in STATIC.rglob("*.js")
        for imported in re.findall(r'(?:from |import\()"(.*)"', path.read_text(encoding="utf-8"))
    }
    assert len(names) > 15
    assert {f"{version()}/{name}" for name in names} <= assets().keys()


@pytest.mark.browser
def test_scripts_and_styles_are_asked_for_once_and_by_names_that_change_with_their_content(
    page: Page, open_scene: Callable[..., Page]
) -> None:
    asked: list[str] = []

    def note(request: Request) -> None:
        if request.resource_type in ("script", "stylesheet") and request.url.startswith("http"):
            asked.append(request.url)

    page.on("request", note)
    open_scene(page, scene="coupled")
    assert len(asked) == len(set(asked)) > len(preloaded())
    assert [url for url in asked if not re.search(r"/assets/[0-9a-f]{12}/", url)] == []
    # What is there for those who hear or print the page comes when all is drawn; the rest when it is asked for.
    assert not any(f"/later/{name}.js" in url for name in ("about", "picker", "runbar", "take") for url in asked)
