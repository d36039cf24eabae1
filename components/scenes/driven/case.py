"""The case of a driven mass: its drive, its steady part, its transient, and what the paper shows."""

from __future__ import annotations

import cmath
import math
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from msgspec.structs import replace

from components.language.picture import Pace
from components.quantities.axes import Axis, log_axis, nice_axis
from components.quantities.motion import pace, scaled
from components.scene import Picture
from components.scene.about import About, Place, bands_among, bounded, few_of, points
from components.scene.case_curves import BandColumns
from components.scene.traces import BAND, RINGING, Columns
from components.scenes.driven.slices import SlicedCase
from physics.bode import ResponsePeak, magnification_peak
from physics.driven import Drive, lag
from physics.forced_vibration import SampledVibration
from physics.magnification import half_power, highest, magnification, ratios
from physics.pushed_vibration import PushedVibration
from physics.reference.damped import driven_points, response_points
from physics.reference.pushed import pushed_points
from physics.sampling import periods

KINDS: tuple[Drive, ...] = ("force", "base", "unbalance")
SWINGS, LONG = 6, 12
"""Natural periods in a time window; the second value is for motions that decay very slowly."""
HARDLY = 0.02
"""Damping ratio up to which a motion counts as decaying very slowly."""
ALIKE = 0.02
"""In rad. Without damping, a drive counts as resonant if its phase stays within this of the free motion's over the
window."""
END = 2.5
"""The end of the axis of the frequency ratio r, unless the drive is faster."""
DECADE = 10.0
"""The reach of log axes to each side of r = 1, unless the drive is beyond it."""
LEAST, USUAL, TALLEST = 1.4, 2.75, 8.8
"""Upper end of the response axis: the smallest, the one if there is no finite peak, the largest."""
# The polygon of the forces.
ASIDE = 0.09
"""Distance between arrows that would overlap, relative to the arrow of the push."""
LEFT, RIGHT = 0.7, 0.6
"""Width of the polygon to each side, relative to the height of the response plot; a wider one is drawn smaller."""
NARROWEST, ASIDE_OF_X = 0.6, 0.5
"""A smaller lag, in rad, leaves no room for its name. The name is then on the other side of the arrow, at this
distance."""
GROWN = 0.8
"""Length of forces that grow without limit, relative to the height of the response plot."""
FILLED = 0.9
"""Share of the stage's height that the polygon fills, if it is alone on its stage."""
APART_NOTE = "The steady and the complementary part are far larger than their sum here, so they are not drawn."
RINGS_NOTE = "At first x rings too fast to be drawn as a line in this window: it stays within the band."
BAND_NOTE = "The motion is too fast to be drawn as a line in this window: the band is what it stays within."
BASE_NOTE = "The base moves too fast to be drawn as a line in this window: it stays within its band."


class Polygon(NamedTuple):
    """The polygon of the forces in units of the push, on the scale of the response, and where its names are.

    From the tail the first arrow goes `up`, that of the dashpot `across`, the third one down to `end`, where the push
    ends too. It reaches `below` the tail; `height` is that of its stage.
    """

    closed: bool = False
    growing: bool = False
    idle: bool = False
    level: bool = False
    braked: bool = False
    y_braked: bool = False
    lags: bool = False
    up: float = 0.0
    across: float = 0.0
    aside: float = 0.0
    end: float = 0.0
    scale: float = 1.0
    y_side: float = 0.0
    y_up: float = 0.0
    phi_side: float = 0.0
    phi_up: float = 0.0
    from_X: float = 0.0
    to_F: float = 0.0
    below: float = 0.0
    height: float = 1.0

    @property
    def push(self) -> float:
        """The length of the push's arrow, relative to the stage's height."""
        return FILLED / self.height


class DrivenCase(SlicedCase):
    """A driven motion of a mass on a spring and a dashpot."""

    view: str
    axes: str

    @property
    def shaken(self) -> bool:
        """True if the base moves."""
        return self.kind == "base" and self.is_driven

    @property
    def zeta(self) -> float:
        return self.one.zeta

    @cached_property
    def r(self) -> float:
        return scaled(0, self.omega, 1 / self.one.omega_n)

    @cached_property
    def ratio(self) -> complex:
        """The complex amplitude X divided by F_0/k, by Y, or by m_0 e/m, depending on the kind of drive."""
        return complex(magnification(self.r, self.zeta, self.kind)[0])

    @property
    def M(self) -> float:
        """The magnification."""
        return abs(self.ratio)

    @cached_property
    def lag(self) -> float:
        """The angle in rad by which x lags the drive."""
        return lag(self.ratio)

    @cached_property
    def lasting(self) -> float:
        repeats = self.is_driven and not self.is_once
        slow = min(self.one.omega_n, 2.5 * self.omega) if repeats else self.one.omega_n
        return periods(slow, LONG if self.zeta < HARDLY else SWINGS)

    @property
    def highest(self) -> float:
        return self.one.omega_d if self.is_once else self.vibration.fastest

    @property
    def pace(self) -> Pace:
        omega_n = self.one.omega_n
        omega = omega_n if self.is_once else self.omega or omega_n
        return pace(min(omega_n, omega), max(omega_n, omega))

    @property
    def spans(self) -> dict[str, tuple[float, float]]:
        return {"omega": (0.0, END * self.one.omega_n)}

    # Axes.

    @property
    def ratio_axis(self) -> Axis:
        """The axis of the drive frequency in units of the natural frequency (r)."""
        end, omega_n = max(END, float(f"{1.1 * self.r:.2g}")), self.one.omega_n
        if self.is_log:
            low = min(1 / DECADE, self.r or 1.0) * omega_n
            axis = log_axis(low, max(DECADE, end) * omega_n, factor=omega_n)
        else:
            axis = nice_axis(0.0, end * omega_n, "", 5, exact=True, factor=omega_n)
        return replace(axis, drawn=(axis.start, max(1.2, self.r) * omega_n), si="rad/s")

    @property
    def response_axis(self) -> Axis:
        """The axis of the magnification: on a log axis down to a decade below the ends."""
        if self.is_log:
            top = 10.0 ** math.ceil(math.log10(1.2 * self.top_mark.height) if self.top_mark else 2.0)
            return log_axis(DECADE ** (-3 if self.view == "harmonics" else -2), top)
        return replace(nice_axis(0.0, self.top, "", 3, exact=True), drawn=(0.0, self.top / 1.1))

    @property
    def drive_axis(self) -> Axis:
        unit = {"force": "N s" if self.is_impulsive else "N", "base": "m", "unbalance": "kg m"}[self.kind]
        return nice_axis(0.0, 1.25 * (self.amount or 1.0), unit, exact=True)

    # Resonance.

    @property
    def is_log(self) -> bool:
        """True if the response has log axes: never next to the polygon of the forces, which is on its scale."""
        return self.view == "harmonics" or (self.axes == "log" and self.view == "response")

    @cached_property
    def top_mark(self) -> ResponsePeak | None:
        """The peak of the magnification, if it is marked."""
        return magnification_peak(self.vibration.oscillator, self.kind) if self.is_log else None

    @cached_property
    def resonant(self) -> bool:
        """True if there is no steady part: at resonance without a dashpot."""
        return self.vibration.oscillator.at_resonance(self.omega)

    @cached_property
    def grows(self) -> bool:
        """True if there is no dashpot and the drive is at resonance, as far as the time window can show."""
        return not self.c and (self.resonant or abs(self.vibration.push.detuning) * self.end < ALIKE)

    @property
    def swells(self) -> bool:
        """True if the motion grows under a sinusoidal drive."""
        return self.grows and self.is_driven and self.is_sine

    @property
    def settles(self) -> bool:
        """True if the steady part has a finite amplitude."""
        return not self.grows and not self.is_once and math.isfinite(self.M)

    @property
    def steady(self) -> bool:
        """True if there is a steady part that is a sine."""
        return self.is_driven and self.settles and self.is_sine

    @property
    def has_dial(self) -> bool:
        """True if the stage has the dial of the lag."""
        return self.steady and self.view in ("response", "forces")

    def worded(self, word: str) -> str:
        """Return the name of a heading: in the view of formulas the variant with a formula, else the one in words."""
        return f"{word}_formula" if word and self.view == "formulas" else word

    @cached_property
    def half_power(self) -> tuple[float, float] | None:
        """The two drive frequencies in rad/s at which the dashpot takes half of its largest power, if they are
        drawn."""
        if (self.is_log and self.view == "response") or self.kind != "force" or not 0.02 < self.zeta < 0.6:
            return None
        below, above = half_power(self.zeta)
        return below * self.one.omega_n, above * self.one.omega_n

    @property
    def top(self) -> float:
        """The upper end of the axis of the response."""
        peak = highest(self.zeta, self.kind)
        if peak and math.isinf(peak[1]):
            return USUAL
        return min(max(1.1 * (peak[1] if peak else 1.0), LEAST), TALLEST)

    def response(self, r: Axis, side: Literal["below", "above"]) -> Columns:
        """Return columns of omega, the response, the lag and the power lost. Without damping there is one table below
        the resonance and one above it.

        The peak of the drawn power is Q, the value of the response at r = 1.
        """
        zeta = self.zeta
        ratio = ratios(zeta, r.start / r.factor, r.end / r.factor, r.log)
        if not zeta:
            ratio = ratio[ratio < 1 if side == "below" else ratio > 1]
        elif side == "above":
            return {}
        X = magnification(ratio, zeta, self.kind)
        lags = np.array([lag(one) if cmath.isfinite(one) else math.pi / 2 for one in X.tolist()])
        power = {"power": 2 * zeta * (ratio * np.abs(X)) ** 2} if self.half_power else {}
        return {"omega": ratio * self.one.omega_n, "M": np.abs(X), "lag": lags, **power}

    # Quantities that are drawn against time.

    @cached_property
    def sampled(self) -> SampledVibration | PushedVibration:
        if isinstance(self.moved, PushedVibration):
            return self.moved
        return SampledVibration(vibration=self.vibration, t=self.times, is_split=not self.grows)

    @property
    def split(self) -> bool:
        """True if the steady part and the transient are drawn too. After a single impulse there is only one part."""
        return self.sampled.split and self.shape != "impulse"

    @property
    def tallest(self) -> float:
        """The largest displacement that is drawn, of the mass or of its base, in m; 1 if nothing moves."""
        return self.sampled.tallest

    @property
    def sum_reach(self) -> float:
        """The largest displacement in m, of the motion and of the sum of the responses to slices."""
        return max(self.tallest, self.sliced.reach if self.sliced else 0.0)

    @cached_property
    def bands(self) -> dict[str, BandColumns]:
        return {name: BandColumns(*band) for name, band in self.sampled.bands.items()}

    def notes(self) -> tuple[str, ...]:
        rings, is_band = self.sampled.rings, "x" in self.bands
        grows = bool(self.harmonics and self.harmonics.resonant)
        found = {
            APART_NOTE: self.is_driven
            and not self.sampled.split
            and not (self.grows if self.is_sine else is_band or grows),
            RINGS_NOTE: rings,
            BAND_NOTE: is_band and not rings,
            BASE_NOTE: self.shaken and "y" in self.bands,
        }
        return tuple(note for note, holds in found.items() if holds)

    # The polygon of the forces.

    def polygon(self, top: float) -> Polygon:
        """Return the polygon next to an axis of the response that ends at `top`."""
        if self.swells:
            return Polygon(growing=True, up=GROWN * top, below=1.0, height=top + 1.0)
        if not self.steady:
            return Polygon(idle=not self.is_driven, below=1.0, height=top + 1.0)
        turned, way = self.kind == "unbalance", 1.0 if self.kind == "unbalance" else -1.0
        size, across = self.M, 2 * self.zeta * self.r
        spring, inertia = size, self.r * self.r * size
        if turned:
            spring, inertia, across = size / (self.r * self.r), size, across / (self.r * self.r)
        first, third = (inertia, spring) if turned else (spring, inertia)
        side = way * across * size
        scale = min(1.0, 0.92 * top / max(first, third - first, side / RIGHT, -side / LEFT, 1.0))
        below = scale * max(1.0, third - first)
        middle = self.lag / 2 if self.lag > NARROWEST else -ASIDE_OF_X
        based, start = self.kind == "base", 0.0 if turned else math.pi
        return Polygon(
            closed=True, level=scale == 1.0, braked=abs(side) > ASIDE, y_braked=based and across > ASIDE,
            lags=self.lag > 0.15, up=first, across=side, end=first - third, scale=scale,
            aside=math.copysign(max(abs(side), ASIDE / scale), side),
            y_side=-math.sin(self.lag), y_up=math.cos(self.lag),
            phi_side=way * math.sin(middle), phi_up=-way * math.cos(middle), from_X=start, to_F=start + self.lag,
            below=below, height=top + below,
        )  # fmt: skip

    def about(self, shown: Picture) -> About | None:
        columns, sweep, one = shown.sources["time"], shown.sources["below"], self.vibration.oscillator
        response, x, t = {"M": "$|X|$ over its unit", "lag": r"$\phi$"}, {"x": "$x$"}, few_of(columns["t"])
        t = t if "x" in columns else []
        limit = 8 if self.pushed_by else 4
        if self.pushed_by:
            largest = float(np.abs(self.moved.from_rest(columns["t"])).max())
            true = pushed_points(self.one, self.pushed_by, self.x_0, self.v_0, largest, t)
        else:
            true = driven_points(one, self.omega, self.amount, self.kind, self.x_0, self.v_0, t)
        true_response = response_points(one, self.kind, few_of(sweep["omega"]))
        tables = (
            bounded("$x(t)$", limit, "the sum of the sizes of its parts", points(x, columns, true)),
            bounded(
                "the response and the lag", 16, "itself, as far as rounding $r$ allows",
                points(response, sweep, true_response, Place("omega", r"$\omega$", "rad/s")),
            ),
        )  # fmt: skip
        work = "The work put in and the work lost in a cycle are equal once the complementary part has decayed."
        bands = {BAND: shown.sources.get(BAND, {}) | shown.sources.get(RINGING, {})}
        return About(tables, work if self.c and self.is_driven and not self.is_once else "", bands_among(bands, x))


def outline(kind: Drive, zeta: float, of_phase: bool) -> str:
    """Return SVG path data for a background curve: x is r, y is minus |X|, or minus the lag."""
    r = np.concatenate([np.linspace(0, 0.9, 30), np.linspace(0.905, 1.1, 40), np.linspace(1.11, 2.5, 40)])
    X = magnification(r[r != 1], zeta, kind)
    up = np.array([lag(complex(one)) for one in X]) if of_phase else np.minimum(np.abs(X), 12.0)
    return "M" + "L".join(f"{a:.3f} {-b:.3f}" for a, b in zip(r[r != 1], up, strict=True))
