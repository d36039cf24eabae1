"""Files of visitors: an own walk, from a file or written on the page; a measurement next to the model."""

import csv
import io
import re
import zipfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import FilePayload, Locator, Page, expect

from components.scenes import SCENES
from components.walks.checking import problems
from components.walks.loading import load_walk
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
from components.walks.walk import Walk
from tests.browser.classroom import draw
from tests.browser.fixtures import READY
from tests.browser.waiting import MINE, clicked, drop, tap, turned

pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]
COVERED = {"plot:x2", "value:omega_minus", "form:beat"}
DRAWN = """(() => {
  const {x, y} = oscillations.plots.find(({block}) => block.name === "x1")
  const {t, x1} = oscillations.shown.view.columns.time
  return Array.from(t, (at, i) => [(at - x.start) / (x.end - x.start), (x1[i] - y.start) / (y.end - y.start)])
})()"""
"""The curve of mass 1, in shares of its frame."""
REFUSED = {
    "big.toml": (b"#" * 48_001, "big.toml: the file has 48001 bytes; at most 48000 are allowed."),
    "cover.toml": (
        MINE.encode() + b'cover = ["plot:z"]',
        "step 1 (pull), cover: “plot:z” is not possible: choose from",
    ),
}


def chosen(page: Page, button: str, name: str, content: bytes) -> None:
    """The file, chosen with a button."""
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name=button).click()
    chooser.value.set_files(FilePayload(name=name, mimeType="application/octet-stream", buffer=content))


def test_a_file_is_run_or_refused_in_a_sentence(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="energy")
    for name, (content, said) in REFUSED.items():
        page.locator(".walks summary").click()
        chosen(page, "Open my own walk", name, content)
        expect(page.locator(".notice span")).to_contain_text(said, timeout=30_000)  # a worker may be starting
    page.locator(".walks summary").click()
    here = MINE.replace("d31-03", "d31-07")  # a step of the visible scene
    chosen(page, "Open my own walk", "here.toml", here.encode())
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


def asked(page: Page, question: str, kind: str, **fields: str) -> None:
    """A step about the visible picture."""
    dialog = page.get_by_role("dialog", name="Write a question")
    dialog.locator("[name=question]").fill(question)
    dialog.locator("[name=kind]").select_option(kind)
    for name, value in {**fields, "title": "A claim", "explain": 'What it "means".'}.items():
        field = dialog.locator(f"[name={name}]")
        if name in ("curve", "axis"):
            field.select_option(value)
        else:
            field.fill(value)
    dialog.get_by_role("button", name="Add this question").click()


def ask_each_kind(page: Page) -> Locator:
    """A step of each kind, and the dialog in which it was written."""
    page.locator(".walks summary").click()
    page.get_by_role("button", name="Write a question on this picture").click()
    dialog = page.get_by_role("dialog", name="Write a question")
    for part in ("Displacement of mass 2 against time", "Number: slow mode", "Text: No beat"):
        dialog.get_by_label(part).check()
    choice = {"text-1": "Both", "text-2": "Neither", "notes": "Show the real springs first."}
    asked(page, "Which one swings?", "choice", **choice)
    expect(dialog.locator(".problem")).to_contain_text("a wrong answer needs a reply", timeout=30_000)
    dialog.get_by_label("The answers keep this order").check()
    dialog.locator("[name=reply-2]").fill("It is right at rest.")
    dialog.get_by_role("button", name="Add this question").click()
    expect(dialog.locator("li")).to_have_count(1)
    asked(page, "How long is {beat:null}?", "number", **{"is": "2500 ms", "unit": "s", "tol": "0,1"})
    expect(dialog.locator("li")).to_have_count(2)
    asked(page, "Sketch mass 1.", "sketch", curve="x1.x1", **{"is-0": "x1_O"})
    expect(dialog.locator(".problem")).to_contain_text("has a name that the scene does not have, x1_O; it has")
    asked(page, "Sketch mass 1.", "sketch", curve="x1.x1", **{"is-0": "x1_0"})
    expect(dialog.locator("li")).to_have_count(3)
    asked(page, "Mark where mass 2 begins.", "point", axis="x2.y", of="x2_0 - 0.5", tol="0.1")
    expect(dialog.locator("li")).to_have_count(4)
    return dialog


def test_what_is_asked_is_a_walk_that_passes_its_checks_and_runs(
    page: Page, open_scene: Callable[..., Page], tmp_path: Path
) -> None:
    shown = {"hidden": "x1_slow", "frame.window": 40, "held.k2": 20}
    open_scene(page, scene="coupled", k2=3, cover="value:omega_plus", **shown)
    drawn = page.evaluate(DRAWN)
    dialog = ask_each_kind(page)
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
    dialog.get_by_role("button", name="Close").click()
    drop(page, file.name, file.read_text(encoding="utf-8"))
    answered(page, walk, drawn)


def answered(page: Page, walk: Walk, drawn: list[tuple[float, float]]) -> None:
    """Every step is asked in the picture on which it was written, and the right answer is right."""
    answers: tuple[Callable[[Page], None], ...] = (
        lambda page: tap(page, 0),
        lambda page: page.get_by_label("Your answer").fill("2.45"),
        lambda page: draw(page, lambda share: float(np.interp(share, *zip(*drawn, strict=True))), 120),
        point,
    )
    for place, answer in enumerate(answers):
        page.wait_for_function(f"place => oscillations.walks.walk?.place === place && {READY}", arg=place)
        page.wait_for_function("oscillations.walks.walk.card?.page === oscillations.page")
        expect(page.locator("h1")).to_have_text(walk.steps[place].question)
        hidden, held, window = page.evaluate(
            "[({hidden, held, frame: {window}}) => [hidden, held, window]][0](oscillations.shown.state)"
        )
        assert (hidden, held, window) == (["x1_slow"], {"k2": 20}, 40)
        answer(page)
        clicked(page)
        page.wait_for_function("oscillations.walks.walk.lesson && !oscillations.shown.state.covered.length")
        assert page.evaluate("oscillations.walks.walk.lesson.right") is True
        clicked(page)


def point(page: Page) -> None:
    mark = page.get_by_role("slider", name="Your mark")
    while float(mark.get_attribute("aria-valuenow") or "nan") > -0.45:
        mark.press("ArrowDown")


def test_a_hall_does_not_see_a_question_written(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="coupled", k2=3, projector="")
    page.locator(".walks summary").click()
    with page.expect_popup() as window:
        page.get_by_role("button", name="Write a question").click()
    desk = window.value
    expect(desk.get_by_role("dialog", name="Write a question")).to_be_visible()
    assert "k2=3" in desk.url and "projector" not in desk.url and "#ask" not in desk.url
    expect(page.get_by_role("dialog", name="Write a question")).to_have_count(0)
    desk.close()


POINTS = """() => document.querySelector(".plot-area path.measured-points").getAttribute("d")
  .split("M").length - 1"""
WINDOW = "oscillations.shown.settings.window.value"
PASTE = """text => {
  const clipboardData = new DataTransfer()
  clipboardData.setData("text/plain", text)
  document.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true}))
}"""
OMEGA, DECAY = 5.0, 0.1
DROP_ROWS = """() => {
  const {wire} = oscillations.messages
  const send = wire.send.bind(wire)
  wire.send = message => message.type === "rows" ? undefined : send(message)
  window.repair = () => { wire.send = send }
}"""
SHAKE = """() => {
  DeviceMotionEvent.requestPermission = async () => "granted"
  window.shaking = setInterval(() => {
    const a = 2 * Math.cos(8 * performance.now() / 1000)
    dispatchEvent(new DeviceMotionEvent("devicemotion", {acceleration: {x: 0.01, y: a, z: 0}, interval: 16}))
  }, 16)
}"""


def record(seed: int = 1, head: str = "t (s);x (cm)\n") -> str:
    """A record with decimal commas: 10 s, 30 rows a second, an offset of 3 cm."""
    t = np.arange(301) / 30
    x = 4 * np.exp(-DECAY * t) * np.cos(OMEGA * t) + 3 + np.random.default_rng(seed).normal(0, 0.02, t.size)
    rows = (f"{time:.4f};{place:.4f}" for time, place in zip(t, x, strict=True))
    return head + "\n".join(rows).replace(".", ",") + "\n;\n"


@pytest.fixture
def measured(desk: Page) -> Page:
    """The view without a file."""
    turned(desk, "damped", {"view": "measured"})
    remove = desk.get_by_role("button", name="Remove")
    if remove.is_visible():
        remove.click()
    expect(desk.locator(".measured-sentence")).to_be_empty()
    return desk


def shows_fit(page: Page) -> None:
    """The numbers of the fit are shown; the first fit of a server may wait for its worker process."""
    expect(page.locator(".measured-sentence")).not_to_be_empty(timeout=120_000)


def removed(page: Page) -> None:
    page.get_by_role("button", name="Remove").click()
    expect(page.get_by_role("button", name="Choose a file")).to_be_focused()
    assert page.evaluate(POINTS) == 0
    expect(page.locator(".measured-sentence")).to_be_empty()


def test_a_dropped_file_is_fitted_and_the_model_passes_through_it(page: Page, open_scene: Callable[..., Page]) -> None:
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
    page.wait_for_function(f"{WINDOW} === 10")
    assert page.evaluate("oscillations.shown.settings.k.value") == pytest.approx(OMEGA**2 + DECAY**2, rel=1e-2)
    with page.expect_download() as download:
        page.get_by_role("button", name="Save residuals").click()
    rows = list(csv.reader(download.value.path().read_text(encoding="utf-8").splitlines()))
    residuals = [float(row[3]) for row in rows[1:]]
    assert len(residuals) == 301 and len(rows[0]) == len(rows[1]) and np.std(residuals) == pytest.approx(2e-4, rel=0.2)
    assert "cart" not in page.url and "window=10" in page.url
    removed(page)
    page.get_by_role("button", name="Simulated: air drag").click()
    shows_fit(page)
    expect(page.locator(".measured-sentence")).to_have_text(re.compile("^The residuals of the fit are not random"))


def test_every_kind_of_file_is_read_or_refused_in_a_sentence(measured: Page) -> None:
    """Text without units, which are asked for; a zip file with its longest table first. A fit can be cancelled."""
    status, name = measured.locator(".measured-status"), measured.locator(".measured-name")
    chosen(measured, "Choose a file", "letter.txt", b"Dear student,\nno table.\n")
    expect(status).to_contain_text("letter.txt: Line 1: “Dear student,” has no two numbers")
    measured.evaluate(PASTE, record(head=""))
    expect(status).to_have_text("Choose the unit of “Time”.")
    measured.get_by_label("Time: unit").focus()
    measured.get_by_label("Time: unit").select_option("s")
    expect(status).to_have_text("Choose the unit of “Motion”.")
    expect(measured.get_by_label("Time: unit")).to_be_focused()
    measured.get_by_label("Motion: unit").select_option("cm")
    shows_fit(measured)
    expect(measured.get_by_role("row", name=re.compile("amplitude"))).to_contain_text("0.0400")
    removed(measured)
    files = io.BytesIO()
    with zipfile.ZipFile(files, "w") as out:
        for table, rows in (("Short", 199), ("Raw", 301)):
            out.writestr(f"{table}.csv", "\n".join(record().splitlines()[: rows + 1]))
    chosen(measured, "Choose a file", "phyphox.zip", files.getvalue())
    shows_fit(measured)
    expect(name).to_have_text("phyphox.zip: 301 points")
    measured.get_by_label("Table", exact=True).select_option("Short.csv")
    expect(name).to_have_text("phyphox.zip: 199 points")
    shows_fit(measured)
    removed(measured)
    measured.evaluate(DROP_ROWS)
    drop(measured, "cart.csv", record())
    measured.get_by_role("button", name="Cancel").click()
    expect(status).to_have_text("The fit is cancelled. “Fit again” computes it.")
    expect(measured.get_by_role("button", name="Cancel")).to_be_hidden()
    measured.wait_for_function("oscillations.messages.rests")
    measured.evaluate("window.repair()")
    again = measured.get_by_role("button", name="Fit again")
    again.click()
    shows_fit(measured)
    expect(again).to_be_hidden()


@pytest.mark.slow  # it records for half a minute
def test_a_phone_records_its_own_acceleration(
    new_page: Callable[..., Page], open_scene: Callable[..., Page], measured: Page
) -> None:
    expect(measured.get_by_role("button", name="Record with this phone")).to_have_count(0)
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
