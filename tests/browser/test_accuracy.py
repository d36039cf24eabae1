"""Accuracy in Chromium: a visitor's own measurement, its place in the queue, its end when the visitor leaves."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Page, expect

from tests.serving.server import Server, serving

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server that notices early that a visitor has left."""
    soon = ("--unused-seconds", "0.3")
    with serving(tmp_path_factory.mktemp("server") / "log", options=soon) as running:
        yield running
        assert not running.complaints(), running.log.read_text()


UNDER_WAY = re.compile("It begins|is running")
STEPPING = re.compile("(Verlet|Newmark|RK4|DOP853|Radau|LSODA) is running")
"""A method with steps is running. Methods without steps come first and are measured already."""


def test_who_leaves_makes_room_for_the_next(new_page: Callable[..., Page], open_scene: Open) -> None:
    first, second = (open_scene(new_page(), scene="accuracy", limit=3, system=name) for name in ("wide", "beats"))
    status = ".transport [role=status]"
    first.get_by_role("button", name="Run", exact=True).click()
    expect(first.locator(status)).to_contain_text(UNDER_WAY, timeout=30_000)
    second.get_by_role("button", name="Run", exact=True).click()
    expect(second.locator(status)).to_contain_text("1 measurement before yours")
    first.close()
    expect(second.locator(status)).to_contain_text(UNDER_WAY, timeout=30_000)
    expect(second.locator(".count")).to_contain_text("of 60 s", timeout=20_000)
    expect(second.locator(status)).to_contain_text(STEPPING, timeout=30_000)
    second.get_by_role("button", name="Skip this method").click()
    second.get_by_role("button", name="Cancel").click()
    expect(second.locator(".count")).to_contain_text("methods measured here")
    expect(second.get_by_role("button", name="Run again")).to_be_visible()
