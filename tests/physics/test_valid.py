"""Numbers that are refused: every public class and function of physics says so in the same words."""

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from functools import partial
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
from physics.lanchester import excess_at_period_excess, invariant, lanchester, period_excess
from physics.magnification import highest, magnification
from physics.modes import trial, trial_forces
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum, amplitude_at_excess, excess
from physics.periodic import PeriodicPush
from physics.phugoid import flight, linear_flight, linear_phugoid
from physics.sampling import periods
from physics.transient import DampedModes

CHAIN, ALONE = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1.0), Oscillator(m=1.0, k=1.0)
ONE, MACHINE = DampedOscillator(m=1.0, c=1.0, k=1.0), TwoMassChain(m1=100.0, m2=16.0, k1=250e3, k2=36864.0)
DRIVEN = DrivenOscillator(m=1.0, c=0.4, k=4.0)
TIMES = [0.0, 0.5, 1.0]
NUMBERS: list[tuple[Callable[..., Any], str]] = [
    (TwoMassChain, "m1>0 m2>0 k1>=0 k2>=0"),
    (DampedChain, "m1>0 m2>0 k1>=0 k2>=0 c1>=0 c2>=0"),
    (Oscillator, "m>0 k>=0"),
    (DampedOscillator, "m>0 c>=0 k>=0"),
    (DrivenOscillator, "m>0 c>=0 k>=0"),
    (UniformChain, "N>0 m>0 k>0"),
    (HangingMass, "m>0 k>0 g>=0"),
    (Pendulum, "l>0 g>0"),
    (partial(PeriodicPush, kind="pulses"), "size omega>0 width>0"),
    (partial(DampedModes, chain=CHAIN), "c>=0 c1>=0 F_0 omega>=0"),
    (partial(ALONE.motion, t=TIMES), "x_0 v_0"),
    (ALONE.constants, "x_0 v_0"),
    (ONE.motion, "x_0 v_0 t[]>=0"),
    (DRIVEN.motion, "omega>=0 size>=0 x_0 v_0 t[]>=0"),
    (partial(Pendulum(l=1.0, g=9.81).motion, t=TIMES), "theta_0"),
    (partial(DRIVEN.response, kind="force"), "omega>=0 size>=0"),
    (partial(free_motion, CHAIN), "x_0[] v_0[] t[]"),
    (partial(particular_solution, CHAIN), "F_0 omega[]>=0"),
    (partial(driven_modes, CHAIN), "F_0 omega>=0"),
    (partial(steady_start, CHAIN), "F_0 omega>=0"),
    (partial(forced_motion, CHAIN, t=TIMES), "F_0 omega>=0"),
    (partial(damped_amplitude, MACHINE), "c>=0 F_0 omega[]>=0"),
    (partial(damped_solution, MACHINE), "c>=0 F_0 omega>=0"),
    (partial(helped_band, MACHINE), "c>=0"),
    (tuned_stiffness, "m2>0 omega>=0"),
    (den_hartog, "m1>0 k1>0 m2>0"),
    (partial(trial, CHAIN), "omega>=0"),
    (partial(trial_forces, CHAIN), "omega>=0 ratio"),
    (linear_phugoid, "v_0>0 g>0"),
    (partial(flight, t=TIMES), "v_0>0 g>0 excess"),
    (partial(linear_flight, t=TIMES), "v_0>0 g>0 excess"),
]
"""Functions and their numbers, some in arrays of two, with the limit of each."""
REFUSED: list[object] = ["2", None, True, float("nan"), float("inf"), [1.0], np.array([1.0]), 1j, 10**400, "many"]
GIVEN: list[Any] = [np.float32(0.5), np.int64(1), Fraction(1, 2), Decimal("0.5"), 1]
UNEVEN, THREE = TwoMassChain(m1=1e-300, m2=1.0, k1=1e300, k2=1.0), UniformChain(N=3, m=1.0, k=1.0)
AT_REST = replace(MEASURED["benign"], v_0=(0.0, 0.0))
MODES = {"chain": CHAIN, "c": 1.0, "F_0": 1.0, "omega": 1.0}
CALLS: list[tuple[str, Callable[[], object]]] = [
    ("omega has the shape", lambda: particular_solution(CHAIN, 1.0, [[1.0, 2.0]])),
    ("x_0", lambda: free_motion(CHAIN, (1.0,), (0.0, 0.0), TIMES)),
    ("v_0", lambda: free_motion(CHAIN, (1.0, 0.0), (0.0, 0.0, 0.0), TIMES)),
    ("t", lambda: free_motion(CHAIN, (1.0, 0.0), (0.0, 0.0), [[0.0, 1.0]])),
    ("t has the shape", lambda: Oscillator(m=1.0, k=1.0).motion(0.0, 0.0, [[0.0], [1.0]])),
    ("the acceleration leaves the range", lambda: DampedOscillator(m=1e-300, c=1.0, k=1.0).motion(1e10, 0.0, 0.0)),
    ("kind = 'wind': a drive is allowed", lambda: DRIVEN.motion(1.0, kind="wind", t=0.0)),
    ("kind = 'wind': a drive is allowed", lambda: driven_resonances(DRIVEN, "wind")),
    ("kind = 'wind': a drive is allowed", lambda: magnification_peak(DRIVEN, "wind")),
    ("kind = 'wind': a drive is allowed", lambda: magnification(1.0, 0.1, "wind")),
    ("kind = 'wind': a drive is allowed", lambda: highest(0.1, "wind")),
    ("the acceleration F/m at omega = 1 rad/s", lambda: DrivenOscillator(m=1e-300, c=1.0, k=1.0).push(1.0, 1e200)),
    ("the amplitude at omega = 1 rad/s", lambda: DrivenOscillator(m=1e-300, c=1e-200, k=1e-300).response(1.0, 1e200)),
    ("x2_0 = nan: a displacement", lambda: DampedModes(**MODES, x_0=(0.0, math.nan))),
    ("v1_0 = inf: a velocity", lambda: DampedModes(**MODES, v_0=(math.inf, 0.0))),
    ("the tuned stiffness", lambda: tuned_stiffness(1.0, 1e200)),
    *(("a speed excess of .* choose from -1", lambda f=f: f(-1.1)) for f in (lanchester, invariant, period_excess)),
    ("a speed excess of .* choose from -1", lambda: lanchester(2e6)),
    *(("an angle of .* below the top", lambda bad=bad: excess(bad)) for bad in (math.nextafter(math.pi, 4), -4.0)),
    ("an angle of .* below the top", lambda: Pendulum(l=1.0, g=1.0).motion(-4.0, [0.0])),
    ("whole", lambda: UniformChain(N=2.5, m=1.0, k=1.0)),
    ("fixed-free", lambda: UniformChain(N=3, m=1.0, k=1.0, ends="loose")),
    ("allowed", lambda: PeriodicPush(kind="saw")),
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
    ("fixed end is needed", lambda: UniformChain(N=3, m=1.0, k=1.0, ends="free-free").pluck(2, 1.0)),
    ("3 are needed", lambda: THREE.motion([1.0], [0.0] * 3, [0.0])),
    ("from 1 to 3", lambda: THREE.pluck(4, 1.0)),
    ("k2 = 0 and mass 2 at rest are needed", lambda: replace(MEASURED["benign"].problem(), c=1.0)),
    *(("errors are compared with both", lambda x_0=x_0: list(measure([replace(AT_REST, x_0=x_0)])))
      for x_0 in ((0.0, 0.0), (1e300, 1e300), (1e-320, 0.0))),
    ("two free masses", lambda: list(measure([replace(AT_REST, chain=replace(CHAIN, k1=0.0, k2=0.0))]))),
    ("omega t leaves the range of doubles", lambda: replace(MEASURED["near"], F_0=1.0, omega=1e308).problem()),
    ("lets the mass swing", lambda: replace(MEASURED["dashpot"].problem(), c=1.0).rates),
]  # fmt: skip


@pytest.mark.parametrize(("words", "call"), CALLS, ids=lambda one: one if isinstance(one, str) else "")
def test_what_a_function_cannot_take_is_refused_by_its_name(words: str, call: Callable[[], object]) -> None:
    with pytest.raises(ValueError, match=words):
        call()


def each_number() -> Iterator[Any]:
    """Yield each number of a function: the function, all its numbers, the name, [] of an array, and the limit."""
    for call, text in NUMBERS:
        found = re.findall(r"(\w+)(\[\])?(>=?0)?", text)
        numbers = {name: [1.0, 1.0] if array else {"N": 3, "width": 0.5}.get(name, 1.0) for name, array, _ in found}
        for one in found:
            yield pytest.param(call, numbers, *one, id=f"{getattr(call, 'func', call).__qualname__} {''.join(one)}")


@pytest.mark.parametrize(("call", "numbers", "name", "array", "limit"), [*each_number()])
def test_real_numbers_of_every_kind_are_taken_and_others_are_refused_in_words(
    call: Callable[..., Any], numbers: dict[str, Any], name: str, array: str, limit: str
) -> None:
    """True among floats is a number, for NumPy. Systems keep their numbers as doubles."""
    signed = [] if not limit else [-1.0, -1e-300, -math.inf, *([0.0] if limit == ">0" else [])]
    for bad in [*REFUSED, *signed]:
        if not (array and bad is True):
            with pytest.raises(ValueError, match=rf"^(a speed )?{name}\b.*(number|possible|dimension)") as refused:
                call(**numbers | {name: [bad, 1.0] if array else bad})
            assert len(str(refused.value)) < 200
    for good in [*GIVEN, *{"": [-1.0], ">=0": [0.0], ">0": []}[limit]]:
        one = {"N": 3, "width": 0.5}.get(name, good)
        kept = call(**numbers | {name: [one, 1.0] if array else one})
        assert name == "N" or not isinstance(call, type) or isinstance(getattr(kept, name), float)
