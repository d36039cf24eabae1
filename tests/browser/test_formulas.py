"""Formulas look the same in all engines, measured by their dark pixels."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.browser.engines import Window
from tests.browser.fixtures import READY
from tests.browser.ink import SIZE, Ink
from tests.serving.server import Server

pytestmark = [pytest.mark.browser, pytest.mark.slow]
DERIVATIVES = (r"\dot{x}", r"\ddot{x}", r"\dot{\theta}", r"\ddot{x}_1")

LARGER = f"""["mtext", "mi"].map(
  name => parseFloat(getComputedStyle(document.querySelector(name)).fontSize) / {SIZE}
)"""


@pytest.fixture
def shown(engine: Window, server: Server) -> Window:
    engine.goto(f"{server.url}?scene=energy")
    engine.wait_for_function(READY)
    return engine


@pytest.mark.parametrize("latex", DERIVATIVES)
def test_the_dots_of_a_derivative_are_close_above_its_letter(shown: Window, latex: str, tmp_path: Path) -> None:
    [gap] = Ink(shown, latex, tmp_path / "formula.png").gaps(axis=1)
    assert 0.05 * SIZE < gap < 0.25 * SIZE


@pytest.mark.parametrize("sign", "-+")
def test_a_frequency_and_its_sign_are_one_symbol(shown: Window, sign: str, tmp_path: Path) -> None:
    inside, after, _ = Ink(shown, rf"\omega_{sign} = 1", tmp_path / "formula.png").gaps(axis=0)
    assert inside < 0.15 * SIZE < 0.4 * SIZE < after < 0.55 * SIZE


def test_words_in_a_formula_are_as_large_as_the_text_around_it(shown: Window, tmp_path: Path) -> None:
    """The letters of the formula itself are larger, because those of its font are small."""
    Ink(shown, r"\text{slow} = x", tmp_path / "formula.png")
    assert shown.evaluate(LARGER) == pytest.approx([1.05, 1.13], abs=0.005)
