"""Files that a visitor saves from the page: numbers and pictures."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Callable
from pathlib import Path
from urllib.parse import unquote
from xml.etree import ElementTree

import numpy as np
import pandas as pd
import pytest
from playwright.sync_api import Download, Page, expect

from components.scenes import SCENES
from components.state.page_state import fitted
from tests.browser.waiting import seek
from tests.grids import spread

pytestmark = pytest.mark.browser


def test_csv_comes_as_a_file_whose_link_leads_back(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="coupled", view="plane", k2=3)
    csv = page.get_by_role("button", name="CSV")
    expect(csv).to_have_accessible_description(re.compile("several tables come in one ZIP file"))
    with page.expect_download() as waiting:
        csv.click()
    assert waiting.value.suggested_filename == "coupled.zip"
    with zipfile.ZipFile(Path(waiting.value.path())) as packed:
        content = packed.read("coupled-time.csv")
    table = pd.read_csv(io.BytesIO(content), comment="#")
    assert list(table)[:2] == ["t [s]", "x1 [m]"] and table["x1 [m]"][0] == 1
    assert f"# {page.url.split('?')[0]}?scene=coupled&k2=3&view=plane\r\n" in content.decode()


SVG = "{http://www.w3.org/2000/svg}"
DRAWN = {
    f"{SVG}{name}"
    for name in ("svg", "title", "g", "rect", "line", "path", "circle", "text", "tspan", "clipPath", "image")
}
WITHIN = re.compile(r' href="data:image/png;base64,[^"]*"')
"""A picture that contains its own drawing."""


def saved(page: Page, kind: str) -> Download:
    with page.expect_download() as waiting:
        page.get_by_role("dialog").get_by_role("button", name=kind).click()
    return waiting.value


def content(download: Download) -> bytes:
    return Path(download.path()).read_bytes()


def drawn(page: Page) -> str:
    """The chosen picture, as SVG."""
    return unquote(page.get_by_role("dialog").locator("img").get_attribute("src") or "").partition(",")[2]


@pytest.mark.parametrize("slug", spread([*SCENES]))
def test_every_picture_is_light_says_what_it_is_of_and_needs_nothing_from_the_page(
    new_page: Callable[..., Page], open_scene: Callable[..., Page], slug: str
) -> None:
    view = {"view": SCENES[slug].views[0].slug} if SCENES[slug].views else {}
    page = open_scene(new_page(color_scheme="dark", reduced_motion="reduce"), scene=slug, **view)
    page.get_by_role("button", name="Pictures").click()
    choices = page.get_by_role("dialog").get_by_role("group", name="Of").get_by_role("button")
    expect(choices.first).to_be_visible()
    for i in range(choices.count()):
        choices.nth(i).click()
        expect(choices.nth(i)).to_have_attribute("aria-pressed", "true")
        source = drawn(page)
        picture = ElementTree.fromstring(source)
        assert {part.tag for part in picture.iter()} <= DRAWN, slug
        assert not re.search(r"var\(| class=| style=|NaN|undefined|href", WITHIN.sub("", source))
        ground = next(part for part in picture.iter(f"{SVG}rect"))
        assert (ground.get("fill"), ground.get("width")) == ("rgb(255, 255, 255)", picture.get("width"))
        texts = ["".join(part.itertext()) for part in picture.iter(f"{SVG}text")]
        assert f"?{fitted(SCENES[slug]().value).query}" in "".join(texts)
        assert "?" not in texts, texts
        assert len(texts) >= 3 and page.get_by_role("dialog").locator("p").inner_text()


def test_a_picture_has_the_curve_of_the_plot_on_any_screen(
    new_page: Callable[..., Page], open_scene: Callable[..., Page]
) -> None:
    scene = SCENES["coupled"](k2=3.0)
    page = open_scene(new_page(390, 844, has_touch=True, reduced_motion="reduce"), scene="coupled", k2=3)
    page.get_by_role("button", name="Pictures").click()
    page.get_by_role("dialog").get_by_role("button", name="Displacement of mass 1 against time").click()
    download = saved(page, "SVG")
    assert download.suggested_filename == "coupled-x1.svg"
    picture = ElementTree.fromstring(content(download))
    paths = [part.get("d", "") for part in picture.iter(f"{SVG}path") if part.get("stroke-width") == "3px"]
    (points,) = [np.array([[float(n) for n in place.split()] for place in d[1:].split("L")]) for d in paths]
    time = scene.sources["time"].data
    for places, column in zip(points.T, (time["t"], time["x1"]), strict=True):
        slope, start = np.polyfit(column, places, 1)
        assert np.max(np.abs(start + slope * column - places)) < 0.02
    assert "= 0.333" not in "".join(picture.itertext()) and "m₁ = 2.00 kg" in "".join(picture.itertext())


@pytest.mark.parametrize(
    ("link", "plot", "ends"),
    [
        ({"scene": "oscillator", "view": "formulas"}, "Phase plane", (" m", " m/s")),
        ({"scene": "oscillator", "view": "formulas"}, "The law", (" m", " m/s²")),
        ({"scene": "coupled", "view": "plane"}, "Displacement of mass 2 against that of mass 1", (" m", " m")),
    ],
)
def test_a_picture_has_the_numbers_and_units_that_on_the_page_stand_beside_another(
    link: dict[str, str], plot: str, ends: tuple[str, str], page: Page, open_scene: Callable[..., Page]
) -> None:
    open_scene(page, **link)
    page.get_by_role("button", name="Pictures").click()
    page.get_by_role("dialog").get_by_role("button", name=plot).click()
    picture = ElementTree.fromstring(drawn(page))
    numbers = [
        ("".join(part.itertext()), part.get("text-anchor"))
        for part in picture.iter(f"{SVG}text")
        if re.match(r"[−\d][\d.]*( m(/s²?)?)?$", "".join(part.itertext()))
    ]
    for anchor, unit in zip(("middle", "end"), ends, strict=True):
        along = [text for text, stands in numbers if stands == anchor]
        assert len(along) >= 3 and along[-1].endswith(unit), numbers
        assert all(text.replace("−", "-").removesuffix(unit).strip("-.0123456789") == "" for text in along)


def test_a_picture_has_what_is_held(page: Page, open_scene: Callable[..., Page]) -> None:
    for slug, values, plot, held in (
        ("oscillator", {"m": 4, "view": "force"}, "Displacement against time", "m = 1.00 kg"),
        ("phugoid", {"view": "height", "excess": 0.4}, "Height against time", "v′ = 90.0 ft/s"),
    ):
        open_scene(page, scene=slug, held="default", **values)
        page.wait_for_function("oscillations.page.compare.ghosts?.held")
        seek(page, 0.4)
        page.get_by_role("button", name="Pictures").click()
        stage = ElementTree.fromstring(drawn(page))
        texts = ["".join(part.itertext()) for part in stage.iter(f"{SVG}text")]
        numbers = [text for text in texts if re.match(r"held [+−]\d", text)]
        assert len(numbers) == 1 + (slug == "phugoid"), texts
        page.get_by_role("dialog").get_by_role("button", name=plot).click()
        picture = ElementTree.fromstring(drawn(page))
        texts = ["".join(part.itertext()) for part in picture.iter(f"{SVG}text")]
        assert any(f"Dotted: held, {held}" in text for text in texts), texts
        rings = [part for part in picture.iter(f"{SVG}circle") if part.get("r") == "5.5"]
        assert len(rings) == texts.count("same start") == (slug == "oscillator"), "both start alike"


def test_a_png_is_twice_the_size_and_a_press_on_a_plot_takes_that_plot(
    page: Page, open_scene: Callable[..., Page]
) -> None:
    open_scene(page, scene="forced", view="motion")
    plot = page.locator(".block.plot", has=page.locator(".figure:visible")).first
    plot.hover()
    plot.get_by_role("button", name="Save the picture, or read its table").click()
    image = page.get_by_role("dialog").locator("img")
    width = image.evaluate("image => image.naturalWidth")
    download = saved(page, "PNG")
    head = content(download)[:24]
    assert head[1:4] == b"PNG" and int.from_bytes(head[16:20]) == 2 * width
    assert download.suggested_filename == "forced-x1.png"
    rows = [text.split("\t") for text in page.get_by_role("dialog").locator("table").inner_text().splitlines()]
    told = page.get_by_role("dialog").locator("p").inner_text()
    turns = re.findall(r"(?:lowest|highest) (\S+) m at (\S+) s", told)
    assert len(turns) == 6 and len(rows) == 26 + len(turns)
    for height, instant in turns:  # the extremum of the motion itself, which may be between drawn points
        assert any(row[0] == instant and height in row[1:] for row in rows), (height, instant)
    page.get_by_role("button", name="Close").click()
    expect(page.get_by_role("dialog")).to_have_count(0)


def test_the_button_of_a_stage_keeps_off_a_heading_at_its_top(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="coupled")
    stage = page.locator(".block.stage").first
    stage.hover()
    button = stage.locator(":scope > .take")
    expect(button).to_have_css("opacity", "1")
    outer, inner = stage.bounding_box(), button.bounding_box()
    assert outer and inner
    assert inner["y"] > outer["y"] + outer["height"] / 2
    assert inner["y"] + inner["height"] <= outer["y"] + outer["height"] + 1
