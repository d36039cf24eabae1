"""Analogues: the scene of one equation in nine systems, and of the pendulum at any amplitude (D31, point 7)."""

from __future__ import annotations

import math

from components.language.picture import Pace
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.motion import pace
from components.quantities.parameters import one_of
from components.quantities.readouts import Readout, SceneNumber
from components.scene import Picture, Scene
from components.scene.about import About
from components.scene.frames import FITTED, framed
from components.scenes.analogues.about import analogue_about
from components.scenes.analogues.case import MOST_HALF_WAVES, AnalogueCase
from components.scenes.analogues.controls import SHORT, SWINGING, groups, quantities, start_angle
from components.scenes.analogues.curves import (
    Signals,
    Swinging,
    axes_of,
    columns_of,
    scalars_of,
    table_axes,
    traces_of,
)
from components.scenes.analogues.numbers import Forms
from components.scenes.analogues.numbers import Numbers as N
from components.scenes.analogues.pictures import tiles
from components.scenes.analogues.sheet import analogue_sheet
from components.scenes.analogues.watch import WATCH
from physics.analogues import ANALOGUES

QUANTITIES = quantities()
"""The other parameters: those of the nine systems, from the table of physics.analogues."""
UNHURRIED = (0.5, 10.0)
"""Periods in s that are easy to watch in real time."""

USUAL = {
    "system": "pendulum",
    "theta_0": 60.0,
    "pendulum_l": 1.0,
    "string_T": 70.0,
    "circuit_L": 1e-3,
    "circuit_C": 2.5e-8,
    "wave_wavelength": 100.0,
    "shaft_J": 0.5,
    "shaft_k_t": 2000.0,
}


class Analogues(Scene):
    slug = "analogues"
    title = "Analogues"
    lecture = "D31"
    points = "point 7"
    headline = "Nine systems, one equation for small swings"
    spoken = {"period": N.period, "frequency": N.frequency}
    equations = (
        "inertia q'' + stiffness q = 0; of a pendulum and a rocking body: theta'' + omega_n^2 sin(theta) = 0",
        "omega_n = sqrt(stiffness/inertia); x is the spring and mass of equal numbers",
    )
    shares = {"mass": "spring_m", "stiffness": "spring_k"}
    sharing = {"system": "spring"}
    start = "Examples"
    start_folded = True
    watch = WATCH
    presets = {
        "10°": {**USUAL, "theta_0": 10.0},
        "60°": USUAL,
        "Clock": {**USUAL, "pendulum_l": 0.994, "theta_0": 3.0},
        "Nearly over": {**USUAL, "theta_0": 179.0},
        "Guitar": {**USUAL, "system": "string", "string_T": 73.45},
        "Radio": {**USUAL, "system": "circuit", "circuit_L": 1e-4, "circuit_C": 2.53e-10},
        "Swell": {**USUAL, "system": "wave", "wave_wavelength": 200.0},
        "Cavendish": {**USUAL, "system": "shaft", "shaft_J": 1.25, "shaft_k_t": 7e-5},
    }
    opens = {"theta_0": 10.0}

    system = one_of("pendulum", SHORT, "System", "The system shown.")

    theta_0 = start_angle()
    views = (
        View(
            "Roles", "Choose a system: what has the role of the mass, and what that of the spring?",
            keys=(system,), names=("stage", "keys", "table"),
        ),
        View(
            "Motion", "Pull the system and let go: does it keep step with the spring next to it?",
            keys=(system,), names=("stage", "keys", "plot:motion"),
        ),
        View(
            "Large swings", "Drag *θ*_0: from which angle on does one swing take 1 % longer?",
            keys=(system, theta_0), names=("stage", "keys", "plot:late"),
        ),
        View(
            "Formula", "Choose a system: what of it sets the frequency, and what drops out?",
            keys=(system,), names=("keys", "words:formula"),
        ),
    )  # fmt: skip
    groups = (Group("System", (system,), pictures=tiles()), *groups(QUANTITIES, theta_0))

    sheet = staticmethod(analogue_sheet)

    def picture(self, frame: Frame = FITTED) -> Picture:
        case = self._case(frame.window)
        axes = framed(frame, axes_of(case))
        counted, moving = axes | table_axes(case), Swinging if case.pendulum else Signals
        return Picture(
            columns=columns_of(case, axes),
            axes=axes,
            signals=moving.signals(case, counted),
            traces={"time": traces_of(case)},
            scalars=scalars_of(case, axes),
            pace=_pace(case),
            values=N.texts(case, counted),
            live=moving.live(counted),
            forms=Forms.forms(case),
            notes=_notes(case),
        )

    def _case(self, frame_window: float | None = None) -> AnalogueCase:
        system = ANALOGUES[self.system]
        p = {parameter.name: getattr(self, f"{self.system}_{parameter.name}") for parameter in system.parameters}
        start = math.radians(self.theta_0) if self.system in SWINGING else getattr(self, f"{self.system}_start")
        return AnalogueCase(system=system, p=p, q_0=start, window=self.window, frame_window=frame_window)

    @property
    def numbers(self) -> dict[str, SceneNumber]:
        case = self._case()
        return {
            **N.numbers(case),
            "inertia": SceneNumber(case.spring.m, case.system.inertia_unit, "inertia, the role of the mass"),
            "stiffness": SceneNumber(case.spring.k, case.system.stiffness_unit, "stiffness, the role of the spring"),
        }

    def readouts(self) -> tuple[Readout, ...]:
        return N.readouts(self._case())

    def about(self, shown: Picture) -> About:
        return analogue_about(shown, self._case())


for _name, _quantity in QUANTITIES.items():
    Analogues.param.add_parameter(_name, _quantity)


def _pace(case: AnalogueCase) -> Pace:
    """Play a period of a few seconds in real time, even if small amplitudes would be played differently."""
    own = pace(2 * math.pi / case.period, case.omega)
    return Pace(1.0, own.limit) if UNHURRIED[0] <= case.period <= UNHURRIED[1] else own


def _notes(case: AnalogueCase) -> tuple[str, ...]:
    if case.p.get("n", 1.0) > MOST_HALF_WAVES:
        return (f"The picture shows {MOST_HALF_WAVES} half waves; the numbers are those of n.",)
    return ()
