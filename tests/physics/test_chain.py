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
from physics.reference.uniform_chain import chain_frequencies, chain_points
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


@given(st.integers(1, 24), st.sampled_from(ENDS))
def test_shapes_are_orthonormal_and_swing_by_themselves(N: int, ends: Any) -> None:
    chain = UniformChain(N=N, m=1.0, k=1.0, ends=ends)
    shapes, omega = chain.shapes, chain.omega
    assert shapes @ shapes.T == pytest.approx(np.eye(N), abs=1e-14)
    K = 2 * np.eye(N) - np.eye(N, k=1) - np.eye(N, k=-1)
    K[-1, -1] -= ends != "fixed-fixed"
    K[0, 0] -= ends == "free-free"
    assert pytest.approx(shapes.T * omega**2, abs=1e-13) == K @ shapes.T
    assert np.all(np.diff(omega) > 0) and chain.omega == pytest.approx(2 * np.sin(chain.theta / 2), abs=1e-15)
    assert np.all(chain.string_omega >= omega) and chain.string_omega == pytest.approx(chain.theta)


def test_a_pulse_runs_to_the_right_alone() -> None:
    chain = UniformChain(N=200, m=1.0, k=1.0)
    x, v = chain.pulse(60.0, 6.0, 0.2)
    moved = chain.motion(x, v, [40.0]).x[:, 0]
    assert moved.argmax() == pytest.approx(99, abs=1) and np.abs(moved[:60]).max() < 1e-3


@pytest.mark.parametrize("ends", ENDS)
@pytest.mark.parametrize("N", [1, 2, 9, 300])
def test_mirror_images_give_the_sum_of_modes(N: int, ends: Any) -> None:
    chain, rng, t = UniformChain(N=N, m=0.3, k=7.0, ends=ends), np.random.default_rng(N), [0.0, 0.4, 11.0]
    x_0, v_0 = rng.normal(size=N), rng.normal(size=N)
    x = chain.motion(x_0, v_0, t).x
    for p, points in chain_points(chain, x_0, v_0, t, range(1, N + 1, 1 + N // 10)).items():
        for point, found in zip(points, x[p - 1].tolist(), strict=True):
            assert abs(found - float(point.value)) <= 2 * U * float(point.size)
    assert [float(one.value) for one in chain_frequencies(chain, range(1, N + 1))] == chain.omega.tolist()
