"""'About these numbers' of the scenes of one oscillating thing."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import numpy as np

from components.about import About, drift, envelope, few, rows, table
from components.analogue_case import Case
from components.numbers import short, three
from components.scene import Picture
from components.swing import Swing
from physics.energy import half_square
from physics.exact import exact, precise
from physics.hanging import Datum, HangingMass
from physics.oscillator import Oscillator
from physics.phugoid import flight, invariant
from physics.reference import Point
from physics.reference_single import flight_points, oscillator_points, pendulum_points

FLIGHT, EACH_SWING = 32, 32
"""ulp: of the first swing of a flight, and by how much its phase adds to that in each later one."""


def oscillator_about(picture: Picture, oscillator: Oscillator, x_0: float, v_0: float) -> About:
    columns = picture.columns["time"]
    at = few(columns["t"])
    true = oscillator_points(oscillator, x_0, v_0, columns["t"][at].tolist())
    names = {"x": "$x$", "v": "$v$", "a": "$a$"}
    found = rows(names, columns, true, at)
    return About(
        (table("$x(t)$, $v(t)$ or $a(t)$", 4, "its amplitude", found),),
        _oscillator_drift(oscillator, x_0, v_0, columns["t"]),
        envelope(picture.columns, names),
    )


def _oscillator_drift(oscillator: Oscillator, x_0: float, v_0: float, t: np.ndarray) -> str:
    motion = oscillator.motion(x_0, v_0, t)
    try:
        total = half_square("T", oscillator.m, motion.v) + half_square("V", oscillator.k, motion.x)
        if not oscillator.k:
            return drift(total, float(total[0]))
        return drift(total, HangingMass(m=oscillator.m, k=oscillator.k, g=0.0).total_energy(x_0, v_0))
    except ValueError as reason:
        return f"$T + V$ cannot be followed: {reason}."


def energy_about(picture: Picture, system: HangingMass, x_0: float, v_0: float, datum: Datum) -> About:
    columns = picture.columns["time"]
    at = few(columns["t"])
    true = oscillator_points(system.oscillator, x_0, v_0, columns["t"][at].tolist())
    energies = {"T": "$T$", "V": "$V$", "spring": "spring", "gravity": "gravity"}
    states = zip(true["x"], true["v"], strict=True)
    each = [_hanging(system, x, v, datum) for x, v in states]
    levels = {name: [point[name] for point in each] for name in energies}
    tables = (
        table("$x(t)$", 4, "its amplitude", rows({"x": "$x$"}, columns, true, at)),
        table("an energy", 12, "its largest", rows(energies, columns, levels, at)),
    )
    motion = system.motion(x_0, v_0, columns["t"])
    total = system.energies(motion.x, motion.v).total
    return About(
        tables, drift(total, system.total_energy(x_0, v_0)), envelope(picture.columns, {"x": "$x$", **energies})
    )


def _hanging(system: HangingMass, x: Point, v: Point, datum: Datum) -> dict[str, Point]:
    """The energies at one time; each measured by the largest it reaches."""
    m, k, g = exact(system.m), exact(system.k), exact(system.g)
    with precise():
        deflection = m * g / k
        shift = k * deflection**2 / 2 if datum == "separate" else Decimal(0)
        T, E = m * v.value**2 / 2, k * x.size**2 / 2
        return {
            "T": Point(T, E),
            "V": Point(k * x.value**2 / 2 + shift, E + shift),
            "spring": Point(k * (x.value + deflection) ** 2 / 2, k * (x.size + deflection) ** 2 / 2),
            "gravity": Point(-m * g * x.value, m * g * x.size),
        }


def analogue_about(picture: Picture, case: Case) -> About:
    """The coordinate, and that of the spring of equal numbers."""
    columns = picture.columns["time"]
    at = few(columns["t"])
    t = columns["t"][at].tolist()
    spring = oscillator_points(case.spring, case.q_0, 0.0, t)["x"]
    true: dict[str, Sequence[Point]] = {
        "q": pendulum_points(case.pendulum, case.q_0, t) if case.pendulum else spring,
        "x": spring,
    }
    symbol = f"${case.system.coordinate}$"
    names = {"q": symbol, "x": "spring"} if case.pendulum else {"q": symbol}
    found = rows(names, columns, true, at)
    return About(
        (table(f"{symbol} over $t$", 4, "its amplitude, once what plays $m$ and $k$ is rounded to doubles", found),),
        _analogue_drift(case, columns["t"]),
        envelope(picture.columns, names),
    )


def _analogue_drift(case: Case, t: np.ndarray) -> str:
    """T + V over what it is at the start, so that no energy leaves the range of doubles."""
    if not case.q_0:
        return drift(np.zeros_like(t), 0.0)
    if case.pendulum:
        motion, size = case.swing(t)
        top = np.sin(size / 2)
        rate, place = motion.theta_dot / (2 * case.pendulum.omega_0), np.sin(motion.theta / 2)
        share = (rate / top) ** 2 + (place / top) ** 2
    else:
        swing = case.spring.motion(case.q_0, 0.0, t)
        share = (swing.v / case.omega / case.q_0) ** 2 + (swing.x / case.q_0) ** 2
    level = case.system.exact_energy(case.p, case.q_0)
    return drift(level * share, level)


def flight_about(picture: Picture, swing: Swing) -> About:
    columns = picture.columns["time"]
    t = columns["t"]
    at = few(t)
    true = flight_points(swing.v_0, swing.g, swing.excess, t[at].tolist())
    names = {"h": "$h'$", "v": "$v'$"}
    later = max(0.0, float(t[-1]) / swing.period - 1)
    bound = table(
        "the flight",
        float(np.ceil(FLIGHT + EACH_SWING * later)),
        r"$v_0^2/g$ for $h'$, of $v_0$ for $v'$",
        rows(names, columns, true, at),
    )
    motion = flight(swing.v_0, swing.g, swing.excess, t)
    V, u = motion.V / swing.v_0, motion.u / swing.v_0
    C = invariant(swing.excess)
    strays = float(np.max(np.abs(u - V**3 / 3 - C)))
    kept = f"The flight's invariant $C = u - V^3/3$ = {three(C)}, {short(strays)} off at most over the window."
    return About((bound,), kept, envelope(picture.columns, names))
