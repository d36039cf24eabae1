"""`panel serve app.py`: the scenes as Panel applications, and a sentence on how to start the lecture."""

from __future__ import annotations

import html
from collections.abc import Iterator
from urllib.parse import parse_qsl

import panel.models  # noqa: F401  # what is pulled is of its classes
import pytest
from bokeh.client import ClientSession, pull_session
from playwright.sync_api import Browser, expect

from components.scenes import SCENES
from tests.serving.server import serving_panel

pytestmark = pytest.mark.slow  # it starts a process
LAST = """() => [...Bokeh.documents[0]._all_models.values()].find(
    model => model.name === "time" && "x1_slow" in model.data).data.x1.at(-1)"""
"""The end of the curve x1."""


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


@pytest.mark.browser
def test_a_widget_drives_the_figures_and_the_address_and_a_refused_value_stays(
    panel_serve: str, browser: Browser
) -> None:
    page = browser.new_page()
    faults: list[str] = []
    page.on("pageerror", lambda fault: faults.append(str(fault)))
    page.goto(f"{panel_serve}?scene=coupled&k2=3")
    k2 = page.locator("input[type=text]").nth(3)
    expect(k2).to_have_value("3.00")
    before = page.evaluate(LAST)
    for text, stands in (("5", "5.00"), ("1/3", "0.3333333333333333")):
        k2.fill(text)
        k2.press("Enter")
        expect(k2).to_have_value(stands)
        page.wait_for_function(f"() => ({LAST})() !== {before}")
        before = page.evaluate(LAST)
    k2.fill("-5")
    k2.press("Enter")
    expect(page.get_by_text("k2, stiffness: −5 N/m is not possible")).to_be_visible()
    expect(k2).to_have_value("-5")
    page.wait_for_url("**k2=0.3333333333333333**")
    assert page.evaluate(LAST) == before
    cursor = "[...Bokeh.documents[0]._all_models.values()].find(model => model.type === 'Span' && model.location > 0)"
    page.locator("button.play").click()
    page.wait_for_function(f"() => {cursor}")
    assert faults == []
    page.close()
