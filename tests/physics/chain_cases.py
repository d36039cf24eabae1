"""The recorded cases of tests/reference/ and the families of chains, as parameters of tests."""

import json
import math
from pathlib import Path

import pytest
from hypothesis import strategies as st

from physics.coupled import TwoMassChain
from tests.physics.chain_families import FAMILIES

CASES = json.loads((Path(__file__).parents[1] / "reference" / "two_mass_cases.json").read_text())["cases"]
each_case = pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case['id']}-{case['family']}")
each_family = pytest.mark.parametrize("family", FAMILIES.values(), ids=FAMILIES)


def chain_of(case):
    """The chain of a recorded case."""
    return TwoMassChain(**{name: float.fromhex(value) for name, value in case["hex"].items()})


def chain_with(parameters):
    """A strategy for chains whose (m1, m2, k1, k2) are drawn from a family."""
    return TwoMassChain(**dict(zip(("m1", "m2", "k1", "k2"), parameters, strict=True)))


def law_of(chain, c, F_0, omega):
    """The equations of motion of a chain with one damper between its masses, driven at the first."""

    def law(t, y):
        x1, x2, v1, v2 = y
        link = chain.k2 * (x2 - x1) + c * (v2 - v1)
        return [v1, v2, (-chain.k1 * x1 + link + F_0 * math.sin(omega * t)) / chain.m1, -link / chain.m2]

    return law


def log_uniform(low, high):
    """A strategy for doubles between two powers of two; all octaves are equally likely."""
    return st.builds(math.ldexp, st.floats(0.5, 1.0, exclude_max=True), st.integers(low + 1, high))
