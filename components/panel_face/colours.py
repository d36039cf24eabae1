"""The colours of the page, for figures on white."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np

TOKENS = Path(__file__).parents[2] / "static" / "styles" / "tokens.css"
SHADES = 101


@cache
def colours() -> dict[str, str]:
    """The colours of the page by name, on white."""
    light, _, _ = TOKENS.read_text(encoding="utf-8").partition('[data-theme="dark"]')
    return dict(re.findall(r"--(\w+): (#[0-9a-f]{6});", light))


def diverging() -> list[str]:
    """Return colours from the tint m2 through white to the tint m1."""
    hues = [np.array([int(colours()[tint][i : i + 2], 16) for i in (1, 3, 5)]) for tint in ("m2", "m1")]
    shares = np.linspace(-1.0, 1.0, SHADES)
    mixed = [255 + abs(share) ** 0.7 * (hues[int(share > 0)] - 255) for share in shares]
    return ["#" + "".join(f"{round(part):02x}" for part in colour) for colour in mixed]
