"""The words of the damped mass: live numbers, which formula stands, and one sentence on what becomes of the motion."""

from __future__ import annotations

from components.layout.sheet import Paragraph, either
from components.quantities.declared import Declared, Form
from components.scene.traces import Floats
from components.scenes.damped.case import DampedCase
from components.scenes.damped.curves import parts_shown
from components.scenes.damped.numbers import Numbers as N
from physics.sampling import drawable

TASK = "Drag a root: where does the swinging end, and does still more damping bring the mass home sooner?"

form = Form[DampedCase]


def _fastest(case: DampedCase) -> str:
    """Where the dashpot takes most."""
    one = case.oscillator
    if not (one.c and case.P_max):
        return ""
    return "at_start" if not case.top.t else "before" if case.kind == "under" else "fastest"


def _roots(case: DampedCase) -> str:
    """The formula over the plane of the roots."""
    return "critical" if case.kind == "critical" else "wall" if case.kind == "plain" else case.roots


class Forms(Declared[DampedCase]):
    kind = form(lambda c: c.kind)
    spring = form(lambda c: "shown" if c.oscillator.k else "none")
    said = form(lambda c: c.said)
    x = form(lambda c: "parts" if parts_shown(c) else "sum" if c.kind == "over" else c.kind)
    upper = form(lambda c: "formula" if c.kind == "under" else "")
    slow = form(lambda c: "formula" if parts_shown(c) else "")
    fast = form(lambda c: "formula" if parts_shown(c) else "")
    heat = form(lambda c: "formula" if c.oscillator.c else "")
    power = form(lambda c: c.oscillator.c > 0)
    fastest = form(_fastest)
    roots = form(_roots)


FACTS: tuple[Paragraph, ...] = (
    r"$m \ddot{x} + c \dot{x} + k x = 0$",
    either(
        Forms.spring,
        shown=rf"$\tint{{T}}{{\zeta = \dfrac{{c}}{{2 m \omega_n}} = {N.zeta}}}$",
        none=rf"[T|$c / m = {N.rate}$ 1/s], and no $\zeta$ without a spring",
    ),
    either(
        Forms.kind,
        under=rf"$\tint{{m1}}{{\omega_d = \omega_n \sqrt{{1 - \zeta^2}} = {N.omega_d}}}$ [m1|rad/s]",
        over=r"$s_{1,2} = -\omega_n (\zeta \mp \sqrt{\zeta^2 - 1})$",
        critical=rf"$s = -\omega_n = -{N.omega}$ 1/s, twice",
        **dict.fromkeys(("rest", "plain", "glide", "drift"), ""),
    ),
    either(
        Forms.kind,
        under=rf"$\delta = \ln \dfrac{{x_1}}{{x_2}} = \zeta \omega_n \tau_d = {N.delta}$",
        over=rf"$s_1 s_2 = \omega_n^2 = {N.square}$ 1/s²",
        **dict.fromkeys(("rest", "plain", "glide", "drift", "critical"), ""),
    ),
)
NATURAL: Paragraph = either(
    Forms.spring,
    shown=rf"$\omega_n = \sqrt{{\dfrac{{k}}{{m}}}} = {N.omega}$ rad/s",
    none=r"$\omega_n = 0$ without a spring",
)
SENTENCE = either(
    Forms.said,
    swing=f"Each swing keeps {N.keep} of its size and {N.keep_energy} of its energy, and takes {N.longer} longer "
    "than undamped.",
    hardly=f"It hardly swings: each turn reaches {N.half} of the one before.",
    plain="Nothing is lost: every swing is as large as the last.",
    thrice=f"It has fallen to 1 % of its start after {N.home} s and never passes 0; "
    f"with three times the damping after {N.home_3} s.",
    home=f"It has fallen to 1 % of its start after {N.home} s and never passes 0.",
    out=f"It goes out to {N.farthest} m, turns once, and comes back without passing 0.",
    crosses=f"It passes 0 once, at {N.zero} s, because it was thrown faster than {N.crossing} m/s; let go, "
    "it never would.",
    never="It never passes 0 again.",
    rest="It rests: there is nothing to lose.",
    glide=f"No spring: it glides to rest {N.glide} m further on.",
    drift="No spring and no dashpot: it keeps its velocity.",
    still="No spring, and a start at rest: nothing moves.",
)
"""The sentence on the fate of the motion, in each of its forms."""


def notes(case: DampedCase, t: Floats) -> tuple[str, ...]:
    if drawable(2 * case.oscillator.omega_d, t):
        return ()
    return ("The energies and the power change too fast to be drawn in this window: they are averages over a swing.",)


FORMULAS = {
    "pair": rf"s = \tint{{T}}{{-{N.a}}} \pm \tint{{m1}}{{{N.omega_d}\, i}} \text{{ 1/s}}",
    "wall": rf"s = \pm {N.omega}\, i \text{{ 1/s}}",
    "critical": rf"s = -{N.omega} \text{{ 1/s, twice}}",
    "real": rf"s = {N.slow},\; {N.fast} \text{{ 1/s}}",
    "bare": rf"s = 0,\; {N.fast} \text{{ 1/s}}",
}
"""The roots of m s^2 + c s + k, as they stand over their plane."""
