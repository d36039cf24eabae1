"""Nine systems: the table of the lecture, evaluated independently."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.analogues import ANALOGUES, G
from tests.grids import tries

U = 2.0**-53
STRING_DENSITY, AIR = 4e-4, 1.2
OMEGA_SQUARED = {
    "spring": lambda p: p["k"] / p["m"],
    "shaft": lambda p: p["k_t"] / p["J"],
    "pendulum": lambda p: p["g"] / p["l"],
    "rocking": lambda p: G * p["d"] / (p["d"] ** 2 + p["r"] ** 2),
    "floating": lambda p: p["rho"] * G * p["A"] / p["m"],
    "circuit": lambda p: 1 / (p["L"] * p["C"]),
    "string": lambda p: (p["n"] * math.pi / p["L"]) ** 2 * p["T"] / STRING_DENSITY,
    "wave": lambda p: p["g"] * 2 * math.pi / p["wavelength"],
    "pipe": lambda p: (p["n"] * math.pi * p["c"] / p["L"]) ** 2,
}
systems = pytest.mark.parametrize("slug", ANALOGUES)


def values(parameter):
    if parameter.whole:
        return st.integers(1, 20)
    return st.builds(math.ldexp, st.floats(0.5, 1.0), st.integers(-100, 100))


@systems
def test_frequency_follows_the_table(slug):
    system = ANALOGUES[slug]

    @settings(max_examples=tries(100))
    @given(st.fixed_dictionaries({parameter.name: values(parameter) for parameter in system.parameters}))
    def check(p):
        tuned, true = system.at(p), math.sqrt(OMEGA_SQUARED[slug](p))
        assert tuned.omega_n == pytest.approx(true, rel=8 * U)
        assert math.sqrt(tuned.stiffness / tuned.inertia) == pytest.approx(true, rel=8 * U)

    check()


@pytest.mark.parametrize(
    ("slug", "p", "omega", "inertia", "stiffness"),
    [
        ("spring", {"m": 2, "k": 8}, 2, 2, 8),
        ("shaft", {"J": 0.5, "k_t": 8}, 4, 0.5, 8),
        ("pendulum", {"l": 2, "g": 8, "m": 3}, 2, 12, 48),
        ("circuit", {"L": 0.25, "C": 1}, 2, 0.25, 1),
        ("rocking", {"m": 2, "d": 3, "r": 4}, math.sqrt(3 * 9.81 / 25), 50, 6 * 9.81),
        ("floating", {"m": 1000, "A": 1, "rho": 1000}, math.sqrt(9.81), 1000, 9810),
        ("string", {"L": 0.5, "T": 64, "n": 2}, 4 * math.pi * 400, 1e-4, 256 * math.pi**2),
        ("wave", {"wavelength": 2 * math.pi, "g": 9, "rho": 1000}, 3, 500, 4500),
        ("pipe", {"L": 0.5, "c": 340, "n": 1}, 680 * math.pi, 3e-4, 1.2e-3 * 340**2 * math.pi**2),
    ],
)
def test_book_values(slug, p, omega, inertia, stiffness):
    tuned = ANALOGUES[slug].at(p)
    assert tuned.omega_n == pytest.approx(omega, rel=4 * U)
    assert tuned.inertia == pytest.approx(inertia, rel=4 * U)
    assert tuned.stiffness == pytest.approx(stiffness, rel=4 * U)


def test_pendulums_know_their_exact_motion():
    assert ANALOGUES["spring"].at({"m": 1, "k": 1}).pendulum is None
    simple = ANALOGUES["pendulum"].at({"l": 2.0, "g": 1.6, "m": 1}).pendulum
    assert (simple.l, simple.g) == (2.0, 1.6)
    rocking = ANALOGUES["rocking"].at({"m": 2, "d": 0.3, "r": 0.2})
    assert rocking.pendulum.omega_0 == pytest.approx(rocking.omega_n, rel=2 * U)


def test_bad_parameters_are_refused_by_name():
    with pytest.raises(ValueError, match="k_t = 0"):
        ANALOGUES["shaft"].at({"J": 1.0, "k_t": 0})
    with pytest.raises(ValueError, match=r"n = 1\.5.*whole"):
        ANALOGUES["string"].at({"L": 1.0, "T": 1.0, "n": 1.5})
    with pytest.raises(ValueError, match=r"role of m.*range of doubles"):
        assert ANALOGUES["pendulum"].at({"l": 1e300, "g": 9.81, "m": 1.0}).inertia


def test_nothing_overflows_on_the_way():
    assert ANALOGUES["circuit"].at({"L": 1e-300, "C": 1e300}).omega_n == pytest.approx(1.0, rel=4 * U)
    assert ANALOGUES["pendulum"].at({"l": 1e300, "g": 1e300, "m": 1e300}).omega_n == 1.0


@systems
def test_energy_is_that_of_the_stretched_spring(slug):
    system = ANALOGUES[slug]
    start = 3 * system.swing
    tuned = system.at(system.defaults)
    assert tuned.energy(start) == pytest.approx(tuned.stiffness * start**2 / 2, rel=4 * U)
    if system.length_of is None:
        assert tuned.exact_energy(start) == tuned.energy(start)


@pytest.mark.parametrize("angle", [0.0, 1e-200, -1e-9, 1.0, 3.0])
def test_energy_of_a_pendulum_is_what_it_was_lifted(angle):
    pendulum = ANALOGUES["pendulum"].at({"l": 2.0, "g": 8.0, "m": 3.0})
    lifted = 48.0 * 2 * math.sin(angle / 2) ** 2
    assert pendulum.exact_energy(angle) == pytest.approx(lifted, rel=8 * U)


def test_energy_out_of_range_is_refused():
    with pytest.raises(ValueError, match=r"energy.*range of doubles"):
        ANALOGUES["spring"].at({"m": 1.0, "k": 40.0}).energy(1e300)
    with pytest.raises(ValueError, match="q_0 = nan"):
        ANALOGUES["spring"].at({"m": 1.0, "k": 40.0}).energy(math.nan)


def test_a_role_too_small_for_a_double_is_refused_by_its_name():
    with pytest.raises(ValueError, match=r"Simple pendulum: the role of m = 1\.000e-600 leaves the range of doubles"):
        assert ANALOGUES["pendulum"].at({"l": 1e-300, "g": 9.81, "m": 1.0}).inertia
