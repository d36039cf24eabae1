"""Special states of the scenes: at rest, at a resonance, without a spring, in the examples of the lecture."""

import math
from collections.abc import Mapping
from typing import Any

import pytest

from components.scene.face import SceneFace
from components.scenes import SCENES
from physics.coupled import TwoMassChain
from tests.scenes.checks import check_picture, said, visible_text

GOLDEN = (math.sqrt(5) - 1) / 2
OWN = math.sqrt(39.48)
"""The natural frequency of the default mass and spring."""
MACHINE = {"own": True, "m1": 3.0, "k1": 1.0, "F_0": 1.0, "m2": 1.0}
"""sqrt(k1/m1) = sqrt(1/3) is no double."""
LIGHT = {"c1": 0.1, "c2": 0.1}
FREE = {"tuning": "free", "k2": 36864.0}


def slow(**chain: float) -> float:
    return float(TwoMassChain(**chain).modes().omega[0])


Given = dict[str, Any]
STATES: dict[str, list[tuple[Given, Given]]] = {
    "oscillator": [
        ({"view": "force", "k": 1e5, "x_0": 0.2, "v_0": 0.0}, {"values.F_unit": "·10³ N", "scalars.forced": 1}),
        ({}, {"signals.F": None, "scalars.forced": 0}),
    ],
    "energy": [
        ({"x_0": 0.001}, {"scalars.natural_seen": 0, "scalars.natural_far": 1, "axes.x.end": -0.00125}),
    ],
    "analogues": [
        ({"theta_0": 50.104}, {"values.late_percent": "5.00"}),
        ({"theta_0": 0.0}, {"values.end_left": "0°", "values.end_right": "0°"}),
        ({"system": "string", "string_n": 100.0}, {"scalars.half_waves": 12, "notes": "12 half waves"}),
    ],
    "phugoid": [
        ({"excess": 0.0}, {"values.verdict": "Steady level flight: nothing swings."}),
        ({"v_0": 250.0, "unit": "ft/s"}, {"values.h_size": "−12500", "axes.h.exponent": 3}),
        ({"view": "limits"}, {"scalars.family_named": 1}),
        ({}, {"values.tau_glider": "12.4 s", "values.tau_light": "20.7 s", "values.tau_airliner": "113 s"}),
    ],
    "damped": [
        ({"c": 40.0}, {"values.tau_d": "", "scalars.has_tau_d": 0, "numbers.omega_d": None, "numbers.delta": None})
    ],
    "chain": [
        ({"N": 8, "ends": "free-free", "starts": "mass", "p": 1.0, "h": 0.0, "v_0": 1.0}, {"notes": "0.125 m/s",
         "numbers.slowest": 0.0}),
        ({"ends": "free-free"}, {"notes": None}),
    ],
    "driven": [
        ({"omega": 0.0}, {"holds": "At ω = 0 nothing pushes", "scalars.polygon_idle": 1, "columns.power": None}),
        ({"view": "harmonics", "push": "step"}, {"forms.meets": "once", "forms.repeats": "", "scalars.omega_at": None,
         "scalars.M_at": None, "numbers.X": None}),
        ({"F_0": 0.0, "x_0": 0.1}, {"holds": "No push", "scalars.polygon_idle": 1, "columns.power": None}),
        ({"omega": OWN, "c": 0.0}, {"holds": "Nothing balances the push: each swing grows by the same 0.159 m.",
         "scalars.M_at": None, "scalars.polygon_growing": 1}),
        ({"view": "harmonics", "m": 1.0, "k": 36.0, "c": 0.0, "push": "square", "omega": 2.0},
         {"meets": "0.0707", "sources.time.x_p": None, "notes": None}),  # 4 F_0/(3 π) over 2 m 3 ω
        ({"axes": "log", "omega": 0.0}, {"scalars.omega_at": None}),
        ({}, {"scalars.natural": None, "scalars.peak_up": None}),
        # The power has a peak of the width Δω under a force; under an unbalance it rises without end.
        ({"zeta": 0.2, "view": "formulas"}, {"text": "Δω"}),
        ({"zeta": 0.2, "view": "formulas", "kind": "unbalance"}, {"not text": "Δω"}),
        ({"view": "formulas"}, {"forms.law": "force", "forms.x_p": "dies_formula"}),
        ({"view": "formulas", "push": "square"}, {"forms.law": "push", "not forms.x_p": "formula"}),
        ({"view": "power", "push": "step"}, {"no_powers": "no mean power", "numbers.P_in": None}),
        ({"view": "convolution", "kind": "base"}, {"sums": "about a force", "sources.time.x_sliced": None}),
        ({"view": "convolution", "F_0": 0.0}, {"sums": "No push", "columns.outline": None}),
        ({"view": "convolution", "push": "step", "window": 1e3}, {"sums": "too fast for a line"}),
        ({"view": "convolution", "push": "impulses", "omega": 1e5}, {"sums": "too fast for a line"}),
        ({"view": "convolution", "push": "impulses", "omega": 2.0}, {"sums": "An impulse is a slice already",
         "forms.has_slices": "", "forms.tail": "each_jolt"}),
    ],
    "coupled": [
        ({"k1": 0.0, "k2": 0.0, "v1_0": 1.0}, {"sources.time.x1_fast": None, "forms.slow_omega": "two"}),
        ({}, {"signals.F1": None}),
    ],
    "modes": [
        ({"view": "sweep"}, {"scalars.cross": math.log10(4)}),  # m1 k2 = m2 (k1 + k2): 2 k2 = 4 + k2
        ({"view": "guess", "k2": 2.0, "omega": math.nextafter(math.sqrt(2), 0.0)},  # no double: mass 1 rests
         {"values.a22": "0.00", "values.D": "−4.00", "forms.row2_says": "pole", "forms.agree": "pole"}),
        ({"view": "guess", "omega": 0.7, "ratio": 3.0},  # arrows in proportion to the forces, the longest 0.17
         {"scalars.need1_N": -0.04165, "scalars.give1_N": 0.0, "scalars.need2_N": -0.062475, "scalars.give2_N": -0.17}),
        ({"view": "roots", "c1": 0.1},  # k1/c1 = 40; the double root is at c1 = 2
         {"scalars.ring_slow": 1, "scalars.ring_fast": 2, "scalars.radius1": 40, "scalars.radius2": 0}),
        ({"view": "roots", "c1": 0.1}, {"scalars.met": 1, "scalars.met1": -0.5, "scalars.met1_im": math.sqrt(1.75)}),
        ({"view": "roots", "c1": 0.1, "grows": "c2"}, {"scalars.met": 0}),
        *(({"view": one, "c1": 0.1}, {"notes": "without the dashpots"}) for one in ("guess", "solve", "sweep", "hunt")),
        ({"view": "guess", "omega": math.nextafter(2.0, 1.0)}, {"forms.agree": "same_fast", "values.apart": "0.00"}),
        ({"view": "hunt"}, {"forms.answer": "", "columns.answer": None, "values.answer_slow": None,
         "values.omega_slow": None}),
        ({"view": "hunt", "answer": "shown"}, {"values.answer_slow": "+2.00", "values.answer_fast": "−1.00"}),
    ],
    "forced": [
        ({"omega": 0.6}, {"scalars.Xp1_over": 1, "scalars.Xp2_over": 1, "scalars.Xp1_under": 0}),
        ({"omega": 0.65, "curve": "signed"}, {"scalars.Xp1_over": 0, "scalars.Xp1_under": 1, "scalars.Xp2_under": 1}),
        ({"k1": 100.0}, {"spans.omega": (0.0, 25.126)}),
        ({"curve": "signed", "axes": "lecture"}, {"scalars.mark_minus": GOLDEN, "scalars.mark_plus": 1 / GOLDEN,
         "scalars.mark_still": 1.0}),
        ({"k1": 0.0, "axes": "lecture"}, {"forms.lecture": "", "notes": "k₁", "axes.X.unit": "m"}),
        ({"omega": 1.3}, {"values.way1": "with F", "values.way2": "against F"}),
        ({"omega": GOLDEN + 2e-5}, {"forms.x1_limit": "grows", "sources.limit.x1_growth": None}),
        ({"omega": GOLDEN + 2e-5, "window": 2e5}, {"forms.x1_limit": "beats"}),
        ({"omega": (1 + 1e-9) * GOLDEN}, {"sources.time.x1_p": None, "notes": "far larger than their sum"}),
        ({"view": "bode", "omega": 1.0}, {"text": "mass 2 lags 180°"}),
        ({"view": "bode", **LIGHT}, {"axes.omega.log": True, "axes.X.log": True}),
        ({"view": "bode", **LIGHT, "scale": "size"}, {"axes.omega.log": False}),
        ({"view": "response", **LIGHT, "scale": "log"}, {"axes.omega.log": False}),
        ({"view": "bode", **LIGHT}, {"text": "peaks at 0.617 (width 0.0383) and 1.62 (width 0.256) rad/s"}),
        (LIGHT, {"scalars.peak1_0": None}),
        ({"c1": 0.4, "omega": 0.0}, {"notes": "At ω = 0 the force F₀ sin ωt is 0 at all times."}),
    ],
    "absorber": [
        ({}, {"values.help_low": "42.6", "values.help_high": "56.3", "values.found0": "16.1 % away: ω₋ 40.3 rad/s",
         "values.found1": "xₚ: 0.00 mm; from rest within 5.18 mm"}),
        ({"own": True, "m1": 2.0, "k1": 4.0, "F_0": 1.0, "omega": 1.0, "m2": 1.0, "k2": 2.0}, {"forms.why": "grow",
         "scalars.is_grow": 1, "values.found1": "no Xₚ here: it grows without limit", "values.judged": "from rest"}),
        ({**MACHINE, "omega": math.sqrt(1 / 3)}, {"values.found1": "xₚ: 0.00 m; from rest within"}),
        ({**MACHINE, "tuning": "free", "omega": slow(m1=3.0, m2=1.0, k1=1.0, k2=1 / 3), "k2": 1 / 3},
         {"values.found1": "no Xₚ here: it grows without limit", "forms.first": "none"}),
        ({**FREE, "omega": 50.0001}, {"scalars.alone_beats": 1, "scalars.alone_grows": 0}),
        ({**FREE, "omega": slow(m1=100.0, m2=16.0, k1=250e3, k2=36864.0) * (1 + 1e-6), "view": "rest"},
         {"forms.why_rest": "beat"}),
    ],
}  # fmt: skip
"""States of each scene and what they show: numbers, scalars, forms and values by name, None if there is none; a part
of the sentence with a name; a part of all visible sentences or notes."""


def found(scene: SceneFace, place: str) -> Any:
    """The content of a place of a picture: numbers.X, sources.time.x, text, notes, or the name of a sentence."""
    part, *names = place.split(".")
    if not names:
        texts = {"text": visible_text(scene), "notes": "\n".join(scene.shown.notes)}
        return texts[part] if part in texts else said(scene, part)
    level: Any = scene.numbers if part == "numbers" else getattr(scene.shown, part)
    for name in names:
        level = level.get(name) if isinstance(level, Mapping) else getattr(level, name, None)
    return getattr(level, "value", level)


@pytest.mark.parametrize(
    ("slug", "values", "shown"),
    [(slug, values, shown) for slug, rows in STATES.items() for values, shown in rows],
    ids=str,
)
def test_a_special_state_shows(slug: str, values: Given, shown: Given) -> None:
    scene = SCENES[slug](**values)
    check_picture(scene)
    for place, expected in shown.items():
        told = found(scene, place.removeprefix("not "))
        if place.startswith("not "):
            assert expected not in told
        elif expected is None:
            assert told is None or not len(told), place
        elif isinstance(expected, str) and place.split(".")[0] != "forms":
            assert expected in told, place
        else:
            assert told == (expected if isinstance(expected, str) else pytest.approx(expected, rel=1e-3)), place
