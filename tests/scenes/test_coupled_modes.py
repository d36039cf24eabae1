"""The coupled masses begun by their modes: amplitude and phase of each, there and back to the last digits."""

from __future__ import annotations

import math
import random
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from components.chain import of_scene as chain_of
from components.scenes import SCENES
from physics.coupled import TwoMassChain, free_modes
from physics.modal_start import amplitudes_and_phases, modes_given, start_given
from tests.page.hand import Hand, grabs, sets
from tests.page.headless_page import Page, set_values

U = 2.0**-53
RANDOM = random.Random(16)


def chains(count: int) -> list[TwoMassChain]:
    sizes = [[10 ** RANDOM.uniform(-6, 6) for _ in range(4)] for _ in range(count)]
    return [TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2) for m1, m2, k1, k2 in sizes]


@pytest.mark.parametrize("chain", [*chains(40), TwoMassChain(m1=1, m2=2, k1=3, k2=0)], ids=str)
def test_a_motion_by_its_modes_comes_back_to_the_last_digits(chain: TwoMassChain) -> None:
    sizes = (RANDOM.uniform(0, 2), RANDOM.uniform(0, 2))
    phases = (RANDOM.uniform(-3, 3), RANDOM.uniform(-3, 3))
    free = modes_given(chain, sizes, phases)
    back = amplitudes_and_phases(free)
    for j, omega in enumerate(chain.modes().omega):
        assert back[0][j] == pytest.approx(sizes[j] if omega else abs(sizes[j] * math.sin(phases[j])), rel=4 * U)
        assert not omega or abs(phases[j] - back[1][j]) < 4 * U * math.pi
    x_0, v_0 = start_given(free)
    for i in (0, 1):
        shape = [float(mode.shape[i]) for mode in chain.exact_modes]
        with mp.workdps(60):
            parts = [A * mp.sin(mp.mpf(phi)) * s for A, phi, s in zip(sizes, phases, shape, strict=True)]
            assert abs(x_0[i] - sum(parts)) <= 2 * U * sum(abs(part) for part in parts)
    again = free_modes(chain, x_0, v_0)
    reach = np.abs(free.amplitude).sum() + np.abs(again.amplitude).sum()
    assert np.abs(again.amplitude - free.amplitude).max() <= 1e-9 * reach


def choose(page: Page, word: str) -> dict[str, Any]:
    return page.send({"type": "choose", "name": "given_by", "value": word, "number": len(page.packets) + 1})


def test_the_choice_changes_nothing_and_leads_back_exactly() -> None:
    start = {"x1_0": 0.37, "x2_0": -0.2, "v1_0": 1 / 3, "k2": 0.77}
    page = Page(SCENES["coupled"](**start))
    before = page.opening()
    told = choose(page, "modes")
    assert told["errors"] == {} and told["view"]["forms"]["given_by_modes"] == "shown"
    for name in ("x1", "x2_fast"):
        one, other = (view["view"]["columns"]["time"][name] for view in (before, told))
        assert np.abs(one - other).max() < 1e-4
    told = choose(page, "values")
    assert {name: told["state"]["parameters"][name] for name in start} == start


def test_one_mode_alone_is_that_mode_exactly() -> None:
    page = Page(SCENES["coupled"]())
    told = set_values(page, X_fast=0.0, X_slow=0.5, phi_slow=0.3)
    assert told["errors"] == {} and told["state"]["parameters"]["given_by"] == "modes"
    assert told["view"]["forms"]["beat"] == "one" and told["view"]["values"]["X1_plus"] == "+ 0.00"
    assert page.scene.x1_0 == pytest.approx(0.5 * math.sin(0.3), rel=1e-15)
    assert page.scene.x2_0 == pytest.approx(2 * 0.5 * math.sin(0.3), rel=1e-15)
    told = set_values(page, k2=7.0)
    assert told["view"]["values"]["X1_plus"] == "+ 0.00", "the mode of the new chain"
    told = set_values(page, x1_0=0.25)
    assert told["state"]["parameters"].get("given_by") is None, "a start is given by starting values"


LABEL = "Slow mode, start, by mass 1"


def test_a_hand_on_a_mode_sets_its_amplitude_and_phase_and_the_other_goes_on() -> None:
    page = Page(SCENES["coupled"]())
    set_values(page, X_slow=0.5, X_fast=0.1 + 0.2, phi_slow=0.3, phi_fast=1.1)
    scene = page.scene
    _, (shape, grab) = (one for one in grabs(SCENES["coupled"]) if one[1].label == LABEL)
    assert sets(grab) == ["X_slow", "phi_slow"]
    held = Hand(page.now, shape, wide=True, t=0.7).take()
    slow, fast = chain_of(scene).modes().omega
    turned = 1.1 + 0.7 * fast
    told = page.send({"type": "set", "values": held, "holding": True, "number": 81})
    assert told["errors"] == {} and told["state"]["parameters"]["given_by"] == "modes"
    scene = page.scene
    assert scene.X_fast == 0.1 + 0.2 and scene.phi_fast == pytest.approx(math.remainder(turned, 2 * math.pi), rel=1e-14)
    assert (
        scene.X_slow == pytest.approx(0.5 * abs(math.sin(0.3 + 0.7 * slow)), abs=0.005)
        and scene.phi_slow == math.pi / 2
    )
    page.send({"type": "set", "values": {"phi_slow": -math.pi / 2}, "holding": False, "number": 82})
    scene = page.scene
    assert scene.X_fast == 0.1 + 0.2 and scene.x1_0 == pytest.approx(0.3 * math.sin(turned) - scene.X_slow)


def test_a_hand_on_a_mode_leaves_every_digit_of_the_other_where_values_give_the_motion() -> None:
    page = Page(SCENES["coupled"](x1_0=0.7, v2_0=1 / 3))
    scene = page.scene
    before = scene.of().free.amplitude[1]
    shape, _ = (shape for shape, grab in grabs(SCENES["coupled"]) if grab.label == LABEL)
    hand = Hand(page.now, shape, wide=True, t=0.7)
    for values in (hand.take(), hand.move((300.0, 0.0))):
        assert values
        hand.set(values)
        assert hand.scene.of().free.amplitude[1] == pytest.approx(before, rel=1e-14)


def test_a_hand_on_a_mass_sets_the_modes_that_give_the_motion() -> None:
    page = Page(SCENES["coupled"]())
    set_values(page, X_slow=0.5, X_fast=0.25, phi_slow=0.3, phi_fast=1.1)
    shape = next(shape for shape, grab in grabs(SCENES["coupled"]) if grab.label == "Mass 1, start")
    held = Hand(page.now, shape, wide=True, t=0.7).take()
    told = page.send({"type": "set", "values": held, "holding": True, "number": 81})
    assert told["errors"] == {} and told["state"]["parameters"]["given_by"] == "modes"
    assert page.scene.v1_0 == 0 and abs(page.scene.phi_slow) == abs(page.scene.phi_fast) == math.pi / 2
    told = page.send({"type": "set", "values": {"v1_0": 0.3}, "holding": False, "number": 83})
    assert told["errors"] == {} and told["state"]["parameters"]["given_by"] == "modes", "a flick as well"
    assert set_values(page, x1_0=0.25)["state"]["parameters"].get("given_by") is None, (
        "a typed start gives the motion itself"
    )


def test_a_drift_is_not_given_by_a_phase() -> None:
    page = Page(SCENES["coupled"](k1=0.0, v1_0=0.5))
    told = choose(page, "modes")
    assert "A drift has no amplitude and no phase" in told["errors"]["given_by"]
    assert "given_by" not in told["state"]["parameters"]
    page = Page(SCENES["coupled"](k1=0.0))
    assert choose(page, "modes")["errors"] == {}
