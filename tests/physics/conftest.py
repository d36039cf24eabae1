"""Tests of physics compute in mpmath with so many bits, or with the `BITS` of their module."""

from collections.abc import Iterator

import mpmath as mp
import pytest

from tests.physics.truth import WORKING_BITS


@pytest.fixture(autouse=True)
def many_digits(request: pytest.FixtureRequest) -> Iterator[None]:
    with mp.workprec(getattr(request.module, "BITS", WORKING_BITS)):
        yield
