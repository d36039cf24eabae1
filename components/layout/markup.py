"""The HTML that a text may contain: words, symbols and formulas. Other HTML is rejected."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from components.quantities.formatting import excerpt

SPACE = "{http://www.w3.org/1998/Math/MathML}"
MATH = {
    *("math", "mrow", "mi", "mo", "mn", "mtext", "mspace", "mstyle", "mpadded", "mphantom", "menclose"),
    *("mfrac", "msqrt", "mroot", "msub", "msup", "msubsup", "munder", "mover", "munderover", "mtable", "mtr", "mtd"),
}
ELEMENTS = {"p", "b", "sub", "span", "a"} | {SPACE + name for name in MATH}
COLOURS = {"m1", "m2", "slow", "fast", "T", "V", "total", "F", "xp", "xc", "k", "mute", "ink"}
CLASSES = {"tint", "n", "v", "up", "dots", "small", "boxed", "whole"} | COLOURS
NAMES = {
    *("display", "displaystyle", "scriptlevel", "mathvariant", "mathcolor", "form", "fence", "stretchy", "separator"),
    *("columnalign", "columnlines", "rowlines", "accent", "accentunder", "notation", "symmetric", "largeop"),
    *("movablelimits", "linebreak", "frame", "data-value"),
}
LENGTHS = {
    *("minsize", "maxsize", "lspace", "rspace", "width", "height", "depth", "voffset", "linethickness"),
    *("rowspacing", "columnspacing"),
}
_WORD = re.compile(r"[\w #.-]{0,100}")
_LENGTH = re.compile(r"([+-]?\d?\d?(\.\d+)?[a-z%]*\s*)+")
_LEADS = re.compile(r"\?scene=\w+")
_DECLARED = re.compile("<[!?]")
"""Matches comments and declarations. They are rejected, because HTML and XML parsers end them at different places."""


def check_markup(html: str) -> None:
    """Raise ValueError, with a reason, for elements and attributes that are not in a short list."""
    strange = _DECLARED.findall(html)
    try:
        tree = ElementTree.fromstring(f"<p>{html}</p>")
    except ElementTree.ParseError:
        raise ValueError(f"“{excerpt(html)}” would not end where it should") from None
    for element in tree.iter():
        strange += [] if element.tag in ELEMENTS else [element.tag.removeprefix(SPACE)]
        strange += [name for name, value in element.attrib.items() if not _may_have(element, name, value)]
    if strange:
        raise ValueError(f"“{excerpt(strange[0])}” is nothing that a text may have")


def _may_have(element: ElementTree.Element, name: str, value: str) -> bool:
    if name == "class":
        return CLASSES.issuperset(value.split())
    if name == "href":
        return element.tag == "a" and _LEADS.fullmatch(value) is not None
    return (name in NAMES and _WORD.fullmatch(value) is not None) or (
        name in LENGTHS and _LENGTH.fullmatch(value) is not None
    )
