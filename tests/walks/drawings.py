"""The wrong sketches that the walks describe, as functions of the abscissa; a dict where two curves are drawn."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

W = 2 * math.pi


def response(w: Any) -> Any:
    return np.abs((1 - w * w) / (w**4 - 3 * w * w + 1))


WRONG: dict[str, list[Callable[[Any], Any]]] = {
    "d31-04": [
        lambda t: 0.1 * np.cos(W * t),
        lambda t: 0.1 * np.cos(W * t + 0.9) + 0.1 * (1 - math.cos(0.9)) * np.exp(-40 * t),
    ],
    "d31-06": [
        lambda t: 0.471 * np.cos(W / 2 * t),
        lambda t: np.abs(0.471 * np.sin(W / 2 * t)),
        lambda t: 0.471 * np.sin(W / 2 * t),
    ],
    "d31-09": [
        lambda t: {"V": 0.394 * (1 + np.cos(2 * W * t)), "T": 0.394 * (1 - np.cos(2 * W * t))},
        lambda t: {"V": 0.788 * np.cos(2 * W * t), "T": 0.788 * np.sin(2 * W * t)},
    ],
    "d31-15": [
        lambda t: 124 * np.sin(0.2275 * t),
        lambda t: -128 + 249 * (1 - np.exp(-t / 4)),
        lambda t: 124 * np.cos(0.2275 * t),
    ],
    "d32-33-05": [
        lambda t: 0.1 * np.exp(-25 * t),
        lambda t: 0.1 * np.exp(-1.5 * t) * np.cos(W / 0.66 * t),
    ],
    "d32-33-10": [
        lambda t: -0.4 * np.cos(W * t),
        lambda t: -0.02 * np.exp(1.1 * t) * np.cos(W * t),
        lambda t: -0.2 * (1 - np.exp(-3 * t)) * np.cos(W * t),
    ],
    "d34-10": [
        lambda t: np.cos(0.1005 * t) * np.cos(0.995 * t),
        lambda t: np.minimum(t / 16, 1) * np.sin(0.995 * t),
        lambda t: 0.2 * np.sin(0.995 * t),
    ],
    "d34-14": [
        lambda w: 1 / np.abs(1 - (w / 1.118) ** 2 + 1e-9),
        lambda w: np.maximum(response(w), 0.8),
        lambda w: w**2 * response(w),
    ],
    "d34-15": [
        lambda t: -2.0 * np.cos(t),
        lambda t: -0.02 * np.exp(0.21 * t) * np.cos(t),
        lambda t: -1.0 * (1 - np.exp(-t / 4)) * np.cos(t),
    ],
}
