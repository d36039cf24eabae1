"""The true answers of the walks, the numbers in their texts, and the wrong sketches that they describe."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.optimize import brentq

from components.scenes import SCENES
from components.state.page_state import PageState
from components.walks.links import page_state_at
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_modes
from physics.damped import DampedOscillator
from physics.forced import particular_solution
from physics.free_decay import FreeDecay
from physics.hanging import HangingMass
from physics.lanchester import period_excess
from physics.magnification import magnification
from physics.modes import trial_forces
from physics.oscillator import Oscillator
from physics.pendulum import amplitude_at_excess, excess
from physics.phugoid import flight

FT = 0.3048
spring, heavy = Oscillator(m=1, k=39.4), Oscillator(m=4, k=39.4)
start = spring.constants(0.1, -0.8)
hanging = HangingMass(m=1, k=39.4, g=9.81)
stretched = float(hanging.spring([0.0])[0])
plain = TwoMassChain(m1=2, m2=1, k1=4, k2=2)
equal = TwoMassChain(m1=1, m2=1, k1=1, k2=1)
beats = TwoMassChain(m1=1, m2=0.04, k1=0.96, k2=0.04)
uneven = TwoMassChain(m1=3, m2=1, k1=9, k2=6)
slowly = TwoMassChain(m1=2, m2=1, k1=1, k2=2)
pushed = particular_solution(slowly, F_0=1.0, omega=0.0).tolist()
ONE_PERCENT = math.degrees(amplitude_at_excess(0.01))


def at(link: str) -> PageState:
    return page_state_at(link, SCENES)


def end_of(link: str) -> float:
    return math.floor(at(link).shown.axes["t"].end)


def force_on_mass_1(ratio: float) -> float:
    return float(trial_forces(plain, 1.7, ratio).springs[0])


def late(degrees: float) -> float:
    return 100 * excess(math.radians(degrees))


first_low = (3 * math.pi / 2 - start.phi) % (2 * math.pi) / spring.omega_n
half_a_period = math.pi / math.sqrt(2) * (1 + period_excess(0.1))
speed_at_the_top = float(flight(1, 1, 0.1, [half_a_period]).V[0])
force_off = math.degrees(brentq(lambda a: (a - math.sin(a)) / a - 0.01, 0.01, 1))
growth = 1 / (2 * (2 + 1 * 2.0**2) * 1.0)

bob, car = DampedOscillator(m=1, c=1.257, k=39.48), DampedOscillator(m=300, c=1500, k=2e4)
slowly_dying = DampedOscillator(m=1, c=0.446, k=39.48)
kept = [0.1 * math.exp(-n * slowly_dying.log_decrement) for n in range(5)]
fastest = FreeDecay(oscillator=car, x_0=0.05, v_0=0.0).first_top_speed or 0.0
at_top_speed = car.motion(0.05, 0.0, [fastest])
to_equilibrium = (FreeDecay(oscillator=car, x_0=0.05, v_0=0.0).first_zero or 0.0) - fastest
half_power = [bob.omega_n * (math.hypot(1, bob.zeta) + way * bob.zeta) for way in (-1, 1)]
eight = UniformChain(N=8, m=0.5, k=2.0)
plucked = eight.drawn_modes(eight.pluck(3, 0.4), [0.0] * 8).energy


def longer(one: DampedOscillator) -> float:
    """By how many percent the period is longer than without a dashpot."""
    return 100 * (one.omega_n / one.omega_d - 1)


def home(zeta: float) -> float:
    """The time after which the displacement of the released mass of 1 kg stays within 1 % of its initial value."""
    one = DampedOscillator(m=1, c=2 * zeta * math.sqrt(39.48), k=39.48)
    return FreeDecay(oscillator=one, x_0=0.1, v_0=0.0).settled(0.01) or 0.0


def shaken(zeta: float) -> float:
    return float(abs(magnification(1.6, zeta, "base")[0]))


# The answer of each number and point, and the value of each typical wrong answer.
ANSWERS: dict[str, tuple[list[float], list[float]]] = {
    "d31-02": ([heavy.period], [4 * spring.period, spring.period, spring.period / 2]),
    "d31-08": ([2 * hanging.delta_st], [hanging.delta_st]),
    "d31-12": ([ONE_PERCENT], [force_off, 5, 45]),
    "d31-13": ([100 * 2 * 0.05], [5, 0, 2.5]),
    "d32-33-01": ([kept[4]], [0.02, kept[3], kept[2], 0.0]),
    "d32-33-08": ([1 / (2 * bob.zeta)], [2 * bob.zeta, 1 / bob.zeta, 1.0, half_power[1] - half_power[0]]),
    "d34-01": ([force_on_mass_1(1.0)], [force_on_mass_1(0.0), 4, -4 + 2 * (2 - 1)]),
    "d34-07": ([float(uneven.modes().ratio[1])], [-1.5, -1 / 1.5, 2]),
    "d34-08": (equal.modes().ratio.tolist(), [1, -1, 0]),
    "d34-13": ([pushed[1]], [-pushed[1], 0, 1 / slowly.k1 + 0.5, 1 / (slowly.k1 + slowly.k2)]),
    "d34-16": ([48.0], [math.sqrt(250e3 / 100), 60, 24]),
    "waves-04": ([eight.omega[7]], [eight.string_omega[7], 4.0, 2.0]),
}

# The periods of sketched curves; for a beat or a growing oscillation, the period of the oscillation.
slow, fast = free_modes(beats, (0.2, 0.0), (0.0, 0.0)).omega.tolist()
PERIODS: dict[str, float] = {
    "d31-04": spring.period,
    "d31-09": Oscillator(m=0.25, k=39.4).period / 2,
    "d31-15": 200 * FT / 9.80665 * 2 * half_a_period,
    "d32-33-10": 2 * math.pi / 6.2833,
    "d34-10": 4 * math.pi / (slow + fast),
    "d34-15": 2 * math.pi / 1.0,
}

STATED: dict[str, list[float]] = {
    "d31-03": [SCENES["oscillator"].param["x_0"].softbounds[1]],
    "d31-04": [first_low, end_of("?scene=oscillator"), 0.8],
    "d31-06": [0.15 * math.sqrt(9.87), -0.15],
    "d31-07": [24.8 / 9.81],
    "d31-08": [2 * hanging.delta_st],
    "d31-09": [0.2 / 2],
    "d31-10": [stretched - float(hanging.spring([-0.2])[0]), 0.2, 9.81 * 0.2],
    "d31-12": [5, late(5), 45, late(45), late(60), 60,
               100 * (1 - math.sin(math.radians(22.8138)) / math.radians(22.8138))],
    "d31-13": [100 * 0.05, 1 + 0.05, 1.05**2, 0.6, 1.6**2, 1 + 2 * 0.6],
    "d31-14": [speed_at_the_top**2, 1.1**2],
    "d31-15": [0.1 * 200, 100 * period_excess(0.6), 0.6],
    "d31-16": [150],
    "d32-33-01": [*kept[1:], math.exp(-2 * slowly_dying.log_decrement)],
    "d32-33-02": [float(at_top_speed.x[0]), to_equilibrium, car.c * float(at_top_speed.v[0]) ** 2],
    "d32-33-03": [100 * (bob.omega_d / DampedOscillator(m=1, c=2.514, k=39.48).omega_d - 1)],
    "d32-33-04": [home(0.1), 0.83, home(0.83)],
    "d32-33-05": [3],
    "d32-33-08": half_power,
    "d32-33-09": [shaken(0.0), shaken(0.05)],
    "d34-01": [force_on_mass_1(0.0)],
    "d34-07": [1.5 * 1.5, beats.m1 / beats.m2, beats.modes().ratio[0], -uneven.m1 / uneven.m2],
    "d34-10": [end_of("?scene=coupled&m1=1&k1=0.96&m2=0.04&k2=0.04&x1_0=0.2"), 2 * 0.04, beats.m1 / beats.m2],
    "d34-12": [200],
    "d34-14": [2.5, 5, -5],
    "d34-15": [end_of("?scene=forced&m1=2&k1=4&k2=2&omega=1"), 1 / growth, 0.95],
    "d34-16": [math.sqrt(250e3 / 100)],
    "waves-01": [6, 100 * plucked[-2:].sum() / plucked.sum()],
    "waves-04": [eight.N + 1],
    "tour-05": [math.sqrt(250e3 / 100)],
}  # fmt: skip
"""Numbers in the texts of a step that are neither a parameter nor a number of one of its scenes."""

W = 2 * math.pi


def response(w: Any) -> Any:
    return np.abs((1 - w * w) / (w**4 - 3 * w * w + 1))


# The wrong sketches that the walks describe, as functions of the abscissa; a dict if two curves are drawn.
WRONG: dict[str, list[Callable[[Any], Any]]] = {
    "d31-04": [
        lambda t: 0.1 * np.cos(W * t),
        lambda t: 0.1 * np.cos(W * t + 0.9) + 0.1 * (1 - math.cos(0.9)) * np.exp(-40 * t),
    ],
    "d31-06": [
        lambda t: 0.471 * np.cos(W / 2 * t),
        lambda t: np.abs(0.471 * np.sin(W / 2 * t)),
        lambda t: 0.471 * np.sin(W / 2 * t),
    ],
    "d31-09": [
        lambda t: {"V": 0.394 * (1 + np.cos(2 * W * t)), "T": 0.394 * (1 - np.cos(2 * W * t))},
        lambda t: {"V": 0.788 * np.cos(2 * W * t), "T": 0.788 * np.sin(2 * W * t)},
    ],
    "d31-15": [
        lambda t: 124 * np.sin(0.2275 * t),
        lambda t: -128 + 249 * (1 - np.exp(-t / 4)),
        lambda t: 124 * np.cos(0.2275 * t),
    ],
    "d32-33-05": [
        lambda t: 0.1 * np.exp(-25 * t),
        lambda t: 0.1 * np.exp(-1.5 * t) * np.cos(W / 0.66 * t),
    ],
    "d32-33-10": [
        lambda t: -0.4 * np.cos(W * t),
        lambda t: -0.02 * np.exp(1.1 * t) * np.cos(W * t),
        lambda t: -0.2 * (1 - np.exp(-3 * t)) * np.cos(W * t),
    ],
    "d34-10": [
        lambda t: np.cos(0.1005 * t) * np.cos(0.995 * t),
        lambda t: np.minimum(t / 16, 1) * np.sin(0.995 * t),
        lambda t: 0.2 * np.sin(0.995 * t),
    ],
    "d34-14": [
        lambda w: 1 / np.abs(1 - (w / 1.118) ** 2 + 1e-9),
        lambda w: np.maximum(response(w), 0.8),
        lambda w: w**2 * response(w),
    ],
    "d34-15": [
        lambda t: -2.0 * np.cos(t),
        lambda t: -0.02 * np.exp(0.21 * t) * np.cos(t),
        lambda t: -1.0 * (1 - np.exp(-t / 4)) * np.cos(t),
    ],
}
