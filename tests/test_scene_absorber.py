"""Scene absorber through its callbacks: set a parameter, read the data sources, the goals and the texts."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from components.controls import apply_message
from components.scenes import SCENES
from components.scenes.absorber import Absorber
from components.url import read_query, write_query
from physics.absorber import den_hartog
from tests.scene_checks import check_picture
from tests.test_scenes import as_arguments, solves

M1, K1, F_0 = 100.0, 250e3, 500.0


def amplitudes(scene: Absorber, omega: float, k2: float, c: float = 0.0) -> np.ndarray:
    """|X1|, |X2| from Newton's laws as two complex equations."""
    link = k2 + 1j * c * omega
    A = [[scene.k1 + link - scene.m1 * omega**2, -link], [-link, link - scene.m2 * omega**2]]
    return np.abs(np.linalg.solve(A, [scene.F_0, 0.0]))


def motion(signal: dict[str, Any], t: np.ndarray) -> np.ndarray:
    """A signal of the form a + b t + sum of sines, at times t."""
    a, b = signal["line"]
    return a + b * t + sum(A * np.sin(w * t + phi) for A, w, phi in signal["sines"])


def met(scene: Absorber) -> list[bool]:
    return [bool(scene.shown.scalars[f"met{i}"]) for i in range(3)]


def lightest_tuned(omega: float) -> float:
    """The mass at which a tuned absorber's resonances are 20 % away: the roots of D at 0.8 and 1.2 omega."""
    below, above = ((K1 - M1 * (s * omega) ** 2) * (1 - s**2) / (s**2 * omega**2) for s in (0.8, 1.2))
    return max(below, above)


def test_book_example() -> None:
    values = Absorber().shown.values
    expected = {"Xp1": "0.00", "Xp2": "−13.6", "alone": "25.5", "slow": "40.3", "fast": "59.6", "mu": "0.160"}
    assert {name: values[name] for name in expected} == expected
    assert (values["help_low"], values["help_high"]) == ("42.6", "56.3")
    assert values["found0"] == "nearest is 16.1 % away: ω₋ 40.3 rad/s"
    assert values["found1"] == "swings 0.00 mm; alone 25.5 mm"
    assert values["found2"] == "F₀/k₂ = 13.6 mm"


@pytest.mark.parametrize(
    "values",
    [{}, {"m2": 40.0, "k2": 60e3}, {"damping": "added", "c": 300.0}, {"damping": "added", "c": 1e4}, {"omega": 60.0}],
)
def test_curves_are_newtons_laws(values: dict[str, Any]) -> None:
    scene = Absorber(**values)
    data = scene.sources["sweep"].data
    c = scene.c if scene.damping == "added" else 0.0
    top = 6 * scene.shown.axes["X1"].end, 6 * scene.shown.axes["X2"].end
    for i in range(3, len(data["w"]) - 3, 7):
        w = float(data["w"][i])
        X1, X2 = amplitudes(scene, w, scene.k2, c)
        rest = scene.k1 - scene.m1 * w**2
        alone = abs(scene.F_0 / rest) if rest else math.inf
        np.testing.assert_allclose(
            [data["swing"][i], data["stroke"][i], data["alone"][i]],
            [min(X1, top[0]), min(X2, top[1]), min(alone, top[0])],
            rtol=1e-6,
            atol=1e-12,
        )


def test_helped_band_lies_between_the_curves() -> None:
    scene = Absorber()
    band = scene.sources["helped"].data
    assert np.all(band["helped_lo"] <= band["helped_hi"] * (1 + 1e-9))
    assert band["w"][0] == pytest.approx(42.606, abs=1e-3)
    assert band["w"][-1] == pytest.approx(56.329, abs=1e-3)


@pytest.mark.parametrize("values", [{}, {"k2": 30e3}, {"damping": "added", "c": 200.0}])
def test_stage_shows_the_steady_motion(values: dict[str, Any]) -> None:
    scene = Absorber(**values)
    signals, c = scene.shown.signals, scene.c if scene.damping == "added" else 0.0

    def rates(t: float, y: np.ndarray) -> list[float]:
        x1, x2, v1, v2 = y
        link = scene.k2 * (x2 - x1) + c * (v2 - v1)
        return [v1, v2, (F_0 * math.sin(scene.omega * t) - K1 * x1 + link) / M1, -link / scene.m2]

    t, step = np.linspace(0.0, 0.5, 200), 1e-7
    start = [motion(signals[f"x{i}"], np.array([0.0]))[0] for i in (1, 2)]
    speed = [np.ptp(motion(signals[f"x{i}"], np.array([-step, step]))) / (2 * step) for i in (1, 2)]
    sign = [np.sign(np.diff(motion(signals[f"x{i}"], np.array([-step, step])))[0]) for i in (1, 2)]
    y_0 = 1e-3 * np.array([*start, *np.multiply(speed, sign)])
    y = solve_ivp(rates, (0, t[-1]), y_0, "DOP853", t, rtol=1e-10, atol=1e-12).y
    np.testing.assert_allclose([motion(signals[f"x{i}"], t) for i in (1, 2)], 1e3 * y[:2], atol=2e-4)
    link = scene.k2 * (y[1] - y[0]) + c * (y[3] - y[2])
    np.testing.assert_allclose(motion(signals["pull_now"], t), link, atol=0.01)


@pytest.mark.parametrize("m2", [1e-6, 0.01, 16.0, 1e6])
def test_springs_end_on_the_smaller_mass(m2: float) -> None:
    scalars = Absorber(m2=m2).shown.scalars
    assert 0 < scalars["hook"] <= min(scalars["side1"], scalars["side2"]) / 2


def test_forces_cancel_on_the_tuned_machine() -> None:
    signals, t = Absorber().shown.signals, np.linspace(0.0, 1.0, 50)
    drive, pull = motion(signals["drive_now"], t), motion(signals["pull_now"], t)
    assert np.max(np.abs(drive)) == pytest.approx(F_0, rel=0.01)
    np.testing.assert_allclose(pull, -drive, atol=1e-9)


def test_at_a_resonance_the_motion_grows_from_rest() -> None:
    scene = Absorber(own=True, m1=2.0, k1=4.0, F_0=1.0, omega=1.0, m2=1.0, k2=2.0)
    assert scene.shown.scalars["is_grow"] == 1
    assert scene.shown.forms["why"] == "grow"
    assert len(scene.shown.signals["x1"]["responses"]) == 2
    assert scene.shown.values["found1"].startswith("swings without limit")
    check_picture(scene)


def test_machine_driven_at_its_own_frequency() -> None:
    scene = Absorber(omega=50.0)
    assert scene.k2 == 40e3
    assert scene.shown.values["found1"] == "swings 0.00 mm; alone without limit"
    assert scene.shown.scalars["alone_grows"] == 1
    assert "responses" in scene.shown.signals["x_alone"]


@pytest.mark.parametrize("label", ["Below", "Resonant", "Above"])
def test_goals_can_be_met_from_the_lightest_mass_on(label: str) -> None:
    scene = Absorber()
    assert apply_message(scene, {"type": "preset", "label": label}) == {}
    mass = lightest_tuned(scene.omega)
    scene.m2 = mass * (1 - 1e-3)
    assert met(scene) == [False, True, True]
    assert scene.shown.values["lightest"] == "none yet"
    scene.m2 = mass * (1 + 1e-3)
    assert met(scene) == [True, True, True]
    assert scene.shown.values["lightest"] == f"{mass * (1 + 1e-3):.4g} kg"


def test_mass_ratios_of_the_book() -> None:
    assert lightest_tuned(50.0) / M1 == pytest.approx(0.2025)
    assert lightest_tuned(48.0) == pytest.approx(25.04, abs=0.005)
    scene = Absorber(omega=50.0, m2=20.25)
    assert met(scene) == [True, True, True]


def test_goals_see_swing_and_stroke() -> None:
    assert met(Absorber(k2=30e3)) == [False, False, True]
    assert met(Absorber(m2=10.0)) == [False, True, False]


def test_score_is_the_lightest_mass_of_this_machine() -> None:
    scene = Absorber(m2=30.0)
    assert scene.shown.values["lightest"] == "30 kg"
    scene.m2 = 26.0
    scene.m2 = 40.0
    assert scene.shown.values["lightest"] == "26 kg"
    scene.set({"damping": "added", "c": 0.1, "m2": 25.5})
    assert scene.shown.values["lightest"] == "26 kg"
    assert "lightest" not in write_query(scene)
    scene.omega = 47.0
    assert scene.shown.values["lightest"] == "none yet"


def test_tuned_spring_follows_mass_and_speed() -> None:
    scene = Absorber()
    scene.m2 = 20.0
    assert (scene.k2, scene.tuning) == (46080.0, "tuned")
    scene.omega = 50.0
    assert (scene.k2, scene.tuning) == (50e3, "tuned")
    scene.k2 = 45e3
    assert (scene.k2, scene.tuning) == (45e3, "free")
    scene.m2 = 30.0
    assert scene.k2 == 45e3
    assert apply_message(scene, {"type": "choose", "name": "tuning", "value": "tuned"}) == {}
    assert scene.k2 == 75e3


def test_knob_drags_the_valley() -> None:
    scene = Absorber()
    assert apply_message(scene, {"type": "set", "values": {"_valley": 40.0}}) == {}
    assert (scene.k2, scene.tuning, scene._valley) == (25600.0, "free", 40.0)
    data = scene.sources["sweep"].data
    low = np.argmin(np.where((data["w"] > 36) & (data["w"] < 44), data["swing"], np.inf))
    assert data["w"][low] == pytest.approx(40.0, abs=1e-9)


def test_detached_the_machine_is_alone() -> None:
    scene = Absorber(tuning="detached")
    data = scene.sources["sweep"].data
    np.testing.assert_array_equal(data["swing"], data["alone"])
    assert not data["stroke"].any()
    assert scene.shown.forms["helped"] == "never"
    assert scene.shown.scalars["is_detached"] == 1
    scene.tuning = "tuned"
    assert scene.shown.scalars["is_still"] == 1


def test_verdict_tells_help_from_harm() -> None:
    assert Absorber(k2=30e3).shown.forms["why"] == "less"
    assert Absorber(omega=60.0, k2=36e3).shown.forms["why"] == "more"


def test_den_hartogs_optimum() -> None:
    scene = Absorber(damping="added")
    assert apply_message(scene, {"type": "act", "name": "optimum"}) == {}
    best = den_hartog(M1, K1, 16.0)
    assert (scene.k2, scene.c) == (pytest.approx(best.k2, rel=5e-4), pytest.approx(best.c, rel=5e-4))
    assert scene.sources["sweep"].data["swing"].max() == pytest.approx(best.height * F_0 / K1, rel=5e-3)
    heights = [scene.shown.scalars[f"{name}_y"] for name in "PQ"]
    assert heights == pytest.approx([1e3 * best.height * F_0 / K1] * 2, rel=1e-3)
    assert scene.shown.forms["why"] == "damped"


def test_no_damping_is_the_lecture() -> None:
    lecture, none = Absorber(), Absorber(damping="added", c=0.0)
    np.testing.assert_array_equal(none.sources["sweep"].data["swing"], lecture.sources["sweep"].data["swing"])
    assert not none.sources["compare"].data
    assert "damped" not in lecture.shown.forms


def test_damping_stays_out_until_asked_for() -> None:
    scene = Absorber(c=500.0)
    np.testing.assert_array_equal(scene.sources["sweep"].data["swing"], Absorber().sources["sweep"].data["swing"])


def test_one_solve_even_where_one_value_follows_another() -> None:
    scene = Absorber()
    counted = solves(scene)
    scene.m2 = 20.0
    apply_message(scene, {"type": "set", "values": {"_valley": 45.0}})
    apply_message(scene, {"type": "preset", "label": "Above"})
    assert len(counted) == 3


def test_presets_choose_the_machine_and_leave_the_absorber() -> None:
    scene = Absorber(m2=30.0)
    for label, omega, kind in (("Resonant", 50.0, "fixed"), ("Above", 60.0, "fixed"), ("Own", 48.0, "own")):
        apply_message(scene, {"type": "preset", "label": label})
        assert (scene.omega, scene.m2, scene.preset()) == (omega, 30.0, label)
        assert kind in scene.shown.forms
        assert scene.k2 == pytest.approx(30.0 * omega**2, rel=1e-15)


def test_refusals_leave_the_scene_as_it_was() -> None:
    scene = Absorber()
    before = scene.shown, scene.param.values()
    for name, text, reason in (
        ("m2", "0", "a mass is a finite number above 0"),
        ("omega", "0", "a running speed is a finite number above 0"),
        ("k1", "0", "a mounting is a finite number above 0"),
        ("m2", "1e307", "the tuned stiffness"),
    ):
        errors = apply_message(scene, {"type": "typed", "name": name, "text": text})
        assert reason in errors[name].lower()
    assert (scene.shown, scene.param.values()) == before


@pytest.mark.parametrize(
    "values",
    [{"m2": 16.7}, {"k2": 30e3}, {"_valley": 43.21}, {"tuning": "detached", "m2": 3.0}, {"own": True, "omega": 31.0}],
)
def test_link_brings_the_absorber_back(values: dict[str, Any]) -> None:
    scene = Absorber()
    scene.set(values)
    link = read_query(as_arguments(write_query(scene)), SCENES)
    again = Absorber()
    again.set(link.values)
    assert link.problems == []
    assert again.param.values() | {"name": ""} == scene.param.values() | {"name": ""}
    assert again.shown.values == scene.shown.values


@pytest.mark.parametrize(("seed", "decades"), [(1, 300), (2, 100), (3, 10)])
def test_any_machine_is_drawn_or_refused_in_words(seed: int, decades: int) -> None:
    draw, scene, drawn = random.Random(seed), Absorber(), 0
    for _ in range(25):
        values: dict[str, Any] = {
            name: 10.0 ** draw.uniform(-decades, decades) for name in ("m1", "k1", "F_0", "omega", "m2", "k2", "c")
        }
        values |= {"tuning": draw.choice(["tuned", "free", "detached"]), "damping": draw.choice(["none", "added"])}
        try:
            with np.errstate(all="raise", under="ignore"):
                scene.set(values)
        except ValueError as reason:
            assert len(str(reason)) > 20
            continue
        drawn += 1
        check_picture(scene)
    assert drawn > 10
