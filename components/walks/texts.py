"""Formulas of a walk's file, which comes from anybody: what they become is MathML and nothing else."""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree import ElementTree

from components.numbers import excerpt
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


def live_names(text: str) -> Iterator[str]:
    """The live numbers that a sentence speaks of."""
    yield from LIVE_IN_FORMULA.findall(text)
    yield from LIVE.findall(FORMULA.sub("", text))
