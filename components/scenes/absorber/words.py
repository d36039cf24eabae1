"""The texts of the absorber's scene: formulas, explanations, verdicts, and their conditions."""

from __future__ import annotations

import math

import numpy as np

from components.layout.sheet import either
from components.quantities.declared import Declared, Form
from components.quantities.formatting import three
from components.scenes.absorber.case import AbsorberCase
from components.scenes.absorber.numbers import Numbers as N

WATCH = {
    "Below": "Below the machine's own frequency: see how much vibration is left with a tuned absorber.",
    "Resonant": "At the machine's own frequency: without an absorber it would swing further and further.",
    "Above": "Above the machine's own frequency: watch between which resonances its speed lies.",
    "Own": "Your own machine: set it first, then its absorber.",
}
"""For each preset, a sentence that says what to watch."""

HELPED = {
    "band": f"less swing from {N.help_low} to {N.help_high} rad/s",
    "above": f"less swing above {N.help_low} rad/s",
    "never": "no improvement",
}

VERDICTS = {
    "still": "Tuned, it stands still",
    "almost": "Nearly tuned, it hardly moves",
    "same": "With it, hardly a change",
    "less": "With it, it shakes less",
    **dict.fromkeys(("more", "adds", "over"), "With it, it shakes more"),
    "aside": "By a resonance of mass 2",
    "grow": "At a resonance, it grows",
    "beat": "By a resonance, it beats",
    "detached": "Detached, it shakes",
    "rest": f"With it, within {N.rest1} {N.x_unit}",
}

NEAR_OWN = 0.005
"""Relative distance from the machine's own frequency within which the machine needs almost no force."""

form = Form[AbsorberCase]


def _kind(case: AbsorberCase) -> str:
    """The form of the amplitudes; it depends on the existence of a particular solution."""
    return "damped" if case.c else "undamped" if np.all(np.isfinite(case.X)) else "none"


def _why(case: AbsorberCase) -> str:
    """The form of the reason for the verdict. If the force of spring 2 equals the drive to three digits, it depends on
    the
    machine's own frequency."""
    if case.c:
        return "damped"
    if case.verdict != "less" or three(case.pull) != three(case.F_0):
        return case.verdict
    return "own" if abs(case.omega / case.own - 1) < NEAR_OWN else "little"


def _why_rest(case: AbsorberCase) -> str:
    if case.c:
        return "alike" if case.alike else "damped"
    return case.unsolved if not case.solved else "parts" if case.k2 else "alone"


class Forms(Declared[AbsorberCase]):
    first = form(_kind)
    second = form(lambda d: "still" if d.verdict == "still" else _kind(d).replace("none", ""))
    why = form(_why)
    why_rest = form(_why_rest)
    rest = form(lambda d: d.from_rest)
    helped = form(lambda d: "never" if d.band is None else "above" if math.isinf(d.band[1]) else "band")
    free = form(lambda d: "undamped" if d.c else "")
    optimum = form(lambda d: d.c > 0)


_X1 = r"X_{\mathrm{p}1} = \dfrac{(k_2 - m_2 \omega^2) F_0}{D}"
_X2 = r"X_{\mathrm{p}2} = \dfrac{k_2 F_0}{D}"
_FIRST = either(
    Forms.first,
    undamped=rf"$\tint{{m1}}{{{_X1} = {N.Xp1}}}$ [m1|{N.x_unit}]",
    damped=rf"$\tint{{m1}}{{|X_1| = \dfrac{{|\kappa - m_2 \omega^2| F_0}}{{|D|}} = {N.swing}}}$ [m1|{N.x_unit}]",
    none=r"$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = 0$",
)
_SECOND = either(
    Forms.second,
    still=rf"$\tint{{m2}}{{{_X2} = -\dfrac{{F_0}}{{k_2}} = {N.Xp2}}}$ [m2|{N.x_unit}]",
    undamped=rf"$\tint{{m2}}{{{_X2} = {N.Xp2}}}$ [m2|{N.x_unit}]",
    damped="",
)
_BOTH = f"alone the machine swings {N.alone} {N.x_unit}, with it {N.swing} {N.x_unit}."
_WHY = either(
    Forms.why,
    still=(
        r"$k_2 = m_2 \omega^2$: spring 2 pulls exactly as hard as the drive pushes, and nothing is left to move the "
        f"machine. From rest it still swings up to {N.rest1} {N.x_unit}: nothing damps that part."
    ),
    less=(
        r"$k_2 \ne m_2 \omega^2$: spring 2 pulls "
        f"with {N.pull} {N.F_unit} at the most, the drive pushes with {N.push}. What is left moves the machine."
    ),
    own=(
        r"$\omega \approx \sqrt{k_1/m_1}$: at this frequency mass 1 on spring 1 needs hardly any other force to swing. "
        f"So spring 2 must pull as hard as the drive pushes, with {N.push}. It does so where the machine swings "
        f"{N.swing} {N.x_unit}."
    ),
    little=(
        r"$k_2 \ne m_2 \omega^2$, but spring 2 pulls almost as hard as the drive pushes, "
        f"with {N.push}. Little is left to move the machine: it swings {N.swing} {N.x_unit}."
    ),
    almost=(
        r"$k_2 \approx m_2 \omega^2$: spring 2 pulls almost as hard as the drive pushes, "
        f"and {N.swing} {N.x_unit} are left. From rest it swings up to {N.rest1} {N.x_unit}: nothing damps that part."
    ),
    same=f"Here the absorber hardly changes anything: {_BOTH}",
    more=f"Here the absorber does harm: {_BOTH} A resonance is too near.",
    adds=f"Here spring 2 pulls with the drive: the absorber only adds to it. {_BOTH[0].upper()}{_BOTH[1:]}",
    over=f"Here spring 2 pulls against the drive, more than twice as hard as that pushes: {_BOTH}",
    grow=(
        r"The drive meets a natural frequency: no particular solution of the form $X \sin \omega t$ exists. From rest "
        "the swing grows in proportion to time."
    ),
    beat=(
        "The drive is next to a natural frequency: from rest the machine's swing grows for long in proportion to "
        "time, then it beats."
    ),
    aside=(
        "The drive is next to a natural frequency at which almost mass 2 alone swings: from rest its swing grows for "
        f"long, the machine's stays within {N.rest1} {N.x_unit}."
    ),
    detached="Nothing pulls back: the machine takes the whole drive.",
    damped=(r"$\kappa = k_2 + i c \omega$ takes the place of $k_2$. $P$ and $Q$ do not depend on $c$."),
)
_OPTIMUM = either(
    Forms.optimum,
    shown=(
        f"Den Hartog makes them equal, {N.height} {N.x_unit}, and nearly the peaks, which are {N.over_height} higher: "
        r"$\omega_2 = \dfrac{\omega_1}{1 + \mu}$, "
        r"$\dfrac{c}{2 m_2 \omega_1} = \sqrt{\dfrac{3 \mu}{8 (1 + \mu)^3}}$"
    ),
)

FORMULAS = (_FIRST, _SECOND, _WHY, _OPTIMUM)
"""Both amplitudes and their explanation; beyond the lecture, the best damping."""

_NEVER = "does not die out: nothing damps it."
FROM_REST = either(
    Forms.why_rest,
    parts=f"The particular solution is {N.swing} {N.x_unit}. The complementary part, {N.part1} {N.x_unit} at "
    f"$\\omega_-$ and {N.part2} {N.x_unit} at $\\omega_+$, {_NEVER}",
    alone=f"The particular solution is {N.swing} {N.x_unit}. The complementary part, {N.part2} {N.x_unit} at its "
    f"own frequency, {_NEVER}",
    grow=r"The drive meets a natural frequency: no particular solution of the form $X \sin \omega t$ exists. The swing "
    "that the drive adds grows in proportion to time.",
    beat="Next to a natural frequency the swing that the drive adds to the machine grows for long in proportion to "
    "time, then it beats.",
    aside="Next to a natural frequency at which almost mass 2 alone swings, the swing that the drive adds to mass 2 "
    f"grows for long. The machine's stays within {N.rest1} {N.x_unit}.",
    damped=f"The particular solution, {N.swing} {N.x_unit}, is what remains. The complementary part dies out, each "
    f"term to 1 % within {N.dies}.",
    alike=f"The particular solution, {N.swing} {N.x_unit}, is what remains. The complementary part dies out.",
)
"""The sentence on the motion from its start."""
