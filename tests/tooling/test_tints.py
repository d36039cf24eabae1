"""Tints: each has a light and a dark colour that is readable on paper and panel, and a class."""

from __future__ import annotations

import re

import pytest

from tests.serving.server import ROOT

TOKENS = (ROOT / "static" / "styles" / "tokens.css").read_text(encoding="utf-8")
FILLS = {"k1fill", "k2fill"}
"""Areas without text."""
TINTS = set(re.findall(r"^  \.(\w+) \{\n    --c: var\(--\1\);", TOKENS, re.M))
THEMES = {
    theme: dict(re.findall(r"--(\w+): (#\w{6});", TOKENS.partition(f"color-scheme: {theme};")[2].partition("\n}")[0]))
    for theme in ("light", "dark")
}


def luminance(colour: str) -> float:
    """Return the relative luminance of a colour by WCAG 2.2."""
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    red, green, blue = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("tint", sorted(TINTS - FILLS))
def test_a_tint_is_readable_on_paper_and_panel(tint: str, theme: str) -> None:
    colours = THEMES[theme]
    for ground in ("paper", "panel"):
        dark, light = sorted((luminance(colours[tint]), luminance(colours[ground])))
        assert (light + 0.05) / (dark + 0.05) >= 4.5, ground


def test_three_masses_have_a_tint_each() -> None:
    assert {"m1", "m2", "m3"} <= TINTS
    for colours in THEMES.values():
        assert len({colours[name] for name in ("m1", "m2", "m3")}) == 3
