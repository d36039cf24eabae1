"""Each preset has a sentence that is shown when it is chosen, and its claim is true in that preset."""

from __future__ import annotations

import math

import numpy as np
import pytest

from components.scenes import SCENES
from components.scenes.accuracy.recorded import records
from physics.forced import forced_motion
from physics.integrators.accuracy import SYSTEMS, Run
from tests.scenes.presets import readout, taken


@pytest.mark.parametrize("slug", SCENES)
def test_each_preset_says_what_to_watch(slug: str) -> None:
    scene = SCENES[slug]
    assert list(scene.watch) == list(scene.presets)


def test_heavier_and_stiffer_oscillators() -> None:
    usual = readout(taken("oscillator", "Pushed back"), "tau")
    assert readout(taken("oscillator", "Heavy"), "tau") == pytest.approx(2 * usual)
    assert readout(taken("oscillator", "Stiff"), "tau") == pytest.approx(usual / 2, rel=0.01)
    still = taken("oscillator", "Pushed back")
    assert still.x_0 * still.v_0 < 0


def test_the_energies_of_the_hanging_mass() -> None:
    pulled, pushed, heavy, soft = (taken("energy", label) for label in ("Pulled down", "Pushed up", "Heavy", "Soft"))
    assert readout(pushed, "E_total") == readout(pulled, "E_total") == readout(heavy, "E_total")
    assert readout(heavy, "delta_st") == pytest.approx(2 * readout(pulled, "delta_st"))
    for one in (heavy, soft):
        assert readout(one, "tau") > readout(pulled, "tau") and readout(one, "delta_st") > readout(pulled, "delta_st")


def test_analogues_and_flights() -> None:
    assert readout(taken("analogues", "Cavendish"), "period") > 600
    for label, least, most in (("60°", 0.05, 0.1), ("Clock", 0.0, 0.001), ("Nearly over", 1.0, 10.0)):
        scene = taken("analogues", label)
        late = readout(scene, "period") * readout(scene, "omega") / (2 * math.pi) - 1
        assert least < late < most, label
    assert "speed falls to 0" in SCENES["phugoid"].watch["Cusp, 0.732"]
    speed = {label: taken("phugoid", label) for label in SCENES["phugoid"].presets}
    lowest = {label: scene.v_0 + scene.shown.sources["time"]["v"].min() for label, scene in speed.items()}
    assert abs(lowest["Cusp, 0.732"]) < 0.01 * speed["Cusp, 0.732"].v_0


def test_the_modes_of_the_coupled_masses() -> None:
    for label, other in (("Slow", "fast"), ("Fast", "slow")):
        columns = taken("coupled", label).shown.sources["time"]
        assert np.abs(columns[f"x1_{other}"]).max() < 1e-15
        ways = np.sign(columns["x1"] * columns["x2"])
        assert set(ways[np.abs(columns["x1"]) > 1e-9]) == {1.0 if label == "Slow" else -1.0}
    omega = [readout(taken("coupled", "All equal"), name) for name in ("omega_minus", "omega_plus")]
    assert omega == pytest.approx([0.618, 1.618], abs=5e-4)
    assert omega[1] / omega[0] == pytest.approx((3 + math.sqrt(5)) / 2), "not rational"
    beats = taken("coupled", "Beats").shown.sources["time"]
    assert np.abs(beats["x1"][:40]).max() > 0.19
    heavy = taken("coupled", "Heavy, light").shown.sources["time"]
    assert np.abs(heavy["x1_fast"]).max() < 0.02 * np.abs(heavy["x1_slow"]).max()
    assert np.abs(heavy["x2_fast"]).max() > 0.9 * np.abs(heavy["x2_slow"]).max()


def test_the_driven_masses() -> None:
    assert readout(taken("forced", "All equal"), "Xp1") < 0
    still = taken("forced", "Still mass 1")
    assert np.abs(still.shown.sources["time"]["x1"]).max() < 1e-15
    light = taken("forced", "Light mass 2")
    slow, fast = readout(light, "omega_minus"), readout(light, "omega_plus")
    assert slow < 1 < fast < 1.3 * slow
    below, at, above = (taken("absorber", label) for label in ("Below", "Resonant", "Above"))
    own = math.sqrt(below.k1 / below.m1)
    assert below.omega < own == at.omega < above.omega


def runs(slug: str, method: str) -> list[Run]:
    """The runs with a result, coarse to fine."""
    known = records(slug)
    assert known
    return [run for run in known.runs.by_method.get(method, ()) if run.error is not None and run.time is not None]


def test_the_formula_at_resonance() -> None:
    for slug, off in (("near", 1e-8), ("resonance", 0.0)):
        system = SYSTEMS[slug]
        assert system.omega / system.chain.modes().omega[0] - 1 == pytest.approx(off, rel=1e-6, abs=1e-15)
        t = system.problem().t
        swing = np.abs(forced_motion(system.chain, F_0=system.F_0, omega=system.omega, t=t).x[0])
        assert np.all(np.diff([part.max() for part in np.array_split(swing, 10)]) > 0)
        assert all((run.error or 0.0) < 1e-15 for run in runs(slug, "closed"))
