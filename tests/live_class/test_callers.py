"""The clients of other tests: what one that fails leaves to those after it."""

from __future__ import annotations

import gc

import pytest

from tests.live_class.caller import Class
from tests.live_class.served import teaching


async def test_a_test_that_fails_leaves_no_stream() -> None:
    """An unclosed stream is a warning, and so an error, of whichever test collects the garbage."""
    with pytest.raises(TimeoutError):
        async with teaching() as (_, url):
            lesson = await Class.open(url)
            for _ in range(3):
                await lesson.follow()
            raise TimeoutError
    gc.collect()
