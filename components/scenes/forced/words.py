"""The texts of the forced masses: formulas, and the conditions of sentences."""

from __future__ import annotations

import math

from components.chain import BOTH
from components.chain.forces import Arrows
from components.layout.sheet import Paragraph, either
from components.quantities.declared import Declared, Form
from components.scenes.forced.case import Signals as S
from components.scenes.forced.damped_case import DampedForcedCase
from components.scenes.forced.driven import Undamped
from components.scenes.forced.numbers import AnyCase
from components.scenes.forced.numbers import Numbers as N

form = Form[AnyCase]


def _steady(case: AnyCase) -> str:
    """The form of the particular solution: its formulas, or the reason why there are none."""
    return case.kind if case.driven else "rest" if not case.moves else "none" if case.modes.F_0 else "idle"


def _part(case: AnyCase) -> str:
    """The form of the parts of a displacement. If they are huge and opposite, the envelope is shown instead."""
    if not case.split or (isinstance(case, DampedForcedCase) and not case.driven):
        return ""
    return "words" if case.view != "formulas" else "formula" if isinstance(case, Undamped) else "dies"


def _transient(case: AnyCase) -> str:
    """The form of the sentence on the decay of the complementary part, or of the motion if nothing is driven."""
    if isinstance(case, Undamped) or case.slowest == math.inf or _steady(case) == "rest":
        return ""
    if not case.slowest:
        return "stays" if case.driven else "stays_free"
    if any(len(term.amplitudes) > 1 for term in case.modes.transient):
        return "alike" if case.driven else "alike_free"
    return "dies" if case.driven else "free"


class Forms(Declared[AnyCase]):
    steady, transient = form(_steady), form(_transient)
    rows = form(lambda c: "braked" if isinstance(c, DampedForcedCase) else "sign")
    x_p, x_c = form.each(BOTH, "x{}_p", value=_part), form.each(BOTH, "x{}_c", value=_part)
    limit = form.each(
        BOTH, "x{}_limit", value=lambda c: "beats" if S.growth[1] in c.limits else "grows" if c.limits else ""
    )
    peaks = form(lambda c: "braked" if c.extremes else "none")
    works = form(lambda c: "braked" if any(c.works) else "none")
    lecture = form(lambda c: "offered" if c.comparable else "")


def _rows(one: str, two: str) -> str:
    """Both equations in matrix form, with springs alone or with springs and dashpots."""
    return (
        rf"[small|$\begin{{pmatrix}} m_1 \omega^2 - {one} - {two} & {two} \\ {two} & m_2 \omega^2 - {two}"
        r" \end{pmatrix} \begin{pmatrix} X_{\mathrm{p}1} \\ X_{\mathrm{p}2} \end{pmatrix}"
        r" = \begin{pmatrix} -F_0 \\ 0 \end{pmatrix}$]"
    )


_GROWS = f"from rest the swing of $x_1$ grows by {N.growth[1]} m a second, that of $x_2$ by {N.growth[2]} m."
UNDRIVEN = ("none", "idle", "rest")
"""The text in place of the particular solution if nothing is driven."""

FATE = either(
    Forms.transient,
    dies=f"The complementary part decays, each term to 1 % within {N.dies}; the particular solution remains.",
    alike="The complementary part decays, and the particular solution remains.",
    stays="Of the complementary part only what nothing ties to its place stays, a constant or a drift.",
    free=f"The motion decays, each of its terms to 1 % within {N.dies}.",
    alike_free="The motion decays.",
    stays_free="Of the motion only what nothing ties to its place stays, a constant or a drift.",
)
"""The decay of the complementary part with dashpots."""

SOLUTION: list[Paragraph] = [
    either(Forms.rows, sign=_rows("k_1", "k_2"), braked=_rows(r"\kappa_1", r"\kappa_2")),
    either(Forms.rows, sign="", braked=r"[small|with $\kappa_j = k_j + i \omega c_j$ for spring and dashpot $j$]"),
    either(
        Forms.steady,
        finite=r"$\tint{m1}{X_{\mathrm{p}1} = \dfrac{(k_2 - m_2 \omega^2) F_0}{D} = "
        rf"{N.Xp[1]}}}$ [m1|m, {N.way[1]}]",
        loose=r"$\tint{m1}{X_{\mathrm{p}1} = \dfrac{F_0}{k_1 - m_1 \omega^2} = "
        rf"{N.Xp[1]}}}$ [m1|m, {N.way[1]}]",
        braked=rf"$\tint{{m1}}{{|X_{{\mathrm{{p}}1}}| = {N.Xp[1]}}}$ [m1|m, {N.way[1]}]",
        none=r"**No drive:** at $\omega = 0$ the force is 0 at all times, and the motion is that of the start alone.",
        idle=r"**No drive:** $F_0 = 0$, so the particular solution is 0, and the motion is that of the start alone.",
        rest="**Nothing moves:** no force at any time, and a start at rest with no spring stretched.",
        resonance=f"**Drive at a natural frequency:** no such solution exists; {_GROWS}",
        near=rf"**Next to a natural frequency,** where $D = 0$: at first, {_GROWS}",
    ),
    either(
        Forms.steady,
        finite=rf"$\tint{{m2}}{{X_{{\mathrm{{p}}2}} = \dfrac{{k_2 F_0}}{{D}} = {N.Xp[2]}}}$ [m2|m, {N.way[2]}]",
        loose=r"[m2|$X_{\mathrm{p}2} = 0$:] without spring 2 nothing moves mass 2.",
        braked=rf"$\tint{{m2}}{{|X_{{\mathrm{{p}}2}}| = {N.Xp[2]}}}$ [m2|m, {N.way[2]}]",
        **dict.fromkeys((*UNDRIVEN, "resonance", "near"), ""),
    ),
    either(
        Forms.steady,
        finite=rf"[small|$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = {N.D}$]",
        resonance=r"[small|$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = 0$]",
        near=rf"[small|$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = {N.D}$]",
        **dict.fromkeys((*UNDRIVEN, "loose", "braked"), ""),
    ),
    FATE,
    either(
        Forms.steady,
        finite=rf"[small|$X_{{\mathrm{{p}}1}} = 0$ at $\sqrt{{k_2/m_2}} = {N.mark['still']}$ rad/s: $m_1$ is a "
        "wall for $m_2$.]",
        **dict.fromkeys((*UNDRIVEN, "loose", "resonance", "near", "braked"), ""),
    ),
]
"""The particular solution: both rows, both amplitudes, or the reason why there are none."""

LAGS: list[Paragraph] = [
    f"[m1|Mass 1 {N.phase[1]}], [m2|mass 2 {N.phase[2]}].",
    either(
        Forms.peaks,
        braked=rf"[m1|$|X_{{\mathrm{{p}}1}}|$ {N.peaks[1]}]; [m2|$|X_{{\mathrm{{p}}2}}|$ {N.peaks[2]}].",
        none="Without dashpots no peak has an end, and the lags jump by 180°.",
    ),
    "Lag 1 stays between 0 and 180°: a push can only feed the mass that it acts on. So with little damping lag 1 falls "
    "back between the resonances. Spring 2 is between the push and mass 2: lag 2 goes on.",
]
"""The lags, the peaks, and the reason why only the lag of mass 1 decreases again."""

WORK: list[Paragraph] = [
    either(
        Forms.works,
        braked=f"The push does **{N.work} J** in a cycle, π*F*_0 times the depth of *X*_1 below the axis: "
        f"{N.works[1]} J go to dashpot 1, {N.works[2]} J to dashpot 2.",
        none="Without dashpots *X*_1 stays on the axis: no loop, and no work in a cycle. Choose “Damped”.",
    ),
    "*X*_1 is never above the axis: a push can only feed the mass that it acts on. *X*_2 can be.",
]
"""The work in a cycle, as the depth of the curve of mass 1."""

MOTION: list[Paragraph] = [
    either(
        Forms.rows,
        sign=r"$\tint{m1}{m_1 \ddot{x}_1} = \tint{k}{-k_1 x_1 - k_2 (x_1 - x_2)} + \tint{F}{F_0 \sin \omega t}$",
        braked=r"[small|$\tint{m1}{m_1 \ddot{x}_1} = \tint{k}{-k_1 x_1 - k_2 (x_1 - x_2)} "
        r"\tint{T}{{} - c_1 \dot{x}_1 - c_2 (\dot{x}_1 - \dot{x}_2)} + \tint{F}{F}$]",
    ),
    rf"$F_1 =$ {S.F[1]} {Arrows.force_unit}",
    either(
        Forms.rows,
        sign=r"$\tint{m2}{m_2 \ddot{x}_2} = \tint{k}{k_2 (x_1 - x_2)}$",
        braked=r"[small|$\tint{m2}{m_2 \ddot{x}_2} = \tint{k}{k_2 (x_1 - x_2)} "
        r"\tint{T}{{} + c_2 (\dot{x}_1 - \dot{x}_2)}$]",
    ),
    rf"$F_2 =$ {S.F[2]} {Arrows.force_unit}",
    rf"$\tint{{F}}{{F = F_0 \sin \omega t =}}$ [F|{S.force_now} {N.F_unit}]",
]
"""Newton's law for each mass, the current force on it, and the drive."""


def notes(case: AnyCase, units: str, shown: str, too_fast: bool) -> list[str]:
    told = {
        "At ω = 0 the force F₀ sin ωt is 0 at all times.": not case.modes.omega,
        "With dashpots a swing is neither with the push nor against it: its size is shown.": (
            shown == "signed" and isinstance(case, DampedForcedCase)
        ),
        "Complementary and particular part are far larger than their sum here, so they are not drawn.": (
            not case.split and case.kind != "resonance"
        ),
        "The lecture's units F₀/k₁ and √(k₁/m₁) need k₁ and F₀ above 0: shown in SI.": (
            units == "lecture" and not case.comparable
        ),
        "The energies change too fast to be drawn in this window.": too_fast,
    }
    return [sentence for sentence, holds in told.items() if holds]
