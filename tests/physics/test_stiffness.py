"""Stiff or highly oscillatory: read off the recorded runs, and by a rule that a reader can check by hand."""

from math import pi

import pytest

from components.scenes.accuracy.recorded import recorded
from physics.integrators.accuracy import SYSTEMS, Run
from physics.integrators.stiffness import stiffness

KINDS = {
    "benign": "neither",
    "beats": "neither",
    "wide": "highly oscillatory",
    "wider": "stiff",
    "light": "highly oscillatory",
    "dashpot": "stiff",
    "near": "neither",
    "resonance": "neither",
}


@pytest.mark.parametrize("slug", SYSTEMS)
def test_each_system_is_called_what_it_is(slug: str) -> None:
    found = stiffness(SYSTEMS[slug], (*recorded(slug).runs.every, *recorded(slug).compiled.every))
    assert found and found.kind == KINDS[slug]
    assert found.stable == pytest.approx(2.79 if slug == "dashpot" else 2.83, abs=0.01)


def test_the_step_of_accuracy_is_read_between_two_runs() -> None:
    runs = [
        Run(system="near", method="gauss4", setting=setting, error=error)
        for setting, error in ((10.0, 1e-4), (100.0, 1e-8))
    ]
    problem = SYSTEMS["near"].problem()
    found = stiffness(SYSTEMS["near"], runs, 1e-6)
    assert found and found.accurate == pytest.approx(problem.rates[1] * problem.spacing / 10**1.5)
    assert problem.rates[1] * problem.spacing == pytest.approx(2 * 2 * pi / 20, rel=1e-9)
    assert stiffness(SYSTEMS["near"], runs[:1], 1e-6) is None
