"""Coupled: the scene in which every free motion of two masses is a slow plus a fast mode (D34, points 1, 2 and 5)."""

from __future__ import annotations

import math
from typing import Self

from components import chain
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.parameters import Quantity, Values, finite, not_negative, one_of
from components.scene.case import CaseScene, ComparedNumber, example
from components.scenes.coupled.case import CoupledShown
from components.scenes.coupled.paper import ENERGY, GIVEN_BY_MODES, paper
from physics.coupled import free_modes
from physics.modal_start import amplitudes_and_phases, modes_given, start_given

BOTH = {
    "m1": 2.0, "m2": 1.0, "k1": 4.0, "k2": 2.0, "x1_0": 1.0, "x2_0": 0.0, "v1_0": 0.0, "v2_0": 0.0,
    "given_by": "values",
}  # fmt: skip
BY_MODES = ("X_slow", "phi_slow", "X_fast", "phi_fast")
"""The parameters of the modes that determine the motion."""
MOST = 100.0
"""Limits of a phase in rad."""
SAME = 16 * 2.0**-53
"""Relative tolerance: initial values this close to those of the modes differ from them only by rounding."""


def amplitude(mode: str, sign: str, default: float) -> Quantity:
    says = f"is the amplitude of mass 1 in the {mode} mode; without spring 2, of the mass that moves. Any value from 0."
    return not_negative(
        default, symbol=f"X_{sign}", unit="m", label=f"amplitude of the {mode} mode", tint=mode,
        allowed="an amplitude is a finite number, 0 or more", softbounds=(0.0, 1.0), says=says,
    )  # fmt: skip


def phase(mode: str, sign: str) -> Quantity:
    return finite(
        math.pi / 2, symbol=f"φ_{sign}", unit="rad", label=f"phase of the {mode} mode", tint=mode,
        bounds=(-MOST, MOST), softbounds=(-math.pi, math.pi),
        allowed=f"a phase is from −{MOST:g} to {MOST:g} rad",
        says=f"is the phase of the {mode} mode at the start. At π/2 it starts from its turning point.",
    )  # fmt: skip


class Coupled(CaseScene):
    slug = "coupled"
    title = "Coupled"
    lecture = "D34"
    points = "points 1, 2, 5"
    headline = "Every free motion is a slow mode plus a fast mode"
    spoken = {
        "slow mode": "{omega_minus} rad/s",
        "fast mode": "{omega_plus} rad/s",
        "energy": "{E_total} {E_unit}",
    }
    equations = chain.FREE
    onward = (chain.measured_by(),)
    shares = chain.SHARES
    examples = (
        example("Both", "Two modes at once: x₁ and x₂ are sums of the same two sines.", BOTH),
        example(
            "Slow", "Released in the shape of the slow mode, both masses swing the same way, in one sine.", BOTH,
            x1_0=0.4, x2_0=0.8,
        ),
        example(
            "Fast", "Released in the shape of the fast mode, the masses swing opposite ways, in one sine.", BOTH,
            x1_0=0.7, x2_0=-0.7,
        ),
        example(
            "Beats", "The energy wanders from mass 1 to mass 2 and back.", BOTH,
            m1=1.0, k1=0.96, m2=0.04, k2=0.04, x1_0=0.2,
        ),
        example(
            "All equal", "The ratio of 0.618 and 1.618 rad/s is irrational, so the motion never repeats.", BOTH,
            m1=1.0, m2=1.0, k1=1.0, k2=1.0,
        ),
        example(
            "Drift", "Without spring 1 the pair moves off at constant speed, and swings about its centre of mass.",
            BOTH, k1=0.0, x1_0=0.3, v1_0=0.2, v2_0=0.2,
        ),
        example(
            "Heavy, light", "The light mass shows both modes; the heavy one swings nearly as if it were alone.", BOTH,
            m1=10.0, m2=0.1, k1=10.0, k2=1.0, x1_0=0.5,
        ),
    )  # fmt: skip

    m1, m2, k1, k2 = chain.masses_and_springs(2.0, 1.0, 4.0, 2.0)
    x1_0, x2_0 = chain.start_positions(1.0)
    v1_0, v2_0 = chain.start_velocities()
    given_by = one_of("values", {"values": "Starting values", "modes": "Modes"}, "The motion is given by")
    X_slow = amplitude("slow", "−", 1 / 3)
    phi_slow = phase("slow", "−")
    X_fast = amplitude("fast", "+", 2 / 3)
    phi_fast = phase("fast", "+")
    energy = ENERGY
    views = (
        View(
            "Motion",
            "Pull mass 1, hold mass 2, let both go: find the slow part and the fast part in the motion of mass 1.",
            keys=(x1_0, x2_0), names=("stage", "plot:x1", "plot:x2"),
        ),
        View(
            "Energy", "Pull mass 1 and let go: which energies come and go, and which never change?",
            keys=(x1_0, x2_0), names=("stage", "plot:energy"),
        ),
        View(
            "x₂ against x₁", "Drag the dot: from which starts is the path a straight line?",
            keys=(x1_0, x2_0), names=("plot:plane",), word="plane",
        ),
        View(
            "Forces", "Watch the arrows: when does spring 2 pull mass 1 on, and when back?",
            keys=(x1_0, x2_0), names=("stage", "plot:x1", "plot:x2"),
        ),
        View(
            "Formulas", "Change one value, and watch the numbers in each formula.",
            keys=(x1_0, x2_0), names=("stage", "plot:x1", "plot:x2"),
        ),
        View(
            "Measured", "Drop or choose a file with both of your motions: do they have two frequencies only?",
            keys=(k1, k2), names=("plot:x1", "plot:x2", "measured:file"),
        ),
    )  # fmt: skip
    old_views = {"view": {"modes": "motion", "constants": "formulas"}}
    groups = (
        chain.chain_group(m1, m2, k1, k2),
        Group("Start", (x1_0, x2_0)),
        Group("", (X_slow, phi_slow, X_fast, phi_fast), form=GIVEN_BY_MODES, idle_when_hidden=True),
        Group("", (v1_0, v2_0, given_by), "Start velocities, or modes", folded=True),
    )

    case = CoupledShown
    paper = staticmethod(paper)
    compared = (
        ComparedNumber("omega_minus", "ω_{−}", "rad/s", "slow"),
        ComparedNumber("ratio_minus", "X₂/X₁_{−}", tint="slow", of="slow_ratio"),
        ComparedNumber("omega_plus", "ω_{+}", "rad/s", "fast"),
        ComparedNumber("ratio_plus", "X₂/X₁_{+}", tint="fast", of="fast_ratio"),
        ComparedNumber("E_minus", "E_{−}", "J", "slow"),
        ComparedNumber("E_plus", "E_{+}", "J", "fast"),
    )

    def following(self, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Values:
        """Return the parameters that depend on a change.

        Typed initial values are kept and the modes follow from them. During a drag it is the reverse, if the modes
        determine the motion.
        """
        if before is None:
            return {} if self.given_by == "values" else self._initial({})
        if changed.intersection(chain.START) and not changed.intersection((*BY_MODES, "given_by")):
            return self._modes() if in_hand and self.given_by == "modes" else {"given_by": "values"}
        if self.given_by == "values" and not changed.intersection(BY_MODES):
            return {}
        taken: dict[str, float] = {}
        if before.given_by == "values":
            taken = {name: value for name, value in self._modes().items() if name not in changed}
        return {"given_by": "modes", **taken, **self._initial(taken)}

    def _modes(self) -> dict[str, float]:
        """Return the amplitude and phase of each mode for the initial values. Raises ValueError if a mode drifts."""
        sizes, phases = amplitudes_and_phases(free_modes(chain.of_scene(self), *chain.start_of(self)))
        return dict(zip(("X_slow", "X_fast", "phi_slow", "phi_fast"), (*sizes, *phases), strict=True))

    def _initial(self, taken: Values) -> dict[str, float]:
        """Return the initial values that follow from the modes (those in `taken`, else the scene's), if they differ
        from the current ones by more than rounding errors."""
        given = {**{name: getattr(self, name) for name in BY_MODES}, **taken}
        sizes, phases = ((given[f"{of}_slow"], given[f"{of}_fast"]) for of in ("X", "phi"))
        free = modes_given(chain.of_scene(self), sizes, phases)
        x_0, v_0 = start_given(free)
        reach = [float(sum(abs(free.amplitude[:, i]))) + abs(x_0[i]) for i in (0, 1)]
        rates = [float(sum(abs(free.amplitude[:, i] * free.omega))) for i in (0, 1)]
        rows = zip(chain.START, (*x_0, *v_0), (*reach, *rates), strict=True)
        return {name: value for name, value, size in rows if abs(getattr(self, name) - value) > SAME * size}
