"""'About these numbers' of the scenes of the two-mass chain."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from math import fsum

import numpy as np
from numpy.typing import NDArray

from components.about import NO_BAND, About, Place, Row, Table, drift, envelope, few, rows, table
from components.duty import Duty
from components.numbers import short, ten
from components.scene import Columns, Picture
from physics.coupled import TwoMassChain, free_modes, free_motion
from physics.energy import chain_energy
from physics.exact import precise
from physics.forced import DrivenModes
from physics.integrators import Problem
from physics.modes import determinant_curve
from physics.reference import Point, determinants, modal_points, modes_of
from physics.reference_single import steady_points

Pair = tuple[float, float]
MODES = ("slow", "fast")
MASSES = {"x1": "$x_1$", "x2": "$x_2$"}
PARTS = {f"x{i}_{mode}": f"$x_{i}$, {mode}" for i in (1, 2) for mode in MODES}
BANDS = MASSES | {f"x{i}_{mode}": f"the {mode} mode" for i in (1, 2) for mode in MODES}
DRIVEN_BANDS = MASSES | {
    f"x{i}_{part}": f"the {name} part" for i in (1, 2) for part, name in (("p", "particular"), ("c", "complementary"))
}
DRIVE, FREQUENCY = (Place(column, r"$\omega$", "rad/s") for column in ("omega", "w"))
ROUNDED_ONCE = 0.51


def coupled_about(picture: Picture, chain: TwoMassChain, x_0: Pair, v_0: Pair) -> About:
    """Displacements, or where these are bands the modes that are not."""
    columns = picture.columns["time"]
    names = {key: name for key, name in PARTS.items() if key[:2] not in columns}
    motion = _motion(MASSES | names, columns, chain, x_0, v_0)
    points = table("$x_1(t)$, $x_2(t)$ or a mode", 2, "its amplitudes", motion)
    return About((points,), _free_drift(chain, x_0, v_0, columns["t"]), envelope(picture.columns, BANDS))


def forced_about(picture: Picture, driven: DrivenModes, x_0: Pair, v_0: Pair) -> About:
    """Displacements, and both amplitudes of the steady swing."""
    columns, sweep = picture.columns["time"], picture.columns["response"]
    motion = _motion(MASSES, columns, driven.chain, x_0, v_0, driven.F_0, driven.omega)
    at = few(sweep["omega"])
    steady = steady_points(driven.chain, 0.0, driven.F_0, sweep["omega"][at].tolist())
    swings = {"Xp1": r"$X_{\mathrm{p}1}$", "Xp2": r"$X_{\mathrm{p}2}$"}
    tables = (
        table("$x_1(t)$ or $x_2(t)$", 4, "the most it can have reached by then", motion),
        table("the steady swing", 2, "itself", rows(swings, sweep, dict(zip(swings, steady, strict=True)), at, DRIVE)),
    )
    return About(tables, _work_gap(driven, columns["t"]), envelope(picture.columns, DRIVEN_BANDS))


def guess_about(picture: Picture, chain: TwoMassChain) -> About:
    """The crossings, and the curve of the determinant."""
    columns = picture.columns["det"]
    at = few(columns["w"])
    exponent = determinant_curve(chain, columns["w"])[1]
    D = [value.scaleb(-exponent) for value in determinants(chain, columns["w"][at].tolist())]
    name = f"$D$ / {ten(exponent)}" if exponent else "$D$"
    found = rows({"D": name}, columns, {"D": [Point(value, abs(value)) for value in D]}, at, FREQUENCY)
    return About((_modes(chain), table("$D$, next to its zeros too,", 32, "itself", found)))


def solve_about(chain: TwoMassChain) -> About:
    return About((_modes(chain),))


def sweep_about(picture: Picture, chain: TwoMassChain, swept: str) -> About:
    """The frequencies of three of the chains that are swept through."""
    columns = picture.columns["omega_sweep"]
    at = few(columns["p"])
    chains = [replace(chain, **{swept: float(columns["p"][i])}) for i in at]
    pairs = zip(*([Point(omega, omega) for omega, _ in modes_of(each)] for each in chains), strict=True)
    names = {"omega_slow": r"$\omega_-$", "omega_fast": r"$\omega_+$"}
    place = Place("p", f"${swept[0]}_{swept[1]}$", {"m": "kg", "k": "N/m"}[swept[0]])
    found = rows(names, columns, dict(zip(names, pairs, strict=True)), at, place)
    return About((_modes(chain), table("the curves of the frequencies", 8, "itself", found)))


def hunt_about(picture: Picture, chain: TwoMassChain, x_0: Pair) -> About:
    """Points of the path; the modes only where the answer is shown."""
    path, rest = picture.columns["path"], (0.0, 0.0)
    points = table("the path", 2, "its amplitudes", _motion(MASSES, path, chain, x_0, rest))
    tables = (points, _modes(chain)) if picture.columns["answer"] else (points,)
    return About(tables, _free_drift(chain, x_0, rest, path["t"]))


def absorber_about(picture: Picture, duty: Duty) -> About:
    """Swing and stroke, with and without the absorber."""
    columns = picture.columns["sweep"]
    caps = {"swing": picture.axes["X1"].end, "stroke": picture.axes["X2"].end, "alone": picture.axes["X1"].end}
    inside = np.flatnonzero(np.all([columns[name] < cap for name, cap in caps.items()], axis=0))
    at = inside[few(inside)].tolist()
    w = columns["w"][at].tolist()
    swing, stroke = steady_points(duty.chain, duty.c, duty.F_0, w) if at else ([], [])
    alone = steady_points(duty.bare.chain, 0.0, duty.F_0, w)[0] if at else []
    true = {"swing": swing, "stroke": stroke, "alone": alone}
    sizes = {name: [Point(abs(point.value), point.size) for point in points] for name, points in true.items()}
    names = {"swing": "$|X_1|$", "stroke": "$|X_2|$", "alone": "$|X_1|$ alone"}
    found = rows(names, columns, sizes, at, FREQUENCY)
    bound = table("$|X_1|$, with the absorber or alone, or of $|X_2|$", 2, "itself", found)
    return About((bound,), envelope=f"{NO_BAND} Curves end far above the frame, towards a resonance without end.")


def _motion(
    names: dict[str, str],
    columns: Columns,
    chain: TwoMassChain,
    x_0: Pair,
    v_0: Pair,
    F_0: float = 0.0,
    omega: float = 0.0,
) -> list[Row]:
    """x1 and x2 and their parts by mode, as far as they are drawn."""
    at = few(columns["t"])
    problem = Problem(chain=chain, x_0=x_0, v_0=v_0, t=columns["t"][at], F_0=F_0, omega=omega)
    modal = modal_points(problem)
    true: dict[str, Sequence[Point]] = {}
    for i in (0, 1):
        true[f"x{i + 1}"] = [_sum(parts) for parts in zip(modal[0][i], modal[1][i], strict=True)]
        true |= {f"x{i + 1}_{mode}": modal[j][i] for j, mode in enumerate(MODES)}
    return rows(names, columns, true, at)


def _sum(parts: Iterable[Point]) -> Point:
    values, sizes = zip(*parts, strict=True)
    with precise():
        return Point(sum(values), sum(sizes))


def _modes(chain: TwoMassChain) -> Table:
    """Both frequencies and both shapes, as far as they are numbers."""
    modes, found = chain.modes(), []
    for j, ((omega, ratio), sign) in enumerate(zip(modes_of(chain), "-+", strict=True)):
        place = f"The {MODES[j]} mode"
        found.append(Row(rf"$\omega_{sign}$", place, float(modes.omega[j]), Point(omega, omega)))
        if ratio is not None and np.isfinite(modes.ratio[j]):
            found.append(Row("$X_2/X_1$", place, float(modes.ratio[j]), Point(ratio, abs(ratio))))
    bound = "Frequencies and shapes of the modes are rounded once: off by at most 0.51 ulp of themselves."
    return Table(bound, ROUNDED_ONCE, tuple(found))


def _free_drift(chain: TwoMassChain, x_0: Pair, v_0: Pair, t: NDArray[np.float64]) -> str:
    total = chain_energy(chain, free_motion(chain, x_0, v_0, t)).total
    return drift(total, fsum(free_modes(chain, x_0, v_0).energy))


def _work_gap(driven: DrivenModes, t: NDArray[np.float64]) -> str:
    total = chain_energy(driven.chain, driven.motion(t)).total
    largest = float(np.max(total))
    if not largest:
        return "Nothing moves, and the drive does no work."
    gap = float(np.max(np.abs((total - total[0] - driven.work(t)) / largest)))
    return f"The gain of $T + V$ and the work of the drive agree to {short(gap)} of the largest $T + V$."
