"""The faults of `make mutants` can be applied. `make nightly` shows that tests find them."""

from __future__ import annotations

import pytest

from tests.serving.server import ROOT
from tools.faults import MUTANTS, Mutant, broken


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.name)
def test_a_fault_can_be_applied(mutant: Mutant) -> None:
    assert mutant.old not in broken(mutant, ROOT) or mutant.old in mutant.new
    assert all((ROOT / name).exists() for name in mutant.tests.split())


def test_a_missing_pattern_is_an_error() -> None:
    with pytest.raises(ValueError, match=r"gone: 'no such words' occurs 0 times in app\.py"):
        broken(Mutant("gone", "app.py", "no such words", "", "tests"), ROOT)
