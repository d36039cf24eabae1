"""Causes of residuals: simulated motions with one cause each, and the noise of a camera."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from physics.fit import Caution, fit_damped
from physics.residuals import Cause, cause_of

T = np.linspace(0.0, 12.0, 361)
OMEGA, START, NOISE = 6.3, 0.08, 5.5e-4
SEEDS = range(20)


def dashpot() -> np.ndarray:
    return np.asarray(START * np.exp(-0.08 * T) * np.cos(OMEGA * T))


def with_force(force: Callable[[float, float], float]) -> np.ndarray:
    """The displacement under a force per mass in addition to the spring's."""
    found = solve_ivp(
        lambda _, s: [s[1], -(OMEGA**2) * s[0] + force(*s)], (0.0, 12.0), [START, 0.0], t_eval=T, rtol=1e-8, atol=1e-11
    )  # fmt: skip
    return np.asarray(found.y[0])


def dry(shift: float) -> np.ndarray:
    """Half cycles about two places `shift` from the middle, in turn, until the spring is too weak."""
    n = np.minimum(np.floor(OMEGA * T / np.pi), np.floor((START / shift + 1) / 2))
    swing = START - (2 * n + 1) * shift
    return np.where(swing > 0, swing * np.cos(OMEGA * T), -((-1) ** n) * 0) + np.where(swing > 0, (-1) ** n * shift, 0)


@cache
def motion(name: str) -> np.ndarray:
    match name:
        case "strong air":
            return with_force(lambda x, v: -1.5 * abs(v) * v)
        case "weak air":
            return with_force(lambda x, v: -0.1 * v - 0.4 * abs(v) * v)
        case "dry":
            return dry(0.0015)
        case "dry until it stops":
            return dry(0.004)
        case "stiff spring":
            return with_force(lambda x, v: -0.1 * v - 40 * OMEGA**2 * x**3)
        case "drift":
            return dashpot() + 0.01 * np.sin(0.4 * T + 0.3) ** 2
        case "faster mode":
            return dashpot() + 0.004 * np.cos(11.7 * T + 1)
        case "slower mode":
            return dashpot() + 0.003 * np.cos(2.1 * T + 1)
    return dashpot()


@pytest.mark.parametrize(
    ("name", "cause"),
    [
        ("strong air", Cause.AIR),
        ("weak air", Cause.AIR),
        ("dry", Cause.DRY),
        ("dry until it stops", Cause.DRY),
        ("stiff spring", Cause.SPRING),
        ("drift", Cause.DRIFT),
        ("faster mode", Cause.OTHER),
        ("slower mode", Cause.OTHER),
    ],
)
def test_each_cause_is_distinguished_from_the_others(name: str, cause: Cause) -> None:
    for seed in SEEDS:
        fit = fit_damped(T, motion(name) + np.random.default_rng(seed).normal(0, NOISE, T.size))
        assert Caution.CORRELATED in fit.cautions
        assert cause_of(T, fit)[0] is cause


@pytest.mark.parametrize(("name", "omega"), [("faster mode", 11.7), ("slower mode", 2.1)])
def test_the_strongest_frequency_is_that_of_the_other_motion(name: str, omega: float) -> None:
    fit = fit_damped(T, motion(name) + np.random.default_rng(1).normal(0, NOISE, T.size))
    assert cause_of(T, fit)[1] == pytest.approx(omega, abs=np.pi / T[-1])


def test_a_dashpot_leaves_random_residuals() -> None:
    fits = (fit_damped(T, dashpot() + np.random.default_rng(seed).normal(0, NOISE, T.size)) for seed in SEEDS)
    assert all(Caution.CORRELATED not in fit.cautions for fit in fits)


def test_too_few_cycles_or_rows_say_nothing_of_friction() -> None:
    for rows in (slice(0, 80), slice(0, None, 8)):
        t, x = T[rows], motion("strong air")[rows]
        assert cause_of(t, fit_damped(t, x + np.random.default_rng(2).normal(0, NOISE, t.size)))[0] is Cause.OTHER
