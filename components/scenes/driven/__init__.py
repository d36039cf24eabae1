"""Driven: one damped mass under a force, a shaken base or an unbalance, through its resonance (D33)."""

from __future__ import annotations

import math

from components.dashpot import DashpotScene, keeping, parts
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.parameters import (
    angular_frequency,
    count,
    displacement,
    force,
    not_negative,
    one_of,
    positive,
    velocity,
)
from components.scene.case import CaseScene, ComparedNumber, example
from components.scenes.driven.case import KINDS
from components.scenes.driven.convolution import SLICED
from components.scenes.driven.paper import AXES, JOLTS, KIND_FORMS, PULSES, PUSHES, paper
from components.scenes.driven.plots import REPEATS
from components.scenes.driven.shown import DrivenShown

NATURAL = math.sqrt(39.48)
"""The natural frequency of the presets, in rad/s: a period of one second."""
BELOW = {
    "kind": "force", "push": "sine", "F_0": 2.0, "Y": 0.05, "moment": 0.05, "omega": 4.398, "m": 1.0, "k": 39.48,
    "c": 2.513, "keep": "c", "x_0": 0.0, "v_0": 0.0, "width": 0.2, "J": 0.5, "slices": 12.0,
}  # fmt: skip


class DrivenScene(DashpotScene, CaseScene):
    slug = "driven"
    title = "Driven"
    lecture = "D32, D33"
    points = "forced vibration with a dashpot"
    headline = "At resonance only the dashpot balances the push"
    spoken = {"size of the swing": "{X} m", "r": "{r}", "lag": "{phi} rad"}
    equations = (
        "kind = force: m x'' + c x' + k x = F_0 sin(omega t)",
        "other pushes: m x'' + c x' + k x = F(t) of the size F_0 or J and the period 2 pi/omega",
        "kind = base: m x'' + c (x' - y') + k (x - y) = 0; y = Y sin(omega t)",
        "kind = unbalance: m x'' + c x' + k x = moment omega^2 sin(omega t); moment = m_0 e",
        "r = omega/omega_n; M = |X| over F_0/k or over Y or over moment/m; lag = -arg X",
        "power = 2 zeta (r M)^2: the power lost over its largest; times Q = 1/(2 zeta)",
        "P_in and P_lost are means over the last 2 pi/omega; 0 before t = 0",
    )
    examples = (
        example("Below", "kX is 1.72 pushes, inertia takes 0.842 of it away; x lags 0.502 rad.", BELOW),
        example(
            "Resonance", "A rectangle: kX and mω²X are 2.5 pushes each, cωX exactly one.", BELOW, omega=6.2833
        ),
        example("Above", "Inertia is 1.29 pushes; x lags 2.88 rad, nearly against the push.", BELOW, omega=12.566),
        example(
            "Strong dashpot", "No peak: at r = 1 the swing is 0.625 of F₀/k.", BELOW, omega=6.2833, c=10.05
        ),
        example(
            "No dashpot", "Straight envelopes: the power put in grows, and none is lost.", BELOW, omega=NATURAL, c=0.0
        ),
        example(
            "Beats", "X is 0.267 m, yet it reaches up to 0.505 m: beats of 10.0 s, for ever.", BELOW, omega=5.655, c=0.0
        ),
        example(
            "Washboard", "0.704 of the base; with ζ = 1 it would be 0.942, with ζ = 0.05 0.646.", BELOW,
            kind="base", omega=10.053,
        ),
        example(
            "Spin-dry", "1.62, towards 1 above; on the way up it passes 2.55 at r = 1.04.", BELOW,
            kind="unbalance", omega=9.425,
        ),
        example(
            "Harmonic", "A square push, and three swings in each: harmonic 3 is at the peak, 0.135 m.", BELOW,
            push="square", omega=2.0944, c=1.0,
        ),
    )  # fmt: skip

    kind = one_of("force", {"force": "Force", "base": "Shaken base", "unbalance": "Unbalance"}, "The drive")
    push = one_of("sine", {
        "sine": "Sine", "square": "Square", "triangle": "Triangle", "pulses": "Pulses", "impulses": "Impulses",
        "step": "Step", "impulse": "One impulse",
    }, "The push")  # fmt: skip
    width = positive(
        0.2, symbol="w", unit="", label="width", tint="F", softbounds=(0.05, 0.95), bounds=(0.0, 1.0),
        inclusive_bounds=(False, False), allowed="a width is a share of the period, above 0 and below 1",
        says="is the share of each period in which the pulse acts, above 0 and below 1.",
    )  # fmt: skip
    slices = count(
        12, symbol="N", label="slices", tint="F", softbounds=(1.0, 60.0), bounds=(1.0, 200.0),
        allowed="a push is cut into 1 to 200 slices", says="is the number of slices of the push, from 1 to 200.",
    )  # fmt: skip
    physical = (kind, push)
    covered_with = {
        "response": ("harmonics",), "harmonics": ("response",), "x": ("pushed", "sum"), "pushed": ("x", "sum"),
        "sum": ("x", "pushed"),
    }  # fmt: skip
    F_0 = force(2.0, says="is the amplitude of the force. Type any value from 0 up.")
    J = not_negative(
        0.5, symbol="J", unit="N s", label="impulse", tint="F", softbounds=(0.0, 2.0),
        says="is the force times its short duration: it changes the velocity by J/m. Any value from 0 up.",
    )  # fmt: skip
    Y = not_negative(
        0.05, symbol="Y", unit="m", label="amplitude of the base", tint="F", softbounds=(0.0, 0.2),
        says="is how far the base is shaken to each side. Any value from 0 up.",
    )  # fmt: skip
    moment = not_negative(
        0.05, symbol="m₀e", unit="kg m", label="unbalance", tint="F", softbounds=(0.0, 0.2),
        says="is the mass that turns times its distance from the axle. Any value from 0 up.",
    )  # fmt: skip
    omega = angular_frequency(
        4.398, softbounds=(0.0, 2.5 * NATURAL), says="is the frequency of the drive. Any value from 0 up."
    )
    m, k, c, zeta = parts(1.0, 39.48, 2.513, k_may_be_0=False)
    keep = keeping()
    x_0 = displacement(symbol="x_0", tint="m1", softbounds=(-0.3, 0.3), says="is where the mass starts. Any number.")
    v_0 = velocity(symbol="v_0", tint="m1", softbounds=(-3.0, 3.0), says="is the velocity at the start. Any number.")
    axes = AXES
    views = (
        View(
            "Response",
            "Drag the dot through the peak: when does the mass *m* go with the push *F*_0, when against it?",
            keys=(omega,), names=("stage", "plot:response"),
        ),
        View(
            "Motion", "Change *ω*: what dies out after the start, and what remains?",
            keys=(omega,), names=("stage", "plot:x"),
        ),
        View(
            "Harmonics", "Choose a push and change *ω*: which of its harmonics hits the peak?",
            keys=(push, omega), names=("stage", "plot:harmonics", "keys"),
        ),
        View(
            "Convolution", "Add slices: when does the sum follow the exact motion?",
            keys=(slices,), names=("plot:sum", "plot:force", "keys"),
        ),
        View(
            "Forces", "Drag *ω* through the peak: which arrow balances the push below it, at it, and above it?",
            keys=(omega,), names=("stage:forces", "plot:response"),
        ),
        View(
            "Power", "Change *ω*: when does the drive put in most, and where does it all go?",
            keys=(omega,), names=("plot:x", "plot:power"),
        ),
        View(
            "Formulas", "Change one value, and watch the numbers in each formula.",
            keys=(omega,), names=("words:formulas",),
        ),
    )  # fmt: skip
    groups = (
        Group("Drive", (kind,)),
        Group("", (omega,), form=REPEATS, idle_when_hidden=True),
        *(Group("", (one,), form=KIND_FORMS[kind]) for kind, one in zip(KINDS, (F_0, Y, moment), strict=True)),
        Group("", (push,), form=PUSHES, idle_when_hidden=True),
        Group("", (width,), form=PULSES, idle_when_hidden=True),
        Group("", (J,), form=JOLTS, idle_when_hidden=True),
        Group("", (slices,), form=SLICED, idle_when_hidden=True),
        Group("Mass, spring, dashpot", (m, k, c, zeta), dense=True),
        Group("", (x_0, v_0), "Start", folded=True),
        Group("When m or k changes", (keep,)),
    )

    case, paper = DrivenShown, staticmethod(paper)
    compared = (
        ComparedNumber("r", "r", tint="F"),
        ComparedNumber("zeta", "ζ", tint="T"),
        ComparedNumber("X", "X", "m", "m1"),
        ComparedNumber("phi", "φ", "rad", "m1", angle=True),
    )
