"""The faults of `make mutants` can be applied, and tests that need no browser find all that are held against them."""

from __future__ import annotations

import ast
import subprocess
import sys
from itertools import islice

import pytest

from tests.serving.server import ROOT
from tools.faults import MUTANTS, Mutant, broken
from tools.random_faults import AREAS, KINDS, put, random_sites


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


def test_random_faults_are_the_same_for_one_seed_and_change_one_place() -> None:
    sites = [*islice(random_sites(ROOT, 56), 25)]
    assert sites[:5] == [*islice(random_sites(ROOT, 56), 5)]
    found = [put(ROOT, site) for site in sites]
    assert {one.site.kind for one in found} == set(KINDS)
    assert all(any(one.site.file.startswith(area) for one in found) for area in AREAS)
    for one in found:
        sound = ast.unparse(ast.parse((ROOT / one.site.file).read_text(encoding="utf-8"))).splitlines()
        faulty = ast.unparse(ast.parse(one.text)).splitlines()
        assert sound != faulty and one.old != one.new
        if one.site.kind == "number":
            assert sum(line != other for line, other in zip(sound, faulty, strict=True)) == 1
