"""Views of a scene: each shows some parts of its sheet, with a task."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from msgspec.structs import replace

from components.language.blocks import Block, Column, Row
from components.language.messages import ViewTab
from components.layout.sheet import blocks
from components.layout.text import rich
from components.quantities.parameters import AnyParameter, names_of

KEYS = "keys"
"""The entry of `View.names` that means the key controls."""


@dataclass(frozen=True)
class View:
    """A view of a scene: the name on its tab, and a task.

    `keys` are the parameters that the task names: their controls are the first ones in the panel. `names` are the parts
    that the task is about, such as "stage", "plot:x" and "keys"; all of them fit on the first screen of a phone. `word`
    is the name of the view in links, by default the first word of its name.
    """

    name: str
    task: str
    keys: tuple[AnyParameter, ...] = ()
    names: tuple[str, ...] = ("stage",)
    word: str = ""

    @property
    def slug(self) -> str:
        return self.word or re.findall(r"\w+", self.name.lower())[0]

    @property
    def sent(self) -> ViewTab:
        keys = tuple(names_of(self.keys))
        return ViewTab(word=self.slug, name=self.name, task=rich(self.task), keys=keys, names=self.names)


def in_views(block: Block, *views: str) -> Block:
    """Return the block, which is then shown only in these views, each given by its word."""
    return replace(block, views=views)


def check_views(sheet: Block, views: Sequence[View]) -> None:
    """Raise ValueError for a block in an unknown view, and for a view whose task names a part that it does not show."""
    known = {view.slug for view in views}
    for block in blocks(sheet):
        if unknown := set(block.views) - known:
            raise ValueError(f"{block.part or 'A block'} is in {', '.join(unknown)}, which is not a view.")
    for view in views:
        shown = {KEYS, *(block.part for block in shown_blocks(sheet, view.slug))}
        if missing := [name for name in view.names if name not in shown]:
            raise ValueError(f"The view {view.name} does not show {', '.join(missing)}, which its task names.")


def shown_blocks(block: Block, view: str, show: Sequence[str] = ()) -> Iterator[Block]:
    """Yield the blocks that a view shows, or the ones named in `show`; rows and columns themselves are left out."""
    if not show and block.views and view not in block.views:
        return
    if isinstance(block, (Row, Column)):
        for inner in block.blocks:
            yield from shown_blocks(inner, view, show)
    elif not show or block.part in show:
        yield block


def known_parts(sheet: Block, names: Sequence[str]) -> tuple[str, ...]:
    """Return the names that are parts of a sheet."""
    return tuple(name for name in names if name in known) if names and (known := parts(sheet)) else ()


def parts(sheet: Block) -> list[str]:
    """Return the names of the parts of a sheet, each once. The list `show` of a step can contain them."""
    return list(dict.fromkeys(block.part for block in blocks(sheet) if block.part))
