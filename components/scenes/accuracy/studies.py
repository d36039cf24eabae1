"""Views beyond the race over 50 periods: other lengths, doubles against 80 digits, and stability."""

from __future__ import annotations

import math
from functools import cache, lru_cache

import numpy as np

from components.language.blocks import Block
from components.layout.plots import Room, curve, mark, plot
from components.layout.sheet import column, phrase, row, words
from components.layout.stage import PlotFrame, text
from components.quantities.declared import Column, Declared, DrawnAxis, by_name
from components.scene.traces import Columns
from components.scenes.accuracy.axes import REACH, TOP, Axes
from components.scenes.accuracy.case import AccuracyCase
from components.scenes.accuracy.data import growth
from components.scenes.accuracy.plots import LOOK, Places
from components.scenes.accuracy.prices import power, time_text
from components.scenes.accuracy.recorded import digits, recorded
from components.scenes.accuracy.words import Numbers as N
from components.scenes.accuracy.words import number
from physics.coupled import TwoMassChain
from physics.integrators.fixed_steps import FIXED_STEP
from physics.integrators.price import LEAST
from physics.integrators.solvers import METHODS
from physics.integrators.stability import amplification, stability_limit, stable_steps

ALIKE = {
    "euler": "Explicit Euler",
    "verlet": "Verlet, semi-implicit Euler",
    "yoshida4": "Yoshida 4",
    "yoshida6": "Yoshida 6",
    "rk4": "RK4",
    "nystrom4": "Nyström 4",
    "nystrom6": "Nyström 6",
    "midpoint": "Midpoint, Newmark, Gauss 4",
    "radau5": "Radau IIA 5",
    "alpha": "Generalized-α",
    "sdirk2": "SDIRK 2",
    "ieuler": "Implicit Euler",
}
"""Methods that treat an oscillation alike in a step share a line, under the name of the first."""
LASTING = (
    "closed", "eigh", "expm", "verlet", "newmark", "rk4", "gauss4", "nystrom6", "yoshida6", "rk45", "dop853", "lsoda",
)  # fmt: skip
WITHOUT = {"closed": "sum", "eigh": "line", "naive": "dash", "slides": "thin"}
"""The widths of the lines of what takes no steps."""
SWEEPS = {
    "ratio": ("Springs far apart, $k_2/k_1$", "k2/k1"),
    "detuning": ("Near resonance, $\\omega/\\omega_- - 1$", "omega/omega_minus - 1"),
    "periods": ("Long runs, slow periods", "the length of the run in slow periods"),
}
"""Titles of the sweeps, and their axes in words."""
BOUNDED = tuple(slug for slug in FIXED_STEP if 0 < stability_limit(slug) < math.inf)
STABILITY = PlotFrame("stability")


class Studied(Declared[object]):
    """Columns: of the growth in a step, of the steps that stability requires, and of the errors of doubles."""

    growth = Column[object].each(ALIKE, "{}", source="stability")
    steps = Column[object].each(BOUNDED, source="explosion")
    place = Column[object]("digits")
    error = Column[object].each(WITHOUT, "{}", source="digits")


def length_view() -> Block:
    """Run time and error against the length of the run."""
    told = words(
        "A longer motion takes a method in steps more time, and its error grows; the formula stays as it is.",
        "[mute|Benign, 100 outputs, in Python; with fixed steps 2,800 evaluations a slow period for each, else "
        f"rtol 10⁻⁶. Recorded {N.length_origin}.]",
        name="length",
        style="plain",
        phone=16,
    )
    plots = [_length_plot(Axes.span_time, "Run time"), _length_plot(Axes.span_error, "Largest error of the motion")]
    return column(told, *plots)


def _length_plot(of: DrawnAxis, title: str) -> Block:
    curves = tuple(
        curve(
            of,
            source=f"length_{slug}",
            label=METHODS[slug].mark,
            tint=LOOK[METHODS[slug].family]["tint"],
            width="dash" if METHODS[slug].family == "fixed" else "line",
        )
        for slug in LASTING
    )
    return plot(
        PlotFrame(of.name),
        x=Axes.span,
        y=of,
        title=f"{title} against the length of the run in slow periods",
        curves=curves,
        x_column=Axes.span,
        heading=(phrase("", "none", "ink", formula=f"**{title}**, against the length of the run"),),
        room=Room(60, 140),
        style="many",
        phone=10,
        height=300,
    )


@cache
def length_columns() -> dict[str, Columns]:
    known, columns = recorded("length").runs, {}
    for slug in LASTING:
        spans, points = [run.setting for run in known.good[slug]], known.points[slug]
        given = (np.array(spans, dtype=float), points[Axes.time.name], points[Axes.error.name])
        columns[f"length_{slug}"] = by_name(dict(zip((Axes.span, Axes.span_time, Axes.span_error), given, strict=True)))
    return columns


def digits_view() -> Block:
    """The view of where doubles begin to fail."""
    told = words(
        "A double has 16 digits; some of them are lost where numbers of different size meet.",
        "[mute|Thick: the closed form. Line: modes by eigh, dashed: the same, naive, thin: the slides' formulas. "
        f"Doubles do for an error of {N.wanted} up to {Digits.digits_ratio} and {Digits.digits_periods}; near "
        f"resonance always, if no difference cancels. 80 digits take {Digits.digits_cost}.]",
        name="digits",
        style="plain",
        phone=16,
    )
    return column(told, row(*map(_digits_plot, SWEEPS)))


def _digits_plot(sweep: str) -> Block:
    title, against = SWEEPS[sweep]
    curves = tuple(
        curve(
            Studied.error[slug],
            source=f"digits_{sweep}_{slug}",
            tint="mute" if slug == "slides" else "ink",
            width=width,
        )
        for slug, width in WITHOUT.items()
    )
    return plot(
        PlotFrame(f"digits_{sweep}"),
        x=Axes.place[sweep],
        y=Axes.span_error,
        title=f"Largest error against {against}",
        curves=curves,
        x_column=Studied.place,
        heading=(phrase("", "none", "ink", formula=f"**{title}**"),),
        marks=(mark(Places.wanted_at, tint="mute", label="accepted error", axis="y", style="dashed"),),
        room=Room(54, 12),
        phone=10 if sweep == "ratio" else 17,
        height=300,
    )


@cache
def digits_columns() -> dict[str, Columns]:
    columns = {}
    for sweep in SWEEPS:
        found = digits()[sweep]
        for slug in WITHOUT:
            pairs = [(x, max(e, LEAST)) for x, e in zip(found["x"], found[slug], strict=True) if e is not None]
            places, errors = np.array(sorted(pairs), dtype=float).T
            columns[f"digits_{sweep}_{slug}"] = by_name({Studied.place: places, Studied.error[slug]: errors})
    return columns


def _cost() -> str:
    """The cost of more digits."""
    (free,) = (each for each in digits()["costs"] if each["motion"] == "free")
    alone, whole, eigh = (time_text(free[name] / 1e3) for name in ("digits", "closed", "eigh"))
    return f"{alone} of its {whole}, where eigh takes {eigh}"


def _last_good(sweep: str, wanted: float) -> str:
    """The last place before eigh's error is too large."""
    found, last = digits()[sweep], ""
    for place, error in zip(found["x"], found["eigh"], strict=True):
        if error is None or error > wanted:
            break
        last = power(float(place))
    return last


class Digits(Declared[AccuracyCase]):
    digits_cost = number(lambda c: _cost())
    digits_ratio = number(lambda c: f"k₂/k₁ = {last}" if (last := _last_good("ratio", c.wanted)) else "no k₂/k₁")
    digits_periods = number(lambda c: f"{last} periods" if (last := _last_good("periods", c.wanted)) else "no period")


def stability_view() -> Block:
    """Amplification a step, and how many steps stability asks for."""
    told = words(
        "A step that is too long explodes. Above 1 an oscillation grows in every step; below 1, as with RK4 and "
        "implicit Euler, it loses energy.",
        name="stability",
        style="plain",
        phone=16,
    )
    return column(told, _stability_plot(), _steps_plot())


@cache
def stability() -> Columns:
    """Amplification a step against h omega, for each kind of method with fixed steps."""
    z = np.linspace(0.005, REACH, 240)
    return by_name({Axes.h_omega: z, **{Studied.growth[slug]: amplification(slug, z) for slug in ALIKE}})


def _stability_plot() -> Block:
    columns = stability()
    z = columns[Axes.h_omega.name]
    # A line that leaves the frame at its top has its name over the frame, each in a row of its own.
    leaves = {slug: last for slug in ALIKE if (last := float(z[columns[slug] <= TOP].max())) < REACH}
    names = tuple(
        text(STABILITY.x(leaves[slug]), STABILITY.top - 6 - 16 * row, ALIKE[slug], tint=_tint(slug), style="t1 halo")
        for row, slug in enumerate(sorted(leaves, key=leaves.__getitem__))
    )
    curves = tuple(
        curve(
            Studied.growth[slug],
            tint=_tint(slug),
            width="sum" if slug == "verlet" else "dash" if slug == "midpoint" else "line",
            label="" if slug in leaves else name,
        )
        for slug, name in ALIKE.items()
    )
    return plot(
        STABILITY,
        x=Axes.h_omega,
        y=Axes.growth,
        title="Growth of an oscillation in one step, against step times angular frequency",
        curves=curves,
        x_column=Axes.h_omega,
        heading=(phrase("", "none", "ink", formula="**Growth a step**, against $h\\,\\omega_+$: above 1 it explodes"),),
        marks=(mark(Places.step_at, html="picked", label="Step of the picked run", lift=16 * len(leaves) + 28),),
        shapes=names,
        room=Room(44, 190, top=16 * len(leaves) + 32),
        phone=10,
        height=260,
    )


def _tint(slug: str) -> str:
    return "ink" if slug == "verlet" else "mute"


@lru_cache(maxsize=16)
def step_explosion(chain: TwoMassChain) -> Columns:
    """Steps in a slow period that a method with a limit needs to stay stable, as k2/k1 grows with all else kept."""
    ratios = np.geomspace(1.0, 1e12, 25)
    k1 = chain.k1 or 1.0
    chains = [TwoMassChain(m1=chain.m1, m2=chain.m2, k1=k1, k2=k1 * ratio) for ratio in ratios]
    steps = {Studied.steps[slug]: np.array([stable_steps(slug, each) for each in chains]) for slug in BOUNDED}
    return by_name({Axes.ratio: ratios, **steps})


def _steps_plot() -> Block:
    return plot(
        PlotFrame("explosion"),
        x=Axes.ratio,
        y=Axes.steps,
        title="Steps in a slow period that stability requires, against k2/k1",
        curves=tuple(curve(Studied.steps[slug], width="line", label=ALIKE[slug]) for slug in BOUNDED if slug in ALIKE),
        x_column=Axes.ratio,
        heading=(
            phrase("", "none", "ink", formula="**Steps in a slow period** that stability requires, against $k_2/k_1$"),
        ),
        room=Room(54, 190),
        phone=11,
        height=220,
    )


def studies(case: AccuracyCase) -> dict[str, Columns]:
    """The columns of the views after the race."""
    stable = {"stability": stability(), "explosion": step_explosion(case.system.chain)}
    return growth(case.compared) | length_columns() | digits_columns() | stable
