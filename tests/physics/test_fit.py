"""Damped sinusoids fitted to noisy columns: against 60 digits, and by how often their errors hold the truth.

Residuals have the cause of the motion that they are simulated with.
"""

import math
from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from physics.chain_fit import chain_of_fit
from physics.coupled import TwoMassChain
from physics.fit import Caution, fit_damped
from physics.residuals import Cause, cause_of
from physics.transient import DampedModes
from tests.grids import tries
from tests.physics.truth import each, reference

pytestmark = pytest.mark.timeout(600)  # hundreds of fits, on a machine that may be busy
SEEDS = 60
Rows = tuple[np.ndarray, np.ndarray]
CHAIN = TwoMassChain(m1=2.0, m2=1.0, k1=16.0, k2=9.0)
T = np.arange(160) * 0.08
ROWS = np.arange(40.0)


@each(reference("beyond", "fit"))
def test_fits_are_the_minimum_of_the_reference(case: dict[str, Any]) -> None:
    fit = fit_damped(case["t"], case["y"], case["modes"], sigma=case["sigma"])
    for found, se, name in ((fit.omega, fit.se_omega, "omega"), (fit.decay, fit.se_decay, "decay")):
        wanted, error = np.array(case[name], float), np.array(case[f"se_{name}"], float)
        assert np.abs(found - wanted).max() <= 1e-6 * error.min()
        assert se == pytest.approx(error, rel=1e-6)
    p = -fit.decay + 1j * fit.omega
    for i, column in enumerate(case["columns"]):
        assert abs(fit.offset[i] - float(column["offset"])) <= 1e-6 * float(column["se_offset"])
        assert fit.se_offset[i] == pytest.approx(float(column["se_offset"]), rel=1e-6)
        at_0 = (fit.C[i] - 1j * fit.S[i]) * np.exp(-p * fit.t_first)
        for Z, part in zip(at_0, column["parts"], strict=True):
            assert abs(Z - complex(float(part["C"]), -float(part["S"]))) <= 1e-6 * float(part["se_amplitude"])
        if not fit.t_first:
            errors = [float(part["se_amplitude"]) for part in column["parts"]]
            assert fit.se_amplitude[i] == pytest.approx(errors, rel=1e-6)
    if len(case["columns"]) == 1:
        assert fit.scatter == pytest.approx([float(case["scatter"])], rel=1e-9)
        assert not case["sigma"] or fit.chi_square == pytest.approx(float(case["rss"]), rel=1e-9)
    assert fit.residual == pytest.approx(np.array(case["y"]) - fit.at(case["t"]), abs=1e-15)


def made(n, periods, zeta, sigma, rng, change=None, uneven=False, kept=0.0):
    """Rows with 2 pi rad/s, amplitude 1, phase 0.5 and offset 0.3; `kept` is the share of noise from the row before."""
    w = 2 * math.pi
    t = np.arange(n) * (periods / (n - 1))
    if uneven:
        t = np.concatenate([[0.0], np.sort(rng.uniform(0, periods, n - 1))])
    noise = sigma * math.sqrt(1 - kept**2) * rng.standard_normal(n)
    for i in range(1, n if kept else 0):
        noise[i] += kept * noise[i - 1]
    y = 0.3 + np.exp(-zeta * w / math.sqrt(1 - zeta**2) * t) * np.sin(w * t + 0.5) + noise
    return change(t, y) if change else (t, y)


@cache
def chain_motion(c: float) -> np.ndarray:
    """x1 and x2 at the times T, with a dashpot c parallel to the second spring."""
    return np.asarray(DampedModes(chain=CHAIN, c=c, F_0=0.0, omega=0.0, x_0=(1.0, 0.2)).motion(T).x)


def record(rng: np.random.Generator, noise: tuple[float, float] = (0.02, 0.06), c: float = 0.0) -> np.ndarray:
    x = chain_motion(c)
    return x + 0.1 + np.array(noise)[:, None] * rng.standard_normal(x.shape)


MARKED: dict[str, tuple[Callable[..., Rows], set[Caution]]] = {
    "plain": (partial(made, 200, 10, 0.02, 0.05), set()),
    "less than a period": (partial(made, 40, 0.6, 0.1, 0.02), set()),
    "uneven": (partial(made, 60, 40, 0.005, 0.05, uneven=True), set()),
    "rounded": (partial(made, 200, 10, 0.02, 0.1, change=lambda t, y: (t, np.round(4 * y) / 4)), set()),
    "clipped": (partial(made, 200, 10, 0.02, 0.05, change=lambda t, y: (t, np.minimum(y, 0.9))), {Caution.CLIPPED}),
    "drifting": (partial(made, 60, 3, 0.1, 0.05, change=lambda t, y: (t, y + 0.2 * t / 3)), {Caution.DRIFT}),
    "few": (partial(made, 12, 2.5, 0.1, 0.02), {Caution.FEW_ROWS}),
    "another mode": (lambda rng: (T, record(rng)[0]), {Caution.CORRELATED}),
}


@pytest.mark.parametrize(("make", "cautions"), MARKED.values(), ids=MARKED)
def test_doubtful_rows_are_named(make: Callable[..., Rows], cautions: set[Caution]) -> None:
    said = [set(fit_damped(*make(np.random.default_rng(seed))).cautions) == cautions for seed in range(20)]
    assert sum(said) >= 18


def test_noise_that_hides_the_motion_is_named() -> None:
    for seed in range(40):
        noise = np.random.default_rng(seed).standard_normal(100)
        try:
            assert Caution.WEAK in fit_damped(np.arange(100) * 0.1, noise).cautions
        except ValueError as refusal:
            assert "needed" in str(refusal)


@pytest.mark.parametrize("zeta", [0.1, None])
def test_one_standard_error_holds_the_truth_as_often_as_it_says(zeta: float | None) -> None:
    """In about 68 % of the records: of less than a period of one motion, and of a chain."""
    make, w = partial(made, 40, 0.6, 0.1, 0.02), 2 * math.pi
    true = np.array([w, 0.1 * w / math.sqrt(0.99), 1.0, 0.5, 0.3])
    if not zeta:
        true = np.array([*CHAIN.modes().omega, 0.0, 0.0, *CHAIN.modes().ratio, 8.0, 4.5, 0.5])
    inside = np.zeros(true.size)
    for seed in range(SEEDS):
        rng = np.random.default_rng(seed)
        fit = fit_damped(*make(rng)) if zeta else fit_damped(T, record(rng), modes=2)
        found, errors = [*fit.omega, *fit.decay], [*fit.se_omega, *fit.se_decay]
        if zeta:
            found += [*fit.amplitude[0], *fit.phase[0], *fit.offset]
            errors += [*fit.se_amplitude[0], *fit.se_phase[0], *fit.se_offset]
        else:
            chain = chain_of_fit(fit)
            assert chain.parts is not None and fit.cautions == ()
            assert abs(chain.difference) < 4 and fit.scatter[1] / fit.scatter[0] == pytest.approx(3.0, rel=0.3)
            found, errors = [*found, *chain.ratio, *chain.parts], [*errors, *chain.se_ratio, *chain.se_parts]
        inside += np.abs(np.array(found) - true) < errors
    assert np.all((inside >= 0.5 * SEEDS) & (inside <= 0.86 * SEEDS)), inside / SEEDS


def test_correlated_noise_widens_the_errors() -> None:
    every = [made(200, 10, 0.02, 0.05, np.random.default_rng(seed), kept=0.8) for seed in range(SEEDS)]
    fits = [fit_damped(*rows) for rows in every]
    assert all(Caution.CORRELATED in fit.cautions for fit in fits)
    assert 0.5 * SEEDS <= sum(abs(fit.omega[0] - 2 * math.pi) < fit.se_omega[0] for fit in fits) <= 0.86 * SEEDS


@pytest.mark.parametrize(("noise", "c", "room"), [(1e-9, 0.0, 1e-7), (1e-4, 0.1, 1e-2)])
def test_the_chain_of_a_fit_with_two_modes(noise: float, c: float, room: float) -> None:
    """A dashpot turns the shapes and hardly changes the chain; columns in the wrong order are no chain."""
    rng = np.random.default_rng(1)
    chain = chain_of_fit(fit_damped(T, record(rng, (noise, noise), c), modes=2))
    assert chain.parts == pytest.approx([8.0, 4.5, 0.5], rel=room)
    assert chain.ratio == pytest.approx(CHAIN.modes().ratio, rel=room)
    assert chain_of_fit(fit_damped(T, record(rng)[::-1], modes=2)).parts is None


def wave(t: np.ndarray) -> np.ndarray:
    return np.asarray(0.3 + np.exp(-0.1 * t) * np.sin(3 * t + 0.4))


@settings(max_examples=tries(100))
@given(st.floats(-6, 6), st.floats(-6, 6), st.floats(-100, 100), st.integers(0, 50))
def test_units_of_time_and_length_do_not_matter(time: float, length: float, begin: float, seed: int) -> None:
    t = np.arange(80) * 0.15
    y = wave(t) + 0.02 * np.random.default_rng(seed).standard_normal(80)
    one, second, metre = fit_damped(t, y), 10.0**time, 10.0**length
    other = fit_damped(second * (t + begin), metre * y)
    assert other.omega * second == pytest.approx(one.omega, abs=1e-4 * one.se_omega[0])
    assert other.se_decay * second == pytest.approx(one.se_decay, rel=1e-5)
    assert other.amplitude / metre == pytest.approx(one.amplitude, abs=1e-4 * one.se_amplitude[0, 0])
    assert other.scatter / metre == pytest.approx(one.scatter, rel=1e-8)


def test_rows_with_holes_are_left_out_and_their_order_does_not_matter() -> None:
    t = np.arange(60) * 0.2
    y = wave(t) + 0.01 * np.random.default_rng(1).standard_normal(60)
    holes = y.copy()
    holes[[0, 7, 30]] = math.nan
    fit, kept = fit_damped(t, holes), np.isfinite(holes)
    plain = fit_damped(t[kept][::-1], y[kept][::-1])
    assert fit.omega == pytest.approx(plain.omega, rel=1e-12) and np.array_equal(fit.used, kept)
    assert np.array_equal(np.isfinite(fit.residual[0]), kept) and fit.t_first == t[1]


def test_evenly_spaced_rows_fit_two_frequencies() -> None:
    t = np.arange(60) * 0.2
    fit = fit_damped(t, wave(t) + 0.01 * np.random.default_rng(1).standard_normal(60))
    (alias,) = fit.aliases
    assert alias == pytest.approx(2 * math.pi / 0.2 - fit.omega[0])
    fast = np.exp(-fit.decay[0] * t) * (fit.C[0, 0] * np.cos(alias * t) - fit.S[0, 0] * np.sin(alias * t))
    assert fit.offset[0] + fast == pytest.approx(fit.at(t)[0], abs=1e-12)
    uneven = np.sort(np.random.default_rng(2).uniform(0, 12, 60))
    assert fit_damped(uneven, wave(uneven)).aliases == ()


@pytest.mark.parametrize(
    ("t", "y", "modes", "words"),
    [
        (ROWS, np.full(40, math.nan), 1, "0 rows"),
        (ROWS[:7], np.sin(ROWS[:7]), 1, "8 or more are needed"),
        (ROWS[:11], np.sin(ROWS[:11]), 2, "12 or more are needed"),
        (ROWS, np.ones(40), 1, "never changes"),
        (np.ones(40), ROWS, 1, "never changes"),
        (ROWS, np.ones(39), 1, "number for each time"),
        (ROWS, np.ones(40), 3, "one or two"),
        (0.005 * ROWS, wave(0.005 * ROWS) + 0.05 * np.cos(ROWS**2), 1, "is needed|are needed"),
    ],
)
def test_refusals_say_what_is_needed(t: np.ndarray, y: np.ndarray, modes: int, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        fit_damped(t, y, modes)


# Causes of residuals, with the noise of a camera.

VIDEO = np.linspace(0.0, 12.0, 361)
OMEGA, START, NOISE = 6.3, 0.08, 5.5e-4
DASHPOT = START * np.exp(-0.08 * VIDEO) * np.cos(OMEGA * VIDEO)


def with_force(force: Callable[[float, float], float]) -> np.ndarray:
    """The displacement under a force per mass in addition to the spring's."""
    found = solve_ivp(
        lambda _, s: [s[1], -(OMEGA**2) * s[0] + force(*s)], (0, 12), [START, 0], t_eval=VIDEO, rtol=1e-8, atol=1e-11
    )  # fmt: skip
    return np.asarray(found.y[0])


def dry(shift: float) -> np.ndarray:
    """Half cycles about two places `shift` from the middle, in turn, until the spring is too weak."""
    n = np.minimum(np.floor(OMEGA * VIDEO / np.pi), np.floor((START / shift + 1) / 2))
    swing = START - (2 * n + 1) * shift
    return np.where(swing > 0, swing * np.cos(OMEGA * VIDEO) + (-1) ** n * shift, 0)


SIMULATED: dict[str, tuple[Callable[[], np.ndarray], Cause | None]] = {
    "dashpot": (lambda: DASHPOT, None),
    "strong air": (lambda: with_force(lambda x, v: -1.5 * abs(v) * v), Cause.AIR),
    "weak air": (lambda: with_force(lambda x, v: -0.1 * v - 0.4 * abs(v) * v), Cause.AIR),
    "dry": (lambda: dry(0.0015), Cause.DRY),
    "dry until it stops": (lambda: dry(0.004), Cause.DRY),
    "stiff spring": (lambda: with_force(lambda x, v: -0.1 * v - 40 * OMEGA**2 * x**3), Cause.SPRING),
    "drift": (lambda: DASHPOT + 0.01 * np.sin(0.4 * VIDEO + 0.3) ** 2, Cause.DRIFT),
    "faster mode": (lambda: DASHPOT + 0.004 * np.cos(11.7 * VIDEO + 1), Cause.OTHER),
    "slower mode": (lambda: DASHPOT + 0.003 * np.cos(2.1 * VIDEO + 1), Cause.OTHER),
}


@pytest.mark.parametrize("name", SIMULATED)
def test_each_cause_is_distinguished_from_the_others(name: str) -> None:
    x, cause = SIMULATED[name][0](), SIMULATED[name][1]
    for seed in range(8):
        noise = np.random.default_rng(seed).normal(0, NOISE, VIDEO.size)
        fit = fit_damped(VIDEO, x + noise)
        assert (Caution.CORRELATED in fit.cautions) == (cause is not None)
        if cause:
            found, omega = cause_of(VIDEO, fit)
            assert found is cause
            assert cause is not Cause.OTHER or omega == pytest.approx(11.7 if "fast" in name else 2.1, abs=np.pi / 12)
        for rows in (slice(0, 80), slice(0, None, 8)) if name == "strong air" else ():  # few cycles, few rows
            few = fit_damped(VIDEO[rows], (x + noise)[rows])
            assert cause_of(VIDEO[rows], few)[0] is Cause.OTHER
