"""The visible sentences of a scene, and random parameters with which they must be true."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from html import unescape
from typing import Any

from components.layout.sheet import in_force
from components.layout.views import shown_blocks
from components.scene import Scene

TAG, LIVE = re.compile(r"<[^>]+>"), re.compile(r'<(\w+)[^>]*data-value="(\w+)"[^>]*></\1>')


def sentences(scene: Scene) -> list[str]:
    """Return the visible sentences of a scene, with live numbers filled in and formulas as plain text."""
    shown = set(map(id, shown_blocks(scene.sheet(), scene.values.get("view", ""))))
    seen = (block for block in in_force(scene.sheet(), scene.shown.forms) if id(block) in shown)
    return [text for block in seen for text in _texts(scene, block)]


def visible_text(scene: Scene) -> str:
    """Return the visible sentences of a scene as one text."""
    return "\n".join(sentences(scene))


def read(scene: Scene, html: str) -> str:
    """The words of a text, with the numbers of the picture."""
    words = TAG.sub("", LIVE.sub(lambda live: scene.shown.values.get(live[2], ""), html))
    return unescape(words).replace("\N{NO-BREAK SPACE}", " ")


def _texts(scene: Scene, block: Any) -> Iterator[str]:
    for item in getattr(block, "items", ()):
        html = item.variants.get(scene.shown.forms.get(item.name, "") if item.name else "")
        if html:
            yield read(scene, html)


class Draw:
    """Random parameters, the same in every run: numbers over decades, and sometimes none."""

    def __init__(self, seed: str) -> None:
        self.pick = random.Random(seed)

    def size(self, low: float = -2.0, high: float = 2.0) -> float:
        return float(f"{10 ** self.pick.uniform(low, high):.4g}")

    def number(self, low: float = -2.0, high: float = 2.0) -> float:
        return self.pick.choice((-1, 1)) * self.size(low, high)

    def some(self, value: float, none: float = 0.2) -> float:
        """The value, or 0 in a share of all draws."""
        return 0.0 if self.pick.random() < none else value
