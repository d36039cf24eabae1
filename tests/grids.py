"""Grids of values: a sample for `make test` and `make rest`, all of them for `make test-all` and `make nightly`."""

import os
from collections.abc import Sequence
from typing import TypeVar

Value = TypeVar("Value")
WHOLE = os.environ.get("GRIDS") == "whole"


def tries(count: int) -> int:
    """Return how many random examples to draw out of `count`."""
    return count if WHOLE else count // 4 + 1


def sample(values: Sequence[Value], every: int = 2) -> Sequence[Value]:
    """Return every value, or the first and each `every`-th after it."""
    return values if WHOLE else values[::every]
