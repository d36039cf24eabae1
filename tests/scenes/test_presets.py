"""The sentence that is shown when a preset is chosen is true, and its motion is played in seconds."""

import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from components.scenes import SCENES
from physics.damped import DampedOscillator
from tests.scenes.checks import number, taken


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


def heat(s: Any) -> float:
    """The share of the energy that is heat after 0.2 s, in percent."""
    return float(100 - 100 * np.interp(0.2, column(s, "t"), column(s, "E")) / column(s, "E_0")[0])


def longer(s: Any) -> float:
    """The period of the pendulum over that of small swings."""
    return value(s, "period") / value(s, "small_period")


def response(s: Any, zeta: float | None = None) -> float:
    """The swing over that of a steady push, of the base or of the unbalance."""
    size = {"force": s.F_0 / s.k, "base": s.Y, "unbalance": s.moment / s.m}[s.kind]
    return value(s.value.at({**s.values, "zeta": zeta or s.zeta, "keep": "zeta"}), "X") / size


def inertia(s: Any) -> float:
    """The force of inertia over the push."""
    return value(s, "X") * s.omega**2 * s.m / s.F_0


def ripple(s: Any) -> float:
    """The largest distance of both heights in the first period, in percent of the swing of the linear theory."""
    t = column(s, "t")
    off = np.abs(column(s, "h") - column(s, "h_lin"))[t <= value(s, "tau_exact")]
    return float(100 * off.max() / (s.v_0**2 / s.g * abs(s.excess)))


def swing(s: Any, name: str) -> float:
    return float(np.abs(column(s, name)).max())


def one_mode(s: Any, other: str, sign: float) -> bool:
    """Whether both masses swing in one mode, with or against each other."""
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
    ("damped", "Thrown", "98.8", heat),
    ("driven", "Below", "1.72", response),
    ("driven", "Below", "0.842", inertia),
    ("driven", "Below", "0.502", lambda s: value(s, "phi")),
    ("driven", "Resonance", "2.5", response),
    ("driven", "Above", "1.29", inertia),
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


PERIODS = {
    **{"oscillator": "tau", "energy": "tau", "analogues": "period", "phugoid": "tau", "coupled": "omega_minus"},
    **{"modes": "omega_slow", "forced": "omega_minus", "absorber": "slow", "chain": "slowest", "accuracy": "slow"},
}
"""The number with the period of a scene, or with a natural frequency."""


@pytest.mark.parametrize("slug", PERIODS)
def test_a_period_is_played_in_one_to_twelve_seconds(slug: str) -> None:
    """From microseconds to minutes; without a spring there is no period."""
    for label in SCENES[slug].presets:
        scene, name = taken(slug, label), PERIODS[slug]
        found = value(scene, name) if name in scene.numbers else 0.0
        period = found if name in ("tau", "period") else 2 * math.pi / found if found else 0.0
        assert not period or 1 <= period / scene.shown.pace.auto <= 12, label
