"""The words of the damped mass: live numbers, which formula stands, and one sentence on what becomes of the motion."""

from __future__ import annotations

import math

from components.layout.sheet import Paragraph, either
from components.quantities.axes import Axis
from components.quantities.motion import scaled
from components.quantities.numbers import plus, short, signed, three
from components.scene.traces import Floats
from components.scenes.damped.case import DampedCase
from components.scenes.damped.curves import parts_shown
from physics.damped import DampedOscillator, FreeDecay
from physics.sampling import drawable

TASK = "Drag a root: where does the swinging end, and does still more damping bring the mass home sooner?"
HOME = 0.01
"""The share of x_0 within which the mass counts as home."""
HARDLY = 0.9
"""From this damping ratio on, half a swing leaves less than two thousandths."""
AT_ONCE = 0.5
"""Up to this damping ratio the mass is fastest close to equilibrium."""

FACTS: tuple[Paragraph, ...] = (
    r"$m \ddot{x} + c \dot{x} + k x = 0$",
    either(
        "spring",
        shown=r"$\tint{T}{\zeta = \dfrac{c}{2 m \omega_n} = \val{zeta}}$",
        none=r"[T|$c / m = \val{rate}$ 1/s], and no $\zeta$ without a spring",
    ),
    either(
        "kind",
        under=r"$\tint{m1}{\omega_d = \omega_n \sqrt{1 - \zeta^2} = \val{omega_d}}$ [m1|rad/s]",
        over=r"$s_{1,2} = -\omega_n (\zeta \mp \sqrt{\zeta^2 - 1})$",
        critical=r"$s = -\omega_n = -\val{omega}$ 1/s, twice",
        **dict.fromkeys(("rest", "plain", "glide", "drift"), ""),
    ),
    either(
        "kind",
        under=r"$\delta = \ln \dfrac{x_1}{x_2} = \zeta \omega_n \tau_d = \val{delta}$",
        over=r"$s_1 s_2 = \omega_n^2 = \val{square}$ 1/s²",
        **dict.fromkeys(("rest", "plain", "glide", "drift", "critical"), ""),
    ),
)
NATURAL: Paragraph = either(
    "spring", shown=r"$\omega_n = \sqrt{\dfrac{k}{m}} = \val{omega}$ rad/s", none=r"$\omega_n = 0$ without a spring"
)
SENTENCE = either(
    "said",
    swing="Each swing keeps {keep} of its size and {keep_energy} of its energy, and takes {longer} longer "
    "than undamped.",
    hardly="It hardly swings: each turn reaches {half} of the one before.",
    plain="Nothing is lost: every swing is as large as the last.",
    thrice="Within 1 % of its start after {home} s and never past 0; with three times the damping after {home_3} s.",
    home="Within 1 % of its start after {home} s and never past 0.",
    crosses="It passes 0 once, at {zero} s, because it was thrown faster than {crossing} m/s; let go, it never would.",
    never="It never passes 0 again.",
    rest="It rests: there is nothing to lose.",
    glide="No spring: it glides to rest {glide} m further on.",
    drift="No spring and no dashpot: it keeps its velocity.",
    still="No spring, and a start at rest: nothing moves.",
)
"""What becomes of the motion, in one sentence."""


def percent(share: float) -> str:
    return f"{short(100 * share)} %"


def values(case: DampedCase, axes: dict[str, Axis]) -> dict[str, str]:
    one, (slow, fast) = case.oscillator, case.oscillator.rates
    x = one.fading(case.x_0, case.v_0)[0]
    delta = one.log_decrement
    tau_ratio = one.zeta**2 / (math.sqrt(1 - one.zeta**2) * (1 + math.sqrt(1 - one.zeta**2))) if one.zeta < 1 else 0.0
    phase = one.decays(case.x_0, case.v_0)[0].phase if case.swings else 0.0
    return {
        "x_unit": axes["x"].full_unit,
        "E_unit": axes["E"].full_unit,
        "P_unit": axes["P"].full_unit,
        "E_total": axes["E"].number(case.E_0),
        "omega": three(one.omega_n),
        "square": three(one.k / one.m),
        "zeta": three(one.zeta) if one.k else "none",
        "rate": three(fast),
        "omega_d": three(one.omega_d),
        "a": three(slow),
        "slow": three(-slow),
        "fast": three(-fast),
        "C": three(case.envelope),
        "phi": plus(phase),
        "A": signed(x.late[0]) if case.kind == "over" else three(case.x_0),
        "B": plus(x.late[1]) if case.kind == "over" else plus(x.rate),
        "x_0": three(case.x_0),
        "v_0": plus(case.v_0),
        "delta": three(delta) if delta < math.inf else "∞",
        "keep": percent(math.exp(-delta)),
        "keep_x": f"× {three(math.exp(-delta))}",
        "keep_energy": percent(math.exp(-2 * delta)),
        "half": percent(math.exp(-delta / 2)),
        "longer": percent(tau_ratio),
        "tau_d": three(2 * math.pi / one.omega_d) if one.omega_d else "",
        **_later(case),
    }


def _later(case: DampedCase) -> dict[str, str]:
    """When it is home, and where it passes 0, as far as that is said."""
    one, said = case.oscillator, sentence(case)
    texts = dict.fromkeys(("home", "home_3", "zero", "crossing", "glide"), "")
    if said in ("home", "thrice"):
        texts["home"] = three(case.motion.settled(HOME) or 0.0)
    if said == "thrice":
        heavier = DampedOscillator(m=one.m, c=scaled(0, 3.0, one.c), k=one.k)
        texts["home_3"] = three(FreeDecay(oscillator=heavier, x_0=case.x_0, v_0=0.0).settled(HOME) or 0.0)
    if said == "crosses":
        texts |= {"zero": three(case.motion.first_zero or 0.0), "crossing": three(case.crossing_speed)}
    if said == "glide":
        texts["glide"] = three(scaled(0, abs(case.v_0), 1 / one.rates[1]))
    return texts


def sentence(case: DampedCase) -> str:
    """The form of SENTENCE that holds."""
    if case.kind in ("glide", "drift"):
        return case.kind if case.v_0 else "still"
    if case.kind == "under":
        return "swing" if case.oscillator.zeta < HARDLY else "hardly"
    if case.kind not in ("critical", "over"):
        return case.kind
    if not case.x_0:
        return "never"
    if case.v_0 * case.x_0 < 0 and case.motion.first_zero is not None:
        return "crosses"
    return "thrice" if case.kind == "critical" and not case.v_0 else "home"


def forms(case: DampedCase) -> dict[str, str]:
    one, kind = case.oscillator, case.kind
    x = "parts" if parts_shown(case) else "sum" if kind == "over" else kind
    fastest = "at_start" if not case.top.t else "before" if one.zeta < AT_ONCE and one.k else "fastest"
    return {
        "kind": kind,
        "spring": "shown" if one.k else "none",
        "said": sentence(case),
        "x": x,
        "upper": "formula" if kind == "under" else "",
        "slow": "formula" if x == "parts" else "",
        "fast": "formula" if x == "parts" else "",
        "heat": "formula" if one.c else "",
        "power": "shown" if one.c else "",
        "fastest": fastest if one.c and case.P_max else "",
        "roots": "bare" if not one.k else "wall" if not one.c else "critical" if kind == "critical" else (
            "pair" if one.zeta < 1 else "real"
        ),
    }  # fmt: skip


def notes(case: DampedCase, t: Floats) -> tuple[str, ...]:
    if drawable(2 * case.oscillator.omega_d, t):
        return ()
    return ("The energies and the power change too fast to be drawn in this window: they are averages over a swing.",)


ROOTS = {
    "pair": r"s = \tint{T}{-\val{a}} \pm \tint{m1}{\val{omega_d}\, i} \text{ 1/s}",
    "wall": r"s = \pm \val{omega}\, i \text{ 1/s}",
    "critical": r"s = -\val{omega} \text{ 1/s, twice}",
    "real": r"s = \val{slow},\; \val{fast} \text{ 1/s}",
    "bare": r"s = 0,\; \val{fast} \text{ 1/s}",
}
"""The roots of m s^2 + c s + k, as they stand over their plane."""
