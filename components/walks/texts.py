"""Formulas of a walk's file, and where the line of a long one may end."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from components.language.text import Html
from components.layout.text import mathml

FORMULA = re.compile(r"\$([^$]+)\$")
LIVE = re.compile(r"(?<!_)(?<!\\val)\{(\w+)\}")
LIVE_IN_FORMULA = re.compile(r"\\val\{(\w+)\}")
_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\S", re.DOTALL)
_OPEN = {"{", "(", "[", r"\{", r"\left", r"\begin"}
_CLOSE = {"}", ")", "]", r"\}", r"\right", r"\end"}
_WIDE = {r"\quad", r"\qquad"}
_ARROW = {r"\Rightarrow", r"\Leftrightarrow"}
_EQUAL = {"=", r"\approx"}
_WHOLE = re.compile(r"\\(over|atop|choose|color|(display|text|script)style)\b")
"""Commands of LaTeX that apply to everything after them, or to the symbol before them."""


def pieces(latex: str) -> list[str]:
    """Return the parts of a formula between which a line may break. Joined, they are the formula."""
    starts = [] if _WHOLE.search(latex) else _starts(latex)
    return [latex[start:end] for start, end in pairwise([0, *starts, len(latex)])]


def _starts(latex: str) -> Iterator[int]:
    """Places where a line may break, outside brackets: after a wide space, at an arrow, at words, at the second equals
    sign."""
    depth, last, gap, equal = 0, "", False, False
    for match in _TOKEN.finditer(latex):
        token = match[0]
        if depth == 0 and token in _WIDE | {r"\;"}:
            gap = gap or token in _WIDE or last == ","
        elif depth == 0 and last:
            words = latex.startswith(r"\text{ ", match.start())
            if gap or words or token in _ARROW or (equal and token in _EQUAL):
                yield match.start()
                equal = False
            gap = False
        depth += (token in _OPEN) - (token in _CLOSE)
        equal = equal or (depth == 0 and token in _EQUAL)
        last = token


def line(latex: str) -> Html:
    """Return a formula that may break between its pieces."""
    return "".join(map(mathml, pieces(latex)))


def live_names(text: str) -> Iterator[str]:
    """Return the names of the live numbers in a sentence."""
    yield from LIVE_IN_FORMULA.findall(text)
    yield from LIVE.findall(FORMULA.sub("", text))
