"""Energy: the scene of a hanging mass and its energies. Gravity only shifts its equilibrium (D31, points 4 to 6)."""

from __future__ import annotations

from components.layout.controls import Group
from components.layout.views import View
from components.quantities.parameters import Values, displacement, mass, not_negative, one_of, positive, velocity
from components.scene.case import CaseScene, ComparedNumber, example
from components.scenes.energy.case import PLANETS, EnergyShown
from components.scenes.energy.paper import ENERGY, paper

PULLED = {"m": 1.0, "k": 39.4, "x_0": 0.2, "v_0": 0.0}


class Energy(CaseScene):
    slug = "energy"
    title = "Energy"
    lecture = "D31"
    points = "points 4 to 6"
    headline = "Energy swings between motion and position; the sum stays constant"
    spoken = {
        "natural frequency": "{omega} rad/s",
        "period": "{tau} s",
        "energy": "{E_total} {E_unit}",
        "static deflection": "{delta_st}",
    }
    equations = (
        "m x'' + k x = 0; x downwards from equilibrium",
        "T = m v^2/2; delta_st = m g/k",
        "V = k x^2/2; with datum = separate larger by m g delta_st/2",
    )
    places = tuple(PLANETS)
    shares = {"mass": "m", "stiffness": "k"}
    examples = (
        example(
            "Pulled down", "T is largest where x passes 0, V where the mass turns; the sum stays constant.", PULLED
        ),
        example("Pushed up", "As far up as it was pulled down: the same energy.", PULLED, x_0=-0.2),
        example(
            "Kicked at equilibrium", "It starts with its largest T; a quarter period later T is 0.", PULLED,
            x_0=0.0, v_0=1.2,
        ),
        example(
            "Heavy", "Twice the mass hangs twice as deep, and swings more slowly with the same T at its largest.",
            PULLED, m=2.0,
        ),
        example(
            "Soft", "On a softer spring it swings more slowly, and where there is gravity it hangs deeper.", PULLED,
            k=20.0,
        ),
        example("Hanging still", "At rest in equilibrium nothing swings: x and T stay 0.", PULLED, x_0=0.0),
    )  # fmt: skip

    m = mass(
        1.0,
        symbol="m",
        tint="m1",
        says="is the mass. It sets where it hangs and how fast it swings. Any value above 0.",
    )
    k = positive(
        39.4, symbol="k", unit="N/m", label="stiffness", tint="k", scale="log", softbounds=(1.0, 200.0),
        says="is the stiffness of the spring. Any value above 0: a weight cannot hang on nothing.",
    )  # fmt: skip
    g = not_negative(
        9.81, symbol="g", unit="m/s²", label="gravity", softbounds=(0.0, 30.0),
        allowed="gravity is a finite number, 0 or more",
        says="is the gravity. It moves the equilibrium, and not the swing. Any value from 0 up.",
    )  # fmt: skip
    x_0 = displacement(
        0.2, symbol="x_0", tint="m1", softbounds=(-0.3, 0.3),
        says="is how far down it is pulled at the start. Any number.",
    )  # fmt: skip
    v_0 = velocity(
        0.0, symbol="v_0", tint="m1", softbounds=(-2.0, 2.0),
        says="is the velocity at the start, positive downwards. Any number.",
    )  # fmt: skip
    datum = one_of(
        "equilibrium",
        {"equilibrium": "Equilibrium", "separate": "Spring + gravity", "slide": "Three terms"},
        "Datum of V",
    )
    views = (
        View(
            "Energy",
            "Pull the mass *m* down and let go: where is all energy motion *T*, where position *V*? What stays?",
            keys=(x_0,), names=("stage", "plot:energy"),
        ),
        View(
            "Well", "Let the ball roll: where does it turn, and where is it fastest?", keys=(x_0,),
            names=("plot:well",),
        ),
        View(
            "Motion, gravity", "Change gravity *g*: what changes, where the mass hangs, or how fast it swings?",
            keys=(g,), names=("stage", "plot:x"),
        ),
        View(
            "Formulas", "Follow the lines to the equation of motion: the sum *T* + *V* is constant.",
            names=("words:law",),
        ),
    )  # fmt: skip
    groups = (
        Group("Mass and spring", (m, k)),
        Group("Start", (x_0,)),
        Group("", (v_0,), "Start velocity", folded=True),
        Group("", (g,), "Gravity", actions=tuple((slug, name) for slug, (name, _) in PLANETS.items()), folded=True),
        Group("V is counted from", (datum,)),
    )

    case = EnergyShown
    paper = staticmethod(paper)
    compared = (
        ComparedNumber("omega", "ω_n", "rad/s"),
        ComparedNumber("tau", "τ", "s"),
        ComparedNumber("E_total", "E", "J", of="T_max"),
        ComparedNumber("delta_st", "δ_{st}", "m", of="delta"),
    )

    def action(self, name: str) -> Values:
        return {"g": PLANETS[name][1]}
