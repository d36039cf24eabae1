"""The families of chains, as parameters and strategies of tests."""

import math

import pytest
from hypothesis import strategies as st

from physics.coupled import TwoMassChain
from tests.physics.chain_families import FAMILIES

each_family = pytest.mark.parametrize("family", FAMILIES.values(), ids=FAMILIES)


def chain_with(parameters):
    """A strategy for chains whose (m1, m2, k1, k2) are drawn from a family."""
    return TwoMassChain(**dict(zip(("m1", "m2", "k1", "k2"), parameters, strict=True)))


def log_uniform(low, high):
    """A strategy for doubles between two powers of two; all octaves are equally likely."""
    return st.builds(math.ldexp, st.floats(0.5, 1.0, exclude_max=True), st.integers(low + 1, high))
