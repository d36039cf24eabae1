"""The words of the coupled masses: captions of the modes, constants, forces, and which sentence stands."""

from __future__ import annotations

from components.layout.sheet import Paragraph, either
from components.scenes.coupled.numbers import Numbers as N
from components.scenes.coupled.numbers import beating
from physics.coupled import FreeModes

TASK = "Pull mass 1, hold mass 2, let go of both: does any part of the motion die out?"

MARKS = {"slow": ("-", "=", N.omega_minus, N.ratio_minus), "fast": ("+", "+", N.omega_plus, N.ratio_plus)}


def captions(mode: str) -> list[Paragraph]:
    """The caption beside the row of a mode: its name, its frequency and its shape."""
    index, sign, omega, ratio = MARKS[mode]
    title = either(
        f"{mode}_fact",
        sine=f"[{mode}|{sign} {mode} mode]",
        drift=f"[{mode}|{sign} drift, off the wall]",
        free=f"[{mode}|{sign} drift of mass 2]",
        two=f"[{mode}|{sign} drift: no springs]",
    )
    fact = either(
        f"{mode}_omega",
        sine=rf"$\omega_{{{index}}} = {omega}$ rad/s, $X_2 / X_1 = {ratio}$",
        drift=rf"$\omega_{{{index}}} = 0$: $x = a + b\,t$, $X_2 / X_1 = {ratio}$",
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
    ["$M$", *map(str, N.M), "kg"],
    [r"$X_1 \sin \phi$", *map(str, N.q), "m"],
    [r"$\omega X_1 \cos \phi$", *map(str, N.rate), "m/s"],
]

FORCES: list[Paragraph] = [
    "**Forces on both masses**",
    r"$\tint{m1}{m_1 \ddot{x}_1} = \tint{k}{-k_1 x_1 - k_2 (x_1 - x_2)}$",
    r"$F_1 =$ {F1} {force_unit}",
    r"$\tint{m2}{m_2 \ddot{x}_2} = \tint{k}{k_2 (x_1 - x_2)}$",
    r"$F_2 =$ {F2} {force_unit}",
    "[small|That $T + V$ stays constant is one equation: two masses need two.]",
]


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
