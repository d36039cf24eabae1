"""`panel serve app.py`: the scenes as Panel applications, and a sentence on how to start the lecture."""

from __future__ import annotations

import html
from collections.abc import Iterator
from urllib.parse import parse_qsl

import panel.models  # noqa: F401  # what is pulled is of its classes
import pytest
from bokeh.client import ClientSession, pull_session

from components.scenes import SCENES
from tests.serving.server import serving_panel

pytestmark = pytest.mark.slow  # it starts a process


@pytest.fixture(scope="module")
def panel_serve(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with serving_panel(tmp_path_factory.mktemp("panel") / "log") as server:
        yield f"http://localhost:{server.port}/app"


def visit(address: str) -> ClientSession:
    return pull_session(url=address.partition("?")[0], arguments=dict(parse_qsl(address.partition("?")[2])))


def texts(session: ClientSession) -> str:
    models = session.document.models
    return html.unescape(" ".join(str(getattr(model, "text", "")) for model in models))


def test_a_page_has_the_menu_and_says_how_the_lecture_is_started_and_what_of_a_link_cannot_be(
    panel_serve: str,
) -> None:
    session = visit(f"{panel_serve}?scene=coupled&k2=3&k1=many")
    text = texts(session)
    fields = [model.value for model in session.document.models if type(model).__name__ == "TextInput"]
    session.close()
    assert all(f'href="?scene={slug}"' in text and scene.title in text for slug, scene in SCENES.items())
    assert "The whole lecture" in text
    assert "make run" in text and "python -m components.serving --show" in text
    assert "“many” is not a number" in text
    assert "3.00" in fields and "4.00" in fields
