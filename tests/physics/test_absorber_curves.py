"""Swing, stroke and swing alone over many drive frequencies, against one frequency at a time."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics.absorber import alone, swing_and_stroke
from physics.absorber_curves import machine_curves
from physics.coupled import TwoMassChain
from physics.forced import antiresonance, particular_solution
from tests.grids import tries

MACHINE = TwoMassChain(m1=100.0, m2=16.0, k1=250e3, k2=36864.0)
values = st.floats(1e-3, 1e6)


def one_by_one(chain, c, F_0, omega):
    """The three curves from whole numbers, each rounded once."""
    by_itself = [abs(particular_solution(alone(chain), F_0, w)[0]) for w in omega]
    return np.array([*swing_and_stroke(chain, c, F_0, omega), by_itself])


def near(chain):
    """Every frequency at which something would cancel, and its neighbours."""
    poles = [*chain.modes().omega, *alone(chain).modes().omega, antiresonance(chain), math.sqrt(chain.k1 / 2)]
    return sorted({w for pole in poles if pole for w in (pole, *np.nextafter(pole, (0.0, math.inf)), 1.001 * pole)})


@settings(max_examples=tries(150))
@given(values, values, values, values, st.one_of(st.just(0.0), values), values, values)
def test_a_curve_is_within_six_ulps(m1, m2, k1, k2, c, F_0, omega):
    chain = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
    frequencies = np.array([*near(chain), omega])
    found, true = machine_curves(chain, c, F_0, frequencies), one_by_one(chain, c, F_0, frequencies)
    finite = np.isfinite(true)
    np.testing.assert_array_equal(np.isfinite(found), finite)
    assert np.all(np.abs(found[finite] - true[finite]) <= 6 * np.spacing(true[finite]))


def test_a_resonance_has_no_amplitude_and_a_tuned_machine_none_either():
    swing, stroke, by_itself = machine_curves(MACHINE, 0.0, 500.0, [40.0, 48.0, 50.0, 60.0])
    assert (swing[1], by_itself[2]) == (0.0, math.inf)
    assert stroke[1] == pytest.approx(500.0 / 36864.0, rel=1e-15)
    swing, stroke, _ = machine_curves(TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0), 0.0, 1.0, [1.0, 2.0])
    assert np.all(np.isinf([swing, stroke]))


@pytest.mark.parametrize("c", [0.0, 3.0, 1e250])
@pytest.mark.parametrize("omega", [[0.0, 1.0], [1e-200, 1.0], [1.0, 1e150]])
def test_far_out_each_frequency_is_worked_out_by_itself(c, omega):
    np.testing.assert_array_equal(machine_curves(MACHINE, c, 500.0, omega), one_by_one(MACHINE, c, 500.0, omega))


def test_without_a_spring_there_is_the_machine_alone():
    loose, omega = alone(MACHINE), [10.0, 48.0, 70.0]
    swing, stroke, by_itself = machine_curves(loose, 0.0, 500.0, omega)
    np.testing.assert_allclose(swing, by_itself, rtol=1e-15)
    np.testing.assert_allclose(machine_curves(loose, 30.0, 500.0, omega), one_by_one(loose, 30.0, 500.0, omega), 1e-15)
    np.testing.assert_allclose(stroke, swing, rtol=1e-15)
