"""Grids of values: walked whole by `make test-all`, a sample of each by `make test`."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TypeVar

Value = TypeVar("Value")
WHOLE = os.environ.get("GRIDS") == "whole"


def tries(count: int) -> int:
    """The number of random examples that are drawn, of so many."""
    return count if WHOLE else count // 4 + 1


def sample(values: Sequence[Value], every: int = 2) -> Sequence[Value]:
    """Each value, or the first and every so many after it."""
    return values if WHOLE else values[::every]
