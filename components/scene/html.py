"""Texts of a sheet as HTML with the numbers of a picture filled in, for pages without our scripts (Panel)."""

from __future__ import annotations

import re
from collections.abc import Mapping

from components.language.blocks import TableBlock, WordsBlock
from components.language.plots import Term
from components.language.text import Html
from components.layout.text import rich
from components.quantities.formatting import MINUS
from components.scene.picture import Picture

SAMPLES = {"sum": "━━", "line": "──", "dash": "╌╌", "band": "██", "none": ""}
_LIVE = re.compile(r'(<(span|mn) class="n" data-value="(\w+)">)(?=</\2>)')


def live_texts(picture: Picture, named: Mapping[str, float]) -> dict[str, str]:
    """Return the texts of all live numbers by name; `named` are the signals at the displayed time."""
    moving = {
        name: f"{named[name]:{'+' if digits.signed else ''}.{digits.decimals}f}".replace("-", MINUS)
        for name, digits in picture.live.items()
    }
    return picture.values | moving


def filled(html: Html, texts: Mapping[str, str]) -> Html:
    """Return a text with its live numbers."""
    return _LIVE.sub(lambda found: found[1] + texts.get(found[3], ""), html)


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
    return rich(" ".join(filter(None, (picture.to_scale, *picture.notes))))
