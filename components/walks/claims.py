"""Numbers in the texts of a step that differ from the numbers that are shown with its answer."""

from __future__ import annotations

import re
from collections.abc import Iterator

from components.quantities.formatting import excerpt, parse_number, three
from components.scene import Scene
from components.walks.subject import Subject
from components.walks.texts import FORMULA
from components.walks.types import BaseStep

SAME = 0.006
"""The relative difference below which two numbers with three digits count as equal."""
_SAID = re.compile(r"(?P<symbol>[^\s=(]+) = (?P<number>[-−+]?\d+(?:\.\d+)?)")


def untrue(step: BaseStep, subject: Subject) -> Iterator[str]:
    """Return a sentence for each number in headline or explanation that differs from the quantity's value in the
    picture of the answer.
    """
    known = _by_symbol(subject.answered.scene)
    for field in ("title", "explain"):
        for said in _SAID.finditer(FORMULA.sub("", getattr(step, field)).replace("*", "")):
            value, number = known.get(said["symbol"]), parse_number(said["number"])
            if value is not None and abs(value - number) > SAME * abs(number):
                yield f"{field}: “{excerpt(said[0])}” is not what is shown with the answer, {three(value)}: see reveal."


def _by_symbol(scene: Scene) -> dict[str, float]:
    """Return the numbers of a scene in SI by the symbols of their quantities."""
    own = {getattr(one, "symbol", ""): scene.values[name] for name, one in type(scene).linked().items()}
    told = {one.symbol: one.value for one in scene.readouts()}
    return {symbol: value for symbol, value in (own | told).items() if symbol and isinstance(value, float)}
