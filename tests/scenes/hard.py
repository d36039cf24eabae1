"""States of each scene that are hard for numbers: stiff, resonant, nearly critical, very large and very small."""

from __future__ import annotations

import math
from typing import Any

GOLDEN = (math.sqrt(5.0) - 1) / 2
ON_SLOW = {"m1": 2.0, "m2": 1.0, "k1": 4.0, "k2": 2.0, "omega": 1.0}
STIFF = [{"k2": 10.0**power} for power in (8, 10, 12)]
TOGETHER = {"x1_0": 1.0, "x2_0": 1.0}
VIEWS = ("guess", "solve", "roots", "sweep", "hunt")
DASHPOTS = [
    {"c1": c1, "c2": c2}
    for c1, c2 in ((0.4, 0.2), (0.2, 0.0), (0.0, 3.0), (0.0, 216.0), (1e-12, 0.0), (0.0, 1e12), (1e12, 1e-3))
]
CHAINS = ({}, *STIFF, {"k1": 0.0}, {"k2": 0.0}, {"m2": 1e150}, {"m2": 1e-150})
ENDS, STARTS, MOVING = ("fixed-fixed", "fixed-free", "free-free"), ("pulse", "pluck", "mass"), {"p": 1.0, "v_0": 0.7}
SHAPES = ("square", "triangle", "pulses", "impulses", "step", "impulse")
HARD: dict[str, list[dict[str, Any]]] = {
    "oscillator": [{"k": 1e12}, {"m": 1e150, "k": 1e-150}, {"m": 1e-150, "k": 1e150}, {"x_0": 1e300}, {"k": 0.0}],
    "energy": [{"k": 1e12}, {"x_0": 1e-150}, {"m": 1e150}, {"datum": "separate", "x_0": -0.2}, {"g": 0.0}],
    "analogues": [
        *({"system": system} for system in ("shaft", "rocking", "floating", "circuit", "string", "wave", "pipe")),
        *({"theta_0": angle} for angle in (1e-150, 1e-30, -60.0, 179.9999)),
        {"pendulum_l": 1e150},
        {"pendulum_l": 1e-150},
    ],
    "phugoid": [
        *({"excess": excess} for excess in (1e-150, 1e-9, -0.5, -0.999, 0.7320508, 2.0, 3.0)),
        *({"v_0": 1e-100}, {"v_0": 1e140}, {"g": 1e-150}, {"excess": 0.1, "window": 1000.0}),
    ],
    "damped": [
        *({"m": 1.0, "k": 1.0, "c": 2 * zeta} for zeta in (1e-12, 1 - 1e-12, 1.0, 1 + 1e-15, 1 + 1e-6, 1e6, 1e12)),
        *({"c": 0.0}, {"k": 0.0}, {"k": 0.0, "c": 0.0, "v_0": 1.0}, {"c": 18.85, "v_0": -3.0}, {"x_0": 0.0}),
        *({name: 10.0**power} for name in ("m", "k", "x_0") for power in (-100, 100)),
    ],
    "chain": [
        *({"N": 8.0, "ends": ends, "starts": starts, **MOVING} for ends, starts in zip(ENDS, STARTS, strict=True)),
        *({"N": 8.0, "ends": ends, "starts": "mode", **MOVING} for ends in ENDS),
        *({"N": 1.0, "ends": ends, "starts": "mass", **MOVING} for ends in ENDS),
        *({"m": 1e100}, {"k": 1e-100}, {"h": 1e100}, {"N": 500.0, "ends": "fixed-free"}),
    ],
    "coupled": [
        *STIFF,
        *({**stiff, **TOGETHER} for stiff in STIFF),
        *({name: 10.0**power} for name in ("m1", "m2", "k1", "k2", "x1_0") for power in (-150, 150)),
        *({"k1": 0.0, "k2": 0.0}, {"k2": 1e-12}, {"x1_0": 0.0, "x2_0": 0.0}),
        *({**stiff, "given_by": "modes", "X_fast": 0.3, "phi_slow": 99.7} for stiff in ({}, *STIFF)),
    ],
    "modes": [
        *({"view": view, **chain} for view in VIEWS for chain in CHAINS),
        *({"view": "sweep", "swept": name, "k2": 1e12} for name in ("m1", "m2", "k1", "k2")),
        {"view": "hunt", "answer": "shown"},
        *({"view": "roots", **dashpots} for dashpots in DASHPOTS),
        *({"view": "roots", spring: 0.0, **dashpots} for spring in ("k1", "k2") for dashpots in DASHPOTS[:3]),
    ],
    "forced": [
        *STIFF,
        *({"omega": GOLDEN * (1 + detuning)} for detuning in (1e-15, 1e-12, -1e-12, 1e-9, 1e-6)),
        *({**ON_SLOW, "omega": w} for w in (1.0, 2.0, 1.0 + 1e-12, 2.0 - 1e-12, math.sqrt(2.0))),
        *({"m1": 1e150}, {"m2": 1e-150}, {"k1": 1e150}, {"F_0": 1e-150}, {"x1_0": 1e150}),
        *({"omega": 1e-150}, {"k1": 0.0}, {"k2": 0.0}, {"F_0": 0.0}, {"omega": 0.0}),
        *({**dashpots, "x1_0": 0.5} for dashpots in DASHPOTS),
    ],
    "driven": [
        *(
            {"push": push, "x_0": 0.02, **values}
            for push in SHAPES
            for values in ({}, {"k": 36.0, "omega": 2.0, "c": 0.0})
        ),
        *({"push": "square", **values} for values in ({"omega": 0.01}, {"omega": 60.0}, {"window": 1e3}, {"k": 1e-6})),
        {"push": "pulses", "width": 1e-9, "k": 36.0, "omega": 2.0, "c": 1e-9},
        {"push": "square", "c": 12.0, "k": 36.0},
    ],
    "absorber": [{"damping": "added"}, {"own": True, "m1": 1e150}, {"k2": 1e12}, {"k2": 0.0}, {"m2": 1e-12}],
}
