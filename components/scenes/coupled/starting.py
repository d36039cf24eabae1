"""The start of a motion: by starting values, or by amplitude and phase of each mode. One follows from the other."""

from __future__ import annotations

import math
from typing import Protocol

from components import chain
from components.chain.parameters import Pair
from components.chain.signals import Signals as S
from components.language.signals import AnySignal
from components.quantities.axes import Axis
from components.quantities.declared import by_name
from components.quantities.motion import sines
from components.quantities.parameters import Quantity, Values, finite, not_negative
from physics.coupled import FreeModes, free_modes
from physics.modal_start import amplitudes_and_phases, modes_given, start_given

SIZES, PHASES = ("X_slow", "X_fast"), ("phi_slow", "phi_fast")
BY_MODES = ("X_slow", "phi_slow", "X_fast", "phi_fast")
MOST = 100.0
"""rad; a phase is no further from 0."""
SAME = 16 * 2.0**-53
"""Starting values as near as this to those of the modes, over the amplitudes, are theirs but for roundings."""


GIVEN = {"values": "Starting values", "modes": "Modes"}
"""The choices of `given_by`: whether starting values or the modes' amplitudes and phases set the motion."""


class Begun(Protocol):
    """The scene whose motion is begun, as far as it is not known by the names of its parameters."""

    given_by: str


def amplitude(mode: str, sign: str, default: float) -> Quantity:
    says = f"is the amplitude of mass 1 in the {mode} mode; without spring 2, of the mass that moves. Any value from 0."
    return not_negative(
        default, symbol=f"X_{sign}", unit="m", label=f"amplitude of the {mode} mode", tint=mode,
        allowed="an amplitude is a finite number, 0 or more", softbounds=(0.0, 1.0), says=says,
    )  # fmt: skip


def phase(mode: str, sign: str, default: float) -> Quantity:
    return finite(
        default, symbol=f"φ_{sign}", unit="rad", label=f"phase of the {mode} mode", tint=mode,
        bounds=(-MOST, MOST), softbounds=(-math.pi, math.pi),
        allowed=f"a phase is from −{MOST:g} to {MOST:g} rad",
        says=f"is the phase of the {mode} mode at the start. At π/2 it starts from its turning point.",
    )  # fmt: skip


def motion(scene: Begun) -> FreeModes:
    """The motion that the parameters stand for."""
    system = chain.of_scene(scene)
    if scene.given_by == "values":
        return free_modes(system, *chain.start_of(scene))
    return modes_given(system, *by_modes(scene))


def by_modes(scene: Begun) -> tuple[Pair, Pair]:
    """The amplitudes, and the phases, of the slow and the fast mode."""
    sizes, phases = ((getattr(scene, slow), getattr(scene, fast)) for slow, fast in (SIZES, PHASES))
    return sizes, phases


def turns(scene: Begun, omega: Pair, time: Axis) -> dict[str, AnySignal]:
    """Where modes give the motion, how far each has turned, in rad: the argument of its sine."""
    if scene.given_by == "values":
        return {}
    lines = zip(chain.MODES, by_modes(scene)[1], omega, strict=True)
    return by_name({S.turn[mode]: sines(Axis(0.0, 1.0), time, line=(phase, rate)) for mode, phase, rate in lines})


def followed(scene: Begun, changed: frozenset[str], before: str, *, in_hand: bool) -> Values:
    """The parameters that follow from a change, before which the motion was given by `before`. A start that is typed
    gives the motion itself; one that a hand sets has its modes, where these give it."""
    if changed.intersection(chain.START) and not changed.intersection((*BY_MODES, "given_by")):
        return _modes(scene) if in_hand and scene.given_by == "modes" else {"given_by": "values"}
    if scene.given_by == "values" and not changed.intersection(BY_MODES):
        return {}
    taken: dict[str, float] = {}
    if before == "values":
        taken = {name: value for name, value in _modes(scene).items() if name not in changed}
    values = {name: getattr(scene, name) for name in BY_MODES} | taken
    return {"given_by": "modes", **taken, **_start(scene, values)}


def opened(scene: Begun) -> Values:
    """The starting values that follow from a state, which says how the motion is given."""
    return {} if scene.given_by == "values" else _start(scene, {name: getattr(scene, name) for name in BY_MODES})


def _modes(scene: Begun) -> dict[str, float]:
    """Amplitude and phase of each mode, of the starting values; ValueError where one drifts."""
    sizes, phases = amplitudes_and_phases(free_modes(chain.of_scene(scene), *chain.start_of(scene)))
    return dict(zip((*SIZES, *PHASES), (*sizes, *phases), strict=True))


def _start(scene: Begun, values: dict[str, float]) -> dict[str, float]:
    """The starting values of modes, where they are others than those that stand, but for roundings."""
    sizes, phases = ((values[slow], values[fast]) for slow, fast in (SIZES, PHASES))
    free = modes_given(chain.of_scene(scene), sizes, phases)
    x_0, v_0 = start_given(free)
    reach = [float(sum(abs(free.amplitude[:, i]))) + abs(x_0[i]) for i in (0, 1)]
    rates = [float(sum(abs(free.amplitude[:, i] * free.omega))) for i in (0, 1)]
    rows = zip(chain.START, (*x_0, *v_0), (*reach, *rates), strict=True)
    return {name: value for name, value, size in rows if abs(getattr(scene, name) - value) > SAME * size}
