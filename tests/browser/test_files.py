"""Files that a visitor saves: numbers, pictures, the printed sheet. Files of visitors: an own walk, a measurement."""

import csv
import io
import re
import zipfile
from pathlib import Path
from urllib.parse import unquote
from xml.etree import ElementTree

import numpy as np
import pytest
from playwright.sync_api import Download, FilePayload, Page, expect

from components.scenes import SCENES
from components.state.page_state import fitted
from components.walks.checking import problems
from components.walks.loading import load_walk
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
from tests.browser import looks
from tests.browser.fixtures import READY, Open
from tests.browser.waiting import MINE, clicked, drop, passed, seek, tap, turned, unfold
from tests.grids import sample

pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]
SVG = "{http://www.w3.org/2000/svg}"
DRAWN = "svg title g rect line path circle text tspan clipPath image"
WITHIN = re.compile(r' href="data:image/png;base64,[^"]*"')
"""A picture that contains its own drawing."""
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
TOLD = {"title": "A claim", "explain": 'What it "means".'}
CHOICE = {"text-1": "Both", "text-2": "Neither", "notes": "Show the real springs first.", **TOLD}
SKETCH = {"question": "Sketch mass 1.", "kind": "sketch", "curve": "x1.x1", "is-0": "x1_O", **TOLD}
POINT = {"kind": "point", "axis": "x2.y", "of": "x2_0 - 0.5", "tol": "0.1", **TOLD}
QUESTIONS: tuple[tuple[dict[str, str], str], ...] = (
    ({"question": "Which one swings?", "kind": "choice", **CHOICE}, "a wrong answer needs a reply"),
    ({"reply-2": "It is right at rest."}, "Which one swings?"),
    ({"question": "Long, {beat:null}?", "kind": "number", "is": "2500 ms", "unit": "s", "tol": "0,1", **TOLD}, "Long"),
    (SKETCH, "has a name that the scene does not have, x1_O; it has"),
    ({"is-0": "x1_0"}, "Sketch mass 1."),
    ({"question": "Mark where mass 2 begins.", **POINT}, "Mark where mass 2 begins."),
)
"""The text to type for a step of each kind, and a part of the message or the list that follows."""
COVERED = {"plot:x2", "value:omega_minus", "form:beat"}
REFUSED = {
    "big.toml": (b"#" * 48_001, "big.toml: the file has 48001 bytes; at most 48000 are allowed."),
    "cover.toml": (MINE.encode() + b'cover = ["plot:z"]', "step 1 (pull), cover: “plot:z” is not possible: choose"),
}
POINTS = """() => document.querySelector(".plot-area path.measured-points").getAttribute("d")
  .split("M").length - 1"""
PASTE = """text => {
  const clipboardData = new DataTransfer()
  clipboardData.setData("text/plain", text)
  document.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true}))
}"""
OMEGA, DECAY = 5.0, 0.1
SHAKE = """() => {
  DeviceMotionEvent.requestPermission = async () => "granted"
  window.shaking = setInterval(() => {
    const a = 2 * Math.cos(8 * performance.now() / 1000)
    dispatchEvent(new DeviceMotionEvent("devicemotion", {acceleration: {x: 0.01, y: a, z: 0}, interval: 16}))
  }, 16)
}"""


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


def is_printed(page: Page, headline: str) -> None:
    """Printed it is one sheet in ink, with its address."""
    page.wait_for_function("oscillations.page.print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    sheet = page.locator(".printed")
    expect(sheet.locator("h1")).to_have_text(headline)
    expect(sheet.locator(".printed-pictures > div").first).to_be_visible()
    expect(sheet).to_contain_text(page.url)
    expect(sheet).to_have_css("background-color", "rgb(255, 255, 255)")
    expect(page.locator(".nav")).to_be_hidden()
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    expect(sheet).to_have_count(0)
    page.emulate_media(media="null")
    for landscape in (False, True):
        assert re.findall(rb"/Count (\d+)", page.pdf(format="A4", landscape=landscape)) == [b"1"], landscape


@pytest.mark.slow  # it waits for a worker, and makes each picture
@pytest.mark.parametrize("slug", sample([*SCENES], 20))
def test_what_every_scene_gives_away(slug: str, new_page: Open, open_scene: Open) -> None:
    """The numbers about its numbers stay within the panel. Pictures are light, and need nothing from the page."""
    page = new_page(color_scheme="dark", reduced_motion="reduce")
    open_scene(page, folded=True, scene=slug, view=SCENES[slug].views[0].slug)
    if SCENES[slug].is_checked():
        page.locator(".about summary").click()
        expect(page.locator(".about .bound").first).to_be_in_viewport(timeout=30_000)  # a worker may be starting
        for width, height in ((1280, 720), (390, 844)):
            page.set_viewport_size({"width": width, "height": height})
            passed(page)
            assert looks.of(page, OUTSIDE) == [], width
        page.set_viewport_size({"width": 1280, "height": 720})
    is_printed(page, SCENES[slug].headline)
    pictured(page)
    choices = page.get_by_role("dialog").get_by_role("group", name="Of").get_by_role("button")
    expect(choices.first).to_be_visible()
    assert slug != "coupled" or looks.axe(page) == []
    for choice in choices.all():
        choice.click()
        expect(choice).to_have_attribute("aria-pressed", "true")
        picture = pictured(page)
        assert {part.tag.removeprefix(SVG) for part in picture.iter()} <= {*DRAWN.split()}
        assert not re.search(r"var\(| class=| style=|NaN|undefined|href", WITHIN.sub("", drawn(page)))
        ground = next(picture.iter(f"{SVG}rect"))
        assert (ground.get("fill"), ground.get("width")) == ("rgb(255, 255, 255)", picture.get("width"))
        texts = texts_of(picture)
        assert f"?{fitted(SCENES[slug]().value).query}" in "".join(texts)
        assert "?" not in texts and len(texts) >= 3, texts
        assert page.get_by_role("dialog").locator("p").inner_text()


def test_a_picture_has_the_curve_of_the_plot_on_any_screen(new_page: Open, open_scene: Open) -> None:
    scene = SCENES["coupled"](k2=3.0)
    page = open_scene(new_page(390, 844, has_touch=True, reduced_motion="reduce"), scene="coupled", k2=3)
    pictured(page, "Displacement of mass 1 against time")
    download = saved(page, "SVG")
    assert download.suggested_filename == "coupled-x1.svg"
    picture = ElementTree.parse(download.path()).getroot()
    paths = [part.get("d", "") for part in picture.iter(f"{SVG}path") if part.get("stroke-width") == "3px"]
    (points,) = [np.array([[float(n) for n in place.split()] for place in d[1:].split("L")]) for d in paths]
    time = scene.sources["time"].data
    for places, column in zip(points.T, (time["t"], time["x1"]), strict=True):
        slope, start = np.polyfit(column, places, 1)
        assert np.max(np.abs(start + slope * column - places)) < 0.02
    assert "= 0.333" not in "".join(picture.itertext()) and "m₁ = 2.00 kg" in "".join(picture.itertext())


def test_a_picture_has_the_units_of_its_axes_and_what_is_held(page: Page, open_scene: Open) -> None:
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
    head = download.path().read_bytes()[:24]
    assert head[1:4] == b"PNG" and int.from_bytes(head[16:20]) == 2 * width
    assert download.suggested_filename == "forced-x1.png"
    rows = [text.split("\t") for text in page.get_by_role("dialog").locator("table").inner_text().splitlines()]
    told = page.get_by_role("dialog").locator("p").inner_text()
    turns = re.findall(r"(?:lowest|highest) (\S+) m at (\S+) s", told)
    assert len(turns) == 6 and len(rows) == 26 + len(turns)
    for height, instant in turns:  # they may be between drawn points
        assert any(row[0] == instant and height in row[1:] for row in rows), (height, instant)


def test_the_numbers_about_these_numbers_follow_a_change(desk: Page) -> None:
    turned(desk, "coupled", {})
    desk.locator(".about summary").click()
    table = desk.locator(".about table").first
    expect(table).to_be_visible(timeout=30_000)
    before = table.text_content()
    desk.locator('input[name="k2-slider"]').press("ArrowRight")
    expect(table).not_to_have_text(before or "")
    expect(table).to_be_visible()


def chosen(page: Page, button: str, name: str, content: bytes) -> None:
    """The file, chosen with a button."""
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name=button).click()
    chooser.value.set_files(FilePayload(name=name, mimeType="application/octet-stream", buffer=content))


def test_a_file_is_run_or_refused_in_a_sentence(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="energy")
    for name, (content, said) in REFUSED.items():
        page.locator(".walks summary").click()
        chosen(page, "Open my own walk", name, content)
        expect(page.locator(".notice span")).to_contain_text(said, timeout=30_000)  # a worker may be starting
    page.locator(".walks summary").click()
    chosen(page, "Open my own walk", "here.toml", MINE.replace("d31-03", "d31-07").encode())  # of the visible scene
    page.wait_for_function(f"oscillations.walks.walk?.sheet.name === 'here' && {READY}")
    expect(page.locator(".notice")).to_be_hidden()
    drop(page, "My walk.toml", f"{MINE}#".ljust(48_000, "x"))  # the largest size
    page.wait_for_function(f"oscillations.walks.walk?.sheet.name === 'my-walk' && {READY}")
    expect(page.locator("h1")).to_have_text("How long does one swing take?")
    assert "walk=my-walk&step=pull" in page.evaluate("location.search")
    page.reload()  # a clicker's start key
    page.wait_for_function(f"oscillations.walks.walk?.card && {READY}")
    expect(page.locator(".notice")).to_be_hidden()
    tap(page, 0)
    clicked(page)
    expect(page.locator("h1")).to_have_text("Twice as far takes just as long")
    page.get_by_role("button", name="Answer again").click()
    page.wait_for_function("oscillations.shown.state.covered.length && !oscillations.walks.walk.lesson")
    page.reload()
    page.wait_for_function(f"oscillations.walks.walk?.card && {READY}")
    assert page.evaluate("oscillations.walks.walk.lesson === null && !oscillations.walks.walk.card.question.given()")


def test_what_is_asked_is_a_walk_that_passes_its_checks(page: Page, open_scene: Open, tmp_path: Path) -> None:
    shown = {"hidden": "x1_slow", "frame.window": 40, "held.k2": 20}
    open_scene(page, scene="coupled", k2=3, cover="value:omega_plus", **shown)
    page.locator(".walks summary").click()
    page.get_by_role("button", name="Write a question on this picture").click()
    dialog = page.get_by_role("dialog", name="Write a question")
    for part in ("Displacement of mass 2 against time", "Number: slow mode", "Text: No beat"):
        dialog.get_by_label(part).check()
    for fields, said in QUESTIONS:
        for name, text in fields.items():
            if name in ("kind", "curve", "axis"):
                dialog.locator(f"[name={name}]").select_option(text)
            else:
                dialog.locator(f"[name={name}]").fill(text)
        if "reply-2" in fields:
            dialog.get_by_label("The answers keep this order").check()
        dialog.get_by_role("button", name="Add this question").click()
        expect(dialog.locator("li, .problem").filter(has_text=said)).to_be_visible(timeout=30_000)
    with page.expect_download() as download:
        dialog.get_by_role("button", name="Save the walk as a file").click()
    file = tmp_path / download.value.suggested_filename
    download.value.save_as(file)
    walk = load_walk(file, {})
    assert not list(problems(walk, SCENES))
    covers = [COVERED, set(), {"plot:x1"}, set()]
    assert [{*step.cover} for step in walk.steps] == [{"value:omega_plus"} | more for more in covers]
    assert walk.steps[0].state == "?scene=coupled&hidden=x1_slow&k2=3&view=motion&frame.window=40&held.k2=20"
    assert isinstance(walk.steps[2], SketchStep)
    assert isinstance(walk.steps[3], PointStep) and walk.steps[3].answer.unit == "m"
    assert walk.steps[3].answer.quantities == ("x2_0 - 0.5",) and not walk.steps[3].answer.numbers
    assert isinstance(walk.steps[0], ChoiceStep) and walk.steps[0].fixed
    assert [step.notes for step in walk.steps] == ["Show the real springs first.", "", "", ""]


def test_a_hall_does_not_see_a_question_written(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", k2=3, projector="")
    page.locator(".walks summary").click()
    with page.expect_popup() as window:
        page.get_by_role("button", name="Write a question").click()
    desk = window.value
    expect(desk.get_by_role("dialog", name="Write a question")).to_be_visible()
    assert "k2=3" in desk.url and "projector" not in desk.url and "#ask" not in desk.url
    expect(page.get_by_role("dialog", name="Write a question")).to_have_count(0)
    desk.close()


def record(seed: int = 1, head: str = "t (s);x (cm)\n") -> str:
    """A record with decimal commas: 10 s, 30 rows a second, an offset of 3 cm."""
    t = np.arange(301) / 30
    x = 4 * np.exp(-DECAY * t) * np.cos(OMEGA * t) + 3 + np.random.default_rng(seed).normal(0, 0.02, t.size)
    rows = (f"{time:.4f};{place:.4f}" for time, place in zip(t, x, strict=True))
    return head + "\n".join(rows).replace(".", ",") + "\n;\n"


def shows_fit(page: Page) -> None:
    """The numbers of the fit are shown; the first fit of a server may wait for its worker process."""
    expect(page.locator(".measured-sentence")).not_to_be_empty(timeout=120_000)


def test_a_dropped_file_is_fitted_and_the_model_passes_through_it(page: Page, open_scene: Open) -> None:
    """Nothing of it is fetched before its view is shown. An example goes along to other views and scenes."""
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    open_scene(page, scene="damped", view="motion")
    page.get_by_role("tab", name="Measured").click()
    expect(page.get_by_role("button", name="Choose a file")).to_be_visible()
    before = [url for url in asked if "measured/" in url or "papaparse" in url]
    assert before and not any("papaparse" in url for url in before)
    drop(page, "cart.csv", record())
    shows_fit(page)
    assert any("papaparse" in url for url in asked)
    expect(page.locator(".measured-name")).to_have_text("cart.csv: 301 points")
    natural = page.get_by_role("row", name=re.compile("natural frequency"))
    expect(natural).to_have_text(re.compile(r"^ωn5\.00\d+± 0\.00\d+rad/s$"))
    expect(page.locator(".measured-sentence")).to_have_text(re.compile("^The residuals of the fit are random"))
    assert 100 < page.evaluate(POINTS) <= 301
    page.get_by_role("button", name="Fit to data").click()
    page.wait_for_function("oscillations.shown.settings.window.value === 10")
    assert page.evaluate("oscillations.shown.settings.k.value") == pytest.approx(OMEGA**2 + DECAY**2, rel=1e-2)
    with page.expect_download() as download:
        page.get_by_role("button", name="Save residuals").click()
    rows = list(csv.reader(download.value.path().read_text(encoding="utf-8").splitlines()))
    residuals = [float(row[3]) for row in rows[1:]]
    assert len(residuals) == 301 and len(rows[0]) == len(rows[1]) and np.std(residuals) == pytest.approx(2e-4, rel=0.2)
    assert "cart" not in page.url and "window=10" in page.url
    page.get_by_role("button", name="Remove").click()
    expect(page.get_by_role("button", name="Choose a file")).to_be_focused()
    assert page.evaluate(POINTS) == 0
    expect(page.locator(".measured-sentence")).to_be_empty()
    page.get_by_role("button", name="Simulated: air drag").click()
    shows_fit(page)
    expect(page.locator(".measured-sentence")).to_have_text(re.compile("^The residuals of the fit are not random"))


def test_every_kind_of_file_is_read_or_refused_in_a_sentence(page: Page, open_scene: Open) -> None:
    """Text without units, which are asked for; a zip file with its longest table first."""
    open_scene(page, scene="damped", view="measured")
    status, name = page.locator(".measured-status"), page.locator(".measured-name")
    chosen(page, "Choose a file", "letter.txt", b"Dear student,\nno table.\n")
    expect(status).to_contain_text("letter.txt: Line 1: “Dear student,” has no two numbers")
    page.evaluate(PASTE, record(head=""))
    expect(status).to_have_text("Choose the unit of “Time”.")
    page.get_by_label("Time: unit").focus()
    page.get_by_label("Time: unit").select_option("s")
    expect(status).to_have_text("Choose the unit of “Motion”.")
    expect(page.get_by_label("Time: unit")).to_be_focused()
    page.get_by_label("Motion: unit").select_option("cm")
    shows_fit(page)
    expect(page.get_by_role("row", name=re.compile("amplitude"))).to_contain_text("0.0400")
    page.get_by_role("button", name="Remove").click()
    files = io.BytesIO()
    with zipfile.ZipFile(files, "w") as out:
        for table, rows in (("Short", 199), ("Raw", 301)):
            out.writestr(f"{table}.csv", "\n".join(record().splitlines()[: rows + 1]))
    chosen(page, "Choose a file", "phyphox.zip", files.getvalue())
    shows_fit(page)
    expect(name).to_have_text("phyphox.zip: 301 points")
    page.get_by_label("Table", exact=True).select_option("Short.csv")
    expect(name).to_have_text("phyphox.zip: 199 points")
    shows_fit(page)


@pytest.mark.slow  # it records for half a minute
def test_a_phone_records_its_own_acceleration(page: Page, new_page: Open, open_scene: Open) -> None:
    open_scene(page, scene="damped", view="measured")
    expect(page.get_by_role("button", name="Choose a file")).to_be_visible()
    expect(page.get_by_role("button", name="Record with this phone")).to_have_count(0)
    phone = new_page(width=390, height=844, has_touch=True, is_mobile=True)
    open_scene(phone, scene="damped", view="measured")
    phone.evaluate("DeviceMotionEvent.requestPermission = async () => 'denied'")
    phone.get_by_role("button", name="Record with this phone").tap()
    expect(phone.locator(".measured-status")).to_contain_text("Allow motion sensors")
    phone.evaluate(SHAKE)
    phone.get_by_role("button", name="Record with this phone").tap()
    stop = phone.get_by_role("button", name="Stop: 24 s left")
    expect(stop).to_be_visible(timeout=60_000)
    expect(phone.locator(".measured-status")).to_have_text("It records: do not touch the phone.")
    stop.tap()
    shows_fit(phone)
    expect(phone.locator(".measured-name")).to_contain_text("Recorded by this phone: ")
    expect(phone.get_by_label("Motion: column")).to_have_value("1")
    expect(phone.get_by_role("row", name=re.compile("natural frequency"))).to_contain_text(re.compile(r"8\.0|7\.9"))
