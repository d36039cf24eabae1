"""The words of the driven mass: live numbers, which formula stands, and the sentence on what holds the push."""

from __future__ import annotations

import math

from components.layout.sheet import Paragraph, either
from components.quantities.declared import Declared, Family, Form
from components.quantities.numbers import three
from components.scenes.driven.case import KINDS, DrivenCase
from components.scenes.driven.numbers import Numbers as N
from components.scenes.driven.power import powers_of

TASK = "Drag ω through the peak: which arrow holds the push below it, at it, and above it?"
ALONE = 0.02
"""Of the dashpot's arrow and of the spring's: where spring and inertia leave less, the dashpot holds the push alone."""
AT_ROOT = 1e-3
"""So near to √2 every dashpot is alike, where three digits say so."""
SIZES = (
    r"\dfrac{1}{\sqrt{(1 - r^2)^2 + (2 \zeta r)^2}}",
    r"\sqrt{\dfrac{1 + (2 \zeta r)^2}{(1 - r^2)^2 + (2 \zeta r)^2}}",
    r"\dfrac{r^2}{\sqrt{(1 - r^2)^2 + (2 \zeta r)^2}}",
)
GROWTH = rf"$c = 0,\ \omega = \omega_n$: no steady size, $\tint{{m1}}{{X = {N.rate}\, t}}$ grows"
NEARLY = rf"$c = 0,\ \omega \approx \omega_n$: steady [m1|$X = {N.X}$ m], at first $\tint{{m1}}{{{N.rate}\, t}}$"

form = Form[DrivenCase]


def _holds(case: DrivenCase) -> str:
    """The form of SENTENCE that is true."""
    if not case.omega:
        return "still"
    if not case.size:
        return "idle"
    if case.grows:
        return ("grows" if case.resonant else "nearly") + ("_on" if case.x_0 or case.v_0 else "")
    r, dashpot = case.r, 2 * case.zeta * case.r
    if not case.zeta and not math.isfinite(case.M):
        return "near"
    if case.kind == "base":
        if abs(r - math.sqrt(2.0)) < AT_ROOT and three(case.M) == "1.00":
            return "alike"
        return "more" if r < math.sqrt(2.0) else "less" if case.zeta else "isolated"
    left = abs((1 - r) * (1 + r))
    if dashpot < left:
        return "spring" if r < 1 else "inertia"
    return "alone" if left < ALONE * min(dashpot, 1.0) else "dashpot"


def _part(case: DrivenCase) -> str:
    """The fate of the complementary part, where it is drawn."""
    return "" if not case.split else "dies" if case.oscillator.c else "stays"


class Forms(Declared[DrivenCase]):
    kind = form(lambda c: c.kind)
    driven = Family(KINDS, lambda kind: form(lambda c: c.kind == kind), "{}")
    size = form(lambda c: ("grows" if c.resonant else "nearly") if c.swells else c.kind)
    steady = form(lambda c: c.pushed and c.steady)
    quality = form(lambda c: c.kind if c.kind != "base" and c.zeta else "")
    work = form(lambda c: ("base" if c.shaken else "push") if c.pushed and c.steady and c.oscillator.c else "")
    holds = form(_holds)
    x_p = form(lambda c: "" if c.shaken else _part(c))
    y = form(lambda c: "formula" if c.shaken else "")
    x_c = form(_part)
    peaks, flat = form(lambda c: bool(c.half_power)), form(lambda c: not c.half_power)
    upper = form(lambda c: ("always" if c.resonant else "first") if c.swells else "")
    power = form(lambda c: bool(powers_of(c)))


FACTS: tuple[Paragraph, ...] = (
    either(
        Forms.kind,
        force=r"$m \ddot{x} + c \dot{x} + k x = F_0 \sin \omega t$",
        base=r"$m \ddot{x} + c (\dot{x} - \dot{y}) + k (x - y) = 0$",
        unbalance=r"$m \ddot{x} + c \dot{x} + k x = m_0 e\, \omega^2 \sin \omega t$",
    ),
    either(
        Forms.size,
        force=rf"$\tint{{m1}}{{\dfrac{{k X}}{{F_0}} = {SIZES[0]} = {N.M}}}$",
        base=rf"$\tint{{m1}}{{\dfrac{{X}}{{Y}} = {SIZES[1]} = {N.M}}}$",
        unbalance=rf"$\tint{{m1}}{{\dfrac{{m X}}{{m_0 e}} = {SIZES[2]} = {N.M}}}$",
        grows=GROWTH,
        nearly=NEARLY,
    ),
    either(Forms.steady, shown=rf"[m1|$X = {N.X}$ m, $\phi = {N.phi}$ rad]"),
    either(
        Forms.quality,
        force=rf"$Q = 1 / (2 \zeta) = {N.Q},\ \Delta \omega = {N.width}$ rad/s",
        unbalance=rf"$Q = 1 / (2 \zeta) = {N.Q}$",
    ),
)
WORK: Paragraph = either(
    Forms.work,
    push=rf"Steady: $\pi c\, \omega X^2 = {N.W}$ J a cycle",
    base=rf"Steady: $\pi c\, \omega |X - Y|^2 = {N.W}$ J a cycle",
)
SENTENCE = either(
    Forms.holds,
    spring="**Below resonance the spring holds most of the push.**",
    inertia="**Above resonance inertia holds most of the push.**",
    dashpot="**Here the dashpot holds most of the push.**",
    alone="**At resonance the dashpot alone holds the push.**",
    grows=f"**Nothing holds the push: each swing grows by the same {N.growth} m.**",
    grows_on=f"**Nothing holds the push: in the end each swing grows by {N.growth} m.**",
    nearly=f"**Nothing holds the push at first: each swing grows by {N.growth} m, until a long beat turns it.**",
    nearly_on=f"**At first the push adds {N.growth} m to its response in each swing; a long beat takes it away.**",
    near="**Next to resonance and without a dashpot the swing grows for very long.**",
    more="**Below √2 the mass swings more than its base; a stronger dashpot helps.**",
    alike="**At √2 every dashpot is alike: the mass swings as far as its base.**",
    less="**Beyond √2 a weaker dashpot would let the mass swing less.**",
    isolated="**Beyond √2 the mass swings less than its base, and least without a dashpot.**",
    still="**At ω = 0 nothing pushes: the curve there is the limit of a very slow push.**",
    idle="**No push: the motion is that of the start alone.**",
)


def notes(case: DrivenCase, banded: bool, later: bool, base: bool) -> tuple[str, ...]:
    """Say which parts are left out, and what the bands of x and of the base are: `later` a line follows that of x."""
    found = []
    if case.pushed and not case.split and not case.grows:
        found.append("The steady and the complementary part are far larger than their sum here, so they are not drawn.")
    if later:
        found.append("At first x rings too fast to be drawn as a line in this window: it stays within the band.")
    elif banded:
        found.append("The motion is too fast to be drawn as a line in this window: the band is what it stays within.")
    if base:
        found.append("The base moves too fast to be drawn as a line in this window: it stays within its band.")
    return tuple(found)
