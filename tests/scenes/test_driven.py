"""The driven mass: its polygon of forces, what is drawn of its motion, its peak, and pushes of other shapes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.scene import Scene
from components.scenes import SCENES
from components.scenes.driven.case import LEFT, RIGHT
from physics.bode import driven_resonances
from physics.convolution import SlicedPush
from physics.damped import DampedOscillator
from physics.driven import Drive, DrivenOscillator
from physics.magnification import magnification
from physics.periodic import PeriodicPush
from physics.pushed import PushedMass
from tests.grids import tries
from tests.scenes.textbook import SIZES, harmonics

DRIVEN = SCENES["driven"]
KINDS = ("force", "base", "unbalance")
PUSHES = ("square", "triangle", "pulses", "impulses")


def corners(scene: Scene) -> dict[str, float]:
    """The numbers of the polygon of the forces."""
    return {name.removeprefix("polygon_"): one for name, one in scene.shown.scalars.items() if "polygon" in name}


def steady(scene: Any) -> complex:
    """X, from the linear equation."""
    size, w = getattr(scene, SIZES[scene.kind]), scene.omega
    force = {"force": size, "base": complex(scene.k, scene.c * w) * size, "unbalance": size * w * w}[scene.kind]
    return complex(force / complex(scene.k - scene.m * w * w, scene.c * w))


SOME = st.floats(-1.0, 1.0).map(lambda power: 10.0**power)


@settings(max_examples=tries(100), deadline=None)
@given(st.sampled_from(KINDS), SOME, st.floats(0.1, 2.4), st.floats(0.01, 1.5))
def test_its_polygon_closes_on_the_push(kind: str, m: float, r: float, zeta: float) -> None:
    """In units of the push, or of k Y, with X up, of the unbalance the acceleration; within its stage."""
    scene = DRIVEN(kind=kind, m=m, zeta=zeta, omega=r * math.sqrt(39.48 / m))
    at, M = corners(scene), scene.shown.axes["M"]
    end = complex(at["end"], -at["across"])
    assert -LEFT <= at["across"] * at["scale"] / M.place(M.end) <= RIGHT
    if kind == "base":
        shaken = complex(at["y_up"], -at["y_side"])
        assert abs(shaken) == pytest.approx(1.0) and shaken * complex(1, 2 * zeta * r) == pytest.approx(end)
    else:
        assert abs(end) == pytest.approx(1.0)
        turned = -1 if kind == "unbalance" else 1
        lag = math.atan2((end * turned).imag, (end * turned).real)
        assert lag % (2 * math.pi) == pytest.approx(scene.numbers["phi"].value, abs=1e-9)
    first = abs(steady(scene)) * (scene.m / scene.moment if kind == "unbalance" else scene.k / scene.F_0)
    assert at["up"] == pytest.approx(abs(steady(scene)) / scene.Y if kind == "base" else first)


def shown_x(scene: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The instants of a window with the lowest and the highest x that is drawn there: a band, a line, or a line that
    follows a band."""
    told, t = scene.shown, scene.shown.traces["time"].t
    if "x" in told.traces["time"].names:
        line = told.traces["time"].columns["x"]
        return t, line, line
    if not (late := told.columns["late"]):
        return t, *(told.columns["band"][end] for end in ("x_lo", "x_hi"))
    first = len(t) - len(late["t"])
    low, high = (np.concatenate([told.columns["ringing"][end][:first], late["x"]]) for end in ("x_lo", "x_hi"))
    return t, low, high


@settings(max_examples=tries(200), deadline=None)
@given(st.sampled_from(KINDS), st.floats(-6, 6), st.floats(-5, 1), st.floats(0.1, 300), st.floats(-0.1, 0.1))
def test_what_is_drawn_of_x_holds_all_of_it_and_stays_in_the_frame(
    kind: str, power: float, damping: float, window: float, x_0: float
) -> None:
    """For a motion drawn as a line, a band, or first a band and then a line; to half a pixel."""
    scene = DRIVEN(kind=kind, omega=2 * math.pi * 10**power, zeta=10**damping, window=window, x_0=x_0)
    t, low, high = shown_x(scene)
    pixel = 0.005 * scene.shown.axes["x"].end
    rows = np.linspace(0, len(t) - 1, 40).astype(int)
    one = DrivenOscillator(m=scene.m, c=scene.c, k=scene.k)
    x = one.motion(scene.omega, getattr(scene, SIZES[kind]), x_0=x_0, t=t[rows], kind=kind).x
    assert np.all(low[rows] - pixel <= x) and np.all(x <= high[rows] + pixel)
    assert max(-low.min(), high.max()) <= scene.shown.axes["x"].end


@settings(max_examples=tries(60), deadline=None)
@given(st.floats(0.021, 0.59), SOME)
def test_both_points_of_half_power_are_where_the_dashpot_takes_half_of_the_most(zeta: float, m: float) -> None:
    scene = DRIVEN(zeta=zeta, m=m)
    at, axes, zeta = scene.shown.scalars, scene.shown.axes, scene.zeta
    r = np.array([at["half_low"], at["half_high"]]) * axes["r"].factor * math.sqrt(m / scene.k)
    np.testing.assert_allclose(2 * zeta * (r * np.abs(magnification(r, zeta))) ** 2, 0.25 / zeta, rtol=1e-9)
    assert axes["M"].place(0.25 / zeta) == pytest.approx(at["half_peak"])


@pytest.mark.parametrize("kind", ["force", "base", "unbalance"])
@pytest.mark.parametrize("c", [1e-3, 2.513, 30.0])
def test_log_axes_mark_the_peak_the_width_and_the_natural_frequency(kind: Drive, c: float) -> None:
    scene = DRIVEN(kind=kind, c=c, axes="log", omega=5.0)
    scalars, axes, curve = scene.shown.scalars, scene.shown.axes, scene.shown.sources["below"]
    assert axes["r"].log and axes["M"].log
    unit = {"force": scene.k, "base": 1.0, "unbalance": scene.m}[kind]
    peaks = driven_resonances(DrivenOscillator(m=scene.m, c=c, k=scene.k), kind).peaks
    assert ("peak_up" in scalars) == bool(peaks)
    for peak in peaks:
        height, (low, high) = unit * peak.height, peak.half_power
        assert scalars["peak_at"] == pytest.approx(axes["r"].place(peak.omega))
        assert scalars["peak_up"] == pytest.approx(axes["M"].place(height))
        assert curve["M"].max() == pytest.approx(height, rel=0.01), "the mark is on the curve"
        assert ("peak_low" in scalars) == bool(low and high)
        if low and high:
            assert scalars["peak_half"] == pytest.approx(axes["M"].place(height / math.sqrt(2)))
            assert np.interp((low, high), curve["omega"], curve["M"]) == pytest.approx(height / math.sqrt(2), rel=0.01)
    assert scalars["natural"] == pytest.approx(0.0), "r = 1"
    drawn = np.interp(math.log(5.0), np.log(curve["omega"]), np.log(curve["M"]))
    assert math.exp(drawn) == pytest.approx(scene.of().M, rel=5e-3)


def pushed(scene: Any) -> tuple[DampedOscillator, PushedMass]:
    """The mass of a scene without its push, and with it."""
    one = DampedOscillator(m=scene.m, c=scene.c, k=scene.k)
    size = scene.J if scene.push.startswith("impulse") else scene.F_0
    return one, one.pushed(PeriodicPush(kind=scene.push, size=size, omega=scene.omega, width=scene.width))


@pytest.mark.parametrize("push", ["step", "impulse"])
def test_what_does_not_repeat_has_no_frequency(push: Any) -> None:
    slow, quick = (DRIVEN(view="harmonics", push=push, omega=omega) for omega in (0.0, 50.0))
    assert slow.sources["time"].data["x"].tolist() == quick.sources["time"].data["x"].tolist()
    assert slow.shown.forms["meets"] == "once" and not slow.shown.forms["repeats"]
    assert not {"omega_at", "M_at"} & slow.shown.scalars.keys()
    assert {"growth", "X", "on_peak", "strongest"}.isdisjoint(quick.numbers)


def test_impulses_are_drawn_where_they_act() -> None:
    scene = DRIVEN(view="harmonics", push="impulses", omega=2.0, J=0.3, window=10.0)
    jolts, flash = scene.sources["jolts"].data, scene.shown.signals["F"]
    assert jolts["jolt_t"][::3] == pytest.approx(math.pi * np.arange(4))
    assert jolts["jolt"][1::3] == pytest.approx(0.3 / math.sqrt(39.48)) and not jolts["jolt"][::3].any()
    assert len(DRIVEN(view="harmonics", push="impulses", omega=1e6).sources["jolts"].data["jolt_t"]) == 600
    assert 10.0 * scene.shown.scalars["period_share"] == pytest.approx(math.pi)
    assert max(flash.y) == pytest.approx(0.3) and min(flash.y) == 0.0 and flash.period == pytest.approx(math.pi)


@pytest.mark.parametrize("push", PUSHES)
def test_bars_are_the_push_dots_lie_under_the_response_and_powers_are_its_work(push: Any) -> None:
    scene = DRIVEN(view="harmonics", push=push, omega=1.7, c=2.0, window=60.0)
    bars, dots = scene.sources["bars"].data, scene.sources["dots"].data
    f, X = harmonics(scene, 400)
    M, seen = scene.shown.axes["M"], scene.shown.axes["r"].end / scene.omega
    size = scene.J * scene.omega / (2 * math.pi) if push == "impulses" else scene.F_0
    has = [i for i in range(1, 400) if f[i - 1] > 1e-12 and i < seen]
    assert np.all(bars["bar"][::3] == M.start) and bars["bar_omega"][::3] == pytest.approx(np.array(has) * scene.omega)
    assert bars["bar"][1::3] == pytest.approx([max(f[i - 1] / size, M.start) for i in has])
    high = [i for i in has if X[i - 1] * scene.k / size >= M.start]
    assert dots["dot_omega"] == pytest.approx(np.array(high) * scene.omega) and len(high) > 1
    assert dots["dot"] == pytest.approx([X[i - 1] * scene.k / size for i in high]) and M.end >= dots["dot"].max()
    work = pushed(scene)[1].work * scene.omega / (2 * math.pi)
    assert [scene.numbers[name].value for name in ("P_in", "P_lost")] == pytest.approx([work, work], rel=1e-5)


@pytest.mark.parametrize("values", [{"omega": 600.0}, {"omega": 0.01}, {"window": 1e5}, {"window": 1e-3}, {"k": 1e-6}])
@pytest.mark.parametrize("push", PUSHES)
def test_a_motion_too_fast_for_a_line_stays_in_its_band(push: Any, values: dict[str, float]) -> None:
    scene = DRIVEN(view="harmonics", push=push, **values)
    band = scene.shown.sources["band"]
    if "x_hi" in band:
        x = pushed(scene)[1].from_rest(np.linspace(0.0, band["t"][-1], 50)).x
        assert np.all(band["x_lo"] <= x.min()) and np.all(band["x_hi"] >= x.max() * (1 - 1e-9))


@pytest.mark.parametrize("push", ["square", "triangle", "pulses", "step"])
@pytest.mark.parametrize("slices", [1, 12, 60, 200])
def test_the_sum_of_slices_follows_the_motion_as_the_page_says(push: Any, slices: int) -> None:
    scene = DRIVEN(view="convolution", push=push, slices=slices, x_0=0.01, c=1.5, width=0.31)
    data, (one, mass) = scene.sources["time"].data, pushed(scene)
    t, end = data["t"], data["t"][-1]
    sliced = SlicedPush(oscillator=one, force=mass.force, end=end, count=slices)
    assert data["x_sliced"] == pytest.approx(sliced.x.at(t) + one.motion(0.01, 0.0, t).x, abs=1e-13)
    fine = np.linspace(0.0, end, 1 + 2 * slices * math.ceil(400 / slices))
    exact = mass.from_rest(fine).x
    miss = np.abs(sliced.x.at(fine) - exact).max()
    assert scene.numbers["misses"].value == pytest.approx(miss, rel=0.02)
    share, width = miss / np.abs(exact).max(), scene.numbers["slice_width"].value
    word = "follows" if share <= 0.05 else "coarse" if width > 0.1 else "changes"
    assert scene.shown.forms["sums"] == word or abs(share - 0.05) < 0.003
    assert width == pytest.approx(end / slices * math.sqrt(39.48) / (2 * math.pi))
    path, tails = scene.sources["outline"].data, scene.sources["tails"].data
    area = np.trapezoid(np.abs(path["slice"]), path["slice_t"])
    assert area == pytest.approx(np.abs(mass.force(end * (np.arange(slices) + 0.5) / slices)).mean() * end)
    assert scene.shown.forms["tail"] == ("some" if slices > 12 else "each")
    assert np.count_nonzero(tails["tail_t"] == end) <= 14
