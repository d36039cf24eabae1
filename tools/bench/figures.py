"""Figures of the benchmark, with matplotlib."""

from collections.abc import Iterable, Sequence
from math import inf
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from physics.coupled import TwoMassChain
from physics.integrators.accuracy import MARKS, Run, System
from physics.integrators.fixed_steps import FIXED_STEP
from physics.integrators.price import LEAST, at_cost, at_error
from physics.integrators.solvers import METHODS
from physics.integrators.stability import amplification, stability_limit, stable_steps

matplotlib.rcParams |= {"svg.hashsalt": "bench", "axes.grid": True, "grid.alpha": 0.3, "font.size": 9}
FAMILIES = {slug: method.family for slug, method in METHODS.items()}
SHADES = {"closed": "Greys", "exact": "Greys", "fixed": "winter", "adaptive": "autumn"}
LINES = {"closed": "none", "exact": "none", "fixed": "--", "adaptive": "-"}
MARKERS = "osD^v<>Ph*Xpd8"
ROUNDING = 2.0**-53
EQUAL_ERROR, EQUAL_COST = 1e-4, 0.1
ASKED = (1e-3, 1e-6, 1e-9)
"""Tolerances that are marked along the lines of solvers."""


def _look(slug: str) -> dict[str, object]:
    """Return the colour and the marker of a method: a shade of its family, and its own marker in this family."""
    family = [other for other in METHODS if SHADES[FAMILIES[other]] == SHADES[FAMILIES[slug]]]
    place = family.index(slug)
    low, high = (0.45, 1.0) if FAMILIES[slug] in ("closed", "exact") else (0.0, 0.85)
    share = high - (high - low) * place / max(len(family) - 1, 1)
    return {"color": matplotlib.colormaps[SHADES[FAMILIES[slug]]](share), "marker": MARKERS[place % len(MARKERS)]}


def draw_system(path: Path, system: System, runs: list[Run], caption: str) -> None:
    """Error against run time and against evaluations; growth of the error at equal error and at equal cost."""
    figure, axes = plt.subplots(2, 2, figsize=(11, 9), layout="constrained")
    for place, quantity, label in zip(
        axes[0], ("time", "evaluations"), ("run time, s", "evaluations of the right-hand side"), strict=True
    ):
        _work_precision(place, runs, quantity, label)
    many = by_method(run for run in runs if not run.compiled)
    same_error = {slug: at_error(each, EQUAL_ERROR) for slug, each in many.items()}
    same_cost = {slug: at_cost(each, EQUAL_COST) for slug, each in many.items()}
    _growth(axes[1][0], system, same_error, f"first run with an error of {EQUAL_ERROR:g} at the most")
    _growth(axes[1][1], system, same_cost, f"finest run within {EQUAL_COST:g} s")
    figure.legend(*axes[0][0].get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=8)
    figure.suptitle(
        f"{system.name}: 1000 outputs over {system.periods:.3g} {system.unit}; dotted: compiled; "
        f"framed: rtol 1e-3, 1e-6, 1e-9. {caption}",
        fontsize=9,
    )
    _save(figure, path)


def by_method(runs: Iterable[Run]) -> dict[str, list[Run]]:
    found: dict[str, list[Run]] = {}
    for run in runs:
        if run.error is not None:
            found.setdefault(run.method, []).append(run)
    return found


def _work_precision(axes: Axes, runs: list[Run], quantity: str, label: str) -> None:
    """In Python, and dotted compiled: they differ in time alone."""
    for slug, many in by_method(run for run in runs if not run.compiled).items():
        line = {"linestyle": LINES[FAMILIES[slug]], "markersize": 4, "linewidth": 1}
        places, errors = _line(axes, many, quantity, {"label": METHODS[slug].name, **_look(slug), **line})
        marked = [run for run in many if run.family == "adaptive" and run.setting in ASKED]
        _line(axes, marked, quantity, {"linestyle": "none", "markersize": 7, "markeredgecolor": "k", **_look(slug)})
        if quantity == "time":
            low, high = ([abs(run.time - end) for run, end in zip(many, ends, strict=True)] for ends in _ends(many))
            axes.errorbar(places, errors, xerr=(low, high), fmt="none", ecolor=_look(slug)["color"], elinewidth=0.8)
    for slug, many in by_method(run for run in runs if run.compiled).items():
        _line(axes, many, quantity, {"linestyle": ":", "markersize": 3, "linewidth": 1, **_look(slug)})
    axes.axhline(ROUNDING, color="k", linewidth=0.8, linestyle=":")
    axes.set(xlabel=label, ylabel="largest error of the motion", ylim=(LEAST / 3, 10))


def _line(axes: Axes, runs: list[Run], quantity: str, look: dict[str, object]) -> tuple[list[float], list[float]]:
    places, errors = [getattr(run, quantity) for run in runs], [max(run.error or 0, LEAST) for run in runs]
    axes.loglog(places, errors, **look)
    return places, errors


def _ends(runs: list[Run]) -> tuple[list[float], list[float]]:
    return [run.time_low or 0.0 for run in runs], [run.time_high or 0.0 for run in runs]


def _growth(axes: Axes, system: System, chosen: dict[str, Run | None], title: str) -> None:
    for slug, run in chosen.items():
        if run is not None and run.error_growth:
            look = {**_look(slug), "linestyle": "-" if FAMILIES[slug] != "fixed" else "--", "markersize": 4}
            axes.semilogy(MARKS[1:], np.maximum(run.error_growth[1:], LEAST), linewidth=1, **look)
    axes.set(xlabel=system.unit, ylabel="error, worst so far", ylim=(LEAST / 3, 10))
    axes.set_title(title, fontsize=9)


def draw_stability(path: Path) -> None:
    """Amplification a step against h omega; stable steps a slow period against k2/k1, equal masses."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    z, ratio = np.linspace(0.01, 3.2, 400), np.logspace(0, 12, 49)
    chains = [TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=k2) for k2 in ratio.tolist()]
    for method in FIXED_STEP:
        limit, look = stability_limit(method), {"color": _look(method)["color"]}
        told = "always unstable" if not limit else f"stable to {limit:.4g}" if limit < inf else "always stable"
        left.plot(z, amplification(method, z), label=f"{METHODS[method].mark}, {told}", **look)
        if 0 < limit < inf:
            steps = [stable_steps(method, chain) for chain in chains]
            right.loglog(ratio, steps, label=METHODS[method].mark, **look)
    left.set(xlabel="h omega", ylabel="amplification a step", ylim=(0.5, 4))
    right.set(xlabel="k2/k1, equal masses", ylabel="stable steps a slow period")
    left.legend(fontsize=8)
    right.legend(fontsize=8)
    _save(figure, path)


def draw_length(path: Path, runs: list[Run], caption: str) -> None:
    """Run time and error against the length of the run, steps and tolerances kept."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 5), layout="constrained")
    for slug, many in by_method(runs).items():
        spans, look = [run.setting for run in many], {**_look(slug), "markersize": 4, "linewidth": 1}
        left.loglog(spans, [run.time for run in many], label=METHODS[slug].name, **look)
        right.loglog(spans, [max(run.error or 0, LEAST) for run in many], **look)
    left.set(xlabel="slow periods", ylabel="run time, s")
    right.set(xlabel="slow periods", ylabel="largest error of the motion")
    figure.legend(loc="outside lower center", ncols=5, fontsize=8)
    figure.suptitle(
        f"Benign in Python: 100 outputs, 2,800 evaluations a slow period or rtol 1e-6. {caption}", fontsize=9
    )
    _save(figure, path)


def draw_digits(path: Path, digits: dict[str, dict[str, list[float]]], caption: str) -> None:
    """Errors of what takes no steps: wide chains, near resonance, long runs."""
    figure, places = plt.subplots(1, 3, figsize=(11, 4.5), layout="constrained", sharey=True)
    labels = {"ratio": "k2/k1", "detuning": "omega/omega_- - 1", "periods": "slow periods"}
    for axes, (sweep, curves) in zip(places, digits.items(), strict=True):
        for slug in (slug for slug in curves if slug != "x"):
            look = {**_look(slug), "markersize": 4, "linewidth": 1}
            axes.loglog(curves["x"], _gaps(curves[slug]), label=METHODS[slug].name, **look)
        axes.set(xlabel=labels[sweep], ylim=(LEAST / 3, 1e3))
    places[0].set(ylabel="largest error of the motion")
    figure.legend(*places[0].get_legend_handles_labels(), loc="outside lower center", ncols=4, fontsize=8)
    figure.suptitle(f"Without steps: doubles against 80 digits. {caption}", fontsize=9)
    _save(figure, path)


def _gaps(errors: Sequence[float | None]) -> list[float]:
    return [np.nan if error is None else max(error, LEAST) for error in errors]


def _save(figure: Figure, path: Path) -> None:
    figure.savefig(path.with_suffix(".png"), dpi=100, metadata={"Software": None})
    plt.close(figure)
