"""Oscillator: the scene of spring and mass, with x, v and a as one rotating arrow (D31, points 1 to 3)."""

from __future__ import annotations

from components.language.picture import Onward
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.parameters import displacement, mass, stiffness, velocity
from components.scene.case import CaseScene, ComparedNumber, example
from components.scenes.oscillator.case import OscillatorShown
from components.scenes.oscillator.paper import paper

PULLED = {"m": 1.0, "k": 39.4, "x_0": 0.15, "v_0": 0.0}


class OscillatorScene(CaseScene):
    slug = "oscillator"
    title = "Oscillator"
    lecture = "D31"
    points = "points 1 to 3"
    headline = "A swing is a turning arrow, seen from the side"
    spoken = {"natural frequency": "{omega} rad/s", "period": "{tau} s"}
    equations = (
        "m x'' + k x = 0",
        "omega_n = sqrt(k/m); v = x'; a = x''; x = x_0 and v = v_0 at t = 0",
    )
    shares = {"mass": "m", "stiffness": "k"}
    examples = (
        example(
            "Pulled", "Let go at rest, x starts at its peak; each peak of v is a quarter period before one of x.",
            PULLED,
        ),
        example(
            "Kicked", "It starts from the middle: all of its amplitude comes from v₀.", PULLED, x_0=0.0, v_0=0.8
        ),
        example(
            "Pushed back",
            "It starts away from the middle and moves towards it: the arrow starts where x₀ and v₀ put it.",
            PULLED, x_0=0.1, v_0=-0.8,
        ),
        example("Heavy", "Four times the mass of the others: it swings half as fast.", PULLED, m=4.0),
        example(
            "Stiff", "About four times the stiffness of the others: it swings about twice as fast.", PULLED, k=158.0
        ),
        example("Rest", "With x₀ = 0 and v₀ = 0 there is no arrow to turn.", PULLED, x_0=0.0),
        example(
            "No spring", "Nothing pulls it back: it moves on at constant speed.", PULLED, k=0.0, x_0=0.1, v_0=0.02
        ),
    )  # fmt: skip
    opens = {"x_0": PULLED["x_0"], "v_0": PULLED["v_0"]}
    old_view, old_views = "formulas", {"view": {"swing": "motion"}}

    m = mass(
        1.0, symbol="m", tint="m1", says="is the mass. Four times the mass swings half as fast. Any value above 0."
    )
    k = stiffness(39.4, symbol="k", says="is the stiffness of the spring. At 0 the mass is free. Any value from 0 up.")
    x_0 = displacement(
        0.1, symbol="x_0", tint="m1", softbounds=(-0.3, 0.3),
        says="is where the mass starts, away from the wall. Any number.",
    )  # fmt: skip
    v_0 = velocity(
        -0.8, symbol="v_0", tint="T", softbounds=(-2.0, 2.0),
        says="is the velocity at the start, positive away from the wall. Any number.",
    )  # fmt: skip
    views = (
        View(
            "Motion", "Pull the mass *m* out and let go: the tip of the turning arrow is always as high as *x*. Why?",
            keys=(x_0,), names=("stage", "plot:x"),
        ),
        View(
            "Speed, acceleration", "Let go, and watch the peaks: where is the mass fastest, and where does it turn?",
            keys=(x_0,), names=("plot:x", "plot:v"),
        ),
        View(
            "Force", "Pull the mass out and let go: where does the spring pull hardest, and where not at all?",
            keys=(x_0,), names=("stage", "plot:x", "plot:a"),
        ),
        View(
            "Formulas", "Drag the arrow at the start: it shows *A*, *B*, *C* and *φ* at once.",
            names=("stage:start", "words:constants"),
        ),
    )  # fmt: skip
    groups = (Group("Mass and spring", (m, k)), Group("Start", (x_0, v_0)))
    onward = (
        Onward(
            label="Open in Chain", scene="chain",
            given={"N": 1.0, "a": 3.0, "ends": "fixed-free", "starts": "mass", "p": 1.0},
            taken={"m": "m", "k": "k", "h": "x_0", "v_0": "v_0"},
        ),
        Onward(
            label="Compare with your file", scene="damped", given={"view": "measured", "c": 0.0, "keep": "c"},
            taken={name: name for name in ("m", "k", "x_0", "v_0")},
        ),
    )  # fmt: skip

    case = OscillatorShown
    paper = staticmethod(paper)
    compared = (
        ComparedNumber("omega", "ω_n", "rad/s"),
        ComparedNumber("tau", "τ", "s"),
        ComparedNumber("C", "C", "m", "m1"),
        ComparedNumber("phi", "φ", "rad", angle=True),
    )
