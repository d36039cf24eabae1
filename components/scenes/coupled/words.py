"""The words of the coupled masses: captions of the modes, constants, forces, and which sentence stands."""

from __future__ import annotations

import math

import numpy as np

from components.chain import MODES
from components.layout.sheet import Paragraph, either
from components.quantities.axes import Axis
from components.quantities.numbers import plus, signed, three
from physics.coupled import FreeModes

TASK = "Pull mass 1, hold mass 2, let go of both: does any part of the motion die out?"

SIGN = {"slow": "minus", "fast": "plus"}
BEATS = 1e-3
"""A mode smaller than this share of the other leaves no beat that is seen."""
CLOSE = 0.2
"""The difference of the frequencies over their sum up to which two sines are seen to beat."""


def captions(mode: str) -> list[Paragraph]:
    """The caption beside the row of a mode: its name, its frequency and its shape."""
    name, index, sign = SIGN[mode], {"slow": "-", "fast": "+"}[mode], {"slow": "=", "fast": "+"}[mode]
    title = either(
        f"{mode}_fact",
        sine=f"[{mode}|{sign} {mode} mode]",
        drift=f"[{mode}|{sign} drift, off the wall]",
        free=f"[{mode}|{sign} drift of mass 2]",
        two=f"[{mode}|{sign} drift: no springs]",
    )
    fact = either(
        f"{mode}_omega",
        sine=rf"$\omega_{{{index}}} = \val{{omega_{name}}}$ rad/s, $X_2 / X_1 = \val{{ratio_{name}}}$",
        drift=rf"$\omega_{{{index}}} = 0$: $x = a + b\,t$, $X_2 / X_1 = \val{{ratio_{name}}}$",
        two=r"$\omega_- = \omega_+ = 0$: $x = a + b\,t$, each mass on its own",
    )
    return [title, fact]


CONSTANTS: list[Paragraph] = [
    "**Four constants, four starting values**",
    either(
        "constants",
        shapes=r"$X_{1j} \sin \phi_j = \dfrac{m_1 x_1 + m_2 r_j x_2}{M_j}$",
        loose="Without spring 2 each mass has two of its own.",
    ),
    either(
        "constants",
        shapes=r"$\omega_j X_{1j} \cos \phi_j = \dfrac{m_1 v_1 + m_2 r_j v_2}{M_j}$",
        loose="",
    ),
    either("constants", shapes=r"$r_j = (X_2/X_1)_j, \quad M_j = m_1 + m_2 r_j^2$", loose=""),
    either(
        "slow_fact",
        sine="",
        drift=r"In the drift they are $a_1$ and $b_1$: no $X$, no $\phi$.",
        free="",
        two="",
    ),
]
"""From the displacements and velocities at the start to the amplitudes and phases of both modes."""

CONSTANTS_TABLE: list[list[Paragraph]] = [
    ["$M$", "{M_minus}", "{M_plus}", "kg"],
    [r"$X_1 \sin \phi$", "{q_minus}", "{q_plus}", "m"],
    [r"$\omega X_1 \cos \phi$", "{rate_minus}", "{rate_plus}", "m/s"],
]

FORCES: list[Paragraph] = [
    "**Forces on both masses**",
    r"$\tint{m1}{m_1 \ddot{x}_1} = \tint{k}{-k_1 x_1 - k_2 (x_1 - x_2)}$",
    r"$F_1 =$ {F1} {force_unit}",
    r"$\tint{m2}{m_2 \ddot{x}_2} = \tint{k}{k_2 (x_1 - x_2)}$",
    r"$F_2 =$ {F2} {force_unit}",
    "[small|That $T + V$ stays constant is one equation: two masses need two.]",
]


def values(free: FreeModes, energy: Axis) -> dict[str, str]:
    texts: dict[str, str] = {}
    for j, mode in enumerate(MODES):
        texts |= _of_mode(free, j, mode)
        texts[f"E_{SIGN[mode]}"] = energy.number(free.energy[j])
    for i in (1, 2):
        texts[f"a{i}"], texts[f"b{i}"] = three(free.drift_a[i - 1]), plus(free.drift_b[i - 1])
    beat = free.chain.modes().beat
    texts["beat_period"] = f"{three(2 * math.pi / beat)} s" if beating(free) == "both" else "none"
    texts["E_total"], texts["E_unit"] = energy.number(float(free.energy.sum())), energy.full_unit
    return texts


def _of_mode(free: FreeModes, j: int, mode: str) -> dict[str, str]:
    """Frequency, shape, modal mass, the coordinate at the start and its rate, amplitudes and phase of one mode."""
    name = SIGN[mode]
    omega, ratio = free.omega[j], free.chain.modes().ratio[j]
    (exact_mode, coordinate, rate) = free.each()[j]
    texts = {
        f"omega_{name}": three(omega),
        f"ratio_{name}": "∞" if math.isinf(ratio) else signed(ratio),
        f"M_{name}": three(exact_mode.mass),
        f"q_{name}": signed(coordinate),
        f"rate_{name}": signed(rate),
        f"phi_{name}": plus(free.phase[j]),
        f"{mode}_period": f"{three(2 * math.pi / omega)} s" if omega else "none",
    }
    written = three if mode == "slow" else plus  # the second of two terms is added
    for i, amplitude in enumerate(free.amplitude[j].tolist(), start=1):
        texts[f"X{i}_{name}"] = written(amplitude)
    return texts


def beating(free: FreeModes) -> str:
    """Whether the motion beats: both modes move, none is a drift, their frequencies are close; or why it does not."""
    if not (np.any(free.amplitude) or np.any(free.drift_b)):
        return "rest"
    slow, fast = free.omega.tolist()
    if not slow:
        return "drift"
    sizes = [sorted(map(abs, of_mass)) for of_mass in free.amplitude.T.tolist()]
    if not any(less > BEATS * more for less, more in sizes):
        return "one"
    return "both" if free.chain.modes().beat <= CLOSE * (slow + fast) else "apart"


def forms(free: FreeModes) -> dict[str, str]:
    """Which sentence stands: a mode of frequency zero is a drift, and with no spring at all both are."""
    slow, fast = free.omega
    loose = not free.chain.k2
    kind = "sine" if slow else ("two" if not fast else "free" if loose else "drift")
    chosen = {"slow_fact": kind, "fast_fact": "sine" if fast else "", "constants": "loose" if loose else "shapes"}
    chosen |= {"slow_omega": kind if kind in ("sine", "two") else "drift", "fast_omega": "sine" if fast else ""}
    chosen["beat"] = beating(free)
    for i in (1, 2):
        chosen[f"x{i}_slow"] = "sine" if slow else "drift"
        chosen[f"x{i}_fast"] = "sine" if fast else ""
    return chosen
