"""The words of the coupled masses: captions of the modes, constants, forces, and which sentence stands."""

from __future__ import annotations

from components.chain.forces import Arrows
from components.chain.signals import Signals as S
from components.layout.sheet import Paragraph, either
from components.quantities.declared import Declared, Family, Form
from components.scenes.coupled.curves import CoupledCase
from components.scenes.coupled.numbers import Numbers as N
from components.scenes.coupled.numbers import beating
from components.scenes.coupled.starting import GIVEN

TASK = "Pull mass 1, hold mass 2, let go of both: does any part of the motion die out?"

form = Form[CoupledCase]


def _slow(case: CoupledCase) -> str:
    """The kind of the slow mode: of frequency zero it is a drift, and with no spring at all both modes are."""
    slow, fast = case.free.omega
    return "sine" if slow else "two" if not fast else "drift" if case.free.chain.k2 else "free"


VIEWS = {"modes": "Modes", "constants": "Constants", "forces": "Forces"}


class Forms(Declared[CoupledCase]):
    slow_fact = form(_slow)
    slow_omega = form(lambda c: _slow(c).replace("free", "drift"))
    x1_slow, x2_slow = form.some(2, lambda c: "sine" if c.free.omega[0] else "drift")
    fast_fact, fast_omega, x1_fast, x2_fast = form.some(4, lambda c: "sine" if c.free.omega[1] else "")
    constants = form(lambda c: "shapes" if c.free.chain.k2 else "loose")
    beat = form(lambda c: beating(c.free))
    parts, modes = form(lambda c: c.energy == "parts"), form(lambda c: c.energy == "modes")
    view = Family(VIEWS, lambda one: form(lambda c: c.view == one))
    start = Family(GIVEN, lambda one: form(lambda c: c.given_by == one))


MARKS = {
    "slow": ("-", "=", N.omega_minus, N.ratio_minus, Forms.slow_fact, Forms.slow_omega),
    "fast": ("+", "+", N.omega_plus, N.ratio_plus, Forms.fast_fact, Forms.fast_omega),
}


def captions(mode: str) -> list[Paragraph]:
    """The caption beside the row of a mode: its name, its frequency and its shape."""
    index, sign, omega, ratio, named, told = MARKS[mode]
    title = either(
        named,
        sine=f"[{mode}|{sign} {mode} mode]",
        drift=f"[{mode}|{sign} drift, off the wall]",
        free=f"[{mode}|{sign} drift of mass 2]",
        two=f"[{mode}|{sign} drift: no springs]",
    )
    fact = either(
        told,
        sine=rf"$\omega_{{{index}}} = {omega}$ rad/s, $X_2 / X_1 = {ratio}$",
        drift=rf"$\omega_{{{index}}} = 0$: $x = a + b\,t$, $X_2 / X_1 = {ratio}$",
        two=r"$\omega_- = \omega_+ = 0$: $x = a + b\,t$, each mass on its own",
    )
    return [title, fact]


CONSTANTS: list[Paragraph] = [
    "**Four constants, four starting values**",
    either(
        Forms.constants,
        shapes=r"$X_{1j} \sin \phi_j = \dfrac{m_1 x_1 + m_2 r_j x_2}{M_j}$",
        loose="Without spring 2 each mass has two of its own.",
    ),
    either(Forms.constants, shapes=r"$\omega_j X_{1j} \cos \phi_j = \dfrac{m_1 v_1 + m_2 r_j v_2}{M_j}$", loose=""),
    either(Forms.constants, shapes=r"$r_j = (X_2/X_1)_j, \quad M_j = m_1 + m_2 r_j^2$", loose=""),
    either(
        Forms.slow_fact, sine="", drift=r"In the drift they are $a_1$ and $b_1$: no $X$, no $\phi$.", free="", two=""
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
    f"$F_1 =$ {S.F[1]} {Arrows.force_unit}",
    r"$\tint{m2}{m_2 \ddot{x}_2} = \tint{k}{k_2 (x_1 - x_2)}$",
    f"$F_2 =$ {S.F[2]} {Arrows.force_unit}",
    "[small|That $T + V$ stays constant is one equation: two masses need two.]",
]
