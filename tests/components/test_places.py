"""Columns on the wire: what is put in steps and differences comes back, in Python as in the browser."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from playwright.sync_api import Browser

from components.page.messages import File
from components.page.picture import Ruler
from components.places import COARSE, FINE, MOST_ORDER, SUM, encoded, span, steps
from components.wire import Packet, packed
from tests.browser.script_page import Scripts
from tests.page.columns import decoded, inflated, with_numbers
from tests.serving.server import ROOT

CASES = json.loads((ROOT / "tests" / "reference" / "columns.json").read_text(encoding="utf-8"))
"""Messages as they were once sent, and what they say."""
UNPACK = """async ([data, usual]) => {
  const told = await columns.unpacked(Uint8Array.from(atob(data), letter => letter.charCodeAt(0)).buffer, usual)
  return JSON.parse(JSON.stringify(told, (_, value) => (ArrayBuffer.isView(value) ? [...value] : value)))
}"""


def told_in(case: dict[str, str]) -> dict[str, object]:
    packet = Packet(sheet="", data=base64.b64decode(case["data"]))
    text, _, numbers = inflated(packet, case["usual"].encode()).partition(b"\n")
    told = json.loads(text)
    return {**told, "view": with_numbers(told["view"], numbers)} if "view" in told else dict(told)


def plain(value: object) -> object:
    return json.loads(json.dumps(value, default=lambda numbers: numbers.tolist()))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_what_was_sent_once_is_read_as_it_was_meant(case: dict[str, str]) -> None:
    assert plain(told_in(case)) == case["told"]


@pytest.fixture(scope="module")
def scripts(browser: Browser) -> Iterator[Scripts]:
    running = Scripts(browser, ("columns",))
    yield running
    running.context.close()
    assert running.faults == []


@pytest.mark.browser
@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_the_browser_reads_the_same(scripts: Scripts, case: dict[str, str]) -> None:
    assert scripts.page.evaluate(UNPACK, [case["data"], case["usual"]]) == case["told"]


@given(st.lists(arrays.arrays(np.int32, st.integers(0, 12), elements=st.integers(0, FINE)), max_size=5))
def test_whole_numbers_come_back(columns: list[np.ndarray]) -> None:
    counts = [len(column) for column in columns]
    found = decoded(encoded(columns), counts)
    assert [one.tolist() for one in found] == [one.tolist() for one in columns]


@pytest.mark.parametrize("degree", range(MOST_ORDER))
def test_a_polynomial_is_sent_as_the_differences_that_vanish(degree: int) -> None:
    column = (np.arange(40) ** degree).astype(np.int32)
    assert encoded([column])[0] > degree


@given(st.floats(0.1, 40.0), st.floats(-3.0, 3.0), st.floats(-3.0, 3.0), st.booleans())
def test_what_follows_its_two_parts_is_sent_as_what_is_left_of_it(w: float, a: float, b: float, aside: bool) -> None:
    t = np.linspace(0.0, 10.0, 301)
    parts = a * np.sin(w * t), b * np.cos(1.618 * w * t)
    total = sum(parts) + (np.sin(7 * t) if aside else 0.0)
    columns = [steps(values, -9.0, 9.0, COARSE) for values in (*parts, total, t)]
    sent = encoded(columns)
    assert [order >= SUM for order in sent[:4]] == [False, False, not aside, False]
    assert [one.tolist() for one in decoded(sent, [301] * 4)] == [one.tolist() for one in columns]


def test_a_sum_that_has_left_the_range_comes_back_all_the_same() -> None:
    parts = np.full(40, 60000, np.int32), np.arange(40, dtype=np.int32)
    total = np.minimum(parts[0] + parts[1], COARSE - 5500).astype(np.int32)
    assert [one.tolist() for one in decoded(encoded([*parts, total]), [40] * 3)] == [
        one.tolist() for one in (*parts, total)
    ]


@given(st.floats(-1e6, 1e6), st.floats(1e-6, 1e6), st.lists(st.floats(allow_nan=False), max_size=20))
def test_what_is_near_the_frame_is_within_half_a_step_and_the_rest_is_outside(
    start: float, height: float, values: list[float]
) -> None:
    axis = {"ticks": (), "labels": (), "unit": "", "exponent": 0, "factor": 1.0, "power": 1, "log": False}
    low, high = span(Ruler(start=start, end=start + height, **axis))
    numbers = np.array(values, dtype=float)
    whole = steps(numbers, low, high, COARSE)
    near = (numbers >= low) & (numbers <= high)
    step = (high - low) / COARSE
    assert np.all(np.abs(low + step * whole[near] - numbers[near]) <= 0.501 * step)
    assert np.all(whole[numbers < low] == 0) and np.all(whole[numbers > high] == COARSE)


def test_what_a_message_repeats_of_the_usual_text_costs_next_to_nothing() -> None:
    name = "".join(np.random.default_rng(1).choice(list("abcdefghijklmnopqrstuvwxyz"), 2000))
    file = File(name=name, kind="text/plain", content=b"")
    alone, known = packed(file), packed(file, sheet="s", usual=name.encode())
    assert len(known["data"]) < 0.1 * len(alone["data"])
    assert inflated(known, name.encode()) == inflated(alone, b"")
