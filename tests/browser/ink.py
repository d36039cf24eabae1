"""Positions of the dark pixels of a formula on a page, independent of the boxes that an engine reports."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
from PIL import Image

from components.layout.text import mathml
from tests.browser.engines import Window

SIZE = 80  # px of the text
SET = f"""formula => {{
  document.body.innerHTML = `<div style="padding: 100px; font-size: {SIZE}px">${{formula}}</div>`
  return document.fonts.ready.then(() => new Promise(drawn => requestAnimationFrame(() => setTimeout(drawn, 100))))
}}"""


class Ink:
    """The dark pixels of one formula, in the lecture's style."""

    def __init__(self, window: Window, latex: str, path: Path) -> None:
        window.evaluate(SET, mathml(latex))
        window.screenshot(path=path)
        self._dark = np.asarray(Image.open(path).convert("L")) < 128

    def gaps(self, axis: int) -> list[int]:
        """The gaps between parts, in px: above each other (axis 1) or next to each other (axis 0)."""
        return [start - end for (_, end), (start, _) in pairwise(self.parts(axis))]

    def parts(self, axis: int) -> list[tuple[int, int]]:
        """The first and last pixel of each part."""
        edges = np.flatnonzero(np.diff(self._dark.any(axis=axis).astype(int))) + 1
        return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))
