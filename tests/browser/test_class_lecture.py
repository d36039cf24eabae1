"""A lecture of five steps from a file: the hall's screen with a clicker, a phone, a remote control."""

from __future__ import annotations

import csv
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.classroom import LED, counted, draw, joined, put, remote_of, taught
from tests.browser.dropping import drop
from tests.browser.halls import seen
from tests.browser.waiting import clicked

pytestmark = pytest.mark.browser

STEPS = {"pull": "d31-03", "mass": "d31-02", "place": "d31-12", "curve": "d34-14", "rest": "d34-12"}
LECTURE = 'title = "Five"\n' + "".join(f'[[step]]\nid = "{name}"\nfrom = "{step}"\n' for name, step in STEPS.items())
SENT = "You can change it until the answer is shown."


def look(lecture: Page, name: str) -> None:
    """The screen in front, as the last row sees it."""
    assert list(seen(lecture, 1080, f"{name}, after")) == []


def choice(lecture: Page, phone: Page) -> None:
    """Two votes with a discussion between them."""
    put(lecture, phone, "pull")
    phone.locator(".answers [data-option='1']").click()
    expect(phone.get_by_text(SENT)).to_be_visible()
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    clicked(lecture)
    counted(lecture, "0", "1", "0")
    lecture.get_by_role("button", name="Vote again").click()
    phone.wait_for_function("oscillations.asked.question.vote === 2 && oscillations.asked.card")
    phone.locator(".answers [data-option='0']").click()
    expect(lecture.locator(".votes")).to_contain_text("1 of 1 have answered")
    clicked(lecture)
    counted(lecture, "0 → 1", "1 → 0", "0 → 0")
    shown = [[row.inner_text() for row in page.locator(".answers .name").all()] for page in (lecture, phone)]
    assert shown[0] == shown[1], "one order for all"
    expect(lecture.locator(".vote-bar .before")).to_have_count(1)  # the first vote stays outlined
    clicked(lecture)
    for page in (lecture, phone):
        expect(page.locator("h1")).to_have_text("Twice as far takes just as long")
    expect(phone.locator(".answers [data-option='0']").get_by_role("img", name="right")).to_be_visible()
    look(lecture, "lecture-choice")
    clicked(lecture)
    expect(lecture.locator(".card .why")).to_be_visible()
    clicked(lecture)


def number(lecture: Page, phone: Page, remote: Page) -> None:
    """Led by the remote control."""
    put(lecture, phone, "mass")
    phone.get_by_role("textbox", name="Your answer").fill("2")
    expect(phone.get_by_text(SENT)).to_be_visible()
    clicked(lecture)
    expect(lecture.locator(".vote-line circle")).to_have_count(1)
    remote.get_by_role("button", name="Show the answer").click()
    expect(lecture.locator(".votes .all")).to_have_text("1 of 1 is right")
    expect(lecture.locator(".vote-line .truth")).to_have_text("2 s")
    look(lecture, "lecture-number")
    remote.get_by_role("button", name="How it follows").click()
    expect(lecture.locator(".card .follows .lines")).to_be_visible()
    remote.get_by_role("button", name="Next").click()


def point(lecture: Page, phone: Page) -> None:
    put(lecture, phone, "place")
    phone.locator(".pill-mark").press("ArrowRight")
    expect(phone.get_by_text(SENT)).to_be_visible()
    clicked(lecture)
    lecture.wait_for_function("""() => {
      const parts = [".vote-dots circle", ".pill-mark"].map(part => document.querySelector(part))
      const [dot, mark] = parts.map(part => part?.getBoundingClientRect()).map(box => box && box.x + box.width / 2)
      return Math.abs(dot - mark) < 20
    }""")  # the answers are on the axis itself, next to where the mark begins
    look(lecture, "lecture-point")
    clicked(lecture)
    expect(lecture.locator(".votes .all")).to_have_text("0 of 1 are right")
    clicked(lecture)
    expect(lecture.locator(".card .why")).to_be_visible()
    clicked(lecture)


def sketch(lecture: Page, phone: Page) -> None:
    """The sketches take the whole screen."""
    put(lecture, phone, "curve")
    draw(phone, lambda x: 0.9 - 0.88 * x)
    expect(phone.get_by_text(SENT)).to_be_visible()
    clicked(lecture)
    ink = lecture.get_by_role("img", name="1 sketches of the class")
    expect(ink).to_be_visible()
    clicked(lecture)
    expect(lecture.locator("h1")).to_have_text(re.compile("^“.*” is right in 1 of 1 sketch, “.*” in 0$"))
    box = ink.bounding_box()
    assert box and box["width"] > 1700 and box["height"] > 500
    expect(lecture.locator(".class-corner")).to_contain_text("1 here")
    look(lecture, "lecture-sketch")
    expect(phone.locator(".findings li")).to_have_count(5)
    clicked(lecture)
    expect(lecture.locator("h1")).to_have_text("Two poles, and a zero between them")
    expect(ink).to_have_count(0)
    clicked(lecture)
    expect(lecture.locator(".card .follows .lines")).to_be_visible()
    clicked(lecture)


def table(lecture: Page, folder: Path) -> list[list[str]]:
    lecture.keyboard.press("j")
    with lecture.expect_download() as download:
        lecture.get_by_role("button", name="Answers as CSV").click()
    path = folder / "answers.csv"
    download.value.save_as(path)
    with path.open(newline="") as file:
        return list(csv.reader(file))


@pytest.mark.slow
@pytest.mark.timeout(300)  # four windows on a busy machine
def test_a_lecture_of_five_steps(window: Callable[[str, int, int], Page], tmp_path: Path) -> None:
    lecture, code = taught(window, "scene=oscillator&projector")
    expect(lecture.locator(".class-corner")).to_contain_text(code)
    remote = remote_of(lecture, window)
    phone = joined(window, code)
    drop(lecture, "five.toml", LECTURE)
    choice(lecture, phone)
    number(lecture, phone, remote)
    point(lecture, phone)
    sketch(lecture, phone)
    put(lecture, phone, "rest")
    expect(remote.locator(".class-remote > [role=status]")).to_contain_text("5 of 5")
    clicked(lecture, "PageUp")
    put(lecture, phone, "curve")
    assert len(phone.evaluate("oscillations.asked.card.question.pad.sent").get("Xp1", [])) == 101  # it is still theirs
    rows = table(lecture, tmp_path)
    assert [[*row[3:6], row[9]] for row in rows] == [
        ["walk", "step", "vote", "right"], ["five", "pull", "1", "no"], ["five", "pull", "2", "yes"],
        ["five", "mass", "1", "yes"], ["five", "place", "1", "no"], ["five", "curve", "1", "no"],
    ]  # fmt: skip
    assert {row[0] for row in rows[1:]} == {"1"} and all(row[1].endswith("Z") and row[2] == "1" for row in rows[1:])
    assert rows[3][7] == "2" and len(rows[5][7].split(";")) == 101 and rows[5][8] == "SI"
    remote.close()  # it would continue to poll, and get the answer that there is no such class
    lecture.evaluate(f"{LED}.end()")
    expect(phone.get_by_role("heading", name="The class is over.")).to_be_visible()
