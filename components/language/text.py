"""Texts: sentences as HTML, and the short texts of a drawing, which SVG sets, as runs."""

from __future__ import annotations

from typing import Literal, TypeAlias

from msgspec import Struct

Html: TypeAlias = str
"""HTML made by components.layout.text from the texts of this project; live numbers are elements with `data-value`."""


class TextRun(Struct, frozen=True):
    """A piece of a text in a drawing: plain, the symbol of a quantity, its index, or the live number of that name."""

    kind: Literal["plain", "symbol", "index", "value"]
    text: str


Runs: TypeAlias = tuple[TextRun, ...]


class Forms(Struct, frozen=True):
    """A sentence in several forms: the picture's form called `name` chooses the variant, "" for no sentence.

    If `name` is empty, the variant "" is always visible.
    """

    variants: dict[str, Html]
    name: str = ""
