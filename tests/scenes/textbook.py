"""Formulas of textbooks that several tests compare with."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

SIZES = {"force": "F_0", "base": "Y", "unbalance": "moment"}
"""The parameter with the size of each kind of drive."""


def harmonics(s: Any, count: int) -> tuple[Any, Any]:
    """The harmonics of a push from 1 to below `count`: |f_n| in N and |X_n| in m."""
    n = np.arange(1, count)
    f = {
        "impulses": np.full(len(n), s.J * s.omega / math.pi),
        "square": 4 * s.F_0 / (n * math.pi) * (n % 2),
        "triangle": 8 * s.F_0 / (n * math.pi) ** 2 * (n % 2),
        "pulses": 2 * s.F_0 * np.abs(np.sin(n * math.pi * s.width)) / (n * math.pi),
    }[s.push]
    with np.errstate(divide="ignore", invalid="ignore"):
        return f, f / np.abs(s.k - s.m * (n * s.omega) ** 2 + 1j * n * s.c * s.omega)
