"""Marks over the plots are on the curves that they mark: dots, peaks, half widths, resonances, tops of energies."""

from itertools import product
from typing import Any

import numpy as np
import pytest

from components.quantities.axes import Axis
from components.scenes import SCENES
from components.state.scene_sheet import column_axes
from tests.scenes.checks import scaled

NEAR = 0.004
"""The largest distance of a mark from its curve, in widths or heights of the plot."""
QUICK = (0, -6, -6)
"""Micrometres and microseconds, as powers of ten: axes count in other powers of ten."""
Pairs = list[tuple[str, str | float]]
KINDS = ("force", "base", "unbalance")
PEAK: Pairs = [("peak_at", "peak_up"), ("peak_low", "peak_half"), ("peak_high", "peak_half"), ("omega_at", "M_at")]
BRAKED = {"c1": 0.1, "c2": 0.1, "omega": 1.1}
WIDTHS = (("peak", "up"), ("low", "half"), ("high", "half"))
BODE: dict[str, Pairs] = {
    f"Xp{i}": [
        *((f"{x}{i}_{n}", f"{y}{i}_{n}") for (x, y), n in product(WIDTHS, (0, 1))),
        *((f"dip{i}", f"down{i}"), ("drive_at", f"Xp{i}_at")),
    ]
    for i in (1, 2)
}
ROOTS = {"view": "roots", "c1": 0.8}
PLANE = {"view": "plane", "k1": 3.0}
DRIVEN = (("log", "M", PEAK), ("linear", "M", PEAK[3:]), ("linear", "lag", [("omega_at", "lag_at")]))
MARKS: list[tuple[str, dict[str, Any], str, str, str, Pairs]] = [
    *(("oscillator", {"m": 0.3, "k": 5.0, "x_0": -0.1, "v_0": 0.4}, "time", "t", y, [(f"peak_{y}", f"top_{y}")])
     for y in "xva"),
    *(("driven", {"kind": kind, "c": c, "axes": axes, "omega": 5.0}, "below", "omega", y, pairs)
     for kind, c, (axes, y, pairs) in product(KINDS, (0.1, 2.513), DRIVEN)),
    *(("driven", {"view": "power", "zeta": zeta}, "below", "omega", "power", [(x, "half_peak"), ("unity", "peak")])
     for zeta, x in product((0.03, 0.2, 0.5), ("half_low", "half_high"))),
    *(("forced", {"view": "bode", **BRAKED}, "branch0", "omega", y, pairs) for y, pairs in BODE.items()),
    *(("forced", {"view": "bode", **braked, "omega": 1.2}, "lag", "w", f"phi{i}", [("now", f"phi{i}_at")])
     for braked, i in product(({}, BRAKED), (1, 2))),
    *(("forced", {"view": "nyquist", **BRAKED}, "nyquist", f"re{i}", f"im{i}", [(f"re{i}_at", f"im{i}_at")])
     for i in (1, 2)),
    ("forced", {"view": "nyquist", **BRAKED}, "nyquist", "re1", "im1",
     [(f"re_mark_{one}", f"im_mark_{one}") for one in ("minus", "plus", "still")]),
    ("analogues", {"theta_0": 75.0}, "late", "angle", "excess",
     [("late_01", 0.001), ("late_1", 0.01), ("late_5", 0.05)]),
    ("absorber", {"damping": "added", "c": 200.0}, "sweep", "w", "swing",
     [("omega", "swing"), ("P_x", "P_y"), ("Q_x", "Q_y")]),
    ("absorber", {}, "sweep", "w", "stroke", [("omega", "stroke")]),
    ("absorber", {}, "sweep", "w", "alone", [("omega", "alone")]),
    ("modes", {"view": "guess"}, "det", "w", "D", [("w", "D"), ("w_held", "D_held"), ("w_slow", 0.0), ("w_fast", 0.0)]),
    ("modes", {"view": "guess"}, "row1", "w", "row1", [("w", "row1"), ("w_slow", "r_slow"), ("w_fast", "r_fast")]),
    ("modes", {"view": "guess"}, "row2_below", "w", "row2_below", [("w_slow", "r_slow")]),
    ("modes", {"view": "guess"}, "row2_above", "w", "row2_above", [("w", "row2"), ("w_fast", "r_fast")]),
    *(("modes", {**ROOTS, "grows": grows}, "paths", f"re{j}", f"im{j}", [(f"root{j}_re", f"root{j}_im")])
     for grows, j in product(("c1", "c2", "both"), range(4))),
    *(("coupled", PLANE, "modes", f"{one}1", f"{one}2", [(f"{one}_name1", f"{one}_name2")])
     for one in ("slow", "fast")),
    ("damped", {}, "time", "t", "x", [(f"peak{n}_t", f"peak{n}_x") for n in range(4)]),
    ("damped", {}, "time", "t", "x", [("quickest_t", "quickest_x")]),
    ("damped", {"view": "energy"}, "time", "t", "P", [("quickest_t", "P_max")]),
    ("phugoid", {"view": "period"}, "periods", "v_0", "tau",
     [(f"at_{one}", f"tau_at_{one}") for one in ("light", "glider")]),
    ("phugoid", {}, "path", "x", "y", [("top_x", "top_y")]),
    ("phugoid", {}, "path", "x_lin", "y_lin", [("top_lin_x", "top_lin_y")]),
    ("driven", {"view": "harmonics", "push": "square", "omega": 1.7}, "below", "omega", "M", PEAK[:3]),
]  # fmt: skip
"""A state, the columns of a curve, and the scalars or numbers in SI units that are on it."""


@pytest.mark.parametrize("is_quick", [False, True])
@pytest.mark.parametrize(("slug", "values", "source", "x", "y", "pairs"), MARKS, ids=lambda one: str(one)[:30])
def test_a_mark_is_on_its_curve(
    slug: str, values: dict[str, Any], source: str, x: str, y: str, pairs: Pairs, is_quick: bool
) -> None:
    scene = SCENES[slug].at(values)
    shown = (scaled(scene, QUICK) if is_quick else scene).shown
    across, up = (shown.axes[column_axes(SCENES[slug])[source][name]] for name in (x, y))
    curve = np.stack([shares(axis, axis.places(shown.sources[source][name])) for axis, name in ((across, x), (up, y))])
    for at, high in pairs:
        mark = shown.scalars[at], shown.scalars[high] if isinstance(high, str) else up.place(high)
        place = np.array([shares(axis, one) for axis, one in zip((across, up), mark, strict=True)])
        assert distance(place, curve) < NEAR, (at, high, place)


def shares(axis: Axis, places: Any) -> Any:
    """Places on an axis in its lengths."""
    return places / abs(axis.place(axis.end) - axis.place(axis.start))


def distance(mark: Any, curve: Any) -> float:
    """The distance of a point from a polyline (2, n)."""
    start, way = curve[:, :-1], np.diff(curve)
    to = mark[:, None] - start
    share = np.clip(np.sum(to * way, axis=0) / np.maximum(np.sum(way * way, axis=0), 1e-300), 0.0, 1.0)
    return float(np.sqrt(np.sum((to - share * way) ** 2, axis=0)).min())
