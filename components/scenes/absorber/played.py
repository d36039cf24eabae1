"""The absorber's motion as the clock plays it: the particular solution, or the motion from its start."""

from __future__ import annotations

import cmath
import math

import numpy as np

from components.language.numbers import var
from components.language.signals import AnySignal
from components.quantities.axes import Axis
from components.quantities.motion import derived, responses, sampled, sines, total
from components.scenes.absorber.duty import Duty
from physics.exact import exact, precise, rounded
from physics.forced import DrivenModes

NODES = 401
"""Points of a window that the browser joins by Hermite pieces."""


def signals(duty: Duty, end: float, size: Axis, time: Axis, push: Axis, *, parts: bool = False) -> dict[str, AnySignal]:
    """The machine alone and with the absorber: the particular solution, or the motion from its start, and its parts."""
    drive = (1.0, duty.omega, 0.0)
    unit = Axis(0.0, 1.0)
    moving: dict[str, AnySignal] = {
        "drive": sines(unit, time, drive),
        "drive_now": sines(push, time, (duty.F_0, duty.omega, 0.0)),
    }
    if duty.plays_alone:
        moving["x_alone"] = sines(size, time, (float(duty.bare.particular[0]), duty.omega, 0.0))
    else:
        moving |= _from_start(duty.bare, 0, "x_alone", size, time)
    if duty.plays:
        for i, X in enumerate(duty.X):
            moving[f"x{i + 1}"] = sines(size, time, (abs(X), duty.omega, float(np.angle(X))))
        X2 = complex(duty.X[1])
        moving["pull_now"] = sines(push, time, (pull(duty), duty.omega, float(np.angle(X2))))
    elif duty.c:
        moving |= _damped(duty, end, size, time, push)
    else:
        for i in (0, 1):
            moving |= _from_start(duty.driven, i, f"x{i + 1}", size, time)
        with precise():
            k2 = rounded("the pull of spring 2", exact(duty.k2).scaleb(size.exponent - push.exponent))
        moving["pull_now"] = derived(k2 * (var("x2") - var("x1")))
    if parts:
        X = complex(duty.damped.particular[0]) if duty.c else complex(duty.driven.particular[0])
        moving["x1_p"] = sines(size, time, (abs(X), duty.omega, cmath.phase(X)))
        moving["x1_c"] = derived(var("x1") - var("x1_p"))
    moving["pull"] = derived(var("pull_now") / push.place(duty.F_0))
    return moving


def _from_start(driven: DrivenModes, i: int, name: str, size: Axis, time: Axis) -> dict[str, AnySignal]:
    """The motion of mass i (0, 1) under `name`: the response to the drive, and the free motion of a start."""
    terms = zip(driven.coupling[:, i].tolist(), driven.free.omega.tolist(), strict=True)
    response = responses(size, time, *((driven.F_0, c, driven.omega, omega_n) for c, omega_n in terms if c))
    if not any((*driven.x_0, *driven.v_0)):
        return {name: response}
    free = driven.free
    swings = [(free.amplitude[j, i], free.omega[j], free.phase[j]) for j in (0, 1) if free.amplitude[j, i]]
    moving = sines(size, time, *swings, line=(float(free.drift_a[i]), float(free.drift_b[i])))
    return {f"{name}_driven": response, f"{name}_free": moving, name: total(f"{name}_driven", f"{name}_free")}


def pull(duty: Duty) -> float:
    """The amplitude of the force of spring and damper, which is what mass 2 needs: m2 omega^2 |X2|."""
    with precise():
        return rounded("the pull of spring 2", exact(duty.m2) * exact(duty.omega) ** 2 * exact(abs(complex(duty.X[1]))))


def _damped(duty: Duty, end: float, size: Axis, time: Axis, push: Axis) -> dict[str, AnySignal]:
    """x1, x2 and the pull of spring and damper from rest, as decaying sines; where two decay alike, from a table."""
    if duty.alike:
        return _tables(duty, end, size, time, push)
    transient = duty.damped.transient
    signals: dict[str, AnySignal] = {}
    for i, X in enumerate(duty.damped.particular[:2].tolist()):
        terms = [_wave(amplitudes[0, i], exponent) for exponent, amplitudes in transient]
        signals[f"x{i + 1}"] = sines(size, time, (abs(X), duty.omega, cmath.phase(X)), *terms)
    # m2 x2'' is what spring and damper pull at mass 2 with; at mass 1 they pull the other way.
    X2 = duty.m2 * duty.omega**2 * complex(duty.damped.particular[1])
    pulls = [_wave(-duty.m2 * exponent**2 * amplitudes[0, 1], exponent) for exponent, amplitudes in transient]
    return signals | {"pull_now": sines(push, time, (abs(X2), duty.omega, cmath.phase(X2)), *pulls)}


def _wave(amplitude: complex, exponent: complex) -> tuple[float, float, float, float]:
    """Re(A exp(s t)) as a decaying sine."""
    return abs(amplitude), exponent.imag, cmath.phase(amplitude) + math.pi / 2, -exponent.real


def _tables(duty: Duty, end: float, size: Axis, time: Axis, push: Axis) -> dict[str, AnySignal]:
    last = 1.02 * end  # a table is periodic: it must not begin anew within the window
    t = np.linspace(0.0, last, NODES)
    motion = duty.from_rest_at(t)
    link = duty.k2 * motion.e[1] + duty.c * (motion.v[1] - motion.v[0])
    columns = {"x1": (size.places(motion.x[0]), size.places(motion.v[0]))}
    columns |= {"x2": (size.places(motion.x[1]), size.places(motion.v[1]))}
    columns |= {"pull_now": (push.places(link), np.gradient(push.places(link), t))}
    return {name: sampled(time, last, *pair) for name, pair in columns.items()}
