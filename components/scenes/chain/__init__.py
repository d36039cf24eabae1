"""Chain: N equal masses on springs, from two masses to waves on a string (D31, slide 7)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Self

from components.language.state import Frame
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.parameters import Quantity, Values, count, displacement, mass, one_of, positive, velocity
from components.scene import Picture
from components.scene.case import CaseScene, ComparedNumber, example
from components.scene.frames import FITTED
from components.scene.traces import TIME, Columns, Floats, Traces, samples
from components.scenes.chain.case import PARTS, MassesShown
from components.scenes.chain.paper import BY_MASS, BY_MODE, BY_PULSE, Y, paper

MOST = 500.0
LENGTH = 4.5
"""Length in m of the string of all examples. It has 1 kg per metre and a tension of 1 N: waves run at 1 m/s."""
MOST_NUMBERS, FEWEST = 100_000, 201
"""Largest number of displacements in a file with more than FEWEST rows, so that a file takes at most half a second."""
DIGITS = 12
"""Significant digits of m, k and a after a change of the number of masses."""


def string(N: int, ends: str = "fixed-fixed") -> dict[str, Any]:
    """Return the parameters of a chain of N masses that makes this string."""
    a = float(f"{LENGTH / (N + PARTS[ends]):.6g}")
    return {"N": float(N), "m": a, "k": float(f"{1 / a:.6g}"), "a": a, "ends": ends, "keep": "string", "way": "across"}


def numbered(default: float, symbol: str, label: str, says: str, **more: Any) -> Quantity:
    """A whole number from 1 to the largest number of masses."""
    allowed = f"a chain has 1 to {MOST:g} masses"
    return count(default, symbol=symbol, label=label, says=says, bounds=(1.0, MOST), allowed=allowed, **more)


PULSE = {**string(50), "starts": "pulse", "centre": 0.8, "width": 0.15, "h": 0.4, "v_0": 0.0, "j": 2.0, "p": 25.0}


class Chain(CaseScene):
    slug = "chain"
    title = "Chain"
    lecture = "Many"
    points = "D31 slide 7, waves; beyond the slides"
    headline = "Every mass adds a mode; many modes make a wave"
    spoken = {"slowest mode": "{slowest} rad/s", "fastest mode": "{fastest} rad/s"}
    equations = (
        "m x_p'' = k (x_(p-1) - 2 x_p + x_(p+1)); no spring at a free end",
        "omega_j = 2 sqrt(k/m) sin(theta_j/2); an ideal string has omega_j = sqrt(k/m) theta_j",
    )
    examples = (
        example("Pulse", "The fixed end sends it back upside down; fast ripples fall behind.", PULSE),
        example("Free end", "The free end sends it back upright.", PULSE, **string(50, "fixed-free")),
        example("Broad", "A broad pulse needs slow modes only: it runs as on a string.", PULSE, width=0.4, centre=1.4),
        example(
            "Plucked", "Modes 3 and 6 stay silent: mass 3 is a node of both.", PULSE, **string(8), starts="pluck", p=3.0
        ),
        example("One mass", "Most of the energy is in fast modes: ripples, and no pulse.", PULSE, starts="mass"),
        example(
            "Mode 2 of 3", "Mass 2 stands still; its neighbours swing opposite ways.", PULSE,
            **{**string(3), "way": "along"}, starts="mode", p=2.0,
        ),
        example(
            "Two", "The two masses of Coupled with equal springs: 0.618 and 1.62 rad/s.", PULSE,
            **{**string(2, "fixed-free"), "m": 1.0, "k": 1.0, "a": 1.8, "way": "along"}, starts="mass", p=1.0,
        ),
    )  # fmt: skip

    N = numbered(50, "N", "number of masses", "is the number of masses, and of modes.", softbounds=(1.0, 60.0))
    m = mass(PULSE["m"], symbol="m", tint="k", softbounds=(0.01, 10.0), says="is each mass. Any value above 0.")
    k = positive(
        PULSE["k"], symbol="k", unit="N/m", label="stiffness", tint="k", scale="log", softbounds=(0.1, 100.0),
        says="is the stiffness of each spring. Any value above 0.",
    )  # fmt: skip
    a = positive(
        PULSE["a"], symbol="a", unit="m", label="spacing", tint="k", scale="log", softbounds=(0.01, 10.0),
        says="is the distance from one mass to the next. Any value above 0.",
    )  # fmt: skip
    keep = one_of("string", {"string": "the string", "masses": "m, k, a"}, "A change of N keeps")
    ends = one_of(
        "fixed-fixed", {"fixed-fixed": "Fixed", "fixed-free": "Right one free", "free-free": "Both free"}, "Ends"
    )
    starts = one_of("pulse", {"pulse": "Pulse", "pluck": "Pluck", "mass": "One mass", "mode": "Mode"}, "Start")
    h = displacement(
        0.4, symbol="h", tint="m1", softbounds=(-1.0, 1.0), says="is the largest displacement at the start. Any number."
    )
    j = numbered(2, "j", "mode", "is the number of the mode that moves alone.", softbounds=(1.0, 50.0), tint="slow")
    p = numbered(25, "p", "mass", "is the number of the mass that a hand holds.", softbounds=(1.0, 50.0))
    v_0 = velocity(0.0, symbol="v_0", tint="m1", says="is the velocity of that mass at the start. Any number.")
    centre = displacement(
        0.8, symbol="s", label="place", softbounds=(0.0, LENGTH), says="is the place of the pulse, from the left end."
    )
    width = positive(
        0.15, symbol="w", unit="m", label="width", scale="log", softbounds=(0.05, 1.0),
        says="is the width of the pulse: its standard deviation. Any value above 0.",
    )  # fmt: skip
    way = one_of("across", {"across": "Transverse", "along": "Longitudinal"}, "The masses move")
    physical = (ends, starts)
    views = (
        View(
            "Wave", "Watch the pulse meet the wall: does it come back upright or upside down? Then free the end.",
            keys=(ends,), names=("stage", "plot:field"),
        ),
        View(
            "Modes", "Choose a mode: it starts alone. Which modes does a pluck need, and which stay silent?",
            keys=(starts,), names=("stage", "modes"),
        ),
        View(
            "Spectrum", "Turn up *N*: which modes come near the string's line, and which fall behind?",
            keys=(N,), names=("plot:spectrum",),
        ),
        View(
            "Formulas", "Change one value, and watch the numbers in each formula.", keys=(N,),
            names=("words:formulas",),
        ),
    )  # fmt: skip
    groups = (
        Group("Chain", (N, m, k, a), dense=True),
        Group("Ends", (ends,)),
        Group("Start", (starts, h)),
        Group("", (j,), form=BY_MODE),
        Group("", (p, v_0), form=BY_MASS),
        Group("", (centre, width), form=BY_PULSE),
        Group("", (keep, way), "What a change of N keeps; direction", folded=True),
    )

    case = MassesShown
    paper = staticmethod(paper)
    compared = (
        ComparedNumber("slowest", "ω_1", "rad/s", "slow"),
        ComparedNumber("fastest", "ω_N", "rad/s", "slow"),
        ComparedNumber("wave_speed", "c", "m/s"),
        ComparedNumber("E", "E", "J"),
    )

    def following(self, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Values:
        """Return dependent values: if the number of masses changes, m, k and a keep the string the same, and a mode or
        mass beyond the last one becomes the last one. Raises ValueError if the visitor asks for such a mode or mass."""
        found: dict[str, Any] = {}
        if before and "N" in changed and self.keep == "string" and not changed & {"m", "k", "a"}:
            share = (before.N + PARTS[self.ends]) / (self.N + PARTS[self.ends])
            values = {"m": self.m * share, "k": self.k / share, "a": self.a * share}
            found |= {name: float(f"{value:.{DIGITS}g}") for name, value in values.items()}
        if before and "j" in changed and not changed & {"N", "starts"}:
            found["starts"] = "mode"
        if "j" in changed and self.j > self.N and "N" not in changed:
            raise ValueError(f"mode {self.j:g}: a chain of {self.N:g} masses has the modes 1 to {self.N:g}")
        if "p" in changed and self.p > self.N and "N" not in changed:
            raise ValueError(f"mass {self.p:g}: this chain has the masses 1 to {self.N:g}")
        length = (self.N + PARTS[self.ends]) * found.get("a", self.a)
        centre = min(max(self.centre, 0.0), length)
        return {**found, "j": min(self.j, self.N), "p": min(self.p, self.N), "centre": centre}

    def picture(self, frame: Frame = FITTED) -> Picture:
        """Return the picture, with the displacements of all masses for files."""
        shown, case = super().picture(frame), self.of(frame)
        assert isinstance(case, MassesShown)
        return replace(shown, traces={TIME: _masses(case)})


def _masses(case: MassesShown) -> Traces:
    """The displacements of all masses, at fewer instants if there are many masses."""
    names = tuple(f"x{p}" for p in range(1, int(case.N) + 1))

    def exact(t: Floats) -> Columns:
        return dict(zip(names, case.modes.x(t), strict=True))

    count = min(samples(case.end, case.highest), max(FEWEST, MOST_NUMBERS // len(names)))
    return Traces(case.end, count, names, exact, axis=Y.name)
