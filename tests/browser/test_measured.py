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

from tests.browser.waiting import drop, turned

pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]
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


def saved_residuals(page: Page) -> np.ndarray:
    """The numbers of the file that the button saves."""
    with page.expect_download() as download:
        page.get_by_role("button", name="Save residuals").click()
    rows = list(csv.reader(download.value.path().read_text(encoding="utf-8").splitlines()))
    assert len(rows[0]) == len(rows[1])
    return np.array([[float(cell or "nan") for cell in row] for row in rows[1:]])


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
    residuals = saved_residuals(page)[:, 3]
    assert len(residuals) == 301 and np.std(residuals) == pytest.approx(2e-4, rel=0.2)
    assert "cart" not in page.url and "window=10" in page.url
    removed(page)
    page.get_by_role("button", name="Simulated: air drag").click()
    shows_fit(page)
    expect(page.locator(".measured-sentence")).to_have_text(re.compile("^The residuals of the fit are not random"))


def choose(page: Page, name: str, content: bytes) -> None:
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Choose a file").click()
    chooser.value.set_files(FilePayload(name=name, mimeType="application/octet-stream", buffer=content))


def test_every_kind_of_file_is_read_or_refused_in_a_sentence(measured: Page) -> None:
    """Text without units, which are asked for; a zip file with its longest table first."""
    status, name = measured.locator(".measured-status"), measured.locator(".measured-name")
    choose(measured, "letter.txt", b"Dear student,\nno table.\n")
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
    choose(measured, "phyphox.zip", files.getvalue())
    shows_fit(measured)
    expect(name).to_have_text("phyphox.zip: 301 points")
    measured.get_by_label("Table", exact=True).select_option("Short.csv")
    expect(name).to_have_text("phyphox.zip: 199 points")
    shows_fit(measured)


def test_a_fit_can_be_cancelled(measured: Page) -> None:
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
    removed(measured)


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
