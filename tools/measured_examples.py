"""`python -m tools.measured_examples` writes the two example files of measured points. They are simulated.

A dashpot and a drag of air, each with the noise of a phone's camera, an offset, and frames that come early or late.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).parents[1] / "static" / "measured"
SEED = 20261127
SECONDS, FRAMES = 12.0, 361
NOISE, OFFSET = 5.5e-4, 2e-3  # m
JITTER = 2e-3  # s
OMEGA, START = 6.3, 0.08  # rad/s, m
DASHPOT, AIR = 0.15, 1.5  # 1/s, 1/m


def acceleration(state: NDArray[np.float64], dashpot: float, air: float) -> float:
    x, v = state
    return float(-(OMEGA**2) * x - dashpot * v - air * abs(v) * v)


def example(dashpot: float, air: float, seed: int) -> str:
    """The text of a file with the columns t and x."""
    from scipy.integrate import solve_ivp

    random = np.random.default_rng(seed)
    t = np.linspace(0.0, SECONDS, FRAMES)
    moments = np.clip(t + random.normal(0.0, JITTER, FRAMES), 0.0, SECONDS)
    found = solve_ivp(
        lambda _, state: [state[1], acceleration(state, dashpot, air)], (0.0, SECONDS), [START, 0.0],
        dense_output=True, rtol=1e-9, atol=1e-12,
    )  # fmt: skip
    x = found.sol(moments)[0] + OFFSET + random.normal(0.0, NOISE, FRAMES)
    rows = (f"{time:.4f},{1e3 * place:.2f}" for time, place in zip(np.maximum.accumulate(moments), x, strict=True))
    return "\n".join(["t (s),x (mm)", *rows, ""])


EXAMPLES = {
    "simulated-dashpot.csv": example(DASHPOT, 0.0, SEED),
    "simulated-air-drag.csv": example(0.02, AIR, SEED + 1),
}

if __name__ == "__main__":
    for name, text in EXAMPLES.items():
        (FOLDER / name).write_text(text, encoding="utf-8")
