"""What goes wrong on the way to an answer: arithmetic is refused in words; the log is told of each kind once."""

from __future__ import annotations

import logging
import math
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from traceback import extract_tb
from typing import Any

import msgspec
import numpy as np

BEYOND = "On the way to this picture a number leaves the range of doubles, about 5e-324 to 1.8e308."
SORRY = "Something went wrong here; everything is as it was."
LINK_LOST = "Something went wrong with this link; its parameters were not used."
MOST_KINDS = 500
"""A log that nobody empties has an end: of so many kinds of fault it tells."""


class Once(logging.Filter):
    """Lets what happens at one place through once; the place is the first argument of a record."""

    def __init__(self) -> None:
        super().__init__()
        self._told: set[object] = set()

    def filter(self, record: logging.LogRecord) -> bool:
        place = record.args[0] if isinstance(record.args, tuple) and record.args else record.msg
        if place in self._told or len(self._told) >= MOST_KINDS:
            return False
        self._told.add(place)
        return True


_log = logging.getLogger(__name__)
_log.addFilter(Once())


@contextmanager
def in_words() -> Iterator[None]:
    """An ArithmeticError, NumPy's too, becomes a ValueError with a sentence for the visitor."""
    try:
        with np.errstate(all="raise", under="ignore"):
            yield
    except ArithmeticError as error:
        _log.warning("%s: refused in words, %s", _place(error), error)
        raise ValueError(BEYOND) from error


def check_sendable(value: Any) -> None:
    """ArithmeticError where a number in nested lists, dicts and structs is not finite: it cannot be sent."""
    left: list[Iterable[Any]] = [[value]]
    numbers: list[float] = []
    columns = [np.empty(0)]
    while left:
        for part in left.pop():
            if isinstance(part, float):
                numbers.append(part)
            elif isinstance(part, str):
                continue
            elif isinstance(part, (list, tuple)):
                left.append(part)
            elif isinstance(part, dict):
                left.append(part.values())
            elif isinstance(part, msgspec.Struct):
                left.append(msgspec.structs.astuple(part))
            elif isinstance(part, np.ndarray):
                columns.append(part)
    if not np.isfinite(np.concatenate(columns)).all():
        raise OverflowError("a column has numbers that are not finite")
    if not all(map(math.isfinite, numbers)):
        raise OverflowError("a number to be sent is not finite")


def report(error: Exception) -> None:
    """Tell the log of an exception that nobody expected, with its traceback."""
    _log.error("%s: a visitor was told that something went wrong", _place(error), exc_info=error)


def _place(error: Exception) -> str:
    """The file and line that raised it."""
    last = extract_tb(error.__traceback__)[-1]
    return f"{last.filename}:{last.lineno}"
