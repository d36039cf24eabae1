"""The chain with dashpots parallel to both springs, compared with an integrator, 60 digits and known results."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from physics.absorber import damped_amplitude, damped_solution
from physics.coupled import TwoMassChain
from physics.damped_chain import DampedChain
from physics.reference.damped_chain import braked_exponents, braked_points
from physics.transient import DampedModes

PLAIN = TwoMassChain(m1=2, m2=1, k1=4, k2=2)
START, SPEED = (1.0, -0.3), (0.2, 0.1)
CASES = [
    (PLAIN, 0.4, 0.2),
    (PLAIN, 0.4, 0.0),
    (PLAIN, 0.0, 0.2),
    (PLAIN, 5.0, 0.1),
    (PLAIN, 0.1, 30.0),
    (TwoMassChain(m1=2, m2=1, k1=0, k2=2), 0.3, 0.1),
    (TwoMassChain(m1=2, m2=1, k1=3, k2=0), 0.3, 0.5),
    (TwoMassChain(m1=2, m2=1, k1=3, k2=0), 0.3, 0.0),
    (TwoMassChain(m1=2, m2=1, k1=0, k2=0), 0.3, 0.5),
    (TwoMassChain(m1=400, m2=225, k1=625, k2=144), 0.0, 216.0),
]
EXTREME = [(c1, c2) for c1 in (0.0, 1e-12, 1.0, 1e12) for c2 in (0.0, 1e-12, 1.0, 1e12) if c1 or c2]


def modes(chain: TwoMassChain, c1: float, c2: float, F_0: float = 1.0, omega: float = 0.9) -> DampedModes:
    return DampedModes(chain=chain, c=c2, c1=c1, F_0=F_0, omega=omega, x_0=START, v_0=SPEED)


@pytest.mark.parametrize(("chain", "c1", "c2"), CASES)
def test_the_motion_is_that_of_an_integrator(chain: TwoMassChain, c1: float, c2: float) -> None:
    one, t = modes(chain, c1, c2), np.linspace(0, 20, 21)

    def rates(t: float, y: np.ndarray) -> list[float]:
        x1, x2, v1, v2 = y
        link = chain.k2 * (x2 - x1) + c2 * (v2 - v1)
        return [v1, v2, (-chain.k1 * x1 - c1 * v1 + link + math.sin(0.9 * t)) / chain.m1, -link / chain.m2]

    found = solve_ivp(rates, (0, 20), [*START, *SPEED], "DOP853", t, rtol=1e-12, atol=1e-13).y
    motion = one.motion(t)
    np.testing.assert_allclose([*motion.x, *motion.v], found, atol=1e-9)
    x, v = one.drawn(t)
    np.testing.assert_allclose([*x[:2], *v[:2]], [*motion.x, *motion.v], atol=1e-11)
    np.testing.assert_allclose(x[2], motion.e[1], atol=1e-11)


@pytest.mark.parametrize("size", [1e-30, 1e-110, 1e-130, 1e-250])
def test_the_hardly_damped_die_as_slowly_as_the_shapes_say(size: float) -> None:
    """To first order a mode decays at the power of its shape in the dashpots divided by twice its energy."""
    found = DampedChain.of(PLAIN, 3 * size, size).free_motions.modes
    rates = [(3 * 1 + 1) / (2 * 6), (3 * 1 + 4) / (2 * 3)]  # shapes (1, 2) and (1, -1)
    assert [one.exponents[0].real for one in found] == pytest.approx([-size * rate for rate in rates], rel=1e-14)
    transient = sorted((one.exponent for one in modes(PLAIN, 3 * size, size).transient), key=abs)
    assert [one.real for one in transient] == pytest.approx([-size * rate for rate in rates], rel=1e-14)
    told = sorted(braked_exponents(PLAIN, 3 * size, size), key=lambda pair: pair[1].value)
    assert [float(re.value) for re, _ in told] == pytest.approx([-size * rate for rate in rates], rel=1e-14)
    turned = [one.shape[1] / one.shape[0] for one in found]
    assert all(0 < abs(ratio.imag) < 10 * size for ratio in turned), "not in line"


def test_no_motion_with_dashpots_grows_over_all_decades() -> None:
    pick = random.Random("braked")
    for _ in range(40):
        m1, m2, k1, k2, c1, c2 = (10 ** pick.uniform(-100, 100) for _ in range(6))
        free = pick.choice(("", "k1", "c1", "c2"))
        chain = TwoMassChain(m1=m1, m2=m2, k1=0.0 if free == "k1" else k1, k2=k2)
        c1, c2 = 0.0 if free == "c1" else c1, 0.0 if free == "c2" else c2
        exponents = [s for one in DampedChain.of(chain, c1, c2).free_motions.modes for s in one.exponents]
        assert all(s.real <= 0 for s in exponents)
        true = braked_exponents(chain, c1, c2)
        assert sorted(s.real for s in exponents) == pytest.approx(sorted(float(re.value) for re, _ in true), rel=1e-15)


@pytest.mark.parametrize(("c1", "c2"), EXTREME)
def test_the_motion_is_within_4_u_of_the_amplitude_for_any_dashpots(c1: float, c2: float) -> None:
    t = [0.001, 0.7, 3.0]
    one = modes(PLAIN, c1, c2, omega=1.0)  # at the slow natural frequency
    for x, points in zip(one.motion(t).x, braked_points(one, t).values(), strict=True):
        for value, true in zip(x.tolist(), points, strict=True):
            assert abs(value - float(true.value)) <= 4 * 2.0**-53 * max(float(true.size), abs(value))


def test_both_shapes_are_those_without_dashpots_where_c1_k2_is_c2_k1() -> None:
    """LECTURE-BEYOND 3.4: zeta 0.05 and 0.1, whatever the masses zeta_j = (c/k) omega_j/2."""
    for chain in (PLAIN, TwoMassChain(m1=0.7, m2=3, k1=4, k2=2)):
        one = modes(chain, 0.4, 0.2, F_0=0.0)
        natural = chain.modes()
        for term in one.transient:
            rows, omega_n = term.amplitudes[0], abs(term.exponent)
            j = int(np.argmin(abs(natural.omega - omega_n)))
            assert omega_n == pytest.approx(natural.omega[j], rel=1e-14)
            assert -term.exponent.real / omega_n == pytest.approx(0.1 * omega_n / 2, rel=1e-12)
            assert complex(rows[1] / rows[0]) == pytest.approx(natural.ratio[j], rel=1e-12)


@pytest.mark.parametrize("omega", [0.3, 1.0, 1.4142135623730951, 2.0, 7.0])
@pytest.mark.parametrize(("c1", "c2"), [(0.4, 0.2), (1e-9, 0.0), (0.0, 1e9), (3.0, 1e-3)])
def test_the_steady_swing_obeys_newtons_laws(c1: float, c2: float, omega: float) -> None:
    X1, X2 = (complex(X) for X in damped_solution(PLAIN, c2, 1.0, omega, c1))
    link = (2 + 1j * omega * c2) * (X1 - X2)
    sizes = abs(4 * X1) + abs(2 * omega**2 * X1) + abs(omega * c1 * X1) + abs(2 + 1j * omega * c2) * (abs(X1) + abs(X2))
    assert abs((4 + 1j * omega * c1 - 2 * omega**2) * X1 + link - 1) < 1e-15 * (sizes + 1)
    assert abs(-link - omega**2 * X2) < 1e-15 * (sizes + 1)
    sizes_alone = damped_amplitude(PLAIN, c2, 1.0, [omega], c1)[:, 0]
    assert sizes_alone == pytest.approx([abs(X1), abs(X2)], rel=1e-15)
