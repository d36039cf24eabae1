"""The reasons for the machine's swing are true near its own frequency, near tuning, and from any start."""

from __future__ import annotations

import math
import re

from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from components.scenes.absorber import Absorber
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
