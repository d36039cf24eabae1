"""Each sentence of the scenes of D31 is true for random parameters, by an independent computation."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from components.scenes.analogues import Analogues
from components.scenes.analogues.controls import LINEAR
from components.scenes.energy import Energy
from components.scenes.oscillator import OscillatorScene
from components.scenes.phugoid import Phugoid
from tests.grids import WHOLE
from tests.scenes.visible_sentences import Draw, visible_text

DRAWS = 120 if WHOLE else 60


def test_what_is_said_of_the_arrow_and_of_its_phase() -> None:
    draw, seen = Draw("oscillator"), set()
    for _ in range(DRAWS):
        moves = draw.pick.random() < 0.8
        scene = OscillatorScene(
            m=draw.size(), k=draw.some(draw.size(-1, 3)), x_0=draw.some(draw.number()) * moves,
            v_0=draw.some(draw.number(), 0.3) * moves, view=draw.pick.choice(("motion", "speed", "formulas")),
        )  # fmt: skip
        text, why = visible_text(scene), scene.shown.forms["why"]
        seen.add(why)
        still = not scene.v_0 and not (scene.k and scene.x_0)
        assert ("nothing moves" in text) == still
        assert ("with k > 0" in " ".join(text.replace(">", " > ").split())) <= bool(scene.k)
        if why in ("right", "wrong", "zero"):
            w = math.sqrt(scene.k / scene.m)
            phi = math.atan2(scene.x_0, scene.v_0 / w)
            same = scene.v_0 != 0 and math.isclose(math.atan(scene.x_0 * w / scene.v_0), phi, abs_tol=1e-12)
            assert (why == "right") == same and (why == "zero") == (scene.v_0 == 0)
        assert (why == "drift") == (not scene.k and scene.v_0 != 0)
    assert seen == {"right", "wrong", "zero", "rest", "drift", "still"}


def test_what_is_said_of_the_largest_energies() -> None:
    draw, seen = Draw("energy"), set()
    for _ in range(120):
        moves = draw.pick.random() < 0.8
        scene = Energy(
            m=draw.size(), k=draw.size(-1, 3), g=draw.some(draw.size(-6, 2)),
            x_0=moves * draw.number(-3, 1), v_0=moves * draw.some(draw.number(-3, 1)),
            datum=draw.pick.choice(("equilibrium", "separate", "slide")),
        )  # fmt: skip
        t = np.linspace(0.0, 2 * math.pi * math.sqrt(scene.m / scene.k), 4001)
        w, delta = math.sqrt(scene.k / scene.m), scene.m * scene.g / scene.k
        x = scene.x_0 * np.cos(w * t) + scene.v_0 / w * np.sin(w * t)
        v = scene.v_0 * np.cos(w * t) - w * scene.x_0 * np.sin(w * t)
        T, V = scene.m * v**2 / 2, scene.k * (x + delta) ** 2 / 2 - scene.m * scene.g * x
        more = V.max() - T.max()
        claim, text = scene.shown.forms["claim"], visible_text(scene)
        seen.add(claim)
        assert ("Nothing moves" in text) == (not T.any() and not np.ptp(x))
        assert ("are one" in text) == (claim == "weightless") == (scene.datum == "separate" and not scene.g and moves)
        if claim == "separate":
            assert more == pytest.approx(scene.k * delta**2 / 2, rel=1e-3, abs=2e-6 * T.max())
            assert "a constant more" in text and more > -1e-6 * T.max()
        if claim == "equilibrium":
            assert (V - scene.k * delta**2 / 2).max() == pytest.approx(T.max(), rel=1e-5)
        assert "is not" not in text
        scalars = scene.shown.scalars
        naming = [scalars[f"naming_{one}"] for one in ("together", "close", "apart")]
        assert naming[0] == (delta == 0), "only without weight is the equilibrium the natural length"
        assert sum(naming) == 1
    assert seen == {"equilibrium", "separate", "slide", "weightless", "rest", "rest_apart"}


@pytest.mark.parametrize("slug", LINEAR)
def test_linear_is_said_of_the_model_with_its_reach_in_truth(slug: str) -> None:
    draw = Draw(slug)
    for _ in range(20):
        start = draw.some(draw.number(-6, 3))
        scene = Analogues(system=slug, view="large", **{f"{slug}_start": start})
        text = visible_text(scene)
        assert ("Nothing moves" in text) == (not start)
        assert ("This model is linear at any size" in text and "That is true while" in text) == bool(start)
        assert bool(np.ptp(scene.sources["time"].data["q"])) == bool(start)


def test_energies_of_a_wave_are_by_area_and_no_angle_is_minus_zero() -> None:
    wave, spring = Analogues(system="wave"), Analogues(system="spring")
    assert "J/m²" in wave.about(wave.shown).energy
    assert "J/m²" not in spring.about(spring.shown).energy
    for degrees in (0.0, 5.0, -5.0):
        values = Analogues(theta_0=degrees).shown.values
        assert (values["end_left"] == values["end_right"]) == (not degrees), values["end_left"]


def flown(excess: float) -> tuple[float, float, bool, float]:
    """Of the exact flight, by another integrator: period over the linear one, how far its height is from the linear one
    at the same share of a period over the size of the swing, whether it loops, and its least speed."""

    def rates(_: float, y: np.ndarray) -> list[float]:
        u, w, _ = y
        V = math.hypot(u, w)
        return [-V * w, V * u - 1, w]

    def level(_: float, y: np.ndarray) -> float:
        return float(y[1])

    start = [1 + excess, 0.0, 0.0]
    way = solve_ivp(rates, (0, 12), start, "DOP853", rtol=1e-10, atol=1e-12, events=level, dense_output=True)
    period = 2 * next(t for t in way.t_events[0] if t > 1e-3)
    t = np.linspace(0, period, 801)
    u, w, h = way.sol(t)
    off = np.abs(h - excess * (1 - np.cos(2 * math.pi * t / period)))
    return (
        period / (math.sqrt(2) * math.pi),
        float(off.max() / (np.ptp(h) / 2)),
        bool(u.min() < 0),
        float(np.hypot(u, w).min()),
    )


def test_the_verdict_on_linear_theory_over_all_excesses() -> None:
    draw, seen = Draw("phugoid"), set()
    for _ in range(DRAWS // 3):
        excess = round(draw.pick.choice((draw.pick.uniform(-0.9, 0.72), draw.pick.uniform(-0.2, 0.2))), 4)
        scene = Phugoid(excess=excess)
        told = scene.shown.values["verdict"].replace("\N{NO-BREAK SPACE}", " ")
        late, off, loops, least = flown(excess)
        seen.add(told.split(",")[0][:20])
        if "right to 0.1 %" in told:
            assert abs(late - 1) <= 1.0005e-3 and off <= 0.08, excess
        elif "more in the shape" in told or "fails in the shape" in told:
            assert off > abs(late - 1) > 0.9995e-3, excess
            assert off > (0.2 if "fails" in told else 0.05), excess
        else:
            assert (loops and "loops" in told) or ("cusp" in told and least < 1e-3), (excess, told)
    assert len(seen) >= 3
    for excess in (0.8, 1.0, 2.0, 3.0):
        assert "loops" in Phugoid(excess=excess).shown.values["verdict"] and flown(excess)[2]
    assert Phugoid(excess=0.0).shown.values["verdict"] == "Steady level flight: nothing swings."
    assert flown(0.1)[1] <= 0.05 and "5 %" in Phugoid.watch["Ripple, 0.1"]
