"""`panel serve app.py`, tried by those who know Panel: a sentence says how the lecture is started."""

from __future__ import annotations

import html
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from urllib.request import urlopen

import panel.models.markup  # noqa: F401  # what is pulled is of its classes
import pytest
from bokeh.client import pull_session

from tests.serving.server import ROOT

PATIENCE = 120.0


@pytest.fixture
def panel_serve() -> Iterator[str]:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [sys.executable, "-m", "panel", "serve", "app.py", "--port", str(port)]
    process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    url, end = f"http://localhost:{port}/app", time.monotonic() + PATIENCE
    try:
        while True:
            try:
                with urlopen(url) as page:
                    assert page.status == 200
                break
            except OSError:
                assert time.monotonic() < end and process.poll() is None
                time.sleep(0.2)
        yield url
    finally:
        process.terminate()
        process.wait()


def test_panel_serve_says_what_this_is_and_how_it_is_started(panel_serve: str) -> None:
    session = pull_session(url=panel_serve)
    text = html.unescape("".join(str(getattr(root, "text", "")) for root in session.document.roots))
    session.close()
    assert "interactive lecture" in text
    assert "make run" in text and "python -m components.serving --show" in text
