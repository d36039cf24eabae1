"""The faults of `make mutants` can be applied, and tests that need no browser find all that are held against them."""

from __future__ import annotations

import subprocess
import sys

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


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_each_fault_of_the_register_that_needs_no_browser_is_found() -> None:
    """It runs in another process, whose forks have imported no module of the project."""
    names = [one.name for one in MUTANTS if "tests/browser" not in one.tests]
    command = [sys.executable, "-m", "tools.mutants", *names]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert f"{len(names)} of {len(names)} faults of the register are found" in done.stdout, done.stdout + done.stderr
