"""N equal masses: frequencies, shapes and motions against 25 digits, images and conserved quantities."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.chain import UniformChain
from tests.grids import tries
from tests.physics.references import each, reference
from tests.physics.truth import log_uniform

U = 2.0**-53
ENDS = ("fixed-fixed", "fixed-free", "free-free")
starts = st.lists(st.floats(-1, 1), min_size=24, max_size=24)


def chain_of(case: dict[str, Any]) -> UniformChain:
    return UniformChain(N=case["N"], m=case["m"], k=case["k"], ends=case["ends"])


def error(value: float, true: str) -> float:
    with mp.workdps(30):
        return float(abs(mp.mpf(float(value)) - mp.mpf(true)))


@each([case for case in reference("beyond", "chain") if case["ends"] in ENDS])
def test_modes_and_motions_are_those_of_the_reference(case: dict[str, Any]) -> None:
    chain = chain_of(case)
    energies = chain.modes(case["x_0"], case["v_0"]).energy
    for j, omega, shape, energy in zip(case["modes"], case["omega"], case["shapes"], case["E_modes"], strict=True):
        i = j if case["ends"] == "free-free" else j - 1
        assert error(chain.omega[i], omega) <= U * float(omega)
        for p, value in zip(case["beads"], shape, strict=True):
            assert error(chain.shapes[i, p - 1], value) <= U * abs(float(value))
        assert error(energies[i], energy) <= 4 * U * float(case["E"])
    motion = chain.motion(case["x_0"], case["v_0"], case["t"])
    for values, name, sizes in ((motion.x, "x", case["size"][0]), (motion.v, "v", case["size"][1])):
        for n in range(len(case["t"])):
            for i, p in enumerate(case["beads"]):
                assert error(values[p - 1, n], case[name][n][i]) <= 4 * U * sizes[n][i] + 5e-324
    if pluck := case.get("pluck"):
        x = chain.pluck(pluck["s"], pluck["h"])
        assert x[pluck["s"] - 1] == pluck["h"]
        modes = chain.modes(x, np.zeros(chain.N))
        found = [modes.amplitude[j - 1] * chain.shapes[j - 1, 0] / math.sin(chain.theta[j - 1]) for j in case["modes"]]
        assert np.abs(found) == pytest.approx([abs(float(B)) for B in pluck["B"]], rel=1e-9, abs=1e-12)


@settings(max_examples=tries(120))
@given(st.integers(1, 24), log_uniform(-400, 400), log_uniform(-400, 400), st.sampled_from(ENDS), starts, starts)
def test_over_all_decades_the_modes_have_all_the_energy_and_start_from_the_start(
    N: int, m: float, k: float, ends: Any, x_0: list[float], v_0: list[float]
) -> None:
    chain = UniformChain(N=N, m=m, k=k, ends=ends)
    Omega = math.sqrt(k) / math.sqrt(m)
    x, v = np.array(x_0[:N]), Omega * np.array(v_0[:N])
    motion = chain.motion(x, v, [0.0, 3.0 / Omega])
    assert np.abs(motion.x[:, 0] - x).max() <= 2 * U * np.abs(x).max() + 1e-300
    modes = chain.modes(x, v)
    walls = {"fixed-fixed": [0.0, *x, 0.0], "fixed-free": [0.0, *x], "free-free": list(x)}[ends]
    energy = (np.sum(v * v) / Omega**2 + np.sum(np.diff(walls) ** 2)) / 2
    assert np.sum(modes.energy / k) == pytest.approx(energy, rel=1e-13, abs=1e-300)
    back = chain.motion(motion.x[:, 1], -motion.v[:, 1], [3.0 / Omega])
    assert np.abs(back.x[:, 0] - x).max() <= 1e-13 * (np.abs(x).max() + np.abs(v).max() / Omega) * N + 1e-300
    if ends == "free-free":
        assert np.sum(motion.v[:, 1]) == pytest.approx(np.sum(v), abs=1e-14 * N * np.abs(v).max() + 1e-300)
        assert modes.drift == pytest.approx((np.mean(x), np.mean(v)), rel=1e-9, abs=1e-15 * (1 + Omega))
