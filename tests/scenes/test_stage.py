"""The signals that only a stage plays, such as arrows and forces, by formulas of their own; and masses never meet."""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from components.chain import EQUILIBRIUM, WALL
from components.scenes import SCENES
from tests.page.scripts import played
from tests.physics.braked_cases import case_of

SHARES = np.array([0.0, 0.13, 0.37, 0.71, 0.98])
"""Instants in windows."""
NEXT = 1e-5
"""The distance of instants, in windows, by which velocities are differences."""
Played = Mapping[str, Any]
Pairs = dict[str, tuple[Any, Any]]


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
