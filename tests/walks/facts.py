"""The true answers of the walks and the numbers in their texts, worked out from the physics."""

from __future__ import annotations

import math

from scipy.optimize import brentq

from components.scenes import SCENES
from components.state.page_state import PageState
from components.walks.links import page_state_at
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_modes
from physics.damped import DampedOscillator
from physics.forced import particular_solution
from physics.free_decay import FreeDecay
from physics.free_oscillation import FreeOscillation
from physics.hanging import HangingMass
from physics.lanchester import period_excess
from physics.magnification import magnification
from physics.modes import trial_forces
from physics.oscillator import Oscillator
from physics.pendulum import amplitude_at_excess, excess
from physics.phugoid import flight, linear_phugoid

FT = 0.3048
spring, heavy = Oscillator(m=1, k=39.4), Oscillator(m=4, k=39.4)
start = spring.constants(0.1, -0.8)
hanging = HangingMass(m=1, k=39.4, g=9.81)
swinging = FreeOscillation(oscillator=hanging.oscillator, x_0=0.2, v_0=0.0)
stretched = float(hanging.spring([0.0])[0])
light = linear_phugoid(150 * FT, 9.80665)
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
slowly_dying, thrown = DampedOscillator(m=1, c=0.446, k=39.48), DampedOscillator(m=1, c=18.85, k=39.48)
kept = [0.1 * math.exp(-n * slowly_dying.log_decrement) for n in range(5)]
fastest = FreeDecay(oscillator=car, x_0=0.05, v_0=0.0).first_top_speed or 0.0
at_top_speed = car.motion(0.05, 0.0, [fastest])
to_equilibrium = (FreeDecay(oscillator=car, x_0=0.05, v_0=0.0).first_zero or 0.0) - fastest
half_power = [bob.omega_n * (math.hypot(1, bob.zeta) + way * bob.zeta) for way in (-1, 1)]
eight, seventeen = UniformChain(N=8, m=0.5, k=2.0), UniformChain(N=17, m=0.25, k=4.0)
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

# Numbers in the texts that are no parameter and no live value of the step's scene.
STATED: dict[str, dict[str, float]] = {
    "d31-03": {"0.3": SCENES["oscillator"].param["x_0"].softbounds[1]},
    "d31-04": {"1.00": spring.period, "0.356": first_low, "2": end_of("?scene=oscillator"), "0.8": 0.8, "−0.1": -0.1},
    "d31-05": {"−0.665": math.atan(0.1 * spring.omega_n / -0.8)},
    "d31-06": {"0.47": 0.15 * math.sqrt(9.87), "−0.15": -0.15},
    "d31-07": {"2.5": 24.8 / 9.81, "0.249": hanging.delta_st},
    "d31-08": {"0.498": 2 * hanging.delta_st, "1": 1},
    "d31-09": {"0.5": Oscillator(m=0.25, k=39.4).period, "0.1": 0.2 / 2},
    "d31-10": {
        "0.79": swinging.E,
        "0.788": swinging.E,
        "1.17": stretched - float(hanging.spring([-0.2])[0]),
        "0.2": 0.2,
        "1.96": 9.81 * 0.2,
        "2.01": swinging.E + hanging.datum_shift,
    },
    "d31-12": {
        "1": 100 * excess(amplitude_at_excess(0.01)),
        "5": 5,
        "0.048": late(5),
        "45": 45,
        "4.0": late(45),
        "22.8": ONE_PERCENT,
        "7.32": late(60),
        "60": 60,
        "2.6": 100 * (1 - math.sin(math.radians(22.8138)) / math.radians(22.8138)),
    },
    "d31-13": {
        "5": 100 * 0.05,
        "1.05": 1 + 0.05,
        "1.1025": 1.05**2,
        "0.6": 0.6,
        "2.56": 1.6**2,
        "2.2": 1 + 2 * 0.6,
        "2.5": 100 * (math.sqrt(1.05) - 1),
    },
    "d31-14": {"0.8": speed_at_the_top**2, "1.21": 1.1**2},
    "d31-15": {
        "20": 0.1 * 200,
        "61": end_of("?scene=phugoid&excess=0.1&v_0=60.96"),
        "1.71": 100 * period_excess(0.6),
        "0.6": 0.6,
    },
    "d31-16": {"20.7": light.tau, "150": 150},
    "d32-33-01": {
        **{f"{size:.3f}": size for size in kept},
        "0.64": math.exp(-2 * slowly_dying.log_decrement),
    },
    "d32-33-02": {
        "0.0204": float(at_top_speed.x[0]),
        "0.0801": to_equilibrium,
        "111": car.c * float(at_top_speed.v[0]) ** 2,
    },
    "d32-33-03": {
        "0.1": bob.zeta,
        "53.2": 100 * math.exp(-bob.log_decrement),
        "1.6": 100 * (bob.omega_d / DampedOscillator(m=1, c=2.514, k=39.48).omega_d - 1),
        "0.504": longer(bob),
    },
    "d32-33-04": {
        "1": 1,
        "1.06": home(1.0),
        "0.1": 0.1,
        "7.13": home(0.1),
        "0.83": 0.83,
        "0.674": home(0.83),
    },
    "d32-33-05": {"1.5": thrown.zeta, "3": 3, "1.65": 0.1 * thrown.rates[1], "−1.5": -1.5},
    "d32-33-06": {"2.5": 0.5 / DampedOscillator(m=1, c=2.513, k=39.48).zeta},
    "d32-33-07": {"0.316": float(abs(magnification(12.566 / bob.omega_n, 0.25, "force")[0]))},
    "d32-33-08": {"6.28": bob.omega_n, "5.69": half_power[0], "6.94": half_power[1]},
    "d32-33-09": {"1.6": 1.6, "0.704": shaken(0.2), "0.641": shaken(0.0), "0.646": shaken(0.05), "0.05": 0.05},
    "d34-01": {"−6": force_on_mass_1(0.0), "1": 1, "2": 2},
    "d34-02": {
        "2": plain.modes().omega[1],
        "1": plain.modes().omega[0],
        "1.7": 1.7,
        "−0.8": -0.8,
        "−5.78": float(trial_forces(plain, 1.7, -0.8).needed[0]),
        "−7.60": float(trial_forces(plain, 1.7, -0.8).springs[0]),
    },
    "d34-07": {
        "2.25": 1.5 * 1.5,
        "1.5": uneven.modes().ratio[0],
        "3": uneven.modes().omega[1],
        "25": beats.m1 / beats.m2,
        "5": beats.modes().ratio[0],
        "−3": -uneven.m1 / uneven.m2,
    },
    "d34-08": {"1.618": equal.modes().ratio[0], "−0.618": equal.modes().ratio[1]},
    "d34-09": {"1.57": free_modes(plain, (1, 0.5), (0, 0)).phase[1], "1": 1, "0.5": 0.5, "1.5": 1.5},
    "d34-10": {
        "62": end_of("?scene=coupled&m1=1&k1=0.96&m2=0.04&k2=0.04&x1_0=0.2"),
        "0.08": 2 * 0.04,
        "25": beats.m1 / beats.m2,
    },
    "d34-11": {"1": 0.2 * beats.modes().ratio[0]},
    "d34-12": {"200": 200},
    "d34-13": {"1": 1.0},
    "d34-14": {"0.618": equal.modes().omega[0], "1.618": equal.modes().omega[1], "2.5": 2.5, "5": 5, "−5": -5},
    "d34-15": {"25": end_of("?scene=forced&m1=2&k1=4&k2=2&omega=1"), "12": 1 / growth, "0.95": 0.95, "1": 1},
    "d34-16": {"50": math.sqrt(250e3 / 100)},
    "waves-01": {
        **{str(j): j for j, energy in enumerate(plucked, 1) if energy < 1e-20},
        "4.5": 100 * plucked[-2:].sum() / plucked.sum(),
        "7": len(plucked) - 1,
    },
    "waves-04": {"9": eight.N + 1},
    "waves-05": {"0.695": eight.omega[0], "0.698": eight.string_omega[0]},
    "tour-03": {"6.28": bob.omega_n},
    "tour-05": {"50": math.sqrt(250e3 / 100)},
}
