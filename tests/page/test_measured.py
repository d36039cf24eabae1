"""Measured rows: pieces in order, the fit after the last one, and refusals."""

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike

from components.quantities.formatting import parse_number
from components.scenes import SCENES
from tests.page.headless_page import Page
from tests.serving.server import ROOT

T = np.arange(300) * 0.04
OMEGA, DECAY, C = 6.3, 0.12, 0.05


def motion(seed: int, noise: float = 1e-4) -> Any:
    swing = C * np.exp(-DECAY * T) * np.cos(OMEGA * T) + 0.01
    return swing + np.random.default_rng(seed).normal(0, noise, T.size)


def piece(number: int, of: int, t: ArrayLike, *columns: ArrayLike, **more: Any) -> dict[str, Any]:
    rows = {"t": np.asarray(t).tolist(), "columns": [np.asarray(column).tolist() for column in columns]}
    return {"type": "rows", "piece": number, "of": of, "number": number + 1, **rows, **more}


def example(name: str) -> Any:
    """The columns of an example file: times in s, displacements in m."""
    t, *columns = np.loadtxt(ROOT / "static" / "measured" / name, delimiter=",", skiprows=1, unpack=True)
    return t, *(1e-3 * column for column in columns)


@pytest.fixture
def page() -> Page:
    return Page(SCENES["damped"]())


def check_numbers(told: dict[str, Any], expected: dict[str, float]) -> None:
    """The numbers of a fit are within four of their errors of the true ones."""
    found = {one["name"]: one for one in told["numbers"]}
    for name, value in expected.items():
        assert abs(parse_number(found[name]["value"]) - value) <= 4 * parse_number(found[name]["error"]), name


def test_pieces_in_order_are_fitted(page: Page) -> None:
    x, before = motion(1), page.session.opening()
    assert page.send(piece(1, 2, T[200:], x[200:]))["piece"] == 0, "a piece out of order is left out"
    for _ in range(2):
        told = page.send(piece(0, 2, T[:200], x[:200]))
        assert (told["type"], told["piece"], told["motion"]) == ("fitted", 1, None), "a repeated piece begins again"
    assert page.send(piece(3, 4, T[200:], x[200:]))["piece"] == 1
    told = page.send(piece(1, 2, T[200:], x[200:]))
    assert told["answer"] == 2 and told["refused"] == ""
    natural = math.hypot(OMEGA, DECAY)
    numbers = {"natural frequency": natural, "damping ratio": DECAY / natural, "amplitude at the start": C}
    check_numbers(told, {**numbers, "offset": 0.01})
    assert told["motion"]["columns"][0]["C"] == pytest.approx([C], abs=1e-4)
    assert told["parameters"]["per_mass"]["k"] == pytest.approx(natural**2, rel=1e-3)
    assert told["parameters"]["values"]["v_0"] == pytest.approx(-DECAY * C, abs=2e-3)
    assert told["sentences"][0].startswith("The residuals of the fit are random:")
    assert page.session.opening() == before, "rows are in no picture and no link"


@pytest.mark.parametrize(("derivative", "unit"), [(1, "m/s"), (2, "m/s²")])
def test_a_derivative_gives_the_displacement(page: Page, derivative: int, unit: str) -> None:
    exponent = complex(-DECAY, OMEGA)
    rows = np.real(C * exponent**derivative * np.exp(exponent * T)) + 9.81
    told = page.send(piece(0, 1, T, rows + np.random.default_rng(5).normal(0, 1e-3, T.size), derivative=derivative))
    check_numbers(told, {"amplitude at the start": C, "offset": 9.81})
    units = {"amplitude at the start": "m", "offset": unit, "natural frequency": "rad/s"}
    assert units.items() <= {one["name"]: one["unit"] for one in told["numbers"]}.items()
    (column,) = told["motion"]["columns"]
    assert column["C"] == pytest.approx([C], rel=1e-2) and abs(column["S"][0]) < 0.02 * C


NO_MESSAGE = "not a message that this page sends"
REFUSED: list[tuple[dict[str, Any], str]] = [
    (piece(0, 1, [0.0, 1.0], [1.0]), "as many times as displacements"),
    (piece(0, 1, [0.0, 1.0], [1.0, 2.0], [1.0]), "as many times as displacements"),
    (piece(0, 1, [0.0, 2.0, 1.0], [1.0, 1.0, 1.0]), "never decrease"),
    (piece(0, 1, [], []), "8 or more are needed"),
    (piece(0, 1, T, np.zeros(T.size)), "never changes"),
    (piece(0, 1, T[:8], motion(4, 0.01)[:8]), "a longer or a quieter record is needed"),
    (piece(0, 1, np.arange(1251), np.zeros(1251)), NO_MESSAGE),
    *((piece(*number, T, T), NO_MESSAGE) for number in ((16, 16), (0, 17))),
    *((piece(0, 1, T, T, **more), NO_MESSAGE) for more in ({"size": 11}, {"derivative": 3}, {"columns": [["1"]]})),
    *((piece(0, 1, T, *columns), NO_MESSAGE) for columns in ([1e300 * T], [[1.0, math.nan]], [], [T, T, T, T])),
]


@pytest.mark.parametrize(("rows", "reason"), REFUSED)
def test_rows_without_a_motion_are_refused_in_words(page: Page, rows: dict[str, Any], reason: str) -> None:
    told = page.send(rows)
    assert told["type"] == ("shown" if reason == NO_MESSAGE else "fitted") and told.get("motion") is None
    assert reason in (told["errors"]["message"] if reason == NO_MESSAGE else told["refused"])
    page.send(piece(0, 2, T, T))
    assert "in the same columns" in page.send(piece(1, 2, T, T, T))["refused"]


def test_two_columns_give_two_frequencies_and_the_ratios_of_a_chain(page: Page) -> None:
    """Both displacements of two carts: k1/m1 = 20, k2/m1 = 10, m2/m1 = 0.5. In the wrong order they set nothing."""
    t, *carts = example("simulated-two-carts.csv")
    left, right = (cart + np.random.default_rng(1).normal(0, 1e-4, t.size) for cart in carts)
    told = page.send(piece(0, 1, t, left, right))
    check_numbers(told, {"k1/m1": 20, "k2/m1": 10, "m2/m1": 0.5, "X2/X1, slow mode": 2, "X2/X1, fast mode": -1})
    check_numbers(told, {f"natural frequency, {mode} mode": omega**0.5 for mode, omega in (("slow", 10), ("fast", 40))})
    parameters = told["parameters"]
    assert (parameters["mass"], parameters["values"]["given_by"]) == ("m1", "values")
    assert parameters["per_mass"]["m2"] == pytest.approx(0.5, rel=0.02)
    assert [parameters["values"][name] for name in ("x1_0", "x2_0")] == pytest.approx([0.08, 0.0], abs=1e-3)
    assert all(any(words in one for one in told["sentences"]) for words in ("only ratios", "no dashpots"))
    told = page.send(piece(0, 1, t, right, left))
    assert told["motion"] and told["parameters"] is None
    assert "check the order of the columns" in told["sentences"][-1]


@pytest.mark.parametrize(
    ("rows", "sentence"),
    [
        (example("simulated-dashpot.csv"), "The residuals of the fit are random:"),
        (example("simulated-air-drag.csv"), "not random: large swings lose more than their share"),
        ((T, motion(7) + 0.004 * np.cos(11.7 * T)), "something else moves too, most at 11.7 rad/s."),
        ((T, np.random.default_rng(1).normal(0, 1, T.size)), "the frequency may be wrong"),
    ],
)
def test_what_the_residuals_say(page: Page, rows: Any, sentence: str) -> None:
    assert sentence in " ".join(page.send(piece(0, 1, *rows))["sentences"])
