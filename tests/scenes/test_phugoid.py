"""Scene phugoid: its verdict on the linear theory against another integrator, its units, and its lift."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from components.scenes.phugoid import Phugoid
from components.scenes.phugoid.swing import SPEEDS
from physics.phugoid import CUSP_EXCESS
from tests.page.headless_page import picture_wire
from tests.page.scripts import played
from tests.scenes.sentences import number


def flown(excess: float) -> tuple[float, float, float, bool]:
    """The period over that of the linear theory; how far the heights of both differ at the same share of a period, and
    at the same time in the first one, over the size of the swing; and whether the flight loops."""

    def rates(_: float, y: np.ndarray) -> list[float]:
        u, w, _ = y
        V = math.hypot(u, w)
        return [-V * w, V * u - 1, w]

    def level(_: float, y: np.ndarray) -> float:
        return float(y[1])

    way = solve_ivp(
        rates, (0, 12), [1 + excess, 0.0, 0.0], "DOP853", rtol=1e-11, atol=1e-14, events=level, dense_output=True
    )
    period = 2 * next(t for t in way.t_events[0] if t > 1e-3)
    t = np.linspace(0, period, 801)
    u, _, h = way.sol(t)
    in_step = np.abs(h - excess * (1 - np.cos(2 * math.pi * t / period))).max()
    # The linear theory leaves out that the flight starts excess^2/2 lower.
    in_time = np.abs(h - excess * (1 - np.cos(math.sqrt(2) * t)) - excess**2 / 2).max()
    late = period / (math.sqrt(2) * math.pi)
    return late, float(in_step / (np.ptp(h) / 2)), float(in_time / abs(excess)), bool(u.min() < 0)


SMALL = st.floats(-4, -0.83).map(lambda power: 10**power)


@given(st.floats(-0.9, 0.72).filter(lambda one: abs(one) > 1e-4) | SMALL | SMALL.map(lambda size: -size))
@example(0.1)
@example(0.8)
@example(3.0)
def test_the_verdict_on_linear_theory_is_true(excess: float) -> None:
    """Its error of the heights shrinks with the swing: it is that over the first period, next to the amplitude."""
    told = Phugoid(excess=excess).shown.values["verdict"].replace("\N{NO-BREAK SPACE}", " ")
    late, off, first, loops = flown(excess)
    assert loops == ("loops" in told)
    if "right to 0.1 %" in told:
        assert abs(late - 1) <= 1.0005e-3 and off <= 0.08
        assert 0.01 * number(told.split("about ")[1].split(" %")[0]) == pytest.approx(first, rel=0.06)
    elif not loops:
        assert off > abs(late - 1) > 0.9995e-3 and first > (0.2 if "fails in the shape" in told else 0.05)


def test_no_property_of_the_aircraft_but_its_speed_enters() -> None:
    before, after = (picture_wire(Phugoid(m=m)) for m in (1.0, 70000.0))
    for source, columns in before["columns"].items():
        assert all(np.array_equal(column, after["columns"][source][name]) for name, column in columns.items())
    assert {**before, "columns": None} == {**after, "columns": None}


@pytest.mark.parametrize("unit", SPEEDS)
def test_units_change_labels_and_never_the_drawing(unit: str) -> None:
    for view in ("period", "energy", "limits"):
        one, other = (Phugoid(unit=name, view=view).shown for name in ("ft/s", unit))
        for name, axis in one.axes.items():
            ends = [(each.start, each.end) for each in (axis, other.axes[name])]
            assert ends[0] == pytest.approx(ends[1], rel=1e-12), name
        assert other.axes["v"].ruler.labels[-1].split()[-1] == unit


def test_cusp_and_loop_are_drawn_without_a_break() -> None:
    for excess in (np.nextafter(CUSP_EXCESS, 0), CUSP_EXCESS, np.nextafter(CUSP_EXCESS, 1), 0.74):
        scene = Phugoid(excess=float(excess))
        path = scene.sources["path"].data
        step = np.hypot(np.diff(path["x"]), np.diff(path["y"]))
        assert step.max() < 0.1 * scene.v_0**2 / scene.g
        assert path["y"].max() == pytest.approx(0.5 * scene.v_0**2 / scene.g, rel=0.05)


def test_an_aircraft_points_along_its_path() -> None:
    """The nose of each drawing is along the velocity: by differences of where it is drawn."""
    shown = Phugoid(excess=0.3).shown
    end, h = shown.axes["t"].place(shown.axes["t"].end), 1e-4
    for t in np.array([0.02, 0.3, 0.7]) * end:
        now, (before, after) = played(shown, t), (played(shown, t + way * h * end) for way in (-1, 1))
        for of in ("", "_lin"):
            forward, up = (after[name + of] - before[name + of] for name in "xy")
            assert now["w" + of] / now["u" + of] == pytest.approx(up / forward, rel=1e-4)


def test_lift_is_upright_to_the_path() -> None:
    shown = Phugoid(view="lift", excess=0.3).shown
    for share in (0.0, 0.3, 0.7):
        now = played(shown, share * shown.axes["t"].place(shown.axes["t"].end))
        assert now["lift_forward"] * now["u"] + now["lift_up"] * now["w"] == pytest.approx(0, abs=1e-12)
        assert math.hypot(now["lift_forward"], now["lift_up"]) == pytest.approx(now["lift"], rel=1e-4)
