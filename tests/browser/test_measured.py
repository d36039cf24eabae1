"""A visitor's own measurement next to the damped model: files in, points, fit and residuals, and files refused."""

from __future__ import annotations

import csv
import io
import re
import zipfile
from collections.abc import Callable

import numpy as np
import pytest
from playwright.sync_api import FilePayload, Page, expect

from tests.browser.dropping import drop

pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]
POINTS = """() => document.querySelector(".plot-area path.measured-points").getAttribute("d")
  .split("M").length - 1"""
SENT = "oscillations.messages.number"
WINDOW = "oscillations.shown.settings.window.value"
PASTE = """text => {
  const clipboardData = new DataTransfer()
  clipboardData.setData("text/plain", text)
  document.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true}))
}"""
OMEGA, DECAY = 5.0, 0.1
LOSE = """() => {
  const {messages, connection} = oscillations
  const request = messages.request.bind(messages)
  window.pieces = []
  messages.request = message => {
    window.pieces.push(message.piece)
    if (window.pieces.length === 3) connection.lose()
    return request(message)
  }
}"""
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
def measured(page: Page, open_scene: Callable[..., Page]) -> Page:
    open_scene(page, scene="damped", view="measured")
    expect(page.get_by_role("button", name="Choose a file")).to_be_visible()
    return page


def shows_fit(page: Page) -> None:
    """The numbers of the fit are shown; the first fit of a server may wait for its worker process."""
    expect(page.locator(".measured-sentence")).not_to_be_empty(timeout=120_000)


def test_a_dropped_file_is_fitted_and_the_model_passes_through_it(measured: Page) -> None:
    drop(measured, "cart.csv", record())
    shows_fit(measured)
    expect(measured.locator(".measured-name")).to_have_text("cart.csv: 301 points")
    expect(measured.get_by_role("row", name=re.compile("natural frequency"))).to_have_text(
        re.compile(r"^ωn5\.00\d+± 0\.00\d+rad/s$")
    )
    expect(measured.locator(".measured-sentence")).to_have_text(re.compile("^The residuals of the fit are random"))
    assert 100 < measured.evaluate(POINTS) <= 301
    measured.get_by_role("button", name="Fit to data").click()
    measured.wait_for_function(f"{WINDOW} === 10")
    k = measured.evaluate("oscillations.shown.settings.k.value")
    assert k == pytest.approx(OMEGA**2 + DECAY**2, rel=1e-2)
    with measured.expect_download() as download:
        measured.get_by_role("button", name="Save residuals").click()
    rows = list(csv.reader(download.value.path().read_text(encoding="utf-8").splitlines()))
    residuals = np.array([float(row[3]) for row in rows[1:]])
    assert len(rows) == 302 and np.std(residuals) == pytest.approx(2e-4, rel=0.2)
    assert "cart" not in measured.url and "window=10" in measured.url
    measured.get_by_role("button", name="Remove").click()
    expect(measured.get_by_role("button", name="Choose a file")).to_be_focused()
    assert measured.evaluate(POINTS) == 0


def test_an_example_is_one_button_away_and_stays_in_another_view(measured: Page) -> None:
    measured.get_by_role("button", name="Simulated: air drag").click()
    shows_fit(measured)
    expect(measured.locator(".measured-sentence")).to_have_text(re.compile("^The residuals of the fit are not random"))
    measured.get_by_role("tab", name="Motion").click()
    points = measured.locator(".plot-area path.measured-points")
    expect(points).to_be_hidden()
    measured.get_by_role("tab", name="Measured").click()
    expect(points).to_be_visible()
    expect(measured.locator(".measured-name")).to_have_text("simulated-air-drag.csv: 361 points")


def test_units_that_a_file_lacks_are_asked_for(measured: Page) -> None:
    measured.evaluate(PASTE, record(head=""))
    expect(measured.locator(".measured-status")).to_have_text("Choose the unit of “Time”.")
    measured.get_by_label("Time: unit").focus()
    measured.get_by_label("Time: unit").select_option("s")
    expect(measured.locator(".measured-status")).to_have_text("Choose the unit of “Motion”.")
    expect(measured.get_by_label("Time: unit")).to_be_focused()
    measured.get_by_label("Motion: unit").select_option("cm")
    shows_fit(measured)
    expect(measured.get_by_role("row", name=re.compile("amplitude"))).to_contain_text("0.0400")


def test_two_columns_are_fitted_next_to_two_masses(page: Page, open_scene: Callable[..., Page]) -> None:
    open_scene(page, scene="coupled", view="measured")
    page.get_by_role("button", name="Simulated: two carts").click()
    shows_fit(page)
    expect(page.locator(".measured-name")).to_have_text("simulated-two-carts.csv: 361 points")
    expect(page.get_by_role("row", name="X2/X1, fast mode")).to_contain_text("−0.99")
    expect(page.locator(".measured-more")).to_contain_text("“Fit to data” keeps the mass m₁")
    drawn = page.locator(".plot-area path.measured-points")
    expect(drawn).to_have_count(2)
    page.get_by_role("button", name="Fit to data").click()
    page.wait_for_function(f"{WINDOW} > 11.9 && {WINDOW} < 12.1")
    k1, k2, m1, m2 = (page.evaluate(f"oscillations.shown.settings.{name}.value") for name in ("k1", "k2", "m1", "m2"))
    assert (m1, k1 / m1, k2 / m1, m2 / m1) == pytest.approx((2, 20, 10, 0.5), rel=1e-2)
    with page.expect_download() as download:
        page.get_by_role("button", name="Save residuals").click()
    rows = list(csv.reader(download.value.path().read_text(encoding="utf-8").splitlines()))
    assert len(rows) == 362 and len(rows[0]) == len(rows[1]) == 7
    assert abs(float(rows[1][3])) < 3e-3 and abs(float(rows[1][6])) < 3e-3
    page.get_by_label("Mass 1: column").select_option("right (mm)")
    expect(page.locator(".measured-status")).to_contain_text("One column is chosen twice")
    page.get_by_label("Mass 2: column").select_option("left (mm)")
    shows_fit(page)
    expect(page.locator(".measured-more")).to_contain_text("check the order of the columns")
    expect(page.get_by_role("button", name="Fit to data")).to_be_disabled()


def test_a_file_goes_along_to_other_scenes(measured: Page) -> None:
    measured.get_by_role("button", name="Simulated: dashpot").click()
    shows_fit(measured)
    measured.evaluate("oscillations.open({scene: 'coupled', parameters: {view: 'measured'}})")
    expect(measured.locator(".measured-status")).to_contain_text("One column is chosen twice")
    expect(measured.locator(".measured-name")).to_have_text("simulated-dashpot.csv")
    measured.evaluate("oscillations.open({scene: 'oscillator', parameters: {m: 2}})")
    measured.get_by_text("Save and share").click()
    measured.get_by_role("link", name="Compare with your file").click()
    expect(measured.locator(".measured-name")).to_have_text("simulated-dashpot.csv: 361 points")
    shows_fit(measured)
    assert measured.evaluate("['m', 'c'].map(name => oscillations.shown.settings[name].value)") == [2, 0]


def test_an_acceleration_is_drawn_as_the_displacement_of_the_fit(measured: Page) -> None:
    t = np.arange(301) / 30
    a = -0.04 * OMEGA**2 * np.cos(OMEGA * t) + 9.81
    drop(measured, "phone.csv", "t (s),a (m/s^2)\n" + "\n".join(f"{x},{y:.4f}" for x, y in zip(t, a, strict=True)))
    shows_fit(measured)
    expect(measured.get_by_role("row", name=re.compile("amplitude"))).to_have_text(re.compile(r"^C0\.0(400|3999)"))
    expect(measured.get_by_role("row", name=re.compile("offset"))).to_have_text(re.compile(r"^offset9\.8(10|09)"))
    measured.get_by_role("button", name="Fit to data").click()
    measured.wait_for_function(f"{WINDOW} === 10")
    with measured.expect_download() as download:
        measured.get_by_role("button", name="Save residuals").click()
    rows = list(csv.reader(download.value.path().read_text(encoding="utf-8").splitlines()))
    points = np.array([float(row[1]) for row in rows[1:]])
    np.testing.assert_allclose(points, 0.04 * np.cos(OMEGA * t), atol=1e-4)


def test_a_file_that_is_no_record_is_refused_in_a_sentence(measured: Page) -> None:
    sent = measured.evaluate(SENT)
    for name, content, reason in (
        ("letter.txt", "Dear student,\nno table.\n", "letter.txt: Line 1: “Dear student,” has no two numbers"),
        ("large.csv", "1,2\n" * 1_400_000, "large.csv has 5.3 MB: files of at most 5 MB are read."),
    ):
        choose(measured, name, content.encode())
        expect(measured.locator(".measured-status")).to_contain_text(reason)
    assert measured.evaluate(SENT) == sent


def test_a_record_is_sent_from_its_first_piece_to_a_new_session(measured: Page) -> None:
    t = np.arange(5000) / 300
    x = 0.04 * np.cos(OMEGA * t) + np.random.default_rng(3).normal(0, 2e-4, t.size)
    measured.evaluate(LOSE)
    drop(measured, "long.csv", "t (s),x (m)\n" + "\n".join(f"{a:.4f},{b:.5f}" for a, b in zip(t, x, strict=True)))
    shows_fit(measured)
    assert measured.evaluate("window.pieces.slice(0, 7)") == [0, 1, 2, 0, 1, 2, 3]
    assert "long.csv" not in str(measured.evaluate("Object.values(sessionStorage)"))


def test_a_fit_can_be_cancelled_and_computed_again(measured: Page) -> None:
    measured.evaluate(DROP_ROWS)
    drop(measured, "cart.csv", record())
    measured.get_by_role("button", name="Cancel").click()
    expect(measured.locator(".measured-status")).to_have_text("The fit is cancelled. “Fit again” computes it.")
    expect(measured.get_by_role("button", name="Cancel")).to_be_hidden()
    measured.wait_for_function("oscillations.messages.rests")
    measured.evaluate("window.repair()")
    measured.get_by_role("button", name="Fit again").click()
    shows_fit(measured)
    expect(measured.get_by_role("button", name="Fit again")).to_be_hidden()


def zipped(**files: str) -> bytes:
    """A zip file of tables by name."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as out:
        for name, text in files.items():
            out.writestr(f"{name}.csv", text)
    return made.getvalue()


def choose(page: Page, name: str, content: bytes) -> None:
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Choose a file").click()
    chooser.value.set_files(FilePayload(name=name, mimeType="application/octet-stream", buffer=content))


def test_a_zip_file_has_its_longest_table_first_and_a_choice(measured: Page) -> None:
    short = "\n".join(record(seed=4).splitlines()[:200])
    choose(measured, "phyphox.zip", zipped(Short=short, Raw=record(), Notes="a letter"))
    shows_fit(measured)
    expect(measured.locator(".measured-name")).to_have_text("phyphox.zip: 301 points")
    measured.get_by_label("Table", exact=True).select_option("Short.csv")
    expect(measured.locator(".measured-name")).to_have_text("phyphox.zip: 199 points")
    shows_fit(measured)


def test_a_phone_records_its_own_acceleration(
    new_page: Callable[..., Page], open_scene: Callable[..., Page], measured: Page
) -> None:
    expect(measured.get_by_role("button", name="Record with this phone")).to_have_count(0)
    phone = new_page(width=390, height=844, fresh=True, has_touch=True, is_mobile=True)
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


def test_nothing_of_it_is_fetched_before_its_view_is_shown(page: Page, open_scene: Callable[..., Page]) -> None:
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


@pytest.mark.parametrize("width", [390, 320])
@pytest.mark.parametrize(("scene", "example"), [("damped", "dashpot"), ("coupled", "two carts")])
def test_a_phone_has_the_file_over_the_plot_and_nothing_beside_the_screen(
    scene: str, example: str, width: int, new_page: Callable[..., Page], open_scene: Callable[..., Page]
) -> None:
    page = open_scene(new_page(width=width, height=844, color_scheme="dark"), scene=scene, view="measured")
    page.get_by_role("button", name=f"Simulated: {example}").click()
    shows_fit(page)
    parts = (".measured-buttons", ".plot-area", ".lane", ".facts-table")
    places = [page.locator(f"{one}:visible").first.bounding_box() for one in parts]
    tops = [place["y"] for place in places if place]
    assert len(tops) == 4 and tops == sorted(tops)
    assert places[1] and places[1]["y"] + places[1]["height"] <= 844
    assert page.evaluate("document.documentElement.scrollWidth") <= width
