"""The faults of `make mutants` can be applied. `make nightly` shows that tests find them."""

from __future__ import annotations

import ast
from itertools import islice

import pytest

from tests.serving.server import ROOT
from tools.faults import MUTANTS, Mutant, broken
from tools.random_faults import put, random_sites


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.name)
def test_a_fault_can_be_applied(mutant: Mutant) -> None:
    assert mutant.old not in broken(mutant, ROOT) or mutant.old in mutant.new
    assert all((ROOT / name).exists() for name in mutant.tests.split())


def test_a_random_fault_changes_what_is_executed() -> None:
    for fault in (put(ROOT, site) for site in islice(random_sites(ROOT, 56), 5)):
        assert ast.dump(ast.parse(fault.text)) != ast.dump(ast.parse((ROOT / fault.site.file).read_text("utf-8")))
