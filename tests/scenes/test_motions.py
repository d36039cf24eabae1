"""The motions of every scene in any state: they begin as they are said to, obey their equation, and their parts and
energies add up.

Scene modes: the buttons and arrows of Guess, and the roots, paths and sentences of Roots for any dashpots.

Derivatives are differences of the exact motion between seven instants, so that no solution is shared with the physics.
"""

import cmath
import math
import re
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import Phase, example, given, settings
from hypothesis import strategies as st

from components.quantities.formatting import three
from components.scene import Scene
from components.scenes import SCENES
from components.scenes.modes import ModesScene
from physics.analogues import ANALOGUES
from physics.coupled import TwoMassChain
from physics.damped_chain import NEAR
from physics.root_paths import RootPath, Varied
from tests.grids import tries
from tests.page.headless_page import Page, say
from tests.physics.truth import Case, cases, eigenvectors
from tests.scenes.checks import in_any_state, numbers, sentences, visible_text

FIRST, SECOND = np.array([-1, 9, -45, 0, 45, -9, 1]) / 60, np.array([2, -27, 270, -490, 270, -27, 2]) / 180
AT_START = np.array([-147, 360, -450, 400, -225, 72, -10]) / 60
"""Coefficients of the first and second derivative at the middle of seven instants, and of the first at their start."""
INSTANTS = np.array([3, 40, 333, 4001, 20_000])
"""The middle of each seven instants, in their distance."""
SHORT = 0.04
"""The distance of instants, in radians of the fastest motion."""
MOST_MASSES = 60
STALLED = 0.2
"""The share of the speed of steady flight below which the path of an aircraft turns too fast for differences."""
WAYS: tuple[Varied, ...] = ("c1", "c2", "both")
PLACES = ("slow", "fast", "third", "fourth")


class Moved(NamedTuple):
    """A displacement, its velocity and its acceleration at INSTANTS, and its largest size in the window."""

    x: Any
    v: Any
    a: Any
    reach: float


Terms = dict[str, list[Any]]
"""The forces on each body, which add up to 0; the first is that of inertia."""
Laws = Callable[[Any, Any, Mapping[str, Moved]], Terms]


def push_on(s: Any, t: Any) -> Any:
    """The force on a driven mass, from its drive."""
    turn = s.omega * t
    if s.kind == "base":
        return s.Y * (s.k * np.sin(turn) + s.c * s.omega * np.cos(turn))
    if s.kind == "unbalance":
        return s.moment * s.omega**2 * np.sin(turn)
    shapes = {
        "sine": lambda: np.sin(turn),
        "square": lambda: np.sign(np.sin(turn)),
        "triangle": lambda: np.arcsin(np.sin(turn)) * 2 / math.pi,
        "pulses": lambda: (turn / (2 * math.pi) % 1 < s.width) * 1.0,
        "step": lambda: np.ones_like(t),
    }
    idle = np.zeros_like(t)
    return idle if s.push.startswith("impulse") or not (s.omega or s.push == "step") else s.F_0 * shapes[s.push]()


def one_mass(s: Any, t: Any, at: Mapping[str, Moved]) -> Terms:
    x, push = at["x"], push_on(s, t) if s.slug == "driven" else 0.0
    return {"x": [s.m * x.a, getattr(s, "c", 0.0) * x.v, s.k * x.x, -push]}


def two_masses(s: Any, t: Any, at: Mapping[str, Moved]) -> Terms:
    one, two = at["x1"], at["x2"]
    push, c1, c2 = (s.F_0 * np.sin(s.omega * t), s.c1, s.c2) if s.slug == "forced" else (0.0, 0.0, 0.0)
    tie, brake = s.k2 * (two.x - one.x), c2 * (two.v - one.v)
    return {"x1": [s.m1 * one.a, s.k1 * one.x, c1 * one.v, -tie, -brake, -push], "x2": [s.m2 * two.a, tie, brake]}


def many_masses(s: Any, t: Any, at: Mapping[str, Moved]) -> Terms:
    N, none = int(s.N), np.zeros_like(t)
    x = [none, *(at[f"x{p}"].x for p in range(1, N + 1)), none]
    left, right = s.ends != "free-free", s.ends == "fixed-fixed"
    found = {f"x{p}": [s.m * at[f"x{p}"].a, s.k * (x[p] - x[p - 1]), s.k * (x[p] - x[p + 1])] for p in range(1, N + 1)}
    found["x1"][1] *= left
    found[f"x{N}"][2] *= right
    return found


def analogue(s: Any, t: Any, at: Mapping[str, Moved]) -> Terms:
    square = s.numbers["omega"].value ** 2
    turned = np.sin(at["q"].x) if ANALOGUES[s.system].length_of else at["q"].x
    return {"q": [at["q"].a, square * turned], "x": [at["x"].a, square * at["x"].x]}


def flight(s: Any, t: Any, at: Mapping[str, Moved]) -> Terms:
    """Lift square to the path, in proportion to the square of the speed, and weight."""
    x, y = at["x"], at["y"]
    turn = s.g * np.hypot(x.v, y.v) / s.v_0**2
    return {"x": [x.a, turn * y.v], "y": [y.a, -turn * x.v, s.g]}


def rate_of_two(s: Any) -> float:
    braked = 2 * (getattr(s, "c1", 0.0) + getattr(s, "c2", 0.0)) * (1 / s.m1 + 1 / s.m2)
    return float(math.sqrt((s.k1 + 2 * s.k2) / s.m1 + 2 * s.k2 / s.m2) + braked + getattr(s, "omega", 0.0))


KINDS: dict[str, tuple[str, Laws, Callable[[Any], float]]] = {
    **dict.fromkeys(
        ("oscillator", "energy", "damped", "driven"),
        ("time", one_mass, lambda s: math.sqrt(s.k / s.m) + getattr(s, "c", 0.0) / s.m + 2 * getattr(s, "omega", 0.0)),
    ),
    **dict.fromkeys(("coupled", "forced"), ("time", two_masses, rate_of_two)),
    "modes": ("path", two_masses, rate_of_two),
    "chain": ("time", many_masses, lambda s: 2 * math.sqrt(s.k / s.m)),
    "analogues": ("time", analogue, lambda s: s.numbers["omega"].value),
    "phugoid": ("path", flight, lambda s: 4 * s.g / s.v_0 * (1 + abs(s.excess))),
}
"""The motions of a scene: the source of their curves, their forces, and a bound of their rates in rad/s."""


def start(s: Any, name: str) -> tuple[float, float] | None:
    """The displacement and the velocity from which a body starts, by the parameters."""
    x, v = (f"{q}{name.removeprefix('x')}_0" for q in "xv")
    if s.slug == "chain":
        at = name == f"x{int(s.p)}"
        return (s.h * at, s.v_0 * at) if s.starts == "mass" or (s.starts == "pluck" and at) else None
    if s.slug == "phugoid" or name == "y" or (s.slug == "analogues" and name == "q"):
        return None
    if s.slug == "modes":
        return getattr(s, x), 0.0
    if s.slug == "analogues":
        return (math.radians(s.theta_0) if ANALOGUES[s.system].length_of else getattr(s, f"{s.system}_start")), 0.0
    kicked = s.slug == "driven" and s.kind == "force" and (s.push == "impulse" or (s.push == "impulses" and s.omega))
    return getattr(s, x), getattr(s, v) + (s.J / s.m if kicked else 0.0)


def sums(s: Any, at: Mapping[str, Moved], given: Mapping[str, Any]) -> Terms:
    """Terms of each sum that a scene draws, without those that it leaves out."""
    if s.slug in ("oscillator", "energy", "damped"):
        x = at["x"]
        T, V = [s.m * x.v**2 / 2], [s.k * x.x**2 / 2]
        lost = [given["E_0"], -T[0], -V[0]] if "E_0" in given else []
        if s.slug == "energy" and s.datum == "separate":
            V.append(s.m * s.g**2 * s.m / s.k / 2)
        found: Terms = {"v": [x.v], "a": [-s.k / s.m * x.x], "T": T, "V": V, "E": T + V, "total": T + V, "heat": lost}
        return found | ({"P": [s.c * x.v**2]} if s.slug == "damped" else {})
    if s.slug == "phugoid":
        V = np.hypot(at["x"].v, at["y"].v)
        return {"v": [V, -s.v_0], "lift": [(V / s.v_0) ** 2], "lift_linear": [2 * V / s.v_0, -1.0], "h": [at["y"].x]}
    if s.slug == "coupled":
        one, two = at["x1"], at["x2"]
        stacked = [s.m1 * one.v**2 / 2, s.k1 * one.x**2 / 2, s.k2 * (two.x - one.x) ** 2 / 2, s.m2 * two.v**2 / 2]
        names = ("T1", "T1_V1", "T1_V1_V2", "T1_V1_V2_T2")
        found = {name: stacked[: i + 1] for i, name in enumerate(names)}
    else:
        found = {}
    pairs = [(name, [f"{name}_{one}" for one in parts]) for name in at for parts in (("p", "c"), ("slow", "fast"))]
    return found | {name: [given[one] for one in parts] for name, parts in pairs if set(parts) <= given.keys()}


class Sampled(NamedTuple):
    """The motion of a scene at groups of seven instants: their distance, the columns, the derivatives of each body,
    which groups are smooth, the columns in the window, and at the first seven instants.
    """

    h: float
    columns: dict[str, Any]
    at: dict[str, Moved]
    smooth: Any
    window: Mapping[str, Any]
    begun: Mapping[str, Any]


def sampled(scene: Scene) -> Sampled | None:
    source, _, rate = KINDS[scene.slug]
    trace = scene.shown.traces.get(source)
    if not trace or scene.values.get("N", 0) > MOST_MASSES:
        return None
    h = 2.0 ** math.floor(math.log2(SHORT / (rate(scene) or 1 / trace.end)))
    t = h * (INSTANTS[:, None] + np.arange(-3, 4))
    columns = {name: one.reshape(t.shape) for name, one in trace.exact(t.ravel()).items()}
    window, begun = trace.exact(np.linspace(0.0, trace.end, 60)), trace.exact(h * np.arange(7))
    bodies = {name: one for name, one in columns.items() if re.fullmatch(r"x\d*|y|q", name)}
    reach = max(max(np.abs(one).max(), np.abs(window[name]).max()) for name, one in bodies.items())
    at = {name: Moved(x[:, 3], x @ FIRST / h, x @ SECOND / h**2, reach) for name, x in bodies.items()}
    middle = {name: one[:, 3] for name, one in columns.items()}
    return Sampled(h, middle, at, is_smooth(scene, t, at), window, begun)


def rounded(one: Sampled) -> dict[str, Moved]:
    """The bodies, with derivatives that are off by the largest error of rounded instants."""
    return {
        name: body._replace(v=body.v + 1e-12 * body.reach / one.h, a=body.a + 1e-12 * body.reach / one.h**2)
        for name, body in one.at.items()
    }


def check_forces(scene: Scene, one: Sampled) -> int:
    """Check that forces add up to 0 and return the number of comparisons in which rounding hides little."""
    sharp, t, (_, laws, _) = 0, one.h * INSTANTS, KINDS[scene.slug]
    beside = laws(scene, t, rounded(one))
    for name, terms in laws(scene, t, one.at).items():
        size, rest = sum(map(np.abs, terms)), np.abs(sum(terms))
        rounding = sum(np.abs(near - term) for near, term in zip(beside[name], terms, strict=True))
        assert np.all((rest <= 1e-7 * size + rounding) | ~one.smooth), (name, rest, size, dict(scene.values))
        sharp += int(np.sum(one.smooth & (rounding < 1e-4 * size)))
    return sharp


def check_start(scene: Scene, one: Sampled) -> None:
    for name in one.at:
        if (said := start(scene, name)) is not None:
            reach = one.at[name].reach
            x, v = one.begun[name][0], one.begun[name] @ AT_START / one.h
            assert x == pytest.approx(said[0], rel=1e-12, abs=1e-12 * reach), (name, dict(scene.values))
            assert v == pytest.approx(said[1], rel=1e-7, abs=1e-8 * reach / one.h), (name, dict(scene.values))


def check_sums(scene: Scene, one: Sampled) -> None:
    beside = sums(scene, rounded(one), one.columns)
    for name, terms in sums(scene, one.at, one.columns).items():
        if name in one.columns:
            least = 1e-6 * one.at[name].reach if name in one.at else 1e-9 * np.abs(one.window[name]).max()
            size, rounding = sum(map(np.abs, terms)) + least, np.abs(sum(beside[name]) - sum(terms))
            off = np.abs(one.columns[name] - sum(terms))
            assert np.all((off <= 1e-6 * size + rounding) | ~one.smooth), (name, off, size, dict(scene.values))


def is_smooth(s: Any, t: Any, at: Mapping[str, Moved]) -> Any:
    """At which instants no push jumps and no aircraft stalls between seven instants."""
    if s.slug == "phugoid":
        return np.hypot(at["x"].v, at["y"].v) > STALLED * s.v_0
    if s.slug != "driven" or s.push in ("sine", "step", "impulse"):
        return np.ones(len(t), bool)
    shares = np.array([0.0, 0.25, 0.5, 0.75, s.width])
    cycles = s.omega * t[:, [0, -1]] / (2 * math.pi)
    turns = np.floor(cycles[:, :, None] - shares)
    near = np.abs(cycles[:, :, None] - shares - np.round(cycles[:, :, None] - shares)) < 1e-9
    return ~((turns[:, 0] != turns[:, 1]) | near.any(axis=1)).any(axis=1)


@pytest.mark.parametrize("slug", KINDS)
def test_a_motion_begins_as_it_is_said_and_obeys_its_equation(slug: str) -> None:
    sharp = 0

    def compare(scene: Scene, one: Sampled | None) -> None:
        nonlocal sharp
        if one:
            sharp += check_forces(scene, one)
            check_start(scene, one)
            check_sums(scene, one)

    in_any_state(SCENES[slug], sampled, compare, 80, **({"view": "hunt"} if slug == "modes" else {}))
    assert sharp > 50


def test_as_a_mass_wants_takes_its_force_away() -> None:
    """With equal masses and springs the flag sets the double next to the golden ratio, and the button its shape."""
    for i in (1, 2):
        told = say(Page(ModesScene(view="guess")), "act", name=f"row{i}")["view"]["values"]
        assert told[f"add{i}_N"] == "+0.00 N" != told[f"add{3 - i}_N"]
    scene = ModesScene(view="guess", **ModesScene.presets["All equal"])
    golden = (math.sqrt(5) - 1) / 2
    assert scene.shown.scalars["w_slow_si"] == pytest.approx(golden, rel=1e-15)
    scene.omega = scene.shown.scalars["w_slow_si"]
    told = say(Page(scene), "act", name="row1")
    assert told["state"]["parameters"]["ratio"] == pytest.approx(1 / golden, rel=1e-14)
    assert told["view"]["values"]["add2_N"] == "+0.00 N"


def crosses(scene: ModesScene) -> list[complex]:
    """The places of the four crosses in 1/s, also outside the frame."""
    re, im = (scene.shown.axes[name] for name in ("re", "im"))
    places = scene.shown.scalars
    return [
        complex(places[f"root{j}_re"] * 10.0**re.exponent, places[f"root{j}_im"] * 10.0**im.exponent) for j in range(4)
    ]


def check_crosses(case: Case, scene: ModesScene) -> None:
    found, shown, true = crosses(scene), scene.shown, case.damped.roots.tolist()
    largest = max(map(abs, true))
    assert max(min(abs(s - one) for one in found) for s in true) < 2e-3 * largest  # four roots that are one
    assert sorted(s.imag for s in found) == pytest.approx(sorted(-s.imag for s in found), abs=1e-9 * largest)
    beyond = sorted((s.real for s in true if s.real < shown.axes["re"].start), reverse=True)
    assert shown.values["out"] == ", ".join(map(three, beyond)), "the roots left of the plane, nearest first"


def check_paths(case: Case, scene: ModesScene, grows: Varied) -> None:
    """Every point of a path is a root at some dashpot, and no path jumps to another one."""
    paths, path = scene.sources["paths"].data, RootPath.of(case.damped, grows)
    unit = case.chain.modes().omega[1]
    for j in range(4):
        s = paths[f"re{j}"] + 1j * paths[f"im{j}"]
        for one in s[:: max(1, len(s) // 12)].tolist():
            if abs(one.real) < 2.997 * unit:
                near = path.at(path.dragged(one)).roots
                assert min(abs(near - one)) < 2e-3 * max(abs(one), 1e-3 * unit)
        steps = np.abs(np.diff(np.clip(s.real, -2 * unit, None) + 1j * s.imag))
        assert steps.max() < 0.35 * unit


def upper(case: Case) -> list[tuple[complex, complex]]:
    """s and X2/X1 of each root that swings, by another computation."""
    return [(complex(s), complex(X2 / X1)) for s, X1, X2 in eigenvectors(case) if 2 * s.imag > NEAR * abs(s)]


def lines(scene: ModesScene) -> list[str]:
    """The lines on the roots, as they are read."""
    names = [scene.shown.values[f"{place}_name"] for place in PLACES]
    return [line for line in sentences(scene) if any(name and line.startswith(f"{name}: ") for name in names)]


@settings(max_examples=tries(100), phases=(Phase.explicit, Phase.generate))
@given(cases(), st.sampled_from(WAYS))
@example(Case(TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0), 50.0, 50.0), "both")  # two roots left of the plane
@example(Case(TwoMassChain(m1=27.8, m2=0.00541, k1=1.0, k2=0.0), 1.0, 0.0), "c1")  # roots meet far from the light mass
def test_crosses_paths_and_what_is_said_of_the_roots_and_of_the_motions_are_true(case: Case, grows: Varied) -> None:
    scene = ModesScene(view="roots", grows=grows, **case.values)
    check_crosses(case, scene)
    if case.chain.modes().omega[1] and max(case.c1, case.c2) > 1e-100:  # else no dashpot in doubles for each place
        check_paths(case, scene, grows)
    check_roots(case, scene)
    check_statement(case, visible_text(scene))


def check_roots(case: Case, scene: ModesScene) -> None:
    """Each root is said with its numbers."""
    true = upper(case)
    sizes = [abs(float(part)) for s, _, _ in eigenvectors(case) for part in (s.real, s.imag)]
    told, every = lines(scene), case.damped.free_motions.modes
    assert len(told) == len(every)
    swings = [line for line in told if "It swings" in line]
    pairs = sum(2 if "each twice" in line else 1 for line in swings)
    assert pairs == len(true) and all("±" in line and "ζ" in line for line in swings)
    frequencies = [one for one in scene.readouts() if one.symbol.startswith("ω")]
    assert len(frequencies) == len(swings) and all(one.value > 0 for one in frequencies)
    for line in told:
        assert ("±" in line) == ("It swings" in line)
        assert ("It does not swing" in line or "critical" in line or "s=0" in line) != ("It swings" in line)
        for value in map(abs, numbers(line.split("s=")[-1].split(" 1/s")[0])):
            assert not value or any(math.isclose(value, one, rel_tol=6e-3) for one in sizes), (line, sizes)


def check_statement(case: Case, text: str) -> None:
    """The sentence on the motions is true."""
    (chain, c1, c2), true = case, eigenvectors(case)
    ratios = [ratio for _, ratio in upper(case)]
    swinging, drifts = len(ratios), not (chain.k1 or c1) or not (chain.k2 or c2)
    assert drifts == ("Nothing brakes the drift" in text)
    assert ("both drift" in text) == (not (chain.k1 or c1)) and ("it drifts" in text) == (not (chain.k2 or c2))
    assert ("What is left at the end" in text) == (not drifts and not (chain.k1 and chain.k2))
    if not (chain.k1 and chain.k2):
        return
    assert "creeps home" not in text and "stays where it is" not in text
    assert ("Nothing swings" in text or "Neither swings" in text) == (not swinging)
    assert ("One motion swings, two do not" in text or "One pair of roots swings, one does not" in text) == (
        swinging == 1 and "stay in line" not in text
    )
    assert ("stay in line" in text) == case.damped.proportional
    if "stay in line" in text:
        assert all(abs(math.sin(cmath.phase(ratio))) < 1e-6 for ratio in ratios)
    else:
        assert max(c1, c2) < 1e-9 or all(abs(math.sin(cmath.phase(ratio))) > 1e-60 for ratio in ratios)
    if "lags behind" in text or "leads mass 1" in text:
        assert swinging == 2 and all((ratio.imag < 0) == ("lags behind" in text) for ratio in ratios)
    if "outlasts" in text:
        slowest = min(true, key=lambda root: abs(root[0]))
        assert (slowest[2] / slowest[1]).real < 0
    roots = [s for s, _ in upper(case)]
    assert ("have become one" in text) == (swinging == 2 and abs(roots[0] - roots[1]) < NEAR * abs(roots[0]))
