"""Work measured by counting function calls. The count is the same on every machine, unlike a time."""

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any, TypeVar

Result = TypeVar("Result")

PICTURE = 200_000
"""Calls for a picture, which blocks the event loop: about 50 ms of CPU."""
FILE, ABOUT = 1_800_000, 3_000_000
"""Calls for a file of numbers and for "About these numbers" in the worker process: about 1 s at most."""


def counted(work: Callable[[], Result]) -> tuple[Result, int]:
    """Return a function's result and how many functions it called, in Python and in C."""
    calls = 0

    def count(frame: FrameType, event: str, argument: Any) -> None:
        nonlocal calls
        calls += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        return work(), calls
    finally:
        sys.setprofile(before)
