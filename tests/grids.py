"""Grids of values: a sample for `make test`, those between for `make rest`, or walked whole by `make test-all`."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TypeVar

import pytest

Value = TypeVar("Value")
WHOLE = os.environ.get("GRIDS") == "whole"


def tries(count: int) -> int:
    """The number of random examples that are drawn, of so many."""
    return count if WHOLE else count // 4 + 1


def sample(values: Sequence[Value], every: int = 2) -> Sequence[Value]:
    """Each value, or the first and every so many after it."""
    return values if WHOLE else values[::every]


def spread(values: Sequence[Value], every: int = 3) -> list[object]:
    """Parameters of a test: the first and every so many after it for `make test`, those between for `make rest`."""
    return [pytest.param(value, marks=[pytest.mark.slow] if i % every else []) for i, value in enumerate(values)]
