"""The clients of other tests: what one that fails leaves to those after it."""

from __future__ import annotations

import gc

import pytest

from components.serving.server import Server
from tests.live_class.caller import Class
from tests.live_class.served import run


def test_a_test_that_fails_leaves_no_stream() -> None:
    """An unclosed stream is a warning, and so an error, of whichever test collects the garbage."""

    async def test(server: Server, url: str) -> None:
        lesson = await Class.open(url)
        for _ in range(3):
            await lesson.follow()
        raise TimeoutError

    with pytest.raises(TimeoutError):
        run(test)
    gc.collect()
