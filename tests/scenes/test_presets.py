"""The sentence of a preset is true and its motion is played in seconds; special states (at rest, at a resonance, in the
examples of the lecture) show what they should.
"""

import math
import re
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest

from components.scene.face import SceneFace
from components.scenes import SCENES
from physics.coupled import TwoMassChain
from physics.damped import DampedOscillator
from tests.scenes.checks import check_picture, number, said, taken, visible_text

PERIODS = {
    **{"oscillator": "tau", "energy": "tau", "analogues": "period", "phugoid": "tau", "coupled": "omega_minus"},
    **{"modes": "omega_slow", "forced": "omega_minus", "absorber": "slow", "chain": "slowest", "accuracy": "slow"},
}
"""The number with the period of a scene, or with a natural frequency."""
GOLDEN = (math.sqrt(5) - 1) / 2
OWN = math.sqrt(39.48)
"""The natural frequency of the default mass and spring."""
MACHINE = {"own": True, "m1": 3.0, "k1": 1.0, "F_0": 1.0, "m2": 1.0}
"""sqrt(k1/m1) = sqrt(1/3) is no double."""
LIGHT = {"c1": 0.1, "c2": 0.1}
FREE = {"tuning": "free", "k2": 36864.0}


def column(s: Any, name: str, source: str = "time") -> Any:
    return s.shown.sources[source][name]


def value(s: Any, name: str) -> float:
    return float(s.numbers[name].value)


def late(s: Any, share: float) -> float:
    """The last time at which |x| is more than that share of |x_0|, from dense samples."""
    one = DampedOscillator(m=s.m, c=s.c, k=s.k)
    t = np.linspace(0.0, 14.0 / one.rates[0], 100_001)
    return float(t[np.flatnonzero(np.abs(one.motion(s.x_0, s.v_0, t).x) > share * abs(s.x_0))[-1]])


def kept(s: Any) -> float:
    """The share of a swing that the next one keeps."""
    return math.exp(-2 * math.pi * s.zeta / math.sqrt(1 - s.zeta**2))


def longer(s: Any) -> float:
    """The period of the pendulum over that of small swings."""
    return value(s, "period") / value(s, "small_period")


def response(s: Any, zeta: float | None = None) -> float:
    """The swing over that of a steady push, of the base or of the unbalance."""
    size = {"force": s.F_0 / s.k, "base": s.Y, "unbalance": s.moment / s.m}[s.kind]
    return value(s.value.at({**s.values, "zeta": zeta or s.zeta, "keep": "zeta"}), "X") / size


def ripple(s: Any) -> float:
    """The largest distance of both heights in the first period, in percent of the swing of the linear theory."""
    t = column(s, "t")
    off = np.abs(column(s, "h") - column(s, "h_lin"))[t <= value(s, "tau_exact")]
    return float(100 * off.max() / (s.v_0**2 / s.g * abs(s.excess)))


def swing(s: Any, name: str) -> float:
    return float(np.abs(column(s, name)).max())


def one_mode(s: Any, other: str, sign: float) -> bool:
    """Return whether the masses swing in one mode only, in phase (`sign` 1) or in opposite phase (-1)."""
    moving = np.abs(column(s, "x1")) > 1e-9
    ways = np.sign(column(s, "x1") * column(s, "x2"))[moving]
    return swing(s, f"x1_{other}") < 1e-15 and set(ways) == {sign}


def echo(s: Any) -> float:
    """The largest displacement of a mass after the pulse has come back from the end."""
    t, x = column(s, "t"), column(s, "x35")
    back = x[(t > value(s, "traverse")) & (t < 1.5 * value(s, "traverse"))]
    return float(back[np.abs(back).argmax()])


def ratio(s: Any, name: str, label: str) -> float:
    """The number of a preset over that of another one of its scene."""
    return value(s, name) / value(taken(s.slug, label), name)


SAID: list[tuple[str, str, str, Callable[[Any], Any]]] = [
    ("damped", "Light", "0.532", kept),
    ("damped", "Light", "7.13", lambda s: late(s, 0.01)),
    ("damped", "Car", "0.306", lambda s: s.zeta),
    ("damped", "Car", "36.4", lambda s: -100 * column(s, "x").min() / s.x_0),
    ("damped", "Car", "0.976", lambda s: late(s, 0.05)),
    ("damped", "Worn", "68", lambda s: 100 * kept(s)),
    ("damped", "Worn", "5.84", lambda s: late(s, 0.05)),
    ("damped", "Door closer", "1.5", lambda s: s.zeta),
    ("damped", "Door closer", "8.31", lambda s: late(s, 0.01)),
    ("damped", "Critical", "1.06", lambda s: late(s, 0.01)),
    ("damped", "Critical", "4.30", lambda s: late(SCENES["damped"](zeta=3.0), 0.01)),
    ("damped", "Critical", "0.674", lambda s: late(SCENES["damped"](zeta=0.83), 0.01)),
    ("damped", "Thrown", "0.0506", lambda s: value(s, "zero")),
    ("damped", "Thrown", "−0.0525", lambda s: column(s, "x").min()),
    ("damped", "Thrown", "98.8", lambda s: 100 - 100 * np.interp(0.2, column(s, "t"), column(s, "E"))
     / column(s, "E_0")[0]),
    ("driven", "Below", "1.72", response),
    ("driven", "Below", "0.842", lambda s: value(s, "X") * s.omega**2 * s.m / s.F_0),
    ("driven", "Below", "0.502", lambda s: value(s, "phi")),
    ("driven", "Resonance", "2.5", response),
    ("driven", "Above", "1.29", lambda s: value(s, "X") * s.omega**2 * s.m / s.F_0),
    ("driven", "Above", "2.88", lambda s: value(s, "phi")),
    ("driven", "Strong dashpot", "0.625", lambda s: 1 / (2 * s.zeta)),
    ("driven", "Beats", "0.267", lambda s: value(s, "X")),
    ("driven", "Beats", "0.505", lambda s: max(abs(s.shown.traces["time"].exact(np.linspace(0, 99, 20_000))["x"]))),
    ("driven", "Beats", "10.0", lambda s: 2 * math.pi / (math.sqrt(s.k / s.m) - s.omega)),
    ("driven", "Washboard", "0.704", response),
    ("driven", "Washboard", "0.942", lambda s: response(s, zeta=1.0)),
    ("driven", "Washboard", "0.646", lambda s: response(s, zeta=0.05)),
    ("driven", "Spin-dry", "1.62", response),
    ("driven", "Spin-dry", "2.55", lambda s: 1 / (2 * s.zeta * math.sqrt(1 - s.zeta**2))),
    ("driven", "Spin-dry", "1.04", lambda s: 1 / math.sqrt(1 - 2 * s.zeta**2)),
    ("driven", "Harmonic", "0.135", lambda s: value(s, "X_strongest")),
    ("analogues", "10°", "0.2", lambda s: 100 * longer(s) - 100),
    ("phugoid", "Ripple, 0.1", "5", ripple),
    ("coupled", "All equal", "0.618", lambda s: value(s, "omega_minus")),
    ("coupled", "All equal", "1.618", lambda s: value(s, "omega_plus")),
    ("chain", "Two", "0.618", lambda s: value(s, "slowest")),
    ("chain", "Two", "1.62", lambda s: value(s, "fastest")),
    ("oscillator", "Heavy", "", lambda s: ratio(s, "tau", "Pulled") == pytest.approx(2)),
    ("oscillator", "Stiff", "", lambda s: ratio(s, "tau", "Pulled") == pytest.approx(0.5, rel=0.01)),
    ("oscillator", "Pushed back", "", lambda s: s.x_0 * s.v_0 < 0),
    ("energy", "Pushed up", "", lambda s: ratio(s, "T_max", "Pulled down") == 1),
    ("energy", "Heavy", "", lambda s: ratio(s, "delta", "Pulled down") == pytest.approx(2)),
    ("energy", "Heavy", "", lambda s: ratio(s, "T_max", "Pulled down") == 1 < ratio(s, "tau", "Pulled down")),
    ("energy", "Soft", "", lambda s: ratio(s, "delta", "Pulled down") > 1 < ratio(s, "tau", "Pulled down")),
    ("analogues", "Cavendish", "", lambda s: value(s, "period") > 600),
    ("analogues", "60°", "", lambda s: 1.05 < longer(s) < 1.1),
    ("analogues", "Clock", "", lambda s: 1 < longer(s) < 1.001),
    ("analogues", "Nearly over", "", lambda s: 2 < longer(s) < 11),
    ("phugoid", "Cusp, 0.732", "", lambda s: abs(s.v_0 + column(s, "v").min()) < 0.01 * s.v_0),
    ("damped", "Worn", "", lambda s: s.c == taken("damped", "Car").c / 5),
    ("driven", "Strong dashpot", "", lambda s: s.zeta > math.sqrt(0.5)),
    ("coupled", "Slow", "", lambda s: one_mode(s, "fast", 1.0)),
    ("coupled", "Fast", "", lambda s: one_mode(s, "slow", -1.0)),
    ("coupled", "Beats", "", lambda s: np.abs(column(s, "x1")[:40]).max() > 0.19),
    ("coupled", "Heavy, light", "", lambda s: swing(s, "x1_fast") < 0.02 * swing(s, "x1_slow")
     and swing(s, "x2_fast") > 0.9 * swing(s, "x2_slow")),
    ("forced", "All equal", "", lambda s: value(s, "Xp1") < 0),
    ("forced", "Still mass 1", "", lambda s: swing(s, "x1") < 1e-15),
    ("forced", "Light mass 2", "", lambda s: 1 < value(s, "omega_plus") < 1.3 * value(s, "omega_minus") < 1.3),
    ("absorber", "Below", "", lambda s: s.omega < math.sqrt(s.k1 / s.m1)),
    ("absorber", "Resonant", "", lambda s: s.omega == math.sqrt(s.k1 / s.m1)),
    ("absorber", "Above", "", lambda s: s.omega > math.sqrt(s.k1 / s.m1)),
    ("chain", "Pulse", "", lambda s: echo(s) < -0.2),
    ("chain", "Free end", "", lambda s: echo(s) > 0.2),
    ("chain", "Broad", "", lambda s: max(abs(column(s, f"x{p}")[-1]) for p in range(1, int(s.N) + 1)) > 0.39),
    ("chain", "Plucked", "", lambda s: column(s, "silent_j", "silent").tolist() == [3.0, 6.0]
     and np.abs(s.of().drawn.energy[[2, 5]]).max() <= 1e-30),
    ("chain", "One mass", "", lambda s: s.of().drawn.energy[25:].sum() > 0.5 * s.of().drawn.energy.sum()),
]  # fmt: skip
"""A number in the sentence of a preset and how it is computed from its state, or what the sentence says in words."""


@pytest.mark.parametrize(("slug", "label", "text", "true"), SAID, ids=lambda one: one if isinstance(one, str) else "")
def test_what_the_sentence_of_a_preset_says_is_true(
    slug: str, label: str, text: str, true: Callable[[Any], Any]
) -> None:
    found, last = true(taken(slug, label)), 10.0 ** -len(text.partition(".")[2])
    assert re.search(rf"(?<![\d.]){re.escape(text)}(?!\.?\d)", SCENES[slug].watch[label])
    assert found == pytest.approx(number(text), abs=0.5 * last) if text else found


@pytest.mark.parametrize("slug", PERIODS)
def test_a_period_is_played_in_one_to_twelve_seconds(slug: str) -> None:
    """From microseconds to minutes; without a spring there is no period."""
    for label in SCENES[slug].presets:
        scene, name = taken(slug, label), PERIODS[slug]
        found = value(scene, name) if name in scene.numbers else 0.0
        period = found if name in ("tau", "period") else 2 * math.pi / found if found else 0.0
        assert not period or 1 <= period / scene.shown.pace.auto <= 12, label


def slow(**chain: float) -> float:
    return float(TwoMassChain(**chain).modes().omega[0])


Given = dict[str, Any]
STATES: dict[str, list[tuple[Given, Given]]] = {
    "oscillator": [({"view": "force", "k": 1e5, "x_0": 0.2, "v_0": 0.0},
                    {"values.F_unit": "·10³ N", "scalars.forced": 1})],
    "energy": [({"x_0": 0.001}, {"scalars.natural_seen": 0, "scalars.natural_far": 1, "axes.x.end": -0.00125})],
    "analogues": [
        ({"theta_0": 50.104}, {"values.late_percent": "5.00"}),
        ({"theta_0": 0.0}, {"values.end_left": "0°", "values.end_right": "0°"}),
        ({"system": "string", "string_n": 100.0}, {"scalars.half_waves": 12, "notes": "12 half waves"}),
    ],
    "phugoid": [
        ({"excess": 0.0}, {"values.verdict": "Steady level flight: nothing swings."}),
        ({"view": "limits"}, {"scalars.family_named": 1}),
    ],
    "damped": [({"c": 40.0}, {"values.tau_d": "", "scalars.has_tau_d": 0, "numbers.omega_d": None,
                              "numbers.delta": None})],
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
    "coupled": [({"k1": 0.0, "k2": 0.0, "v1_0": 1.0}, {"sources.time.x1_fast": None, "forms.slow_omega": "two"})],
    "modes": [
        ({"view": "sweep"}, {"scalars.cross": math.log10(4)}),  # m1 k2 = m2 (k1 + k2): 2 k2 = 4 + k2
        ({"view": "guess", "k2": 2.0, "omega": math.nextafter(math.sqrt(2), 0.0)},  # no double: mass 1 rests
         {"values.a22": "0.00", "values.D": "−4.00", "forms.row2_says": "pole", "forms.agree": "pole"}),
        ({"view": "guess", "omega": 0.7, "ratio": 3.0},  # arrows in proportion to the forces, the longest 0.17
         {"scalars.need1_N": -0.04165, "scalars.give1_N": 0.0, "scalars.need2_N": -0.062475, "scalars.give2_N": -0.17}),
        ({"view": "roots", "c1": 0.1},  # k1/c1 = 40; the double root is at c1 = 2
         {"scalars.ring_slow": 1, "scalars.ring_fast": 2, "scalars.radius1": 40, "scalars.radius2": 0,
          "scalars.met": 1, "scalars.met1": -0.5, "scalars.met1_im": math.sqrt(1.75)}),
        ({"view": "roots", "c1": 0.1, "grows": "c2"}, {"scalars.met": 0}),
        *(({"view": one, "c1": 0.1}, {"notes": "without the dashpots"}) for one in ("guess", "solve", "sweep", "hunt")),
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
        ({"view": "bode", **LIGHT}, {"axes.omega.log": True, "axes.X.log": True,
         "text": "peaks at 0.617 (width 0.0383) and 1.62 (width 0.256) rad/s"}),
        ({"view": "bode", **LIGHT, "scale": "size"}, {"axes.omega.log": False}),
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
