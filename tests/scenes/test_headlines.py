"""Headlines and tasks are true in every state of their view."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from components.scenes.analogues import Analogues
from components.scenes.analogues.controls import SWINGING
from components.scenes.modes import ModesScene
from components.scenes.phugoid import Phugoid
from physics.analogues import ANALOGUES
from physics.coupled import TwoMassChain
from tests.grids import tries
from tests.physics.braked_cases import sizes
from tests.scenes.visible_sentences import visible_text

SPRINGS = sizes() | sizes() | st.just(0.0)
MASSES = {"m1": sizes(), "m2": sizes()}
CHAINS = st.fixed_dictionaries({**MASSES, "k1": SPRINGS, "k2": SPRINGS})
COUPLED = st.fixed_dictionaries({**MASSES, "k1": SPRINGS, "k2": sizes()})
many = settings(max_examples=tries(200), suppress_health_check=[HealthCheck.too_slow])


# Modes


@many
@given(COUPLED, st.floats(0.01, 3.0))
def test_two_coupled_masses_agree_on_a_shape_at_two_frequencies(values: dict[str, float], share: float) -> None:
    system = TwoMassChain(**values)
    slow, fast = system.modes().omega
    assert 0 <= slow < fast
    scene = ModesScene(view="guess", **values)
    for mode, omega in (("slow", slow), ("fast", fast), ("", share * fast)):
        scene.set({"omega": float(omega)})
        assert mode == "" or scene.shown.forms["agree"] == f"same_{mode}"
    if min(abs(share * fast - slow), abs(share * fast - fast)) > 1e-3 * fast:
        assert not scene.shown.forms["agree"].startswith("same")
    assert ModesScene.headline.startswith("Undamped masses agree on a shape")


@many
@given(CHAINS, st.floats(-1, 1), st.floats(-1, 1))
def test_with_both_springs_two_lines_can_be_found_and_without_one_every_start_gives_a_line(
    values: dict[str, float], x1: float, x2: float
) -> None:
    scene = ModesScene(view="hunt", x1_0=x1, x2_0=x2, **values)
    coupled, ratios = values["k1"] > 0 < values["k2"], TwoMassChain(**values).modes().ratio
    assert ModesScene.views[0].task.endswith("With both springs there are two.")
    assert not coupled or "Every start gives a line here" not in visible_text(scene)
    if coupled:
        assert ratios[0] > 0 > ratios[1]
    else:
        path = np.array([scene.sources["path"].data[name] for name in ("x1", "x2")])
        centred = path - path.mean(axis=1, keepdims=True)
        assert np.linalg.svd(centred, compute_uv=False)[1] <= 1e-9 * np.abs(path).max() * path.shape[1]


@many
@given(CHAINS, st.sampled_from(("m1", "m2", "k1", "k2")))
def test_the_shapes_of_a_sweep_mirror_each_other_with_spring_2_only(values: dict[str, float], swept: str) -> None:
    text, ratio = visible_text(ModesScene(view="sweep", swept=swept, **values)), TwoMassChain(**values).modes().ratio
    assert ("With spring 2 the two shapes mirror each other" in text) == bool(values["k2"] or swept == "k2")
    if values["k2"]:
        np.testing.assert_allclose(-ratio[0] * ratio[1], values["m1"] / values["m2"], rtol=1e-12)
    else:
        assert ratio.tolist() == [math.inf, 0.0]


# Phugoid


@many
@given(sizes(0, 3), sizes(0, 2), sizes(0, 5), sizes(0, 5), st.floats(-0.9, 1.0))
def test_the_speed_of_an_aircraft_sets_its_period_and_its_mass_does_not(
    v_0: float, g: float, m: float, other: float, excess: float
) -> None:
    def periods(speed: float, mass: float) -> list[float]:
        readouts = Phugoid(v_0=speed, g=g, m=mass, excess=excess).readouts()
        return [one.value for one in readouts if one.symbol.startswith("τ") and isinstance(one.value, float)]

    found = periods(v_0, m)
    assert found and periods(v_0, other) == found
    np.testing.assert_allclose(periods(2 * v_0, m), 2 * np.array(found), rtol=1e-9)
    assert "only" not in Phugoid.headline and Phugoid.headline.startswith("Without losses")


# Analogues


@many
@given(st.sampled_from(sorted(ANALOGUES)), sizes(-3, 0))
def test_small_swings_of_each_system_are_those_of_a_spring(slug: str, share: float) -> None:
    start = {"theta_0": 10 * share} if slug in SWINGING else {f"{slug}_start": share * ANALOGUES[slug].swing}
    readouts = {one.symbol: one.value for one in Analogues(system=slug, **start).readouts()}
    assert "for small swings" in Analogues.headline
    assert abs(readouts["τ"] * readouts["ω_n"] / (2 * math.pi) - 1) < 2e-3
