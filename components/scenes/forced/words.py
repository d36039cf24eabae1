"""The words of the forced masses: formulas, live numbers, and which sentence stands."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection

import numpy as np

from components.layout.sheet import Paragraph, either
from components.quantities.numbers import plus, signed, three
from components.scenes.forced.driven import growth_rate, resonant
from components.scenes.forced.dying import Dying
from physics.forced import DrivenModes, determinant

TASK = "Drag ω: where does mass 1 swing farthest, where not at all, and when against the push?"

_ROWS = (
    r"[small|$\begin{pmatrix} m_1 \omega^2 - k_1 - k_2 & k_2 \\ k_2 & m_2 \omega^2 - k_2 \end{pmatrix}"
    r" \begin{pmatrix} X_{\mathrm{p}1} \\ X_{\mathrm{p}2} \end{pmatrix}"
    r" = \begin{pmatrix} -F_0 \\ 0 \end{pmatrix}$]"
)
_BRAKED_ROWS = (
    r"[small|$\begin{pmatrix} m_1 \omega^2 - i \omega c_1 - k_1 - \kappa & \kappa \\ \kappa & m_2 \omega^2 - \kappa"
    r" \end{pmatrix} \begin{pmatrix} X_{\mathrm{p}1} \\ X_{\mathrm{p}2} \end{pmatrix}"
    r" = \begin{pmatrix} -F_0 \\ 0 \end{pmatrix}$]"
)
_GROWS = "from rest the swing of $x_1$ grows by {growth1} m a second, that of $x_2$ by {growth2} m."
UNDRIVEN = ("none", "idle", "rest")
"""Where nothing is driven, in the words of the particular solution."""

SOLUTION: list[Paragraph] = [
    either("rows", sign=_ROWS, braked=_BRAKED_ROWS),
    either(
        "steady",
        finite=r"$\tint{m1}{X_{\mathrm{p}1} = \dfrac{(k_2 - m_2 \omega^2) F_0}{D} = \val{Xp1}}$ [m1|m, {way1}]",
        loose=r"$\tint{m1}{X_{\mathrm{p}1} = \dfrac{F_0}{k_1 - m_1 \omega^2} = \val{Xp1}}$ [m1|m, {way1}]",
        braked=r"$\tint{m1}{|X_{\mathrm{p}1}| = \val{Xp1}}$ [m1|m, {way1}]",
        none=r"**No drive:** at $\omega = 0$ the force is 0 at all times, and the motion is that of the start alone.",
        idle=r"**No drive:** $F_0 = 0$, so the particular solution is 0, and the motion is that of the start alone.",
        rest="**Nothing moves:** no force at any time, and a start at rest with no spring stretched.",
        resonance=f"**Drive at a natural frequency:** no such solution exists; {_GROWS}",
        near=rf"**Next to a natural frequency,** where $D = 0$: at first, {_GROWS}",
    ),
    either(
        "steady",
        finite=r"$\tint{m2}{X_{\mathrm{p}2} = \dfrac{k_2 F_0}{D} = \val{Xp2}}$ [m2|m, {way2}]",
        loose=r"[m2|$X_{\mathrm{p}2} = 0$:] without spring 2 nothing moves mass 2.",
        braked=r"$\tint{m2}{|X_{\mathrm{p}2}| = \val{Xp2}}$ [m2|m, {way2}]",
        **dict.fromkeys((*UNDRIVEN, "resonance", "near"), ""),
    ),
    either(
        "steady",
        finite=r"[small|$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = \val{D}$]",
        resonance=r"[small|$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = 0$]",
        near=r"[small|$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = \val{D}$]",
        braked=r"[small|with $\kappa = k_2 + i \omega c_2$ for spring and dashpot 2]",
        **dict.fromkeys((*UNDRIVEN, "loose"), ""),
    ),
    either(
        "dying",
        dies="The complementary part dies: after {dies} each of its terms has at most 1 % left. The particular "
        "solution remains.",
        alike="The complementary part dies, and the particular solution remains.",
        stays="Of the complementary part only what nothing ties to its place stays, a constant or a drift.",
        free="The motion dies: after {dies} each of its terms has at most 1 % left.",
        alike_free="The motion dies.",
        stays_free="Of the motion only what nothing ties to its place stays, a constant or a drift.",
    ),
    either(
        "steady",
        finite=r"[small|$X_{\mathrm{p}1} = 0$ at $\sqrt{k_2/m_2} = \val{mark_still}$ rad/s: $m_1$ is a "
        "wall for $m_2$.]",
        **dict.fromkeys((*UNDRIVEN, "loose", "resonance", "near", "braked"), ""),
    ),
]
"""The particular solution: both rows, both amplitudes, or why there are none."""

MOTION: list[Paragraph] = [
    either(
        "rows",
        sign=r"$\tint{m1}{m_1 \ddot{x}_1} = \tint{k}{-k_1 x_1 - k_2 (x_1 - x_2)} + \tint{F}{F_0 \sin \omega t}$",
        braked=r"[small|$\tint{m1}{m_1 \ddot{x}_1} = \tint{k}{-k_1 x_1 - k_2 (x_1 - x_2)} "
        r"\tint{T}{{} - c_1 \dot{x}_1 - c_2 (\dot{x}_1 - \dot{x}_2)} + \tint{F}{F}$]",
    ),
    r"$F_1 =$ {F1} {force_unit}",
    either(
        "rows",
        sign=r"$\tint{m2}{m_2 \ddot{x}_2} = \tint{k}{k_2 (x_1 - x_2)}$",
        braked=r"[small|$\tint{m2}{m_2 \ddot{x}_2} = \tint{k}{k_2 (x_1 - x_2)} "
        r"\tint{T}{{} + c_2 (\dot{x}_1 - \dot{x}_2)}$]",
    ),
    r"$F_2 =$ {F2} {force_unit}",
    r"$\tint{F}{F = F_0 \sin \omega t =}$ [F|{force_now} {F_unit}]",
]
"""Newton's law for each mass, the force on it now, and the drive."""


def values(driven: DrivenModes) -> dict[str, str]:
    at_resonance = driven.at_resonance
    texts = {"omega": three(driven.omega), "D": three(0.0 if at_resonance else determinant(driven.chain, driven.omega))}
    for i, X in enumerate(sizes(driven)):
        texts[f"X{i + 1}"] = texts[f"Xp{i + 1}"] = signed(X)
        texts[f"way{i + 1}"] = f"{'with' if X > 0 else 'against'} F" if X else "at rest"
        texts[f"growth{i + 1}"] = three(growth_rate(driven, i)) if resonant(driven) else ""
    return texts


def sizes(driven: DrivenModes) -> list[float]:
    """Xp1 and Xp2; at resonance infinite, but for a mass 2 that no spring ties."""
    if not driven.at_resonance:
        one, two = driven.particular.tolist()
        return [one, two]
    return [math.inf, math.inf if driven.chain.k2 else 0.0]


def steady(driven: DrivenModes) -> str:
    """The form of the particular solution: its formulas, or why they do not stand."""
    if not (driven.F_0 and driven.omega):
        free = driven.free
        moves = np.any(free.amplitude) or np.any(free.drift_b)
        return "none" if moves and driven.F_0 else "idle" if moves else "rest"
    if driven.at_resonance:
        return "resonance"
    return "near" if resonant(driven) else "finite" if driven.chain.k2 else "loose"


def forms(driven: DrivenModes, limit: Collection[str], view: str) -> dict[str, str]:
    """Close to a natural frequency the two parts are huge and opposite: there the envelope stands in their place."""
    split = driven.split_is_meaningful
    parts = {f"x{i}_{part}": "formula" if split else "" for i in (1, 2) for part in "pc"}
    kind = ("beats" if "x1_growth" in limit else "grows") if limit else ""
    limits = {f"x{i}_limit": kind for i in (1, 2)}
    offered = driven.chain.k1 > 0 and driven.F_0 > 0
    shown = {view: "shown", "solution": "" if view == "forces" else "shown"}
    return {
        "steady": steady(driven),
        "rows": "sign",
        **parts,
        **limits,
        **shown,
        "lecture": "offered" if offered else "",
    }


def dying_values(dying: Dying) -> dict[str, str]:
    one = dying.modes
    texts = {"omega": three(one.omega), "D": "", "growth1": "", "growth2": ""}
    texts["dies"] = f"{three(math.log(100) / dying.slowest)} s" if 0 < dying.slowest < math.inf else ""
    for i, X in enumerate(dying.X, start=1):
        lag = -cmath.phase(X) % (2 * math.pi)
        texts |= {f"X{i}": three(abs(X)), f"Xp{i}": three(abs(X)), f"lag{i}": plus(-lag)}
        texts[f"way{i}"] = f"lags F by {three(lag)} rad" if X else "at rest"
    return texts


def dying_forms(dying: Dying, view: str) -> dict[str, str]:
    one, moves = dying.modes, np.any(dying.motion(np.linspace(0.0, dying.end, 9)).x)
    steady = "braked" if one.F_0 and one.omega else "rest" if not moves else "none" if one.F_0 else "idle"
    alike = any(len(term.amplitudes) > 1 for term in one.transient)
    dying_ = "stays" if not dying.slowest else "alike" if alike else "dies"
    undriven = {"stays": "stays_free", "alike": "alike_free", "dies": "free"}
    told = dying_ if steady == "braked" else undriven[dying_]
    parts = "dies" if dying.split and steady == "braked" else ""
    return {
        "steady": steady,
        "rows": "braked",
        "dying": "" if steady == "rest" or dying.slowest == math.inf else told,
        **{f"x{i}_{part}": parts for i in (1, 2) for part in "pc"},
        **{f"x{i}_limit": "" for i in (1, 2)},
        view: "shown",
        "solution": "" if view == "forces" else "shown",
        "lecture": "offered" if dying.chain.k1 > 0 and one.F_0 > 0 else "",
    }


def dying_notes(dying: Dying, units: str, lecture: bool, signed: bool, too_fast: bool) -> list[str]:
    told = ["With dashpots a swing is neither with the push nor against it: its size is shown."] if signed else []
    if not dying.split:
        told.append("Complementary and particular part are huge and opposite here, so they are not drawn.")
    return told + _shown_otherwise(units, lecture, too_fast)


def _shown_otherwise(units: str, lecture: bool, too_fast: bool) -> list[str]:
    told = []
    if units == "lecture" and not lecture:
        told.append("The lecture's units F₀/k₁ and √(k₁/m₁) need k₁ and F₀ above 0: shown in SI.")
    if too_fast:
        told.append("The energies change too fast to be drawn in this window.")
    return told


def notes(driven: DrivenModes, units: str, lecture: bool, too_fast: bool) -> list[str]:
    told = []
    if not driven.omega and not driven.at_resonance:
        told.append("At ω = 0 the force F₀ sin ωt is 0 at all times.")
    if resonant(driven) and not driven.at_resonance:
        told.append("Complementary and particular part are huge and opposite here, so they are not drawn.")
    return told + _shown_otherwise(units, lecture, too_fast)
