"""The public face of physics is documented: parameters and fields with units and shapes, results, errors, source."""

from __future__ import annotations

import ast

import pytest

from tests.serving.server import ROOT
from tools.docstrings import gaps, public

FACE = {
    "oscillator": ("Oscillator", "Oscillator.constants", "Oscillator.motion", "OscillatorMotion"),
    "damped": ("DampedOscillator", "DampedOscillator.motion", "DampedOscillator.steady"),
    "driven": tuple(f"DrivenOscillator{method}" for method in ("", ".response", ".bode", ".motion")),
    "magnification": ("magnification",),
    "coupled": ("TwoMassChain", "Modes", "Motion", "free_motion"),
    "particular": ("particular_solution",),
    "forced": ("forced_motion", "steady_start"),
    "damped_chain": tuple(f"DampedChain{method}" for method in ("", ".response", ".lags", ".works")),
    "periodic": ("PeriodicPush",),
    "chain": ("UniformChain", "UniformChain.motion", "ChainMotion"),
    "phugoid": ("LinearPhugoid", "Flight", "linear_phugoid", "linear_flight", "flight"),
    "pendulum": ("Pendulum", "Pendulum.period", "Pendulum.motion"),
    "hanging": ("HangingMass",),
    "energy": ("ChainEnergy", "chain_energy", "half_square"),
    "absorber": (
        "Optimum", "den_hartog", "tuned_stiffness", "damped_solution", "damped_amplitude", "damped_lags",
        "swing_and_stroke", "helped_band", "checked_damping",
    ),
}  # fmt: skip
"""The names that notebooks use, by module."""


@pytest.mark.parametrize("module", FACE)
def test_the_public_face_documents_its_errors_or_its_fields(module: str) -> None:
    tree = ast.parse((ROOT / f"physics/{module}.py").read_text(encoding="utf-8"))
    known = dict(public(tree))
    assert set(FACE[module]) <= known.keys()
    for name in FACE[module]:
        text = ast.get_docstring(known[name]) or ""
        assert "\nRaises\n" in text or "\nAttributes\n" in text, name


def test_every_public_name_of_physics_is_documented() -> None:
    assert list(gaps()) == []
