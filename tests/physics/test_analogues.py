"""Nine systems: the table of the lecture, evaluated independently."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.analogues import ANALOGUES, G
from tests.grids import tries

U = 2.0**-53
ROLES = {
    "spring": lambda p: (p["m"], p["k"]),
    "shaft": lambda p: (p["J"], p["k_t"]),
    "pendulum": lambda p: (p["m"] * p["l"] ** 2, p["m"] * p["g"] * p["l"]),
    "rocking": lambda p: (p["m"] * (p["d"] ** 2 + p["r"] ** 2), p["m"] * G * p["d"]),
    "floating": lambda p: (p["m"], p["rho"] * G * p["A"]),
    "circuit": lambda p: (p["L"], 1 / p["C"]),
    "string": lambda p: (4e-4 * p["L"] / 2, (p["n"] * math.pi) ** 2 * p["T"] / (2 * p["L"])),
    "wave": lambda p: (p["rho"] * p["wavelength"] / (4 * math.pi), p["rho"] * p["g"] / 2),
    "pipe": lambda p: (1.2 * AREA * p["L"] / 2, 1.2 * AREA * p["c"] ** 2 * (p["n"] * math.pi) ** 2 / (2 * p["L"])),
}
"""Inertia and stiffness by the table of the lecture."""
AREA = 1e-3
systems = pytest.mark.parametrize("slug", ANALOGUES)


def values(parameter):
    if parameter.whole:
        return st.integers(1, 20)
    return st.builds(math.ldexp, st.floats(0.5, 1.0), st.integers(-100, 100))


@systems
def test_roles_and_frequency_follow_the_table(slug):
    system = ANALOGUES[slug]

    @settings(max_examples=tries(100))
    @given(st.fixed_dictionaries({parameter.name: values(parameter) for parameter in system.parameters}))
    def check(p):
        tuned, (inertia, stiffness) = system.at(p), ROLES[slug](p)
        assert tuned.omega_n == pytest.approx(math.sqrt(stiffness / inertia), rel=8 * U)
        assert tuned.inertia == pytest.approx(inertia, rel=8 * U)
        assert tuned.stiffness == pytest.approx(stiffness, rel=8 * U)

    check()
    tuned, start = system.at(system.defaults), 3 * system.swing
    assert tuned.energy(start) == pytest.approx(tuned.stiffness * start**2 / 2, rel=4 * U)
    if system.length_of is None:
        assert tuned.exact_energy(start) == tuned.energy(start)


def test_pendulums_know_their_exact_motion():
    assert ANALOGUES["spring"].at({"m": 1, "k": 1}).pendulum is None
    simple = ANALOGUES["pendulum"].at({"l": 2.0, "g": 1.6, "m": 1}).pendulum
    assert (simple.l, simple.g) == (2.0, 1.6)
    rocking = ANALOGUES["rocking"].at({"m": 2, "d": 0.3, "r": 0.2})
    assert rocking.pendulum.omega_0 == pytest.approx(rocking.omega_n, rel=2 * U)


@pytest.mark.parametrize(
    ("words", "call"),
    [
        ("k_t = 0", lambda: ANALOGUES["shaft"].at({"J": 1.0, "k_t": 0})),
        (r"n = 1\.5.*whole", lambda: ANALOGUES["string"].at({"L": 1.0, "T": 1.0, "n": 1.5})),
        (r"role of m.*range of doubles", lambda: ANALOGUES["pendulum"].at({"l": 1e300, "g": 9.81, "m": 1.0}).inertia),
        (
            r"Simple pendulum: the role of m = 1\.000e-600 leaves the range of doubles",
            lambda: ANALOGUES["pendulum"].at({"l": 1e-300, "g": 9.81, "m": 1.0}).inertia,
        ),
        (r"energy.*range of doubles", lambda: ANALOGUES["spring"].at({"m": 1.0, "k": 40.0}).energy(1e300)),
        ("q_0 = nan", lambda: ANALOGUES["spring"].at({"m": 1.0, "k": 40.0}).energy(math.nan)),
    ],
)
def test_what_is_not_possible_is_refused_by_name(words, call):
    with pytest.raises(ValueError, match=words):
        call()


def test_nothing_overflows_on_the_way():
    assert ANALOGUES["circuit"].at({"L": 1e-300, "C": 1e300}).omega_n == pytest.approx(1.0, rel=4 * U)
    assert ANALOGUES["pendulum"].at({"l": 1e300, "g": 1e300, "m": 1e300}).omega_n == 1.0


@pytest.mark.parametrize("angle", [0.0, 1e-200, -1e-9, 1.0, 3.0])
def test_energy_of_a_pendulum_is_what_it_was_lifted(angle):
    pendulum = ANALOGUES["pendulum"].at({"l": 2.0, "g": 8.0, "m": 3.0})
    lifted = 48.0 * 2 * math.sin(angle / 2) ** 2
    assert pendulum.exact_energy(angle) == pytest.approx(lifted, rel=8 * U)
