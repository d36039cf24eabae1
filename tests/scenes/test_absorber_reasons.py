"""The reasons for the machine's swing are true near its own frequency, near tuning, and from any start."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from components.scenes.absorber import Absorber
from physics.coupled import TwoMassChain
from physics.forced import forced_motion
from tests.grids import tries
from tests.physics.braked_cases import sizes
from tests.scenes.visible_sentences import visible_text

OFF = st.just(0.0) | st.tuples(st.sampled_from((-1, 1)), sizes(-6, -1)).map(lambda parts: parts[0] * parts[1])
many = settings(max_examples=tries(400), suppress_health_check=[HealthCheck.too_slow])


def forces(scene: Absorber) -> tuple[float, float]:
    """The amplitude of the pull of spring 2 over F_0, signed, and |X1| over F_0/k1, of the particular solution."""
    one, two = scene.k1 - scene.m1 * scene.omega**2, scene.k2 - scene.m2 * scene.omega**2
    D = (one + scene.k2) * two - scene.k2**2
    return scene.k2 * scene.m2 * scene.omega**2 / D, abs(two * scene.k1 / D)


@many
@given(sizes(0, 3), sizes(2, 6), sizes(0, 4), sizes(-2, 1), OFF, OFF | sizes(-2, 1))
def test_two_equal_forces_leave_nothing_to_move_the_machine(
    m1: float, k1: float, F_0: float, share: float, off: float, untuned: float
) -> None:
    omega, m2 = math.sqrt(k1 / m1) * (1 + off), share * m1
    k2 = m2 * omega**2 * (1 + untuned)
    scene = Absorber(own=True, m1=m1, k1=k1, F_0=F_0, omega=omega, m2=m2, k2=k2, tuning="free", view="formulas")
    why, text = scene.shown.forms["why"], visible_text(scene)
    assume(why in ("less", "own", "little"))
    pull, swing = forces(scene)
    assert -2.001 < pull < 0
    if why == "less":
        told = re.search(r"pulls with (\S+) .* at the most, the drive pushes with (\S+) .* What is left moves", text)
        assert told and told[1] != told[2]
    else:
        assert abs(1 + pull) < 0.011 and "What is left moves" not in text
        assert swing < 0.2 if why == "little" else abs(off) < 0.0051


def test_at_its_own_frequency_the_machine_swings_though_the_forces_are_equal() -> None:
    scene = Absorber(omega=50.0, k2=30e3, tuning="free", view="formulas")
    text = visible_text(scene)
    assert "spring 2 must pull as hard as the drive pushes, with 500 N" in text and "is left" not in text
    assert scene.shown.values["swing"] in text


@pytest.mark.parametrize("x1_0", [0.0, 0.5])
@pytest.mark.parametrize("mode", [0, 1])
def test_the_drive_adds_what_grows_from_any_start(x1_0: float, mode: int) -> None:
    chain = TwoMassChain(m1=100.0, m2=16.0, k1=250e3, k2=36864.0)
    omega = float(chain.modes().omega[mode])
    scene = Absorber(omega=omega, k2=36864.0, tuning="free", view="rest", x1_0=x1_0)
    assert "the drive adds" in visible_text(scene)

    def added(late: float) -> float:
        t = late + np.linspace(0.0, 4 * math.pi / omega, 200)
        driven, free = (forced_motion(chain, F_0, omega, t, (x1_0, 0.0)).x[0] for F_0 in (500.0, 0.0))
        return float(np.abs(driven - free).max())

    assert added(200.0) == pytest.approx(2 * added(100.0), rel=0.02)
