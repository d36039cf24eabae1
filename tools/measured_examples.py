"""`python -m tools.measured_examples` writes the example files of measured points. They are simulated.

One mass with a dashpot or with the drag of air, and two carts with little friction, each with the noise of a phone's
camera, an offset, and frames that come early or late.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).parents[1] / "static" / "measured"
SEED = 20261127
SECONDS, FRAMES = 12.0, 361
NOISE, OFFSET = 5.5e-4, 2e-3  # m
JITTER = 2e-3  # s
OMEGA, START = 6.3, 0.08  # rad/s, m
DASHPOT, AIR = 0.15, 1.5  # 1/s, 1/m
K1, K2, M2, FRICTION = 20.0, 10.0, 0.5, 0.05  # N/m, N/m, kg and N s/m for a first cart of 1 kg


Rates: TypeAlias = Callable[[NDArray[np.float64]], list[float]]


def one_mass(dashpot: float, air: float) -> Rates:
    """The rates of change of x and v."""

    def rates(state: NDArray[np.float64]) -> list[float]:
        x, v = state
        return [float(v), float(-(OMEGA**2) * x - dashpot * v - air * abs(v) * v)]

    return rates


def two_carts(state: NDArray[np.float64]) -> list[float]:
    """The rates of change of x1, x2, v1 and v2."""
    x1, x2, v1, v2 = state
    a1 = -K1 * x1 - K2 * (x1 - x2) - FRICTION * v1
    a2 = (K2 * (x1 - x2) - FRICTION * v2) / M2
    return [float(v1), float(v2), float(a1), float(a2)]


def example(rates: Rates, start: Sequence[float], seed: int, names: str = "x (mm)") -> str:
    """The text of a file with the columns t and `names`: the first half of the state, over time."""
    from scipy.integrate import solve_ivp

    random = np.random.default_rng(seed)
    t = np.linspace(0.0, SECONDS, FRAMES)
    moments = np.clip(t + random.normal(0.0, JITTER, FRAMES), 0.0, SECONDS)
    found = solve_ivp(
        lambda _, state: rates(state), (0.0, SECONDS), start, dense_output=True, rtol=1e-9, atol=1e-12
    )  # fmt: skip
    x = found.sol(moments)[: len(start) // 2]
    x = 1e3 * (x + OFFSET + random.normal(0.0, NOISE, x.shape))
    rows = np.column_stack([np.maximum.accumulate(moments), *x])
    lines = [",".join([f"{row[0]:.4f}", *(f"{place:.2f}" for place in row[1:])]) for row in rows.tolist()]
    return "\n".join([f"t (s),{names}", *lines, ""])


EXAMPLES = {
    "simulated-dashpot.csv": example(one_mass(DASHPOT, 0.0), (START, 0.0), SEED),
    "simulated-air-drag.csv": example(one_mass(0.02, AIR), (START, 0.0), SEED + 1),
    "simulated-two-carts.csv": example(two_carts, (START, 0.0, 0.0, 0.0), SEED + 2, "left (mm),right (mm)"),
}

if __name__ == "__main__":
    for name, text in EXAMPLES.items():
        (FOLDER / name).write_text(text, encoding="utf-8")
