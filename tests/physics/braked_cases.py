"""Chains with dashpots for tests, and their free motions as eigenvectors with 120 digits or more."""

import math
from dataclasses import asdict
from typing import Any, NamedTuple

import mpmath as mp
from hypothesis import strategies as st

from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain
from tests.physics.truth import reference

CASES = reference("poles")
BRAKED = [case for case in CASES if case["c1"] or case["c2"]]
DIGITS = 120


class Case(NamedTuple):
    """A chain and its dashpots, at least one of which is not 0."""

    chain: TwoMassChain
    c1: float
    c2: float

    @property
    def damped(self) -> DampedChain:
        return DampedChain.of(*self)

    @property
    def values(self) -> dict[str, float]:
        return {**asdict(self.chain), "c1": self.c1, "c2": self.c2}


def case_of(values: dict[str, Any]) -> Case:
    chain = TwoMassChain(**{name: values[name] for name in ("m1", "m2", "k1", "k2")})
    return Case(chain, values["c1"], values["c2"])


def sizes(low: float = -3.0, high: float = 3.0) -> st.SearchStrategy[float]:
    """Numbers with three digits, over several decades."""
    return st.floats(low, high).map(lambda power: float(f"{10**power:.3g}"))


def _or_none(one: st.SearchStrategy[float]) -> st.SearchStrategy[float]:
    return one | one | one | st.just(0.0)


@st.composite
def _any_case(draw: Any) -> Case:
    m1, m2, k1, k2, c1, c2 = (draw(one) for one in (sizes(), sizes(), *(_or_none(sizes()) for _ in range(4))))
    return Case(TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2), c1, c2 if c1 or c2 else 1.0)


@st.composite
def _proportional(draw: Any) -> Case:
    """c1 k2 = c2 k1; most of these numbers are no doubles."""
    m1, m2 = draw(sizes(-1, 1)), draw(sizes(-1, 1))
    parts, factor, unit = draw(st.tuples(st.integers(1, 9), st.integers(1, 9))), draw(st.integers(1, 400)), 0.1
    k1, k2 = (round(part * unit, 12) for part in parts)
    c1, c2 = (round(part * factor * unit / 100, 12) for part in parts)
    return Case(TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2), c1, c2)


@st.composite
def _on_the_ray(draw: Any) -> Case:
    """One dashpot, and an exceptional point at some size of it: k2 m1 = k1 m2 and c2 = 0."""
    m1, k1, share = draw(st.integers(1, 9)), draw(st.integers(1, 9)), draw(st.integers(1, 9))
    chain = TwoMassChain(m1=m1, m2=m1 * share, k1=k1, k2=k1 * share)
    return Case(chain, draw(sizes(-1, 2)), 0.0)


def cases() -> st.SearchStrategy[Case]:
    """Any chain with dashpots, the exceptional ones as often as others."""
    return _any_case() | _proportional() | _on_the_ray() | st.sampled_from([case_of(one) for one in BRAKED])


def matrices(case: Case) -> tuple[mp.matrix, mp.matrix, mp.matrix]:
    """M, C and K."""
    m1, m2, k1, k2 = (mp.mpf(getattr(case.chain, name)) for name in ("m1", "m2", "k1", "k2"))
    c1, c2 = mp.mpf(case.c1), mp.mpf(case.c2)
    stiff, damping = ([[one + two, -two], [-two, two]] for one, two in ((k1, k2), (c1, c2)))
    return mp.matrix([[m1, 0], [0, m2]]), mp.matrix(damping), mp.matrix(stiff)


def eigenvectors(case: Case) -> list[tuple[Any, Any, Any]]:
    """s, X1, X2 of each root that is not 0, from the state (x1, x2, v1, v2); the larger part of a shape is 1."""
    weakest = min(c for c in (case.c1, case.c2) if c)
    with mp.workdps(DIGITS + 2 * max(0, -round(math.log10(weakest)))):  # its effect has as many digits as the others
        M, C, K = matrices(case)
        A = mp.zeros(4)
        for i in range(2):
            A[i, i + 2] = 1
            for j in range(2):
                A[i + 2, j], A[i + 2, j + 2] = -K[i, j] / M[i, i], -C[i, j] / M[i, i]
        values, vectors = mp.eig(A)
        largest, found = max(map(abs, values)), []
        for j, s in enumerate(values):
            one, two = vectors[0, j], vectors[1, j]
            over = one if abs(one) > abs(two) else two
            if abs(s) > mp.mpf(10) ** -40 * largest:
                found.append((s, one / over, two / over))
        return found
