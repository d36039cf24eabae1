"""The motions of the scenes without their closed forms: matrix exponentials, Taylor series, linear equations.

In the working precision of mpmath; each gives, at one time or frequency, the values of the rows by their names.
"""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp


def flow(matrix: list[list[float]], start: list[float], t: float) -> list[Any]:
    """exp(matrix t) start: the motion of a linear system, without its modes."""
    A, time = mp.matrix(matrix), mp.mpf(t)
    with mp.extradps(2 * max(0, int(mp.log10(1 + mp.mnorm(A) * time)))):
        return list(mp.expm(A * time) * mp.matrix(start))


def chain_flow(scene: Any, t: float) -> dict[str, Any]:
    m1, m2, k1, k2 = map(mp.mpf, (scene.m1, scene.m2, scene.k1, scene.k2))
    F, w = (mp.mpf(getattr(scene, name, 0)) for name in ("F_0", "omega"))
    matrix = [
        [0, 0, 1, 0, 0, 0],
        [0, 0, 0, 1, 0, 0],
        [-(k1 + k2) / m1, k2 / m1, 0, 0, F / m1, 0],
        [k2 / m2, -k2 / m2, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, w],
        [0, 0, 0, 0, -w, 0],
    ]
    x1, x2, *_ = flow(matrix, [scene.x1_0, scene.x2_0, scene.v1_0, scene.v2_0, 0, 1], t)
    return {"$x_1$": x1, "$x_2$": x2}


def oscillator_flow(scene: Any, t: float) -> dict[str, Any]:
    square = mp.mpf(scene.k) / mp.mpf(scene.m)
    x, v = flow([[0, 1], [-square, 0]], [scene.x_0, scene.v_0], t)
    T, V = scene.m * v**2 / 2, scene.k * x**2 / 2
    return {"$x$": x, "$v$": v, "$a$": -square * x, "$T$": T, "$V$": V}


def damped_flow(scene: Any, t: float) -> dict[str, Any]:
    m, c, k = map(mp.mpf, (scene.m, scene.c, scene.k))
    x, v = flow([[0, 1], [-k / m, -c / m]], [scene.x_0, scene.v_0], t)
    V = k * x**2 / 2
    return {"$x$": x, "$V$": V, "$T + V$": V + m * v**2 / 2, "$P$": c * v**2}


def pendulum_flow(scene: Any, t: float) -> dict[str, Any]:
    angle, square = mp.mpf(math.radians(scene.theta_0)), mp.mpf(scene.pendulum_g) / mp.mpf(scene.pendulum_l)
    theta, _ = mp.odefun(lambda _, y: [y[1], -square * mp.sin(y[0])], 0, [angle, 0])(mp.mpf(t))
    return {r"$\theta$": theta, "spring": angle * mp.cos(mp.sqrt(square) * t)}


def flight_flow(scene: Any, t: float) -> dict[str, Any]:
    speed, g = mp.mpf(scene.v_0), mp.mpf(scene.g)

    def rates(_: Any, state: Any) -> list[Any]:
        u, w, _ = state
        V = mp.hypot(u, w)
        return [-V * w, V * u - 1, w]

    u, w, h = mp.odefun(rates, 0, [1 + mp.mpf(scene.excess), 0, 0])(t * g / speed)
    start = (1 - (1 + mp.mpf(scene.excess)) ** 2) / 2
    return {"$h'$": (h + start) * speed**2 / g, "$v'$": (mp.hypot(u, w) - 1) * speed}


def swing_at(scene: Any, w: float) -> dict[str, Any]:
    """The steady swing from Newton's laws as linear equations."""
    m1, m2, k1, k2, w = map(mp.mpf, (scene.m1, scene.m2, scene.k1, scene.k2, w))
    X1, X2 = mp.lu_solve(mp.matrix([[k1 + k2 - m1 * w**2, -k2], [-k2, k2 - m2 * w**2]]), mp.matrix([scene.F_0, 0]))
    bare = scene.F_0 / (k1 - m1 * w**2)
    names = (r"$X_{\mathrm{p}1}$", r"$X_{\mathrm{p}2}$", "$|X_1|$", "$|X_2 - X_1|$", "$|X_1|$ alone")
    return dict(zip(names, (X1, X2, abs(X1), abs(X2 - X1), abs(bare)), strict=True))
