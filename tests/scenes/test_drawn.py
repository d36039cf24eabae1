"""The browser draws curves that are motions of the physics, marks on their curves, and true signals on the stage.

Draggable shapes of every scene use names of the scene, and the frame stays fixed during a drag.
"""

import math
from collections import Counter
from collections.abc import Callable, Mapping
from itertools import product
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from components.chain import EQUILIBRIUM, START, WALL
from components.language.shapes import Along, AnyShape, Grab
from components.language.signals import Sampled
from components.quantities.axes import TIME_AXIS, Axis
from components.quantities.instant import instant
from components.scene import Picture, Scene
from components.scenes import SCENES
from components.scenes.coupled import BY_MODES
from components.state.page_state import fitted
from components.state.scene_sheet import column_axes, plots
from tests.grids import WHOLE
from tests.page.hand import Hand, grabs, sets
from tests.page.headless_page import picture_wire
from tests.page.scripts import played
from tests.physics.truth import case_of
from tests.scenes.checks import choices, in_any_state, scaled

pytestmark = pytest.mark.timeout(600)
TABLES = {"driven", "absorber"}
"""Scenes whose motions are tables in some states."""
OFF = {"absorber": 1e-7}
"""The error of motions of a scene, relative to the frame, in place of CLOSED."""
CORNERS = {"x_sliced": 5e-3}
"""The velocity of a sum of slices has a corner at each slice, which sampling cuts off."""
TOLD, CLOSED = 1e-6, 1e-9
"""Error of a motion sent as a table of one period, and of one sent as a formula."""
SHARES = np.array([0.0, 0.13, 0.37, 0.71, 0.98])
"""Instants in windows."""
NEXT = 1e-5
"""The distance of instants, in windows, by which velocities are differences."""
Played = Mapping[str, Any]
Pairs = dict[str, tuple[Any, Any]]
AT = 0.37
"""The instant at which a hand takes hold, in the unit of the time axis."""
ROOM = 0.6
"""Pixels: a drag rounds the set value to about half a pixel."""
OFTEN = 100 if WHOLE else 3
"""In how many states each shape is dragged."""
ALSO: dict[str, tuple[dict[str, Any], ...]] = {
    "modes": (
        {"view": "guess"},
        {"view": "guess", "ratio": 2.0},
        *({"view": "roots", "grows": grows, "c1": c, "c2": c} for grows in ("c1", "c2", "both") for c in (0.5, 10.0)),
    ),
    "absorber": ({"view": "rest", "x1_0": 0.002},),
}
"""States in which something else is in hand."""
FOLLOWS = {"damped": ("c",), "driven": ("c",), "absorber": ("k2",), "coupled": ("given_by", *BY_MODES, *START)}
"""Parameters that follow from one that is set: a tuned spring follows the speed, modes a start."""


def axis_of(scene: type[Scene], picture: Picture, source: str, name: str) -> Axis:
    """Return the axis of a curve. For a chain's masses, which are drawn by colour, it is the axis of the signal."""
    return picture.axes[column_axes(scene)[source][name] if source in column_axes(scene) else "y"]


@pytest.mark.parametrize("slug", SCENES)
def test_what_is_drawn_is_the_motion_of_the_physics_with_enough_points(slug: str) -> None:
    kind, checked = SCENES[slug], 0

    def compare(scene: Scene, _: object) -> None:
        nonlocal checked
        checked += check_drawn(scene)
        check_points(scene)

    def drawn(scene: Scene) -> object:
        return [trace.columns for trace in scene.shown.traces.values()]

    ways = (way for way in choices(kind) if not any(kind.linked()[name] in kind.physical for name in way))
    in_any_state(kind, drawn, compare, 0 if slug in TABLES else 48, rare=ways)
    assert checked or not any(plot.time for plot in plots(kind))


def check_drawn(scene: Scene) -> int:
    """Compare each curve that the browser draws with the physics, and return how many there are."""
    shown, wire = scene.shown, picture_wire(scene)["columns"]
    by_table = any(isinstance(one, Sampled) for one in shown.signals.values())
    near = TOLD if by_table else OFF.get(scene.slug, CLOSED)
    curves = {(source, name): one.columns[name] for source, one in shown.traces.items() for name in one.names}
    for (source, name), exact in curves.items():
        axis = axis_of(type(scene), shown, source, name)
        off = np.abs(wire[source][name] - axis.places(exact)).max() / abs(axis.place(axis.end) - axis.place(axis.start))
        assert off < CORNERS.get(name, near), (dict(scene.values), source, name, off)
        trace, third = shown.traces[source], len(exact) // 3
        now = instant(shown.signals, shown.scalars, shown.axes[TIME_AXIS].place(trace.t[third]))
        signal, size = trace.signals.get(name, name), abs(axis.place(axis.end) - axis.place(axis.start))
        if signal in now:  # not a mass of a chain
            assert now[signal] == pytest.approx(axis.places(exact)[third], abs=1e-6 * size), "in Python too"
    for source, one in shown.traces.items():
        np.testing.assert_allclose(wire[source]["t"], shown.axes[TIME_AXIS].places(one.t), rtol=1e-14, atol=0)
    return len(curves)


def check_points(scene: Scene) -> None:
    """With eight times as many instants a curve reaches as far, apart from what twelve points per cycle miss.

    A motion that ends before the second point is too short to be seen.
    """
    for source, one in scene.shown.traces.items():
        dense = one.exact(np.linspace(0.0, one.end, 8 * (one.count - 1) + 1))
        for name in one.names:
            axis, drawn = axis_of(type(scene), scene.shown, source, name), one.columns[name]
            later = np.append(dense[name][0], dense[name][8:])
            reached = later.max() - drawn.max(), drawn.min() - later.min()
            roundings = 1e-12 * abs(axis.end - axis.start)
            assert 0 <= max(reached) <= 0.035 * np.ptp(dense[name]) + roundings, (dict(scene.values), source, name)


NEAR = 0.004
"""The largest distance of a mark from its curve, in widths or heights of the plot."""
QUICK = (0, -6, -6)
"""Micrometres and microseconds, as powers of ten: axes count in other powers of ten."""
Marked = list[tuple[str, str | float]]
KINDS = ("force", "base", "unbalance")
PEAK: Marked = [("peak_at", "peak_up"), ("peak_low", "peak_half"), ("peak_high", "peak_half"), ("omega_at", "M_at")]
BRAKED = {"c1": 0.1, "c2": 0.1, "omega": 1.1}
WIDTHS = (("peak", "up"), ("low", "half"), ("high", "half"))
BODE: dict[str, Marked] = {
    f"Xp{i}": [
        *((f"{x}{i}_{n}", f"{y}{i}_{n}") for (x, y), n in product(WIDTHS, (0, 1))),
        *((f"dip{i}", f"down{i}"), ("drive_at", f"Xp{i}_at")),
    ]
    for i in (1, 2)
}
ROOTS = {"view": "roots", "c1": 0.8}
PLANE = {"view": "plane", "k1": 3.0}
DRIVEN = (("log", "M", PEAK), ("linear", "M", PEAK[3:]), ("linear", "lag", [("omega_at", "lag_at")]))
MARKS: list[tuple[str, dict[str, Any], str, str, str, Marked]] = [
    *(("oscillator", {"m": 0.3, "k": 5.0, "x_0": -0.1, "v_0": 0.4}, "time", "t", y, [(f"peak_{y}", f"top_{y}")])
     for y in "xva"),
    *(("driven", {"kind": kind, "c": c, "axes": axes, "omega": 5.0}, "below", "omega", y, pairs)
     for kind, c, (axes, y, pairs) in product(KINDS, (0.1, 2.513), DRIVEN)),
    *(("driven", {"view": "power", "zeta": zeta}, "below", "omega", "power", [(x, "half_peak"), ("unity", "peak")])
     for zeta, x in product((0.03, 0.2, 0.5), ("half_low", "half_high"))),
    *(("forced", {"view": "bode", **BRAKED}, "branch0", "omega", y, pairs) for y, pairs in BODE.items()),
    *(("forced", {"view": "bode", **braked, "omega": 1.2}, "lag", "w", f"phi{i}", [("now", f"phi{i}_at")])
     for braked, i in product(({}, BRAKED), (1, 2))),
    *(("forced", {"view": "nyquist", **BRAKED}, "nyquist", f"re{i}", f"im{i}", [(f"re{i}_at", f"im{i}_at")])
     for i in (1, 2)),
    ("forced", {"view": "nyquist", **BRAKED}, "nyquist", "re1", "im1",
     [(f"re_mark_{one}", f"im_mark_{one}") for one in ("minus", "plus", "still")]),
    ("analogues", {"theta_0": 75.0}, "late", "angle", "excess",
     [("late_01", 0.001), ("late_1", 0.01), ("late_5", 0.05)]),
    ("absorber", {"damping": "added", "c": 200.0}, "sweep", "w", "swing",
     [("omega", "swing"), ("P_x", "P_y"), ("Q_x", "Q_y")]),
    ("absorber", {}, "sweep", "w", "stroke", [("omega", "stroke")]),
    ("absorber", {}, "sweep", "w", "alone", [("omega", "alone")]),
    ("modes", {"view": "guess"}, "det", "w", "D", [("w", "D"), ("w_held", "D_held"), ("w_slow", 0.0), ("w_fast", 0.0)]),
    ("modes", {"view": "guess"}, "row1", "w", "row1", [("w", "row1"), ("w_slow", "r_slow"), ("w_fast", "r_fast")]),
    ("modes", {"view": "guess"}, "row2_below", "w", "row2_below", [("w_slow", "r_slow")]),
    ("modes", {"view": "guess"}, "row2_above", "w", "row2_above", [("w", "row2"), ("w_fast", "r_fast")]),
    *(("modes", {**ROOTS, "grows": grows}, "paths", f"re{j}", f"im{j}", [(f"root{j}_re", f"root{j}_im")])
     for grows, j in product(("c1", "c2", "both"), range(4))),
    *(("coupled", PLANE, "modes", f"{one}1", f"{one}2", [(f"{one}_name1", f"{one}_name2")])
     for one in ("slow", "fast")),
    ("damped", {}, "time", "t", "x", [(f"peak{n}_t", f"peak{n}_x") for n in range(4)]),
    ("damped", {}, "time", "t", "x", [("quickest_t", "quickest_x")]),
    ("damped", {"view": "energy"}, "time", "t", "P", [("quickest_t", "P_max")]),
    ("phugoid", {"view": "period"}, "periods", "v_0", "tau",
     [(f"at_{one}", f"tau_at_{one}") for one in ("light", "glider")]),
    ("phugoid", {}, "path", "x", "y", [("top_x", "top_y")]),
    ("phugoid", {}, "path", "x_lin", "y_lin", [("top_lin_x", "top_lin_y")]),
    ("driven", {"view": "harmonics", "push": "square", "omega": 1.7}, "below", "omega", "M", PEAK[:3]),
]  # fmt: skip
"""A state, the columns of a curve, and the scalars or numbers in SI units that are on it."""


@pytest.mark.parametrize("is_quick", [False, True])
@pytest.mark.parametrize(("slug", "values", "source", "x", "y", "pairs"), MARKS, ids=lambda one: str(one)[:30])
def test_a_mark_is_on_its_curve(
    slug: str, values: dict[str, Any], source: str, x: str, y: str, pairs: Marked, is_quick: bool
) -> None:
    scene = SCENES[slug].at(values)
    shown = (scaled(scene, QUICK) if is_quick else scene).shown
    across, up = (shown.axes[column_axes(SCENES[slug])[source][name]] for name in (x, y))
    curve = np.stack([shares(axis, axis.places(shown.sources[source][name])) for axis, name in ((across, x), (up, y))])
    for at, high in pairs:
        mark = shown.scalars[at], shown.scalars[high] if isinstance(high, str) else up.place(high)
        place = np.array([shares(axis, one) for axis, one in zip((across, up), mark, strict=True)])
        start, way = curve[:, :-1], np.diff(curve)
        to = place[:, None] - start
        share = np.clip(np.sum(to * way, axis=0) / np.maximum(np.sum(way * way, axis=0), 1e-300), 0.0, 1.0)
        distance = np.sqrt(np.sum((to - share * way) ** 2, axis=0)).min()
        assert distance < NEAR, (at, high, place)


def shares(axis: Axis, places: Any) -> Any:
    """Places on an axis in its lengths."""
    return places / abs(axis.place(axis.end) - axis.place(axis.start))


def turning_arrow(s: Any, t: Any, now: Played) -> Pairs:
    """The tip of the arrow is on the level of x, its side on that of v over omega."""
    w = math.sqrt(s.k / s.m)
    C, start = math.hypot(s.x_0, s.v_0 / w), math.atan2(s.x_0, s.v_0 / w)
    both = {"sine": np.sin(w * t + start), "cosine": np.cos(w * t + start)}
    return {name: (now[name], one) for name, one in both.items()} | {"x": (C * now["sine"], now["x"])}


def pendulum(s: Any, t: Any, now: Played) -> Pairs:
    """The energies of a pendulum, and those of its linear model, from its displacements."""
    lift, start = s.pendulum_m * 9.81 * s.pendulum_l, math.radians(s.theta_0)
    q, x = now["q"], now["x"]
    totals = {"q": lift * (1 - math.cos(start)), "x": lift * start**2 / 2}
    parts = {"V_q": lift * (1 - np.cos(q)), "V_x": lift * x**2 / 2}
    parts |= {f"T_{name}": totals[name] - parts[f"V_{name}"] for name in totals}
    return {name: (now[name], one) for name, one in parts.items()}


def lift_on_path(s: Any, t: Any, now: Played) -> Pairs:
    """Lift is square to the path, in proportion to the square of the speed; each nose points along its path."""
    across = now["lift_forward"] * now["u"] + now["lift_up"] * now["w"]
    found = {
        "square": (across, np.zeros_like(t)),
        "size": (np.hypot(now["lift_forward"], now["lift_up"]), now["u"] ** 2 + now["w"] ** 2),
    }
    noses = {f"nose{of}": (now["w" + of] * now[f"x{of}'"], now["u" + of] * now[f"y{of}'"]) for of in ("", "_lin")}
    return found | noses


def machine(s: Any, t: Any, now: Played) -> Pairs:
    """The motion of a machine with its absorber, steady or from a start, and the pull on it."""
    attached = s.tuning != "detached"
    k2, c = attached * s.k2, attached * (s.damping == "added") * s.c

    def rates(t: float, y: Any) -> list[float]:
        pull = k2 * (y[1] - y[0]) + c * (y[3] - y[2])
        return [y[2], y[3], (s.F_0 * math.sin(s.omega * t) - s.k1 * y[0] + pull) / s.m1, -pull / s.m2]

    start = np.array([s.x1_0, s.x2_0, s.v1_0, s.v2_0])
    if s.view != "rest":
        link, square = k2 + 1j * c * s.omega, s.omega**2
        X = np.linalg.solve([[s.k1 + link - s.m1 * square, -link], [-link, link - s.m2 * square]], [s.F_0, 0.0])
        start = np.array([*X.imag, *(1j * s.omega * X).imag])
    y = solve_ivp(rates, (0, t[-1]), start, "DOP853", t, rtol=1e-11, atol=1e-14).y
    found = {f"x{i}": (now[f"x{i}"] * 10.0 ** s.shown.axes[f"X{i}"].exponent, y[i - 1]) for i in (1, 2)}
    return found | {"pull_now": (now["pull_now"], k2 * (y[1] - y[0]) + c * (y[3] - y[2]))}


def forces_on_masses(s: Any, t: Any, now: Played) -> Pairs:
    """The arrows of the forces on both masses, from their displacements and velocities."""
    one, two = now["x1"], now["x2"]
    v = now["x1'"], now["x2'"]
    braked = s.slug == "forced"
    push, c1, c2 = (s.F_0 * np.sin(s.omega * t), s.c1, s.c2) if braked else (0.0, 0.0, 0.0)
    tie = s.k2 * (two - one) + c2 * (v[1] - v[0])
    size = s.shown.scalars["newton"] * s.F_0 / s.shown.scalars["push"] if braked else 1.0
    forces = {"F1": push + tie - s.k1 * one - c1 * v[0], "F2": -tie}
    return {name: (now[name] * size, true) for name, true in forces.items()}


def roots(s: Any, t: Any, now: Played) -> Pairs:
    """Re(X exp(s t)) for the root of each drawn motion, whose phase is that of mass 1 or of mass 2."""
    case = case_of({name: getattr(s, name) for name in ("m1", "m2", "k1", "k2", "c1", "c2")})
    found: Pairs = {}
    for place, one in zip(("slow", "fast"), case.damped.free_motions.modes, strict=False):
        turned = np.exp(one.exponents[0] * t)
        found |= {f"x{i}_{place}": (now[f"x{i}_{place}"], (one.shape[i - 1] * turned).real) for i in (1, 2)}
    return found


OWN = {"own": True, "omega": 1.0, "tuning": "free"}
TWICE = {**OWN, "damping": "added", "m1": 400.0, "k1": 625.0, "F_0": 100.0, "m2": 225.0, "k2": 144.0, "x1_0": 0.3}
STARTED: list[dict[str, Any]] = [
    {**OWN, "damping": "none", "m1": 2.0, "k1": 4.0, "F_0": 1.0, "m2": 1.0, "k2": 2.0},
    *({"damping": "added", "tuning": "free", **one} for one in ({"c": 313.7, "k2": 27.4e3}, {"c": 2000.0})),
    *({**TWICE, "c": c} for c in (216.0, 216.0000001, 230.0)),
    {**TWICE, "m1": 1.0, "k1": 1.0, "m2": 1.0, "k2": 0.0, "c": 1.0},
]
"""Machines at a resonance, with strong damping, with equal exponents (c = 216), and with a dashpot alone."""
PUSHED = ({"m1": 2.0, "k2": 2.0}, {"k1": 0.0, "x1_0": 0.3}, {"c1": 0.4, "c2": 0.2, "v2_0": 0.1, "F_0": 3.0})
STATES: list[tuple[str, Callable[..., Pairs], dict[str, Any]]] = [
    *(("oscillator", turning_arrow, {"x_0": x, "v_0": v}) for x, v in ((-0.1, -0.8), (0.15, 0.0), (0.0, 0.8))),
    ("analogues", pendulum, {"theta_0": 100.0, "pendulum_m": 2.0, "pendulum_l": 0.5}),
    ("phugoid", lift_on_path, {"view": "lift", "excess": 0.3}),
    *(("absorber", machine, one) for one in ({"k2": 30e3}, {"damping": "added", "c": 200.0})),
    *(("absorber", machine, {"view": "rest", **one}) for one in ({}, {"tuning": "detached"}, *STARTED)),
    *(("forced", forces_on_masses, {"view": "forces", **one}) for one in PUSHED),
    ("coupled", forces_on_masses, {"view": "forces", "m1": 2.0, "k2": 3.0, "v1_0": 0.3}),
    *(("modes", roots, {"view": "roots", "c1": c, "c2": 0.3 * c}) for c in (0.1, 0.6, 8.0)),
]


@pytest.mark.parametrize(("slug", "true", "values"), STATES, ids=lambda one: str(getattr(one, "__name__", one)))
def test_what_a_stage_plays_is_true(slug: str, true: Callable[..., Pairs], values: dict[str, Any]) -> None:
    scene = SCENES[slug].at(values)
    axis = scene.shown.axes["t"]
    near = SHARES[:, None] + NEXT * np.array([-1, 0, 1])
    every = played(scene.shown, near * axis.place(axis.end))
    now = {name: one[:, 1] for name, one in every.items()}
    now |= {f"{name}'": (one[:, 2] - one[:, 0]) / (2 * NEXT * axis.end) for name, one in every.items()}
    for name, (found, expected) in true(scene, SHARES * axis.end, now).items():
        size = max(np.abs(expected).max(), np.abs(found).max(), 1e-9)
        np.testing.assert_allclose(found, expected, atol=2e-4 * size, rtol=0, err_msg=name)


@pytest.mark.parametrize(
    "values", [{"k2": 5.0}, {"m1": 10.0, "x1_0": -2.0}, {"x2_0": 2.0, "v1_0": 5.0}, {"k1": 0.0, "v1_0": 3.0}]
)
def test_blocks_never_meet(values: dict[str, float]) -> None:
    scene = SCENES["coupled"](**values)
    data, scalars = scene.sources["time"].data, scene.shown.scalars
    metre = scalars["metre"] * 10.0 ** -scene.shown.axes["x"].exponent
    one, two = (EQUILIBRIUM[i] + metre * data[f"x{i + 1}"] for i in (0, 1))
    assert np.all(one - scalars["side1"] / 2 > WALL)
    assert np.all(two - one > (scalars["side1"] + scalars["side2"]) / 2)
    assert np.all(two + scalars["side2"] / 2 <= 1)


def test_masses_along_the_chain_never_meet() -> None:
    scene = SCENES["chain"](N=50, starts="mass", way="along")
    columns = scene.shown.sources["time"]
    x = scene.shown.scale * np.array([columns[f"x{p}"] for p in range(1, 51)])
    assert "times as large" in scene.shown.to_scale and np.diff(x, axis=0).min() > -0.9 * scene.a


@pytest.mark.parametrize("slug", SCENES)
def test_each_grab_sets_what_it_names_and_its_handle_is_where_the_hand_was(slug: str) -> None:
    """In each preset and each way of showing things, on a wide page and on a phone."""
    taken = Counter[AnyShape]()
    ways = (*SCENES[slug].presets.values(), *ALSO.get(slug, ()), *choices(SCENES[slug]))
    for values, wide in (({}, False), *((values, True) for values in ways)):
        now = fitted(SCENES[slug].at(values))
        for shape, grab in grabs(now.kind, now.shown.forms):
            if taken[shape] < OFTEN:
                taken[shape] += dragged(Hand(now, shape, wide=wide, t=AT), grab)
    every = {shape for shape, _ in grabs(SCENES[slug])}
    assert {shape for shape in every if taken[shape]} == every, f"not taken in hand: {slug}"


def dragged(hand: Hand, grab: Grab) -> bool:
    """Take a grip and drag it; return whether it is drawn."""
    before, grip = hand.scene.values, hand.at()
    free = {way.across for way in grab.ways if isinstance(way, Along) and not way.parameter}
    if not grip:
        return False
    hand.set(hand.take())
    x, y = hand.at() or pytest.fail(f"{grab.label} vanishes when it is taken")
    if grab.start:
        said = f"{grab.label} jumps when it is taken: is `size` one of the parameter in SI, `place` where it is drawn?"
        assert (x, y) == pytest.approx(grip, abs=0.15), said
    for far in ((7.0, -5.0), (-9.0, 6.0)):
        values = hand.move((x + far[0], y + far[1]))
        if any(hand.scene.param[name].refusal(value) for name, value in values.items()):
            continue
        hand.set(values)
        changed = hand.scene.differing(before) & hand.scene.linked().keys()
        assert changed <= {*sets(grab), *(one.parameter for one in grab.start), *FOLLOWS.get(hand.scene.slug, ())}
        assert values.items() <= hand.scene.values.items()
        after = hand.at(moved=False) or pytest.fail(f"{grab.label} vanishes when it is dragged")
        for across, answered, drawn in zip("xy", after, hand.at() or (), strict=True):
            assert across in free or answered == pytest.approx(drawn, abs=ROOM), grab.label
        again, aside = hand.move(after), hand.move((after[0] + 1, after[1] + 1))
        for name, value in values.items():
            assert again[name] == pytest.approx(value, rel=1e-12, abs=0.1 * abs(aside[name] - value)), name
    return True


@pytest.mark.parametrize(("stiff", "exponent"), [(2.0, 0), (2e10, -6), (2e-12, 6)])
def test_the_mode_that_is_not_taken_goes_on_with_the_velocity_that_it_had(stiff: float, exponent: int) -> None:
    """The slope of its part of the motion gives the velocity, for times in s, in µs and in 10⁶ s."""
    now = fitted(SCENES["coupled"](k1=stiff, k2=stiff, v1_0=0.1 * stiff**0.5).value)
    time, place = now.shown.axes["t"].ruler, now.shown.axes["x"].ruler
    assert (time.exponent, place.exponent) == (exponent, 0)
    at, gap = 0.3 * time.end, 1e-6 * time.end
    seen = played(now.shown, [at - gap, at + gap])
    going = 0
    for shape, grab in grabs(now.kind):
        if velocities := [one for one in grab.start if one.of.startswith("v")]:
            begun = Hand(now, shape, wide=True, t=at).take()
            for one in velocities:
                before, after = seen[f"x{one.of.removeprefix('v')}"]
                slope = (after - before) / (2 * gap) / 10.0**exponent
                assert begun[one.parameter] == pytest.approx(slope, rel=1e-6), grab.label
                going += 1
    assert going == 8
