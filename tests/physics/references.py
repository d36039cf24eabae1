"""Reference cases: inputs in doubles, results as strings of 25 digits."""

import json
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from tests.grids import sample

FOLDER = Path(__file__).parents[1] / "reference"


@cache
def reference(file: str, part: str = "cases") -> list[dict[str, Any]]:
    """Return the cases of a part of a file."""
    found: list[dict[str, Any]] = json.loads((FOLDER / f"{file}_cases.json").read_text())[part]
    return found


def each(cases: list[dict[str, Any]]) -> pytest.MarkDecorator:
    """Parametrize a test by `case`: each second one, or all in whole grids."""
    return pytest.mark.parametrize("case", sample(cases), ids=lambda case: str(case["id"]))
