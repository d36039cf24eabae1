"""The recorded cases of tests/reference/ and the families of chains, as parameters of tests."""

import json
from pathlib import Path

import pytest

from physics.coupled import TwoMassChain
from tests.physics.chain_families import FAMILIES

CASES = json.loads((Path(__file__).parents[1] / "reference" / "two_mass_cases.json").read_text())["cases"]
each_case = pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case['id']}-{case['family']}")
each_family = pytest.mark.parametrize("family", FAMILIES.values(), ids=FAMILIES)


def chain_of(case):
    """The chain of a recorded case."""
    return TwoMassChain(**{name: float.fromhex(value) for name, value in case["hex"].items()})


def chain_with(parameters):
    """The chain with (m1, m2, k1, k2), as a family draws them."""
    return TwoMassChain(**dict(zip(("m1", "m2", "k1", "k2"), parameters, strict=True)))
