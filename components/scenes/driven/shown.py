"""The attributes that the paper of the driven mass shows: motions, numbers and words in texts, places on plots."""

from __future__ import annotations

import cmath
import math

from components.layout.stage import wire
from components.paper.deferred import Attributes
from components.quantities.formatting import three
from components.quantities.motion import scaled
from components.scenes.driven.case import DrivenCase
from physics.forced_vibration import rotating
from physics.magnification import past_half
from physics.motion import ExactMotion, Harmonic, constant, harmonic_motion

ALONE = 0.02
"""If the sum of spring force and inertia is below this share of the dashpot's force, the dashpot alone balances the
push."""
AT_ROOT = 1e-3
"""Within this distance of r from √2, the dashpot does not change the amplitude to three digits."""


def _size(case: DrivenCase) -> float:
    """The amplitude of the steady part in m."""
    return math.inf if case.resonant else abs(case.vibration.X)


def _growth(case: DrivenCase) -> float:
    """The growth from period to period of an undamped resonance, in m."""
    push = case.vibration.push
    return scaled(0, math.pi, math.hypot(push.re, push.im), 1 / case.omega, 1 / case.omega)


def _rate(case: DrivenCase) -> float:
    """The growth of an undamped resonance in m/s."""
    return _growth(case) * case.omega / (2 * math.pi)


def _part(case: DrivenCase) -> str:
    """Return whether the transient "dies" or "stays"; "" if it is not drawn."""
    return "" if not case.split else "dies" if case.c else "stays"


def _work(case: DrivenCase) -> float:
    """Return the work of the drive in a cycle of the steady motion in J. The dashpot takes all of it."""
    stroke = abs(case.vibration.X - (case.amount if case.kind == "base" else 0.0))
    return scaled(0, math.pi, case.c, case.omega, stroke, stroke)


def _hand(symbol: str, case: DrivenCase, ahead: float) -> ExactMotion | None:
    """Return the sine of the phase of the steady part, plus `ahead` in rad."""
    return rotating(symbol, cmath.rect(1.0, ahead - case.lag), case.omega) if case.has_dial else None


def _count(number: int) -> str:
    """Return the number of a harmonic: all digits of less than a million."""
    return str(number) if number < 1e6 else three(number)


def _line(rate: float) -> ExactMotion:
    return harmonic_motion("line", Harmonic((), (0.0, rate)), lambda t: rate * t)


def _holds(case: DrivenCase) -> str:
    """Return the name of the sentence on which force balances the push."""
    if not case.is_driven:
        return "idle" if case.omega else "still"
    if not case.is_sine:
        return "once" if case.is_once else "others"
    if case.grows:
        return ("grows" if case.resonant else "nearly") + ("_on" if case.x_0 or case.v_0 else "")
    r, zeta = case.r, case.zeta
    if not zeta and not math.isfinite(case.M):
        return "near"
    if case.kind == "base":
        if abs(r - math.sqrt(2.0)) < AT_ROOT and three(case.M) == "1.00":
            return "alike"
        return "more" if r < math.sqrt(2.0) else "less" if zeta else "isolated"
    left, dashpot = abs((1 - r) * (1 + r)), 2 * zeta * r
    if dashpot < left:
        return "spring" if r < 1 else "inertia"
    return "alone" if left < ALONE * min(dashpot, 1.0) else "dashpot"


value = Attributes(DrivenCase)


class DrivenShown(DrivenCase):
    """Everything that the paper shows. Motions come first: their order is that of the columns in a file."""

    x = value(lambda c: c.moved.x)
    x_c = value.optional(lambda c: c.moved.transient.x if c.split else None)
    y = value.optional(lambda c: c.vibration.drive if c.shaken else None)
    base = value(lambda c: c.vibration.drive if c.shaken else constant(0.0))
    x_p = value.optional(lambda c: c.moved.x_p if c.split and not c.shaken else None)
    upper = value.optional(lambda c: _line(_rate(c)) if c.swells else None)
    lower = -upper
    F = value(lambda c: c.seen_push)
    F_over_k = value.optional(lambda c: c.moved.drive / c.k if c.pushed_by and not c.is_impulsive else None)
    x_sliced = value.optional(lambda c: c.sliced.x if c.sliced else None)
    push_F = value.optional(lambda c: c.moved.drive if c.in_slices and not c.is_impulsive else None)
    sine = value(lambda c: rotating("sine", 1.0, c.omega))
    cosine = value(lambda c: rotating("cosine", 1j, c.omega))
    turn = value(lambda c: _line(c.omega))
    mass_sine = value.optional(lambda c: _hand("mass_sine", c, 0.0))
    mass_cosine = value.optional(lambda c: _hand("mass_cosine", c, math.pi / 2))
    # Numbers in formulas and sentences.
    X = value.optional(lambda c: _size(c) if c.is_driven and c.is_sine else None, "m", "size")
    phi = value.optional(lambda c: c.lag if c.is_driven and c.is_sine else None, "rad", "lag behind the drive")
    phi_minus = value(lambda c: -c.lag)
    Q = value(lambda c: 0.5 / c.zeta if c.zeta else math.inf, "", "quality factor")
    bandwidth = value(
        lambda c: 2 * c.zeta * c.one.omega_n, "rad/s", "width of the response at half the power", called="width"
    )
    lag_degrees = value.optional(lambda c: f"{math.degrees(c.lag):.0f}°" if c.has_dial else None)
    drive_name = value(lambda c: "push" if c.kind == "force" else c.kind)
    W = value.optional(lambda c: _work(c) if c.steady else None, "J", "work of the drive per period")
    growth = value.optional(lambda c: _growth(c) if c.is_driven and c.is_sine else None, "m", "growth per period")
    rate = value.optional(lambda c: _rate(c) if c.is_driven and c.is_sine else None, "m/s", "growth per second")
    decay = value(lambda c: c.one.rates[0], "1/s", "decay rate of the transient")
    P_in = value.optional(lambda c: float(c.power["P_in"][-1]) if c.power else None, "W", "mean power of the drive")
    P_lost = value.optional(lambda c: float(c.power["P_lost"][-1]) if c.power else None, "W", "mean power lost")
    # Which formulas and words are shown.
    size = value(lambda c: ("grows" if c.resonant else "nearly") if c.swells else c.kind)
    law = value(lambda c: "push" if c.pushed_by else c.kind)
    no_powers = value(lambda c: "once" if c.is_driven and c.is_once else "")
    quality = value(lambda c: c.kind if c.kind != "base" and c.zeta else "")
    work = value(lambda c: ("base" if c.shaken else "push") if c.steady and c.c else "")
    holds = value(_holds)
    part = value(lambda c: c.worded(_part(c)))
    steady_part = value(lambda c: "" if c.shaken else c.worded(_part(c)) if c.is_sine else _part(c))
    base_form = value(lambda c: c.worded("name" if c.shaken else ""))
    growing = value(lambda c: c.worded(("always" if c.resonant else "first") if c.swells else ""))
    is_peaked = value(lambda c: bool(c.half_power) and not c.is_log)
    is_flat = value(lambda c: not (c.half_power or c.is_log))
    outlined = value(lambda c: "" if c.is_log else c.kind)
    has_power = value(lambda c: bool(c.power))
    # Positions on the stage and on the response. Dragging the line at r = 1 sets zeta to `half` divided by its height.
    side = value(lambda c: min(max(c.m**0.15, 0.75), 1.25))
    wire = value(lambda c: wire(c.k))
    stroke = value(lambda c: c.Y if c.kind == "base" else 0.0)
    omega_at = value.optional(lambda c: c.omega if not c.is_once and (c.omega or not c.is_log) else None)
    unity = value(lambda c: 1.0)
    root2 = value(lambda c: math.sqrt(2.0) * c.one.omega_n)
    M_at = value.optional(lambda c: c.M if c.settles else None)
    lag_at = value.optional(lambda c: c.lag if c.settles else None)
    half_low, half_high = value.pair(lambda c: c.half_power)
    half = value(lambda c: 0.5)
    peak = value(lambda c: 0.5 / c.zeta if c.half_power else 0.0)
    half_peak = value.optional(lambda c: 0.25 / c.zeta if c.half_power else None)
    beyond = value.optional(lambda c: past_half(c.zeta) * c.one.omega_n if c.half_power else None)
    peak_form = value(lambda c: bool(c.top_mark and c.top_mark.width))
    natural = value.optional(lambda c: c.one.omega_n if c.is_log else None)
    peak_at = value.optional(lambda c: c.top_mark and c.top_mark.omega)
    peak_up = value.optional(lambda c: c.top_mark and c.top_mark.height)
    peak_low, peak_high = value.pair(lambda c: c.top_mark and c.top_mark.ends)
    peak_half = value.optional(lambda c: c.top_mark and c.top_mark.height / math.sqrt(2))
    peak_width = value.optional(lambda c: c.top_mark and c.top_mark.width)
    # The harmonics of a push.
    offers_pushes = value(lambda c: c.kind == "force" and (c.view in ("harmonics", "convolution") or c.push != "sine"))
    has_force = value(lambda c: c.kind == "force" and not c.is_impulsive)
    repeats = value(lambda c: not c.is_once)
    on_peak = value.optional(lambda c: c.harmonics.on_peak or None if c.harmonics else None, "", "harmonic at the peak")
    strongest = value.optional(lambda c: c.harmonics.strongest[0] if c.harmonics else None, "", "strongest harmonic")
    n_peak = value.optional(lambda c: _count(c.harmonics.on_peak) if c.harmonics else None)
    n_strongest = value.optional(lambda c: _count(c.harmonics.strongest[0]) if c.harmonics else None)
    X_strongest = value.optional(lambda c: c.harmonics.strongest[1] if c.harmonics else None, "m", "size of its swing")
    harmonic_growth = value.optional(lambda c: c.harmonics.mass.growth if c.harmonics else None)
    meets = value(lambda c: c.met())
    strongest_at = value.optional(lambda c: c.harmonics.strongest[0] * c.omega if c.harmonics else None)
    first_line = value(lambda c: float(c.harmonics.lines([1]).f[0]) / c.mean_size if c.harmonics else 1.0)
    sine_at = value.optional(lambda c: c.M if c.settles and c.is_sine else None)
    # The rings of a push. Dragging the period's ring sets omega to `full_turn` divided by the share of the window.
    # `stretch` converts a push to m: the stretch of the spring, or the amplitude that an impulse causes.
    period_share = value.optional(lambda c: c.period_in_window)
    full_turn = value.optional(lambda c: None if c.period_in_window is None else 2 * math.pi / c.end)
    pulse_width = value.optional(lambda c: c.width if c.has_width and c.pushed_by else None)
    half_F = value.optional(lambda c: c.F_0 / 2 if c.has_width and c.pushed_by else None)
    F_high = value.optional(lambda c: c.F_0 if c.pushed_by and not c.is_impulsive else None)
    J_high = value.optional(lambda c: c.J if c.pushed_by and c.is_impulsive else None)
    stretch = value(lambda c: c.drive_axis.factor / (c.m * c.one.omega_n if c.is_impulsive else c.k))
    # The slices of a push.
    has_slices = value(lambda c: c.view == "convolution" and c.kind == "force" and not c.is_impulsive)
    misses = value.optional(
        lambda c: c.compared[0] if c.compared else None,
        "m",
        "largest distance of the sum of the slices from the motion",
    )
    slice_width = value.optional(
        lambda c: c.slice_share if c.sliced else None,
        "",
        "slice over a natural period",
    )
    sums = value(lambda c: c.summed())
    tail_form = value(lambda c: c.tail_words())
