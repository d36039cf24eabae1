"""`panel serve app.py`: the scenes as Panel applications, and a sentence on how to start the lecture."""

import html
from pathlib import Path

import panel.models  # noqa: F401  # what is pulled is of its classes
import pytest
from bokeh.client import pull_session

from components.scenes import SCENES
from tests.serving.server import serving_panel


@pytest.mark.slow
def test_a_page_has_the_menu_and_says_how_the_lecture_is_started_and_what_of_a_link_cannot_be(tmp_path: Path) -> None:
    with serving_panel(tmp_path / "log") as server:
        address = f"http://localhost:{server.port}/app"
        session = pull_session(url=address, arguments={"scene": "coupled", "k2": "3", "k1": "many"})
        models = session.document.models
        text = html.unescape(" ".join(str(getattr(model, "text", "")) for model in models))
        fields = [model.value for model in models if type(model).__name__ == "TextInput"]
        session.close()
    assert all(f'href="?scene={slug}"' in text and scene.title in text for slug, scene in SCENES.items())
    for says in ("The whole lecture", "make run", "python -m components.serving --show", "“many” is not a number"):
        assert says in text
    assert {"3.00", "4.00"} <= set(fields)
