"""Files that a visitor saves: numbers and pictures; the printed sheet; the numbers about these numbers."""

import re
from collections.abc import Callable
from pathlib import Path
from urllib.parse import unquote
from xml.etree import ElementTree

import numpy as np
import pytest
from playwright.sync_api import Download, Locator, Page, expect

from components.scenes import SCENES
from components.state.page_state import fitted
from tests.browser import looks
from tests.browser.waiting import QUIET, passed, seek, turned, unfold
from tests.grids import sample

pytestmark = pytest.mark.browser
Open = Callable[..., Page]
SVG = "{http://www.w3.org/2000/svg}"
DRAWN = {
    f"{SVG}{name}"
    for name in ("svg", "title", "g", "rect", "line", "path", "circle", "text", "tspan", "clipPath", "image")
}
WITHIN = re.compile(r' href="data:image/png;base64,[^"]*"')
"""A picture that contains its own drawing."""
LATER = 700  # ms, much longer than the pause after which a request is sent
OUTSIDE = """() => {
  const about = document.querySelector('.about'), panel = document.querySelector('.panel')
  const wide = [about, ...about.querySelectorAll('table, p')].filter(part => part.scrollWidth > about.clientWidth)
  const top = about.getBoundingClientRect().top - panel.getBoundingClientRect().top
  return [...wide.map(part => `${part.localName} is wider than its panel`),
    ...(panel.scrollWidth > innerWidth ? ["the panel is wider than the page"] : []),
    ...(innerWidth > 700 && top <= -1 ? ["it is scrolled out at the top"] : []),
    ...(innerWidth > 700 && document.documentElement.scrollHeight > innerHeight ? ["the page scrolls"] : [])]
}"""
"""Parts of "About these numbers" that leave the panel."""


def content(download: Download) -> bytes:
    return Path(download.path()).read_bytes()


def saved(page: Page, kind: str) -> Download:
    with page.expect_download() as waiting:
        page.get_by_role("dialog").get_by_role("button", name=kind).click()
    return waiting.value


def drawn(page: Page) -> str:
    """The chosen picture, as SVG."""
    return unquote(page.get_by_role("dialog").locator("img").get_attribute("src") or "").partition(",")[2]


def texts_of(picture: ElementTree.Element) -> list[str]:
    return ["".join(part.itertext()) for part in picture.iter(f"{SVG}text")]


def pictured(page: Page, plot: str = "") -> ElementTree.Element:
    """Open the choice of pictures, or choose another one there."""
    dialog = page.get_by_role("dialog")
    if not dialog.count():
        unfold(page)
        page.get_by_role("button", name="Pictures").click()
    if plot:
        dialog.get_by_role("button", name=plot).click()
    return ElementTree.fromstring(drawn(page))


def printed(page: Page) -> Locator:
    """The sheet that the browser prints."""
    page.wait_for_function("oscillations.page.print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    return page.locator(".printed")


def put_away(page: Page) -> None:
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    expect(page.locator(".printed")).to_have_count(0)
    page.emulate_media(media="null")


@pytest.mark.parametrize("slug", sample([*SCENES], 20))
def test_what_every_scene_gives_away(slug: str, new_page: Callable[..., Page], open_scene: Open) -> None:
    """The numbers about its numbers stay within the panel. Printed it is one sheet in ink. Every picture is light, says
    what it is of, and needs nothing from the page.
    """
    page = new_page(color_scheme="dark", reduced_motion="reduce")
    open_scene(page, folded=True, scene=slug, view=SCENES[slug].views[0].slug)
    if SCENES[slug].is_checked():
        page.locator(".about summary").click()
        expect(page.locator(".about .bound").first).to_be_in_viewport(timeout=30_000)  # a worker may be starting
        found = looks.of(page, OUTSIDE)
        page.set_viewport_size({"width": 390, "height": 844})
        passed(page)
        assert [*found, *looks.of(page, OUTSIDE)] == []
        page.set_viewport_size({"width": 1280, "height": 720})
    sheet = printed(page)
    expect(sheet.locator("h1")).to_have_text(SCENES[slug].headline)
    expect(sheet.locator(".printed-pictures > div").first).to_be_visible()
    expect(sheet).to_contain_text(page.url)
    expect(sheet).to_have_css("background-color", "rgb(255, 255, 255)")
    expect(page.locator(".nav")).to_be_hidden()
    put_away(page)
    for landscape in (False, True):
        assert re.findall(rb"/Count (\d+)", page.pdf(format="A4", landscape=landscape)) == [b"1"], landscape
    pictured(page)
    choices = page.get_by_role("dialog").get_by_role("group", name="Of").get_by_role("button")
    expect(choices.first).to_be_visible()
    assert slug != "coupled" or looks.axe(page) == []
    for choice in choices.all():
        choice.click()
        expect(choice).to_have_attribute("aria-pressed", "true")
        source = drawn(page)
        picture = ElementTree.fromstring(source)
        assert {part.tag for part in picture.iter()} <= DRAWN
        assert not re.search(r"var\(| class=| style=|NaN|undefined|href", WITHIN.sub("", source))
        ground = next(picture.iter(f"{SVG}rect"))
        assert (ground.get("fill"), ground.get("width")) == ("rgb(255, 255, 255)", picture.get("width"))
        texts = texts_of(picture)
        assert f"?{fitted(SCENES[slug]().value).query}" in "".join(texts)
        assert "?" not in texts and len(texts) >= 3, texts
        assert page.get_by_role("dialog").locator("p").inner_text()


def test_a_picture_has_the_curve_of_the_plot_on_any_screen(new_page: Callable[..., Page], open_scene: Open) -> None:
    scene = SCENES["coupled"](k2=3.0)
    page = open_scene(new_page(390, 844, has_touch=True, reduced_motion="reduce"), scene="coupled", k2=3)
    pictured(page, "Displacement of mass 1 against time")
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


def test_a_picture_has_the_units_that_on_the_page_stand_beside_another_and_what_is_held(
    page: Page, open_scene: Open
) -> None:
    open_scene(page, scene="oscillator", held="default", m=4, view="formulas")
    page.wait_for_function("oscillations.page.compare.ghosts?.held")
    seek(page, 0.4)
    assert len([text for text in texts_of(pictured(page)) if re.match(r"held [+−]\d", text)]) == 1
    texts = texts_of(pictured(page, "The law"))
    assert all(any(text.endswith(unit) for text in texts) for unit in (" m", " m/s²")), texts
    picture = pictured(page, "Displacement against time")
    texts = texts_of(picture)
    assert any("Dotted: held, m = 1.00 kg" in text for text in texts), texts
    rings = [part for part in picture.iter(f"{SVG}circle") if part.get("r") == "5.5"]
    assert len(rings) == texts.count("same start") == 1


def test_a_png_is_twice_the_size_and_a_press_on_a_plot_takes_that_plot(page: Page, open_scene: Open) -> None:
    """Its table has the extrema of the motion itself."""
    open_scene(page, scene="forced", view="motion")
    plot = page.locator(".block.plot", has=page.locator(".figure:visible")).first
    plot.hover()
    plot.get_by_role("button", name="Save the picture, or read its table").click()
    width = page.get_by_role("dialog").locator("img").evaluate("image => image.naturalWidth")
    download = saved(page, "PNG")
    head = content(download)[:24]
    assert head[1:4] == b"PNG" and int.from_bytes(head[16:20]) == 2 * width
    assert download.suggested_filename == "forced-x1.png"
    rows = [text.split("\t") for text in page.get_by_role("dialog").locator("table").inner_text().splitlines()]
    told = page.get_by_role("dialog").locator("p").inner_text()
    turns = re.findall(r"(?:lowest|highest) (\S+) m at (\S+) s", told)
    assert len(turns) == 6 and len(rows) == 26 + len(turns)
    for height, instant in turns:  # they may be between drawn points
        assert any(row[0] == instant and height in row[1:] for row in rows), (height, instant)


def test_the_numbers_are_asked_for_when_opened_and_after_a_change_and_never_while_folded(desk: Page) -> None:
    turned(desk, "coupled", {})
    desk.evaluate("""() => {
      const {wire} = oscillations.messages, {send} = wire
      globalThis.abouts = 0
      wire.send = message => { if (message.type === "about") abouts += 1; send(message) }
    }""")
    slider, table = desk.locator('input[name="k2-slider"]'), desk.locator(".about table").first
    slider.press("ArrowRight")
    since = desk.evaluate("performance.now()")
    desk.wait_for_function(f"since => performance.now() > since + {LATER} && {QUIET}", arg=since)
    assert desk.evaluate("abouts") == 0
    desk.locator(".about summary").click()
    expect(table).to_be_visible(timeout=30_000)
    before = table.text_content()
    slider.press("ArrowRight")
    expect(table).not_to_have_text(before or "")
    expect(table).to_be_visible()
