"""Damped: a mass on a spring and a dashpot, which takes the same share of every swing (D32)."""

from __future__ import annotations

from components.dashpot import DashpotScene, keeping, parts
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.parameters import displacement, velocity
from components.scene.case import CaseScene, ComparedNumber, example
from components.scenes.damped.case import DampedShown
from components.scenes.damped.paper import paper

LIGHT = {"m": 1.0, "c": 1.257, "k": 39.48, "x_0": 0.1, "v_0": 0.0, "keep": "c"}
CAR = {**LIGHT, "m": 300.0, "c": 1500.0, "k": 2e4, "x_0": 0.05}


class Damped(DashpotScene, CaseScene):
    slug = "damped"
    title = "Damped"
    lecture = "D32, D33"
    points = "free vibration with a dashpot"
    headline = "A dashpot takes the same share of every swing, or stops the first"
    spoken = {"damping ratio": "{zeta}", "natural frequency": "{omega} rad/s", "each swing keeps": "{keep}"}
    equations = (
        "m x'' + c x' + k x = 0",
        "omega_n = sqrt(k/m); zeta = c/(2 m omega_n); omega_d = omega_n sqrt(1 - zeta^2); delta = 2 pi zeta "
        "omega_n/omega_d",
        "T = m v^2/2; V = k x^2/2; P = c v^2; E = T + V; E_0 - E is heat",
    )
    examples = (
        example(
            "Light",
            "Four drops, four lengths, one factor: × 0.532. It stays below 1 % of its start only after 7.13 s.",
            LIGHT,
        ),
        example("Car", "ζ 0.306: it overshoots by 36.4 %, and stays below 5 % of its start after 0.976 s.", CAR),
        example(
            "Worn", "A fifth of the car's damping: each swing keeps 68 %; below 5 % of its start after 5.84 s.", CAR,
            c=300.0,
        ),
        example(
            "Door closer", "ζ 1.5: it shuts without a slam, and is 8 mm from shut after 8.31 s.", LIGHT,
            m=20.0, c=90.0, k=45.0, x_0=0.8,
        ),
        example(
            "Critical",
            "It falls to 1 % of its start in 1.06 s; ζ 3 takes 4.30 s; ζ 0.83, which goes 1 % past 0, 0.674 s.",
            LIGHT, c=12.566622,
        ),
        example(
            "Thrown", "It passes 0 once at 0.0506 s and turns at −0.0525 m; 98.8 % is heat after 0.2 s.", LIGHT,
            c=18.85, v_0=-3.0,
        ),
        example(
            "No dashpot", "Envelope and staircase are gone, and the roots sit on the axis: nothing is lost.", LIGHT,
            c=0.0,
        ),
    )  # fmt: skip

    m, k, c, zeta = parts(1.0, 39.48, 1.257)
    keep = keeping()
    x_0 = displacement(
        0.1, symbol="x_0", tint="m1", softbounds=(-0.3, 0.3),
        says="is where the mass starts, away from the wall. Any number.",
    )  # fmt: skip
    v_0 = velocity(
        0.0, symbol="v_0", tint="m1", softbounds=(-3.0, 3.0),
        says="is the velocity at the start, positive away from the wall. Any number.",
    )  # fmt: skip
    views = (
        View(
            "Motion",
            "Turn up the damping *ζ*: where does the swinging end, and does still more bring the mass *m* home sooner?",
            keys=(zeta,), names=("stage", "plot:x"),
        ),
        View(
            "Roots",
            "Drag the black dot: left it decays faster, up it swings faster. Where does the swinging end?",
            keys=(zeta,), names=("plot:roots",),
        ),
        View(
            "Energy", "Watch the coloured areas: when does the dashpot take most of the energy?",
            keys=(zeta,), names=("plot:energy",),
        ),
        View(
            "Forces", "Watch both arrows: where does the dashpot pull hardest, and where not at all?",
            keys=(zeta,), names=("stage", "plot:x"),
        ),
        View(
            "Formulas", "Change one value, and watch the numbers in each formula.", keys=(zeta,),
            names=("plot:x", "words:formulas"),
        ),
        View(
            "Measured", "Drop or choose a file of your own motion: does the model pass through your points?",
            keys=(zeta,), names=("plot:x", "measured:file"),
        ),
    )  # fmt: skip
    groups = (
        Group("Mass, spring, dashpot", (m, k, c, zeta)),
        Group("When m or k changes", (keep,)),
        Group("Start", (x_0, v_0)),
    )

    case = DampedShown
    paper = staticmethod(paper)
    compared = (
        ComparedNumber("omega", "ω_n", "rad/s"),
        ComparedNumber("zeta", "ζ", tint="T"),
        ComparedNumber("rate", "c/m", "1/s", tint="T"),
        ComparedNumber("omega_d", "ω_d", "rad/s", tint="m1"),
        ComparedNumber("delta", "δ"),
    )
