"""Views beyond the race over 50 periods: other lengths, doubles against 80 digits, and stability."""

from __future__ import annotations

import math
from functools import cache, lru_cache

import numpy as np

from components.language.blocks import Block
from components.language.numbers import var
from components.language.plots import Mark
from components.layout.plots import Room, curve, plot
from components.layout.sheet import column, phrase, row, when, words
from components.layout.stage import on_x, text
from components.quantities.axes import Axis, log_axis, nice_axis
from components.scene.traces import Columns
from components.scenes.accuracy.data import done
from components.scenes.accuracy.plots import LOOK
from components.scenes.accuracy.prices import power, time_text
from components.scenes.accuracy.recorded import digits, recorded
from physics.accuracy import MARKS
from physics.coupled import TwoMassChain
from physics.integrators import FIXED_STEP
from physics.price import LEAST
from physics.solvers import METHODS
from physics.stability import amplification, stability_limit, stable_steps

REACH, LOW, TOP = 3.2, 0.4, 3.0
"""The reach of the plot of the amplification in h omega, and its ends downward and upward."""
ALIKE = {
    "euler": "Explicit Euler",
    "verlet": "Verlet, semi-implicit Euler",
    "yoshida4": "Yoshida 4",
    "yoshida6": "Yoshida 6",
    "rk4": "RK4",
    "nystrom4": "Nyström 4",
    "nystrom6": "Nyström 6",
    "midpoint": "Midpoint, Newmark, Gauss 4",
}
"""Methods that treat an oscillation alike in a step share a line, under the name of the first."""
LASTING = (
    "closed", "eigh", "expm", "verlet", "newmark", "rk4", "gauss4", "nystrom6", "yoshida6", "rk45", "dop853", "lsoda",
)  # fmt: skip
WITHOUT = ("closed", "eigh", "naive", "slides")
SWEEPS = {
    "ratio": "Springs far apart, $k_2/k_1$",
    "detuning": "Near resonance, $\\omega/\\omega_- - 1$",
    "periods": "Long runs, slow periods",
}
AGAINST = {
    "ratio": "k2/k1",
    "detuning": "omega/omega_minus - 1",
    "periods": "the length of the run in slow periods",
}
"""The axes of SWEEPS in words."""


def length_view() -> Block:
    """Run time and error against the length of the run."""
    told = words(
        "Benign, 100 outputs, in Python; with fixed steps 2,800 evaluations a slow period for each, else rtol 10⁻⁶. "
        "Recorded {length_origin}. "
        "The formula is flat, stepping grows with the length, and so does the error of its phase.",
        style="plain",
        phone=9,
    )
    plots = [_length_plot("span_time", "Run time"), _length_plot("span_error", "Largest error of the motion")]
    return when("length", column(told, *plots))


def _length_plot(of: str, title: str) -> Block:
    curves = tuple(
        curve(
            of,
            source=f"length_{slug}",
            x="span",
            label=METHODS[slug].mark,
            tint=LOOK[METHODS[slug].family]["tint"],
            width="dash" if METHODS[slug].family == "fixed" else "line",
        )
        for slug in LASTING
    )
    return plot(
        of,
        x="span",
        y=of,
        title=f"{title} against the length of the run in slow periods",
        curves=curves,
        x_column="span",
        heading=(phrase("", "none", "ink", formula=f"**{title}**, against the length of the run"),),
        room=Room(60, 140),
        phone=10,
        height=300,
    )


@cache
def length_columns() -> dict[str, Columns]:
    known, columns = recorded("length").runs, {}
    for slug in LASTING:
        spans = [run.setting for run in done(known.by_method[slug])]
        points = known.points[slug]
        columns[f"length_{slug}"] = {
            "span": np.array(spans, dtype=float),
            "span_time": points["time"],
            "span_error": points["error"],
        }
    return columns


def digits_view() -> Block:
    """The view of where doubles begin to fail."""
    told = words(
        "Thick: the closed form. Line: modes by eigh, dashed: the same, naive, thin: the slides' formulas. Doubles do "
        "for an error of {wanted} up to {digits_ratio} and {digits_periods}; near resonance always, if no difference "
        "cancels. 80 digits take {digits_cost}.",
        style="plain",
        phone=9,
    )
    return when("digits", column(told, row(*(_digits_plot(sweep, title) for sweep, title in SWEEPS.items()))))


def _digits_plot(sweep: str, title: str) -> Block:
    curves = tuple(
        curve(
            slug,
            source=f"digits_{sweep}_{slug}",
            x="place",
            tint=_ink(slug),
            width={"closed": "sum", "eigh": "line", "naive": "dash", "slides": "thin"}[slug],
            group=slug,
        )
        for slug in WITHOUT
    )
    return plot(
        f"digits_{sweep}",
        x=f"place_{sweep}",
        y="span_error",
        title=f"Largest error against {AGAINST[sweep]}",
        curves=curves,
        x_column="place",
        heading=(phrase("", "none", "ink", formula=f"**{title}**"),),
        marks=(Mark(at="wanted_at", tint="mute", label="accepted error", axis="y", style="dashed"),),
        room=Room(54, 12),
        phone=10,
        height=300,
    )


def _ink(slug: str) -> str:
    return "mute" if slug == "slides" else "ink"


@cache
def digits_columns() -> dict[str, Columns]:
    columns = {}
    for sweep in SWEEPS:
        found = digits()[sweep]
        for slug in WITHOUT:
            pairs = [(x, max(e, LEAST)) for x, e in zip(found["x"], found[slug], strict=True) if e is not None]
            places, errors = np.array(sorted(pairs), dtype=float).T
            columns[f"digits_{sweep}_{slug}"] = {"place": places, slug: errors}
    return columns


def digits_texts(wanted: float) -> dict[str, str]:
    """Texts on the reach of doubles and the cost of more digits."""
    costs = {each["motion"]: each for each in digits()["costs"]}
    free = costs["free"]
    alone, whole, eigh = (time_text(free[name] / 1e3) for name in ("digits", "closed", "eigh"))
    ratio, periods = _last_good("ratio", wanted), _last_good("periods", wanted)
    return {
        "digits_cost": f"{alone} of its {whole}, where eigh takes {eigh}",
        "digits_ratio": f"k₂/k₁ = {power(ratio)}" if ratio else "no k₂/k₁",
        "digits_periods": f"{power(periods)} periods" if periods else "no period",
    }


def _last_good(sweep: str, wanted: float) -> float | None:
    """The last place before eigh's error is too large."""
    found, last = digits()[sweep], None
    for place, error in zip(found["x"], found["eigh"], strict=True):
        if error is None or error > wanted:
            break
        last = float(place)
    return last


def stability_view() -> Block:
    """Amplification a step, and how many steps stability asks for."""
    return when("stability", column(_stability_plot(), _steps_plot()))


@cache
def stability() -> Columns:
    """Amplification a step against h omega, for each kind of method with fixed steps."""
    z = np.linspace(0.005, REACH, 240)
    return {"h_omega": z, **{slug: amplification(slug, z) for slug in ALIKE}}


def leaves(columns: Columns, slug: str) -> float:
    """Where the amplification of a method leaves the frame for good; the end of the frame where it stays."""
    inside = columns["h_omega"][columns[slug] <= TOP]
    return float(inside.max())


def _stability_plot() -> Block:
    columns = stability()
    # A line that leaves the frame at its top has its name where it leaves.
    names = tuple(
        text(
            on_x("stability", leaves(columns, slug)),
            var("stability.top"),
            name,
            anchor="beside",
            tint=_tint(slug),
            style="t1 halo",
        )
        for slug, name in ALIKE.items()
        if leaves(columns, slug) < REACH
    )
    curves = tuple(
        curve(
            slug,
            source="stability",
            x="h_omega",
            tint=_tint(slug),
            width="sum" if slug == "verlet" else "dash" if slug == "midpoint" else "line",
            label="" if leaves(columns, slug) < REACH else name,
        )
        for slug, name in ALIKE.items()
    )
    return plot(
        "stability",
        x="h_omega",
        y="growth",
        title="Growth of an oscillation in one step, against step times angular frequency",
        curves=curves,
        x_column="h_omega",
        heading=(phrase("", "none", "ink", formula="**Growth a step**, against $h\\,\\omega_+$: above 1 it explodes"),),
        marks=(Mark(at="step_at", html="picked", label="Step of the picked run", lift=32),),
        shapes=names,
        room=Room(44, 190, top=36),
        phone=10,
        height=260,
    )


def _tint(slug: str) -> str:
    return "ink" if slug == "verlet" else "mute"


BOUNDED = tuple(slug for slug in FIXED_STEP if 0 < stability_limit(slug) < math.inf)


@lru_cache(maxsize=16)
def step_explosion(chain: TwoMassChain) -> Columns:
    """Steps in a slow period that a method with a limit needs to stay stable, as k2/k1 grows with all else kept."""
    ratios = np.geomspace(1.0, 1e12, 25)
    k1 = chain.k1 or 1.0
    chains = [TwoMassChain(m1=chain.m1, m2=chain.m2, k1=k1, k2=k1 * ratio) for ratio in ratios]
    return {
        "ratio": ratios,
        **{f"steps_{slug}": np.array([stable_steps(slug, each) for each in chains]) for slug in BOUNDED},
    }


def _steps_plot() -> Block:
    return plot(
        "explosion",
        x="ratio",
        y="steps",
        title="Steps in a slow period that stability requires, against k2/k1",
        curves=tuple(
            curve(f"steps_{slug}", source="explosion", x="ratio", width="line", label=ALIKE[slug])
            for slug in BOUNDED
            if slug in ALIKE
        ),
        x_column="ratio",
        heading=(
            phrase("", "none", "ink", formula="**Steps in a slow period** that stability requires, against $k_2/k_1$"),
        ),
        room=Room(54, 190),
        phone=11,
        height=220,
    )


@cache
def study_axes(unit: str) -> dict[str, Axis]:
    """The axes of all that is not the work plot; `unit` is what periods are counted in."""
    return {
        "period": nice_axis(0.0, float(MARKS[-1]), unit, 5, exact=True),
        "span": log_axis(5.0, 500.0, "slow periods"),
        "span_time": log_axis(3e-5, 30.0, "s"),
        "span_error": log_axis(1e-17, 10.0, ""),
        "place_ratio": log_axis(1.0, 1e16, ""),
        "place_detuning": log_axis(1e-15, 0.1, ""),
        "place_periods": log_axis(1.0, 1e12, ""),
        "h_omega": nice_axis(0.0, REACH, "", 6, exact=True),
        "growth": nice_axis(LOW, TOP, "", 4, exact=True),
        "ratio": log_axis(1.0, 1e12, ""),
        "steps": log_axis(1.0, 1e8, ""),
    }
