"""Figures of the benchmark, with matplotlib."""

from collections.abc import Iterable
from itertools import groupby
from math import inf
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from physics.accuracy import Run, System
from physics.coupled import TwoMassChain
from physics.integrators import FIXED_STEP, amplification, stability_limit, stable_steps
from physics.solvers import METHODS

matplotlib.rcParams |= {"svg.hashsalt": "bench", "axes.grid": True, "grid.alpha": 0.3, "font.size": 9}
GREYS = ("black", "0.35", "0.55", "0.75")
COLOURS = dict(zip(METHODS, (*GREYS, *(f"C{n}" for n in (0, 1, 2, 3, 4, 5, 6, 9, 8))), strict=True))
LINES = {"closed": "none", "fixed": "--", "adaptive": "-"}
BESIDE = {
    "slides": (-4, -12),
    "eigh": (4, 6),
    "verlet": (-4, -12),
}  # names of points that lie on each other, in points
ROUNDING = 2.0**-53
LOWEST = 1e-17  # an error of zero is drawn here


def draw_system(path: Path, system: System, runs: list[Run], caption: str) -> None:
    """Work-precision on the left; growth of error and energy error, one run a method, on the right."""
    figure = plt.figure(figsize=(11, 7), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=(3, 2))
    _work_precision(figure.add_subplot(grid[:, 0]), runs)
    chosen = [_middle(list(many)) for _, many in groupby(_good(runs), key=lambda run: run.method)]
    upper, lower = figure.add_subplot(grid[0, 1]), figure.add_subplot(grid[1, 1])
    _growth(upper, "error", {_label(run): (run, run.error_growth) for run in chosen})
    _growth(lower, "energy error", {_label(run): (run, run.energy_growth) for run in chosen})
    figure.legend(*upper.get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=8)
    figure.suptitle(f"{system.name}: 1000 output times over 50 slow periods\n", fontsize=11)
    figure.text(0.5, 0.955, caption, fontsize=7, color="0.4", ha="center")
    _save(figure, path)


def draw_stability(path: Path) -> None:
    """Amplification a step against h omega; stable steps a slow period against k2/k1, equal masses."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    z, ratio = np.linspace(0.01, 3, 1500), np.logspace(0, 12, 49)
    chains = [TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=k2) for k2 in ratio.tolist()]
    for method in FIXED_STEP:
        limit = stability_limit(method)
        name = METHODS[method].name + (f", stable to {limit:.4g}" if limit < inf else ", always stable")
        left.plot(z, amplification(method, z), label=name, color=COLOURS[method])
        if limit < inf:
            steps = [stable_steps(method, chain) for chain in chains]
            right.loglog(ratio, steps, label=METHODS[method].name, color=COLOURS[method])
    left.set(xlabel="h omega", ylabel="amplification a step", ylim=(0.9, 4))
    right.set(xlabel="k2/k1, equal masses", ylabel="stable steps a slow period")
    left.legend()
    right.legend()
    _save(figure, path)


def _work_precision(axes: Axes, runs: list[Run]) -> None:
    for slug, group in groupby(_good(runs), key=lambda run: run.method):
        many = list(group)
        times, errors = [1e3 * (run.time or 0) for run in many], [max(run.error or 0, LOWEST) for run in many]
        axes.loglog(times, errors, color=COLOURS[slug], marker="o", linestyle=LINES[many[0].family], markersize=5)
        axes.annotate(
            many[-1].name, (times[-1], errors[-1]), fontsize=8,
            xytext=BESIDE.get(slug, (6, 3)), textcoords="offset points",
        )  # fmt: skip
    axes.axhline(ROUNDING, color="k", linewidth=0.8, linestyle=":")
    axes.margins(x=0.15)
    axes.set(xlabel="run time, ms", ylabel="largest error of the motion")
    failed = sum(run.failure is not None for run in runs)
    axes.set_title(f"{failed} of {len(runs)} runs have no result: see the table", fontsize=8)


def _growth(axes: Axes, quantity: str, curves: dict[str, tuple[Run, tuple[float, ...]]]) -> None:
    for label, (run, values) in curves.items():
        line = "-" if run.family == "closed" else LINES[run.family]
        periods, worst = range(1, len(values)), np.maximum(values[1:], LOWEST)
        axes.semilogy(periods, worst, line, label=label, color=COLOURS[run.method])
    axes.set(xlabel="slow periods", ylabel=f"{quantity}, worst so far", ylim=(LOWEST, 10))


def _label(run: Run) -> str:
    return run.name + (f" {run.setting:g}" if run.setting else "")


def _good(runs: Iterable[Run]) -> list[Run]:
    return [run for run in runs if run.error is not None]


def _middle(runs: list[Run]) -> Run:
    return runs[len(runs) // 2]


def _save(figure: Figure, path: Path) -> None:
    for suffix, metadata in ((".png", None), (".svg", {"Date": None})):
        figure.savefig(path.with_suffix(suffix), dpi=150, metadata=metadata)
    plt.close(figure)
