"""Numbers that are refused: every public class and function of physics says so in the same words."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from physics.absorber import den_hartog
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_motion
from physics.damped import DampedOscillator
from physics.damped_chain import DampedChain
from physics.driven import DrivenOscillator
from physics.fit import fit_damped
from physics.forced import forced_motion, particular_solution
from physics.hanging import HangingMass
from physics.modes import trial_forces
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum
from physics.periodic import PeriodicPush
from physics.phugoid import flight, linear_phugoid

CHAIN = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1.0)
DRIVEN = DrivenOscillator(m=1.0, c=0.4, k=4.0)
TIMES = [0.0, 0.5, 1.0]
NUMBERS: dict[str, Callable[[Any], object]] = {
    "m1": lambda a: TwoMassChain(m1=a, m2=1.0, k1=1.0, k2=1.0),
    "k2": lambda a: TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=a),
    "m": lambda a: Oscillator(m=a, k=1.0),
    "x_0": lambda a: Oscillator(m=1.0, k=1.0).motion(x_0=a, v_0=0.0, t=TIMES),
    "c": lambda a: DampedOscillator(m=1.0, c=a, k=1.0),
    "k": lambda a: DrivenOscillator(m=1.0, c=1.0, k=a),
    "omega": lambda a: DRIVEN.response(a, size=1.0, kind="force"),
    "size": lambda a: DRIVEN.response(1.0, size=a, kind="force"),
    "c1": lambda a: DampedChain(m1=1.0, m2=1.0, k1=1.0, k2=1.0, c1=a, c2=0.0),
    "g": lambda a: HangingMass(m=1.0, k=1.0, g=a),
    "l": lambda a: Pendulum(l=a, g=9.81),
    "theta_0": lambda a: Pendulum(l=1.0, g=9.81).motion(a, TIMES),
    "N": lambda a: UniformChain(N=a, m=1.0, k=1.0, ends="fixed-fixed"),
    "width": lambda a: PeriodicPush(kind="pulses", size=1.0, omega=1.0, width=a),
    "F_0": lambda a: forced_motion(CHAIN, F_0=a, omega=0.5, t=TIMES),
    "v_0": lambda a: linear_phugoid(a, 9.81),
    "a speed excess": lambda a: flight(50.0, 9.81, a, TIMES),
    "m2": lambda a: den_hartog(1.0, 1.0, a),
    "ratio": lambda a: trial_forces(CHAIN, 1.0, a),
}
ARRAYS: dict[str, Callable[[Any], object]] = {
    "x_0": lambda a: free_motion(CHAIN, x_0=[a, 1.0], v_0=(0.0, 0.0), t=TIMES),
    "t": lambda a: free_motion(CHAIN, x_0=(0.0, 1.0), v_0=(0.0, 0.0), t=[0.0, a]),
    "omega": lambda a: particular_solution(CHAIN, F_0=1.0, omega=[a, 2.0]),
}
REFUSED: list[object] = ["2", None, True, float("nan"), float("inf"), [1.0], np.array([1.0]), 1j, 10**400, "many"]
GIVEN: list[Any] = [np.float32(0.5), np.int64(1), Fraction(1, 2), Decimal("0.5"), 1]


@pytest.mark.parametrize("bad", REFUSED, ids=lambda bad: type(bad).__name__)
@pytest.mark.parametrize("name", NUMBERS)
def test_what_is_no_finite_number_is_refused_in_words(name: str, bad: object) -> None:
    with pytest.raises(ValueError, match=rf"^{name}\b.*(number|possible)") as refused:
        NUMBERS[name](bad)
    assert len(str(refused.value)) < 200


@pytest.mark.parametrize("bad", REFUSED, ids=lambda bad: type(bad).__name__)
@pytest.mark.parametrize("name", ARRAYS)
def test_an_array_has_finite_numbers_only(name: str, bad: object) -> None:
    if bad is True:
        return  # among floats, NumPy has made a number of it
    with pytest.raises(ValueError, match=rf"^{name}\b"):
        ARRAYS[name](bad)


def test_measured_columns_are_numbers() -> None:
    with pytest.raises(ValueError, match=r"^columns\b.*only finite numbers"):
        fit_damped([0.0, 1.0], [["1", "many"]], modes=1)


@pytest.mark.parametrize("good", GIVEN, ids=lambda good: type(good).__name__)
@pytest.mark.parametrize("name", NUMBERS)
def test_every_kind_of_real_number_is_taken(name: str, good: Any) -> None:
    if name == "N" or (name == "width" and good == 1):
        good = 3 if name == "N" else 0.5
    NUMBERS[name](good)
