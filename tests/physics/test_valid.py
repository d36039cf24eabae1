"""Numbers that are refused: every public class and function of physics says so in the same words."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from physics.absorber import damped_amplitude, damped_solution, den_hartog, helped_band, tuned_stiffness
from physics.analogues import ANALOGUES
from physics.bode import driven_resonances, magnification_peak
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_modes, free_motion
from physics.damped import DampedOscillator
from physics.damped_chain import DampedChain
from physics.driven import DrivenOscillator
from physics.energy import chain_energy
from physics.fit import fit_damped
from physics.forced import driven_modes, forced_motion, particular_solution, steady_start
from physics.free_decay import FreeDecay
from physics.free_oscillation import FreeOscillation
from physics.hanging import HangingMass
from physics.integrators.accuracy import SYSTEMS as MEASURED
from physics.integrators.race import measure
from physics.magnification import highest, magnification
from physics.modes import trial, trial_forces
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum, amplitude_at_excess, excess
from physics.periodic import PeriodicPush
from physics.phugoid import (
    excess_at_period_excess,
    flight,
    invariant,
    lanchester,
    linear_flight,
    linear_phugoid,
    period_excess,
)
from physics.precision.exact import rounded
from physics.reference.uniform_chain import chain_points
from physics.sampling import periods
from physics.sinusoids import ExactSinusoid, added
from physics.sweeps import sweep
from physics.transient import DampedModes

CHAIN = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1.0)
DRIVEN = DrivenOscillator(m=1.0, c=0.4, k=4.0)
TIMES = [0.0, 0.5, 1.0]
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
NUMBERS: list[tuple[str, Callable[[Any], object]]] = [
    *((name, lambda a, s=one, n=given, name=name: s(**(n | {name: a}))) for one, given, _ in SYSTEMS for name in given),
    ("x_0", lambda a: Oscillator(m=1.0, k=1.0).motion(x_0=a, v_0=0.0, t=TIMES)),
    ("omega", lambda a: DRIVEN.response(a, size=1.0, kind="force")),
    ("size", lambda a: DRIVEN.response(1.0, size=a, kind="force")),
    ("theta_0", lambda a: Pendulum(l=1.0, g=9.81).motion(a, TIMES)),
    ("width", lambda a: PeriodicPush(kind="pulses", size=1.0, omega=1.0, width=a)),
    ("F_0", lambda a: forced_motion(CHAIN, F_0=a, omega=0.5, t=TIMES)),
    ("v_0", lambda a: linear_phugoid(a, 9.81)),
    ("a speed excess", lambda a: flight(50.0, 9.81, a, TIMES)),
    ("m2", lambda a: den_hartog(1.0, 1.0, a)),
    ("ratio", lambda a: trial_forces(CHAIN, 1.0, a)),
]
"""Each number of a system, and numbers of functions."""
ARRAYS: dict[str, Callable[[Any], object]] = {
    "x_0": lambda a: free_motion(CHAIN, x_0=[a, 1.0], v_0=(0.0, 0.0), t=TIMES),
    "t": lambda a: free_motion(CHAIN, x_0=(0.0, 1.0), v_0=(0.0, 0.0), t=[0.0, a]),
    "omega": lambda a: particular_solution(CHAIN, F_0=1.0, omega=[a, 2.0]),
}
REFUSED: list[object] = ["2", None, True, float("nan"), float("inf"), [1.0], np.array([1.0]), 1j, 10**400, "many"]
GIVEN: list[Any] = [np.float32(0.5), np.int64(1), Fraction(1, 2), Decimal("0.5"), 1]
ONE, MACHINE = DampedOscillator(m=1.0, c=1.0, k=1.0), TwoMassChain(m1=100.0, m2=16.0, k1=250e3, k2=36864.0)
UNEVEN, THREE = TwoMassChain(m1=1e-300, m2=1.0, k1=1e300, k2=1.0), UniformChain(N=3, m=1.0, k=1.0)
HUGE = ExactSinusoid(Decimal(1), (Decimal(0), Decimal("1e400")), (Decimal(0), Decimal(0)))
AT_REST = replace(MEASURED["benign"], v_0=(0.0, 0.0))
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
    (r"^columns\b.*only finite numbers", lambda: fit_damped([0.0, 1.0], [["1", "many"]], modes=1)),
    # Results that leave the range of doubles are named.
    ("v1 leaves the range of doubles", lambda: free_motion(UNEVEN, (1e20, 0.0), (0.0, 0.0), [1e-300])),
    ("energy of a mode", lambda: free_modes(UNEVEN, (1e20, 0.0), (0.0, 0.0)).energy),
    ("the energy V1 leaves", lambda: chain_energy(UNEVEN, free_motion(UNEVEN, (1e10, 0.0), (0.0, 0.0), [0.0]))),
    ("the work of the drive leaves", lambda: driven_modes(CHAIN, 1e200, 1.0).work([1.0])),
    ("static deflection", lambda: HangingMass(m=1e300, k=1e-300, g=9.81).delta_st),
    ("of the spring leaves the range", lambda: HangingMass(m=2.0, k=50.0, g=9.81).spring([1e200])),
    ("the weight m g = ", lambda: HangingMass(m=1e200, k=1.0, g=1e200).gravity([0.0])),
    ("acceleration leaves the range", lambda: Oscillator(m=1e-300, k=1e300).motion(1e-200, 0.0, [0.0])),
    ("acceleration leaves the range", lambda: Oscillator(m=2.0**-54, k=1.5 * 2.0**1023).motion(-0.5, -8e146, [-0.5])),
    ("the largest acceleration = .* leaves", lambda: FreeOscillation(
        oscillator=Oscillator(m=1e-300, k=1e10), x_0=0.2, v_0=-0.3).amplitude(2)),
    ("the energy lost leaves", lambda: FreeDecay(oscillator=ONE, x_0=1e200, v_0=0.0).lost([1.0])),
    *((r"4 periods at omega = .* leaves", lambda bad=bad: periods(bad, 4.0)) for bad in (0.0, 1e-310, math.inf)),
    ("other leaves the range of doubles", lambda: added([HUGE], np.array([0.0, 1.0]), ("one", "other"))),
    (r"the speed = -1.000e\+400 leaves", lambda: rounded("the speed", Decimal("-1e400"))),
    (r"omega = 1\.41.*range of doubles", lambda: linear_phugoid(1e-300, 1e300)),
    (r"v_0\^2/g = 1\.0.*range of doubles", lambda: flight(1e200, 1.0, 0.1, [0.0])),
    *(("the phase leaves", lambda f=f: f(1e-10, 1e10, 0.1, [1e300])) for f in (flight, linear_flight)),
    (r"role of m.*range of doubles", lambda: ANALOGUES["pendulum"].at({"l": 1e300, "g": 9.81, "m": 1.0}).inertia),
    (r"Simple pendulum: the role of m = 1\.000e-600 leaves the range of doubles",
     lambda: ANALOGUES["pendulum"].at({"l": 1e-300, "g": 9.81, "m": 1.0}).inertia),
    (r"energy.*range of doubles", lambda: ANALOGUES["spring"].at({"m": 1.0, "k": 40.0}).energy(1e300)),
    # Questions without an answer.
    *(("t = inf", lambda f=f: f(1.0, 1.0, 0.1, [math.inf])) for f in (flight, linear_flight)),
    *(("at the cusp", lambda bad=bad: excess_at_period_excess(bad)) for bad in (-1e-3, 0.03, math.nan)),
    *(("T/T_0 - 1", lambda bad=bad: amplitude_at_excess(bad)) for bad in (-1e-3, 1.001 * excess(math.pi), math.nan)),
    ("k_t = 0", lambda: ANALOGUES["shaft"].at({"J": 1.0, "k_t": 0})),
    (r"n = 1\.5.*whole", lambda: ANALOGUES["string"].at({"L": 1.0, "T": 1.0, "n": 1.5})),
    ("q_0 = nan", lambda: ANALOGUES["spring"].at({"m": 1.0, "k": 40.0}).energy(math.nan)),
    ("m1, m2, k1, k2", lambda: sweep(CHAIN, "omega", [1.0])),
    ("fixed end is needed", lambda: UniformChain(N=3, m=1.0, k=1.0, ends="free-free").pluck(2, 1.0)),
    ("3 are needed", lambda: THREE.motion([1.0], [0.0] * 3, [0.0])),
    ("from 1 to 3", lambda: THREE.pluck(4, 1.0)),
    (r"at most t = 1e\+04 s is possible", lambda: chain_points(THREE, np.ones(3), np.zeros(3), [2e4], [1])),
    ("k2 = 0 and mass 2 at rest are needed", lambda: replace(MEASURED["benign"].problem(), c=1.0)),
    *(("errors are compared with both", lambda x_0=x_0: list(measure([replace(AT_REST, x_0=x_0)])))
      for x_0 in ((0.0, 0.0), (1e300, 1e300), (1e-320, 0.0))),
    ("two free masses", lambda: list(measure([replace(AT_REST, chain=replace(CHAIN, k1=0.0, k2=0.0))]))),
    ("omega t leaves the range of doubles", lambda: replace(MEASURED["near"], F_0=1.0, omega=1e308).problem()),
    ("lets the mass swing", lambda: replace(MEASURED["dashpot"].problem(), c=1.0).rates),
]  # fmt: skip


@pytest.mark.parametrize(("system", "numbers", "may_be_0"), SYSTEMS, ids=lambda one: getattr(one, "__name__", ""))
def test_each_number_of_a_system_is_checked_by_its_name_and_kept_as_a_double(
    system: type[Any], numbers: dict[str, float], may_be_0: set[str]
) -> None:
    for name in numbers:
        for bad in (-1.0, -1e-300, -math.inf, *([] if name in may_be_0 else [0.0])):
            with pytest.raises(ValueError, match=rf"^{name} = {bad}\b|at least 1"):
                system(**(numbers | {name: bad}))
        system(**(numbers | (dict.fromkeys([name], 0.0) if name in may_be_0 else {})))
    kept = vars(system(**{name: Fraction(number) for name, number in numbers.items()}))
    assert all(isinstance(kept[name], float) for name in numbers.keys() - {"N"})


@pytest.mark.parametrize(("words", "call"), CALLS, ids=lambda one: one if isinstance(one, str) else "")
def test_what_a_function_cannot_take_is_refused_by_its_name(words: str, call: Callable[[], object]) -> None:
    with pytest.raises(ValueError, match=words):
        call()


@pytest.mark.parametrize(("name", "call"), NUMBERS, ids=lambda one: one if isinstance(one, str) else "")
def test_real_numbers_of_every_kind_are_taken_and_others_are_refused_in_words(
    name: str, call: Callable[[Any], object]
) -> None:
    for bad in REFUSED:
        with pytest.raises(ValueError, match=rf"^{name}\b.*(number|possible)") as refused:
            call(bad)
        assert len(str(refused.value)) < 200
    for good in GIVEN:
        call({"N": 3, "width": 0.5}.get(name, good))


@pytest.mark.parametrize("bad", [bad for bad in REFUSED if bad is not True], ids=lambda bad: type(bad).__name__)
@pytest.mark.parametrize("name", ARRAYS)
def test_an_array_has_finite_numbers_only(name: str, bad: object) -> None:
    """True among floats is a number, for NumPy."""
    with pytest.raises(ValueError, match=rf"^{name}\b"):
        ARRAYS[name](bad)
