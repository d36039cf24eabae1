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
@settings(max_examples=tries(100))
@given(data=st.data())
def test_roles_frequency_and_energy_follow_the_table(slug, data):
    system = ANALOGUES[slug]
    p = {parameter.name: data.draw(values(parameter)) for parameter in system.parameters}
    tuned, (inertia, stiffness) = system.at(p), ROLES[slug](p)
    assert tuned.omega_n == pytest.approx(math.sqrt(stiffness / inertia), rel=8 * U, abs=0)
    assert tuned.inertia == pytest.approx(inertia, rel=8 * U, abs=0)
    assert tuned.stiffness == pytest.approx(stiffness, rel=8 * U, abs=0)
    start = 3 * system.swing
    assert tuned.energy(start) == pytest.approx(stiffness * start**2 / 2, rel=12 * U)
    if system.length_of is None:
        assert tuned.exact_energy(start) == tuned.energy(start)
    else:  # the exact motion of a pendulum, and the height to which it is lifted
        assert tuned.pendulum.omega_0 == pytest.approx(tuned.omega_n, rel=4 * U)
        for angle in (0.0, 1e-200, -1e-9, 1.0, 3.0):
            lifted = stiffness * 2 * math.sin(angle / 2) ** 2
            assert tuned.exact_energy(angle) == pytest.approx(lifted, rel=12 * U, abs=1e-300)
    assert (tuned.pendulum is None) == (system.length_of is None)


def test_nothing_overflows_on_the_way():
    assert ANALOGUES["circuit"].at({"L": 1e-300, "C": 1e300}).omega_n == pytest.approx(1.0, rel=4 * U)
    assert ANALOGUES["pendulum"].at({"l": 1e300, "g": 1e300, "m": 1e300}).omega_n == 1.0
