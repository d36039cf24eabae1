"""The first view of each scene: each symbol has a name next to it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from html import unescape

import pytest

from components.language.blocks import Block, PlotBlock, StageBlock, TableBlock, WordsBlock
from components.language.text import Forms, Html, Runs
from components.layout.text import rich
from components.layout.views import View, shown_blocks
from components.scene import Picture
from components.scenes import SCENES

NAMED = re.compile(r"[a-z]{3,}(?: \d)?[ ,:(|]+\*([^*]+)\*", re.IGNORECASE)
"""A word, perhaps with a number, and after it the letter of a symbol."""
USUAL = {"t", "e", "π", "g"}
"""Time, two numbers, and the gravity of the earth."""
SCREEN = {"wide", "narrow", "stacked", "hall", "desk", "low"}
"""Conditions of shapes that the browser knows."""


def marked(html: Html) -> str:
    """A sentence of HTML as plain text, with the letter of each symbol between stars and without its index."""
    text = re.sub(r'<mi class="up">.*?</mi>|<sub>.*?</sub>', "", html)
    text = re.sub(r"<msub><mrow>(<mi.*?</mi>)</mrow>.*?</msub>|<msub>(<mi.*?</mi>).*?</msub>", r"\1\2", text)
    text = re.sub(r'<span class="v">(.*?)</span>|<mi[^>]*>(.*?)</mi>', r"*\1\2*", text)
    return " ".join(unescape(re.sub(r"<[^>]+>", "", text)).split())


def drawn(runs: Runs) -> str:
    """A text of a drawing in the same form."""
    signs = {"symbol": "*{}*", "index": "", "value": "", "plain": "{}"}
    return "".join(signs[run.kind].format(run.text) for run in runs)


def said(items: Iterable[Forms], picture: Picture) -> str:
    forms = {**picture.forms, "": ""}
    return marked(" ".join(item.variants.get(forms.get(item.name, ""), "") for item in items))


def texts(block: Block, picture: Picture) -> Iterator[str]:
    """The texts of a block that the picture shows, on any screen."""
    if isinstance(block, WordsBlock):
        yield said(block.items, picture)
    if isinstance(block, TableBlock):
        yield from (said(row, picture) for row in block.rows)
    if isinstance(block, PlotBlock):
        forms = picture.forms
        yield " ".join(marked(term.variants.get(forms.get(term.form, "formula"), "")) for term in block.heading)
        yield from (drawn(one.label) for one in (*block.curves, *block.regions))
        yield from (marked(mark.html) for mark in block.marks)
    if isinstance(block, PlotBlock | StageBlock):
        for shape in block.shapes:
            if all(picture.scalars.get(name, name in SCREEN) for name in shape.show):
                yield drawn(getattr(shape, "words", None) or getattr(shape, "label", ()))


def shown(slug: str) -> tuple[View, list[str]]:
    scene = SCENES[slug]().value
    view = scene.views[0]
    blocks = shown_blocks(type(scene).sheet(), view.slug)
    return view, [text for block in blocks for text in texts(block, scene.picture()) if text]


@pytest.mark.parametrize("slug", SCENES)
def test_each_symbol_of_a_first_view_has_a_name_next_to_it(slug: str) -> None:
    """A sentence names a symbol by the word before it; the word “mass 1” names its letter."""
    view, found = shown(slug)
    controls = [f"{key.label} *{symbol[0]}*" for key in view.keys if (symbol := getattr(key, "symbol", ""))]
    sentences = [marked(rich(view.task)), *controls, *found]
    named = {letter for text in sentences for letter in NAMED.findall(text)} | USUAL
    if any("mass 1" in text for text in sentences):
        named.add("m")
    for text in found:
        before, *letters = re.split(r"\*([^*]+)\*", text, maxsplit=1)
        unnamed = set(re.findall(r"\*([^*]+)\*", text)) - named
        assert not letters or not unnamed or re.search(r"[a-z]{3,}", before, re.IGNORECASE), (text, unnamed, named)
