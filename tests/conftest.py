"""What all tests share."""

from collections.abc import Iterator

import numpy as np
import pytest

pytest_plugins = ["tests.fixtures_browser"]


@pytest.fixture(autouse=True)
def floating_point_errors_raise() -> Iterator[None]:
    """An overflow, an invalid operation or a division by zero is a defect even where its result is not used."""
    with np.errstate(all="raise", under="ignore"):
        yield
