"""Texts of a sheet as HTML with the numbers of a picture, for pages that have no script to fill them in."""

from __future__ import annotations

import re
from collections.abc import Mapping

from components.language.blocks import TableBlock, WordsBlock
from components.language.plots import Term
from components.language.text import Html
from components.layout.text import rich
from components.quantities.formatting import MINUS
from components.quantities.motion import starts
from components.scene.picture import Picture

SAMPLES = {"sum": "━━", "line": "──", "dash": "╌╌", "band": "██", "none": ""}
_LIVE = re.compile(r'(<(span|mn) class="n" data-value="(\w+)">)(?=</\2>)')


def filled(html: Html, picture: Picture) -> Html:
    """Return a text with its live numbers; moving ones have their initial values."""
    begun = starts(picture.signals, picture.scalars) if picture.live else {}
    moving = {
        name: f"{begun[name]:{'+' if digits.signed else ''}.{digits.decimals}f}".replace("-", MINUS)
        for name, digits in picture.live.items()
    }
    return _LIVE.sub(lambda found: found[1] + (picture.values | moving).get(found[3], ""), html)


def words(block: WordsBlock, forms: Mapping[str, str]) -> Html:
    """Return the sentences of a block that a picture shows."""
    return "".join(f"<p>{item.variants.get(forms.get(item.name, ''), '')}</p>" for item in block.items)


def heading(terms: tuple[Term, ...], forms: Mapping[str, str]) -> Html:
    """Return the heading of a plot: its formula, with a sample of each line."""
    texts = [(term, term.variants.get(forms.get(term.form, "formula"), "")) for term in terms]
    return " ".join(f'<span class="sample {one.tint}">{SAMPLES[one.key]}</span> {text}' for one, text in texts if text)


def table(block: TableBlock, forms: Mapping[str, str]) -> Html:
    """Return a table without its empty rows."""
    body = [[cell.variants.get(forms.get(cell.name, ""), "") for cell in row] for row in block.rows]
    rows = [f"<td>{'</td><td>'.join(row)}</td>" for row in (list(block.head), *body) if any(row)]
    return f"<table><tr>{'</tr><tr>'.join(rows)}</tr></table>"


def notes(picture: Picture) -> Html:
    """Return the notes of a picture."""
    still = ("Numbers that move are those at *t* = 0.",) if picture.live else ()
    return rich(" ".join((*still, *picture.notes)))
