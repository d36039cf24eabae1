"""Numbers that are refused: every public class and function of physics says so in the same words."""

from __future__ import annotations

import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from physics.absorber import damped_amplitude, damped_solution, den_hartog, helped_band, tuned_stiffness
from physics.bode import driven_resonances, magnification_peak
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_motion
from physics.damped import DampedOscillator
from physics.damped_chain import DampedChain
from physics.driven import DrivenOscillator
from physics.fit import fit_damped
from physics.forced import driven_modes, forced_motion, particular_solution, steady_start
from physics.hanging import HangingMass
from physics.magnification import highest, magnification
from physics.modes import trial, trial_forces
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum, excess
from physics.periodic import PeriodicPush
from physics.phugoid import flight, invariant, lanchester, linear_phugoid, period_excess
from physics.transient import DampedModes

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
SYSTEMS: list[tuple[type[Any], dict[str, float], set[str]]] = [
    (TwoMassChain, dict.fromkeys(("m1", "m2", "k1", "k2"), 1.0), {"k1", "k2"}),
    (DampedChain, dict.fromkeys(("m1", "m2", "k1", "k2", "c1", "c2"), 1.0), {"k1", "k2", "c1", "c2"}),
    (Oscillator, {"m": 1.0, "k": 1.0}, {"k"}),
    (DampedOscillator, {"m": 1.0, "c": 1.0, "k": 1.0}, {"c", "k"}),
    (DrivenOscillator, {"m": 1.0, "c": 1.0, "k": 1.0}, {"c", "k"}),
    (UniformChain, {"N": 3, "m": 1.0, "k": 1.0}, set()),
    (HangingMass, {"m": 1.0, "k": 1.0, "g": 9.81}, {"g"}),
    (Pendulum, {"l": 1.0, "g": 9.81}, set()),
]
"""Systems with their numbers: none may be negative, and some may be 0."""
ONE, MACHINE = DampedOscillator(m=1.0, c=1.0, k=1.0), TwoMassChain(m1=100.0, m2=16.0, k1=250e3, k2=36864.0)
MODES = {"chain": CHAIN, "c": 1.0, "F_0": 1.0, "omega": 1.0}
CALLS: list[tuple[str, Callable[[], object]]] = [
    *(("F_0 = nan", lambda f=f: f(CHAIN, math.nan, 0.5)) for f in (particular_solution, driven_modes, steady_start)),
    *(("omega = -1.0", lambda f=f: f(CHAIN, 1.0, -1.0)) for f in (particular_solution, driven_modes, steady_start)),
    *(("omega", lambda bad=bad: particular_solution(CHAIN, 1.0, [1.0, bad])) for bad in (-1.0, math.inf, math.nan)),
    ("omega has the shape", lambda: particular_solution(CHAIN, 1.0, [[1.0, 2.0]])),
    *(("omega", lambda bad=bad: trial(CHAIN, bad)) for bad in (-1.0, math.nan, math.inf)),
    ("x_0", lambda: free_motion(CHAIN, (1.0,), (0.0, 0.0), TIMES)),
    ("v_0", lambda: free_motion(CHAIN, (1.0, 0.0), (0.0, 0.0, 0.0), TIMES)),
    ("v_0", lambda: free_motion(CHAIN, (1.0, 0.0), (0.0, math.inf), TIMES)),
    ("t", lambda: free_motion(CHAIN, (1.0, 0.0), (0.0, 0.0), [[0.0, 1.0]])),
    ("t has the shape", lambda: Oscillator(m=1.0, k=1.0).motion(0.0, 0.0, [[0.0], [1.0]])),
    ("v_0 = inf", lambda: Oscillator(m=1.0, k=1.0).constants(0.0, math.inf)),
    ("x_0 = nan: a displacement", lambda: ONE.motion(math.nan, 0.0, 0.0)),
    ("t = -1.0: a time", lambda: ONE.motion(1.0, 0.0, -1.0)),
    ("the acceleration leaves the range", lambda: DampedOscillator(m=1e-300, c=1.0, k=1.0).motion(1e10, 0.0, 0.0)),
    ("size = -1.0: the size of a drive", lambda: DRIVEN.motion(1.0, -1.0, t=0.0)),
    ("kind = 'wind': a drive is allowed", lambda: DRIVEN.motion(1.0, kind="wind", t=0.0)),
    ("kind = 'wind': a drive is allowed", lambda: driven_resonances(DRIVEN, "wind")),
    ("kind = 'wind': a drive is allowed", lambda: magnification_peak(DRIVEN, "wind")),
    ("kind = 'wind': a drive is allowed", lambda: magnification(1.0, 0.1, "wind")),
    ("kind = 'wind': a drive is allowed", lambda: highest(0.1, "wind")),
    ("the acceleration F/m at omega = 1 rad/s", lambda: DrivenOscillator(m=1e-300, c=1.0, k=1.0).push(1.0, 1e200)),
    ("the amplitude at omega = 1 rad/s", lambda: DrivenOscillator(m=1e-300, c=1e-200, k=1e-300).response(1.0, 1e200)),
    ("x2_0 = nan: a displacement", lambda: DampedModes(**MODES, x_0=(0.0, math.nan))),
    ("v1_0 = inf: a velocity", lambda: DampedModes(**MODES, v_0=(math.inf, 0.0))),
    ("c = -1.0: a damping", lambda: DampedModes(**(MODES | {"c": -1.0}))),
    ("c1 = -1.0: a damping", lambda: DampedModes(**MODES, c1=-1.0)),
    ("F_0 = inf: a force", lambda: DampedModes(**(MODES | {"F_0": math.inf}))),
    ("omega = -2.0: a drive frequency", lambda: DampedModes(**(MODES | {"omega": -2.0}))),
    ("c = -1.0: a damping", lambda: damped_amplitude(MACHINE, -1.0, 500.0, 48.0)),
    ("c = nan: a damping", lambda: damped_solution(MACHINE, math.nan, 500.0, 48.0)),
    ("F_0 = inf: a force", lambda: damped_amplitude(MACHINE, 1.0, math.inf, 48.0)),
    ("omega = -2.0: a drive frequency", lambda: damped_amplitude(MACHINE, 1.0, 500.0, [1.0, -2.0])),
    ("c = -2.0: a damping", lambda: helped_band(MACHINE, -2.0)),
    ("the tuned stiffness", lambda: tuned_stiffness(1.0, 1e200)),
    ("k1 = 0.0: a stiffness", lambda: den_hartog(100.0, 0.0, 1.0)),
    *(("a speed excess of .* choose from -1", lambda f=f: f(-1.1)) for f in (lanchester, invariant, period_excess)),
    ("a speed excess of .* choose from -1", lambda: lanchester(2e6)),
    ("v_0 = ", lambda: flight(0.0, 9.81, 0.1, [0.0])),
    ("g = ", lambda: linear_phugoid(46.0, -1.0)),
    *(("an angle of .* below the top", lambda bad=bad: excess(bad)) for bad in (math.nextafter(math.pi, 4), -4.0)),
    ("an angle of .* below the top", lambda: Pendulum(l=1.0, g=1.0).motion(-4.0, [0.0])),
    ("whole", lambda: UniformChain(N=2.5, m=1.0, k=1.0)),
    ("fixed-free", lambda: UniformChain(N=3, m=1.0, k=1.0, ends="loose")),
    ("allowed", lambda: PeriodicPush(kind="saw")),
    ("omega", lambda: PeriodicPush(kind="pulses", omega=0.0)),
    ("between 0 and 1", lambda: PeriodicPush(kind="pulses", width=1.0)),
]  # fmt: skip


@pytest.mark.parametrize(("system", "numbers", "may_be_0"), SYSTEMS, ids=lambda one: getattr(one, "__name__", ""))
def test_each_number_of_a_system_is_checked_by_its_name_and_kept_as_a_double(
    system: type[Any], numbers: dict[str, float], may_be_0: set[str]
) -> None:
    for name in numbers:
        for bad in (-1.0, -1e-300, -math.inf, math.inf, math.nan, *([] if name in may_be_0 else [0.0])):
            with pytest.raises(ValueError, match=rf"^{name} = {bad}\b|at least 1"):
                system(**(numbers | {name: bad}))
        system(**(numbers | (dict.fromkeys([name], 0.0) if name in may_be_0 else {})))
    kept = vars(system(**{name: Fraction(number) for name, number in numbers.items()}))
    assert all(isinstance(kept[name], float) for name in numbers.keys() - {"N"})


@pytest.mark.parametrize(("words", "call"), CALLS, ids=lambda one: one if isinstance(one, str) else "")
def test_what_a_function_cannot_take_is_refused_by_its_name(words: str, call: Callable[[], object]) -> None:
    with pytest.raises(ValueError, match=words):
        call()


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
