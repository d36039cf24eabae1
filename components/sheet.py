"""What stands where on the paper: rows and columns of blocks, as plain data for the browser.

A block is a dict with a `kind`; `grow` and `basis` say how it shares the height (in a column) or the width (in a
row), `phone` is its place from top to bottom on a narrow screen and `height` its height there.
"""

from __future__ import annotations

from typing import Any

from components.equations import mathml, rich

Block = dict[str, Any]


def row(*blocks: Block, grow: float = 1, basis: int = 0, gap: int = 24) -> Block:
    return {"kind": "row", "blocks": list(blocks), "grow": grow, "basis": basis, "gap": gap}


def column(*blocks: Block, grow: float = 1, basis: int = 0, gap: int = 0) -> Block:
    return {"kind": "column", "blocks": list(blocks), "grow": grow, "basis": basis, "gap": gap}


def stage(
    *shapes: dict[str, Any], label: str, grow: float = 1, basis: int = 0, phone: int = 0, height: int = 180
) -> Block:
    """The picture. `label` describes it to those who do not see it."""
    return {
        "kind": "stage",
        "shapes": list(shapes),
        "label": label,
        "grow": grow,
        "basis": basis,
        "phone": phone,
        "height": height,
    }


def words(
    *paragraphs: str | dict[str, str], style: str = "facts", grow: float = 0, basis: int = 0, phone: int = 50
) -> Block:
    """Sentences and formulas. A dict holds several forms by name; the picture's `forms` choose one ('' hides it).

    A paragraph is text for `rich`, or a dict {"form": name, variant: text, ...}.
    """
    items = [_item(paragraph) for paragraph in paragraphs]
    return {"kind": "words", "items": items, "style": style, "grow": grow, "basis": basis, "phone": phone}


def table(
    *rows: list[str | dict[str, str]],
    head: list[str] | None = None,
    grow: float = 0,
    basis: int = 0,
    phone: int = 50,
    style: str = "",
) -> Block:
    """Rows of cells, each a paragraph as in `words`; the first cell of a row is its name. `style` may be tight."""
    cells = [[_item(cell) for cell in line] for line in rows]
    heads = [rich(text) for text in head or []]
    return {"kind": "table", "head": heads, "rows": cells, "style": style, "grow": grow, "basis": basis, "phone": phone}


def _item(paragraph: str | dict[str, str]) -> dict[str, str]:
    if isinstance(paragraph, str):
        return {"": rich(paragraph)}
    return {key: text if key == "form" else rich(text) for key, text in paragraph.items()}


def when(form: str, block: Block) -> Block:
    """The block, standing only while the picture has a form of that name: how a scene has several views."""
    return {**block, "show": form}


def choice(
    name: str, options: dict[str, str], label: str, grow: float = 0, basis: int = 34, phone: int = 50, style: str = ""
) -> Block:
    """A joined segment of two to four options that sets the Selector parameter `name`.

    With the style "views" it stands right of the headline and switches the views of the scene.
    """
    pairs = [{"value": value, "label": text} for value, text in options.items()]
    return {
        "kind": "choice",
        "name": name,
        "options": pairs,
        "label": label,
        "style": style,
        "grow": grow,
        "basis": basis,
        "phone": phone,
    }


def term(curve: str = "", key: str = "line", tint: str = "ink", **forms: str) -> dict[str, Any]:
    """One term of a plot's heading: the formula of a curve, its line sample and its switch.

    `key` is sum, line, dash, band or none. Forms are LaTeX by variant; a single form is called `formula`.
    """
    return {"curve": curve, "key": key, "tint": tint, "forms": {k: mathml(v) if v else "" for k, v in forms.items()}}


def phrase(curve: str = "", key: str = "line", tint: str = "ink", **forms: str) -> dict[str, Any]:
    """The same with words, as for `rich`, in place of formulas."""
    return {"curve": curve, "key": key, "tint": tint, "forms": {k: rich(v) if v else "" for k, v in forms.items()}}
