"""Measured rows: pieces in order, the fit after the last one, and refusals."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike

from components.quantities.formatting import parse_number
from components.scenes import SCENES
from tests.page.headless_page import Page
from tests.serving.server import ROOT
from tools.measured_examples import EXAMPLES

T = np.arange(300) * 0.04
OMEGA, DECAY, C = 6.3, 0.12, 0.05
FOLDER = ROOT / "static" / "measured"


def motion(seed: int, noise: float = 1e-4) -> Any:
    swing = C * np.exp(-DECAY * T) * np.cos(OMEGA * T) + 0.01
    return swing + np.random.default_rng(seed).normal(0, noise, T.size)


def piece(number: int, of: int, t: ArrayLike, *columns: ArrayLike, **more: Any) -> dict[str, Any]:
    rows = {"t": np.asarray(t).tolist(), "columns": [np.asarray(column).tolist() for column in columns]}
    return {"type": "rows", "piece": number, "of": of, "number": number + 1, **rows, **more}


@pytest.fixture
def page() -> Page:
    return Page(SCENES["damped"]())


def within(number: dict[str, str], value: float, errors: float = 4) -> bool:
    return abs(parse_number(number["value"]) - value) <= errors * parse_number(number["error"])


def test_pieces_in_order_are_fitted(page: Page) -> None:
    x = motion(1)
    first = page.send(piece(0, 2, T[:200], x[:200]))
    assert (first["type"], first["piece"], first["motion"]) == ("fitted", 1, None)
    told = page.send(piece(1, 2, T[200:], x[200:]))
    assert told["answer"] == 2 and told["refused"] == ""
    numbers = {number["name"]: number for number in told["numbers"]}
    natural = math.hypot(OMEGA, DECAY)
    assert within(numbers["natural frequency"], natural) and numbers["natural frequency"]["unit"] == "rad/s"
    assert within(numbers["damping ratio"], DECAY / natural)
    assert within(numbers["amplitude at the start"], C) and within(numbers["offset"], 0.01)
    assert told["motion"]["columns"][0]["C"] == pytest.approx([C], abs=1e-4)
    assert told["parameters"]["per_mass"]["k"] == pytest.approx(natural**2, rel=1e-3)
    assert told["parameters"]["values"]["v_0"] == pytest.approx(-DECAY * C, abs=2e-3)
    assert "random" in told["sentences"][0] and "not random" not in told["sentences"][0]


def test_means_of_rows_give_the_amplitude_of_the_rows(page: Page) -> None:
    t = np.arange(3000) * 0.04
    x = C * np.exp(-0.02 * t) * np.cos(OMEGA * t)
    means = (column.reshape(-1, 10).mean(axis=1) for column in (t, x))
    told = page.send(piece(0, 1, *means, size=10))
    (column,) = told["motion"]["columns"]
    assert math.hypot(*column["C"], *column["S"]) == pytest.approx(C * math.exp(-0.02 * 0.18), rel=1e-6)


@pytest.mark.parametrize(("derivative", "unit"), [(1, "m/s"), (2, "m/s²")])
def test_a_derivative_gives_the_displacement(page: Page, derivative: int, unit: str) -> None:
    exponent = complex(-DECAY, OMEGA)
    rows = np.real(C * exponent**derivative * np.exp(exponent * T)) + 9.81
    told = page.send(piece(0, 1, T, rows + np.random.default_rng(5).normal(0, 1e-3, T.size), derivative=derivative))
    numbers = {number["name"]: number for number in told["numbers"]}
    assert within(numbers["amplitude at the start"], C) and numbers["amplitude at the start"]["unit"] == "m"
    assert within(numbers["offset"], 9.81) and numbers["offset"]["unit"] == unit
    (column,) = told["motion"]["columns"]
    assert column["C"] == pytest.approx([C], rel=1e-2) and abs(column["S"][0]) < 0.02 * C


def test_a_piece_out_of_order_is_left_out_and_the_needed_one_named(page: Page) -> None:
    x = motion(2)
    assert page.send(piece(1, 2, T[200:], x[200:]))["piece"] == 0
    assert page.send(piece(0, 2, T[:200], x[:200]))["piece"] == 1
    assert page.send(piece(0, 2, T[:200], x[:200]))["piece"] == 1, "a repeated piece begins again"
    assert page.send(piece(3, 4, T[200:], x[200:]))["piece"] == 1
    assert page.send(piece(1, 2, T[200:], x[200:]))["motion"]


@pytest.mark.parametrize(
    ("rows", "reason"),
    [
        (piece(0, 1, [0.0, 1.0], [1.0]), "as many times as displacements"),
        (piece(0, 1, [0.0, 1.0], [1.0, 2.0], [1.0]), "as many times as displacements"),
        (piece(0, 1, [0.0, 2.0, 1.0], [1.0, 1.0, 1.0]), "never decrease"),
        (piece(0, 1, [0.0], [1.0]), "8 or more are needed"),
        (piece(0, 1, [], []), "8 or more are needed"),
        (piece(0, 1, T, np.zeros(T.size)), "never changes"),
        (piece(0, 1, T[:8], motion(4, 0.01)[:8]), "a longer or a quieter record is needed"),
    ],
)
def test_rows_without_a_motion_are_refused_in_words(page: Page, rows: dict[str, Any], reason: str) -> None:
    told = page.send(rows)
    assert told["motion"] is None and reason in told["refused"]


@pytest.mark.parametrize(
    "rows",
    [
        piece(0, 1, np.arange(1251), np.zeros(1251)),
        piece(16, 16, T, T),
        piece(0, 17, T, T),
        piece(0, 1, T, T, size=11),
        piece(0, 1, T, T, derivative=3),
        piece(0, 1, T, 1e300 * T),
        piece(0, 1, [0.0, 1.0], [math.nan, 1.0]),
        piece(0, 1, T),
        piece(0, 1, T, T, T, T),
        {**piece(0, 1, T, T), "columns": [["1"]]},
        {**piece(0, 1, T, T), "name": "my file"},
    ],
)
def test_rows_that_no_page_sends_are_refused(page: Page, rows: dict[str, Any]) -> None:
    told = page.send(rows)
    assert told["type"] == "shown" and "not a message that this page sends" in told["errors"]["message"]


def test_pieces_with_other_columns_than_the_first_are_refused(page: Page) -> None:
    x = motion(6)
    page.send(piece(0, 2, T[:200], x[:200]))
    assert "in the same columns" in page.send(piece(1, 2, T[200:], x[200:], x[200:]))["refused"]


def two_masses(seed: int, noise: float = 1e-4) -> Any:
    """Both displacements of two carts: k1/m1 = 20, k2/m1 = 10, m2/m1 = 0.5."""
    path = FOLDER / "simulated-two-carts.csv"
    t, *columns = np.loadtxt(path.read_text(encoding="utf-8").splitlines()[1:], delimiter=",", unpack=True)
    return t, *(1e-3 * column + np.random.default_rng(seed).normal(0, noise, t.size) for column in columns)


def test_two_columns_give_two_frequencies_and_the_ratios_of_a_chain(page: Page) -> None:
    told = page.send(piece(0, 1, *two_masses(1)))
    numbers = {number["name"]: number for number in told["numbers"]}
    assert within(numbers["k1/m1"], 20) and within(numbers["k2/m1"], 10) and within(numbers["m2/m1"], 0.5)
    assert within(numbers["natural frequency, slow mode"], math.sqrt(10))
    assert within(numbers["natural frequency, fast mode"], math.sqrt(40))
    assert within(numbers["X2/X1, slow mode"], 2) and within(numbers["X2/X1, fast mode"], -1)
    parameters = told["parameters"]
    assert parameters["mass"] == "m1" and parameters["values"]["given_by"] == "values"
    assert parameters["per_mass"]["m2"] == pytest.approx(0.5, rel=0.02)
    assert parameters["values"]["x1_0"] == pytest.approx(0.08, abs=1e-3)
    assert parameters["values"]["x2_0"] == pytest.approx(0.0, abs=1e-3)
    assert any("only ratios" in sentence for sentence in told["sentences"])
    assert any("no dashpots" in sentence for sentence in told["sentences"])


def test_columns_in_the_wrong_order_are_named_and_set_nothing(page: Page) -> None:
    t, left, right = two_masses(2)
    told = page.send(piece(0, 1, t, right, left))
    assert told["motion"] and told["parameters"] is None
    assert "check the order of the columns" in told["sentences"][-1]


def test_rows_are_in_no_picture_and_no_link(page: Page) -> None:
    before = page.session.opening()
    assert page.send(piece(0, 1, T, motion(3)))["motion"]
    assert page.session.opening() == before


def test_noise_is_fitted_with_a_warning(page: Page) -> None:
    told = page.send(piece(0, 1, T, np.random.default_rng(1).normal(0, 1, T.size)))
    assert "the frequency may be wrong" in " ".join(told["sentences"])


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("simulated-dashpot.csv", "The residuals of the fit are random:"),
        ("simulated-air-drag.csv", "The residuals of the fit are not random: large swings lose more than their share"),
    ],
)
def test_the_examples_distinguish_two_frictions(page: Page, name: str, sentence: str) -> None:
    t, x = np.loadtxt((FOLDER / name).read_text(encoding="utf-8").splitlines()[1:], delimiter=",", unpack=True)
    assert page.send(piece(0, 1, t, 1e-3 * x))["sentences"][0].startswith(sentence)


def test_another_motion_is_named_with_its_frequency(page: Page) -> None:
    told = page.send(piece(0, 1, T, motion(7) + 0.004 * np.cos(11.7 * T)))
    assert "something else moves too, most at 11.7 rad/s." in told["sentences"][0]


def test_example_files_are_those_of_the_tool() -> None:
    files = {path.name: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.csv")}
    assert files == EXAMPLES
