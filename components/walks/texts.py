"""Formulas of a walk's file, which comes from anybody: what they become is MathML and nothing else."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from xml.etree import ElementTree

from components.numbers import excerpt
from components.page.text import Html
from components.text import mathml

FORMULA = re.compile(r"\$([^$]+)\$")
LIVE = re.compile(r"(?<!_)(?<!\\val)\{(\w+)\}")
LIVE_IN_FORMULA = re.compile(r"\\val\{(\w+)\}")
SPACE = "{http://www.w3.org/1998/Math/MathML}"
ELEMENTS = {
    *("math", "mrow", "mi", "mo", "mn", "mtext", "mspace", "mstyle", "mpadded", "mphantom", "menclose"),
    *("mfrac", "msqrt", "mroot", "msub", "msup", "msubsup", "munder", "mover", "munderover", "mtable", "mtr", "mtd"),
}
ATTRIBUTES = {
    *("class", "data-value", "display", "displaystyle", "scriptlevel", "mathvariant", "mathcolor", "form", "fence"),
    *("stretchy", "minsize", "maxsize", "lspace", "rspace", "width", "height", "depth", "voffset", "linethickness"),
    *("columnalign", "columnlines", "rowlines", "rowspacing", "columnspacing", "accent", "accentunder", "notation"),
    *("separator", "symmetric", "largeop", "movablelimits", "linebreak", "frame"),
}


def check_formula(latex: str) -> None:
    """ValueError, in words, for what is no formula, or would be more than one."""
    try:
        tree = ElementTree.fromstring(mathml(latex))
    except Exception as error:  # whatever the converter, made for formulas that are right, stumbles over
        raise ValueError(f"“{excerpt(latex)}” cannot be set as a formula") from error
    for element in tree.iter():
        name = element.tag.removeprefix(SPACE)
        strange = [name] if name not in ELEMENTS else sorted(element.attrib.keys() - ATTRIBUTES)
        if strange:
            raise ValueError(f"“{excerpt(latex)}” has “{excerpt(strange[0])}”, which no formula of a walk may have")


def check_formulas(text: str) -> None:
    """The same for every formula of a sentence."""
    for latex in FORMULA.findall(text):
        check_formula(latex)


_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\S", re.DOTALL)
_OPEN = {"{", "(", "[", r"\{", r"\left", r"\begin"}
_CLOSE = {"}", ")", "]", r"\}", r"\right", r"\end"}
_WIDE = {r"\quad", r"\qquad"}
_ARROW = {r"\Rightarrow", r"\Leftrightarrow"}
_EQUAL = {"=", r"\approx"}
_WHOLE = re.compile(r"\\(over|atop|choose|color|(display|text|script)style)\b")
"""What acts on all that follows it, or on what stands before it."""


def pieces(latex: str) -> list[str]:
    """A formula in the pieces between which its line may end. They make the formula again when they are joined."""
    starts = [] if _WHOLE.search(latex) else _starts(latex)
    return [latex[start:end] for start, end in pairwise([0, *starts, len(latex)])]


def _starts(latex: str) -> Iterator[int]:
    """After a wide space, at an arrow, at words, at the second sign of equality: where it is in no bracket."""
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
    """A formula whose line may end between its pieces."""
    return "".join(map(mathml, pieces(latex)))


def live_names(text: str) -> Iterator[str]:
    """The live numbers that a sentence speaks of."""
    yield from LIVE_IN_FORMULA.findall(text)
    yield from LIVE.findall(FORMULA.sub("", text))
