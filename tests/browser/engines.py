"""The three browser engines: Chromium, Safari's and Firefox, with visible scrollbars."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

from tools.browsers import firefox, webkit
from tools.browsers.chromium import find
from tools.browsers.driven import DrivenWindow

Window = Page | DrivenWindow
"""The methods that tests use: `goto`, `reload`, `set_viewport_size`, `evaluate`, `wait_for_function`, `screenshot`,
`mouse`, `keyboard`.
"""
MISSING = "not installed: make browsers installs it"
ENGINES = ("chromium", "webkit", "firefox")


@pytest.fixture(scope="session", params=ENGINES)
def engine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Window]:
    """A window of 1280 x 720 in each engine; engines that the machine lacks are skipped."""
    name = request.param
    yield from OPENERS[name](request, tmp_path_factory.mktemp(name))


def _chromium(request: pytest.FixtureRequest, _: Path) -> Iterator[Window]:
    browser: Browser = request.getfixturevalue("browser")
    # Playwright hides the scrollbars that Chrome has on Windows.
    chromium = browser.browser_type.launch(executable_path=find(), ignore_default_args=["--hide-scrollbars"])
    yield chromium.new_page(viewport={"width": 1280, "height": 720}, bypass_csp=True)
    chromium.close()


def _driven(kind: type[DrivenWindow], path: str | None, folder: Path) -> Iterator[Window]:
    if path is None:
        pytest.skip(f"{kind.__name__} is {MISSING}")
    window = kind(path, folder)
    try:
        window.set_viewport_size({"width": 1280, "height": 720})
        yield window
    finally:
        window.close()


OPENERS: dict[str, Callable[[Any, Path], Iterator[Window]]] = {
    "chromium": _chromium,
    "webkit": lambda _, folder: _driven(webkit.WebKit, webkit.find(), folder),
    "firefox": lambda _, folder: _driven(firefox.Firefox, firefox.find(), folder),
}
