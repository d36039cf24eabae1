"""Refusals: arithmetic errors become sentences for the visitor, and each kind is logged once."""

from __future__ import annotations

import logging
import math
import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from traceback import extract_tb
from typing import Any

import msgspec
import numpy as np

from physics.valid import DOUBLES

BEYOND = f"A number that this picture needs lies outside {DOUBLES}."
SORRY = "Something went wrong on the server; nothing was changed."
LINK_LOST = "Something went wrong with this link; its parameters were not used."
_GREEK = {"omega": "ω", "tau": "τ", "theta": "θ", "delta": "δ", "pi": "π"}
_BELOW = str.maketrans("pnst0123456789+-", "ₚₙₛₜ₀₁₂₃₄₅₆₇₈₉₊₋")
_SYMBOL = re.compile(rf"(?<![\w“:.])({'|'.join(_GREEK)}|[A-Za-z])(p\d?|\d|_[pn\d+-]|_st)?(_0)?(?![A-Za-z0-9_”:])")
"""Matches names of parameters, except in quotation marks and before a colon, where a text means the name in a link."""
MOST_KINDS = 500
"""Maximum number of kinds of error that are logged, so that the log stays finite."""


class Once(logging.Filter):
    """A log filter that passes only the first record from each line of code, which is the record's first argument."""

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
    """Turn an ArithmeticError, including NumPy's, into a ValueError with a sentence for the visitor."""
    try:
        with np.errstate(all="raise", under="ignore"):
            yield
    except ArithmeticError as error:
        _log.warning("%s: refused in words, %s", _place(error), error)
        raise ValueError(BEYOND) from error


def as_on_screen(text: str) -> str:
    """Return an error's text with the symbols of the sliders: omega_n becomes ωₙ."""
    return _SYMBOL.sub(_symbol, text).replace("sqrt(", "√(").replace("^2", "²")


def _symbol(found: re.Match[str]) -> str:
    letter, below, start = found.groups(default="")
    if letter not in _GREEK and not below:
        return found[0]
    return _GREEK.get(letter, letter) + below.lstrip("_").translate(_BELOW) + ("(0)" if start else "")


def check_sendable(value: Any) -> None:
    """Raise ArithmeticError if a number in nested lists, dicts and structs is not finite, because it cannot be sent."""
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
    """Log an unexpected exception with its traceback."""
    _log.error("%s: a visitor was told that something went wrong", _place(error), exc_info=error)


def _place(error: Exception) -> str:
    """Return the file and line that raised an exception."""
    last = extract_tb(error.__traceback__)[-1]
    return f"{last.filename}:{last.lineno}"
