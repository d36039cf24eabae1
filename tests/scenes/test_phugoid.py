"""Scene phugoid through its callbacks, against book values and an independent solver."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from components.language.state import Frame
from components.scene.frames import framed
from components.scenes.phugoid import Phugoid
from components.scenes.phugoid.swing import SPEEDS
from physics.phugoid import CUSP_EXCESS, flight, linear_flight
from tests.page.headless_page import picture_wire
from tests.page.scripts import played
from tests.scenes.chains import number

EXCESSES = (0.1, 0.6, 1.0, 2.5, -0.5)


def flown(scene: Phugoid, times: np.ndarray) -> dict[str, np.ndarray]:
    """The flight in SI units by Newton's law: lift m g (V/v_0)^2 square to the path, and weight."""

    def rates(_: float, state: np.ndarray) -> list[float]:
        _, _, u, w = state
        lift = scene.g * math.hypot(u, w) / scene.v_0**2
        return [u, w, -lift * w, lift * u - scene.g]

    speed = scene.v_0 * (1 + scene.excess)
    height = (scene.v_0**2 - speed**2) / (2 * scene.g)
    out = solve_ivp(rates, (0, times[-1]), [0, height, speed, 0], "DOP853", times, rtol=1e-12, atol=1e-9).y
    return {"x": out[0], "h": out[1], "u": out[2], "w": out[3], "v": np.hypot(out[2], out[3]) - scene.v_0}


def test_no_property_of_the_aircraft_but_its_speed_enters() -> None:
    scene = Phugoid()
    before = picture_wire(scene)
    scene.m = 70000.0
    after = picture_wire(scene)
    for source, columns in before["columns"].items():
        for name, column in columns.items():
            assert np.array_equal(column, after["columns"][source][name])
    assert {**before, "columns": None} == {**after, "columns": None}
    scene.v_0 *= 2
    assert scene.shown.values["tau"] == "41.4"


@pytest.mark.parametrize("reach", [50.0, 245.0, 1e4])
def test_the_stage_alone_names_the_level_of_the_flight(reach: float) -> None:
    """Also in a frame that a link or a step of a walk keeps."""
    axes = Phugoid().shown.axes
    kept = framed(Frame(ranges={"up": (-reach, reach)}), axes)["up"]
    for axis in (axes["up"], kept):
        assert axis.ticks and 0 not in axis.ticks and min(axis.ticks) < 0 < max(axis.ticks)


@pytest.mark.parametrize("view", ["period", "energy", "limits"])
def test_units_change_labels_and_never_the_drawing(view: str) -> None:
    def places(unit: str) -> dict[str, np.ndarray]:
        scene = Phugoid(unit=unit, view=view)
        wire, axes = picture_wire(scene), scene.shown.axes
        shares = {}
        for name, axis in (("h", "h"), ("v", "v"), ("t", "t")):
            start, end = (axes[axis].place(value) for value in (axes[axis].start, axes[axis].end))
            shares[name] = (wire["columns"]["time"][name] - start) / (end - start)
        for name, axis in (("x", "along"), ("y", "up")):
            start, end = (axes[axis].place(value) for value in (axes[axis].start, axes[axis].end))
            shares[name] = (wire["columns"]["path"][name] - start) / (end - start)
        return shares

    foot = places("ft/s")
    for unit in SPEEDS:
        for name, share in places(unit).items():
            np.testing.assert_allclose(share, foot[name], atol=2e-6)
    labels = {unit: Phugoid(unit=unit).shown.axes["v"].ruler.labels[-1].split()[-1] for unit in SPEEDS}
    assert labels == {unit: unit for unit in SPEEDS}


@pytest.mark.parametrize("excess", [*EXCESSES, CUSP_EXCESS])
def test_what_the_clock_plays_is_the_flight(excess: float) -> None:
    scene = Phugoid(excess=excess, unit="m/s")
    axes = scene.shown.axes
    times = np.linspace(0, axes["t"].end, 301)
    # At the cusp the speed turns in a corner, which a smooth curve can only cut.
    tolerance = 0.02 if excess == CUSP_EXCESS else 2e-5
    flight, now = flown(scene, times), played(scene.shown, times / 10.0 ** axes["t"].exponent)
    for name, size, unit in (
        ("x", flight["x"], scene.v_0**2 / scene.g),
        ("h", flight["h"], scene.v_0**2 / scene.g),
        ("v", flight["v"], scene.v_0),
        ("u", flight["u"] / scene.v_0, 1.0),
        ("w", flight["w"] / scene.v_0, 1.0),
    ):
        scale = 10.0 ** axes[{"x": "along"}.get(name, name)].exponent if name in "xhv" else 1.0
        np.testing.assert_allclose(now[name] * scale, size, atol=tolerance * unit)


@given(st.floats(-8, -0.83).map(lambda power: 10**power), st.sampled_from((-1, 1)))
def test_the_error_of_the_heights_is_that_of_the_first_period(size: float, sign: int) -> None:
    """It shrinks with the swing: over the first period, next to the amplitude of the linear theory."""
    scene = Phugoid(excess=sign * size)
    verdict = scene.shown.values["verdict"].replace("\xa0", " ")
    if "right to 0.1 %" not in verdict:
        return
    period = next(one.value for one in scene.readouts() if one.name == "tau_exact")
    t = np.linspace(0.0, period, 4001)
    exact, linear = (theory(scene.v_0, scene.g, scene.excess, t).h for theory in (flight, linear_flight))
    off = 100 * np.max(np.abs(exact - linear)) / (scene.v_0**2 / scene.g * size)
    assert number(verdict.split("about ")[1].split(" %")[0]) == pytest.approx(off, rel=0.06)


def test_cusp_and_loop_are_drawn_without_a_break() -> None:
    for excess in (np.nextafter(CUSP_EXCESS, 0), CUSP_EXCESS, np.nextafter(CUSP_EXCESS, 1), 0.74):
        scene = Phugoid(excess=float(excess))
        path = scene.sources["path"].data
        step = np.hypot(np.diff(path["x"]), np.diff(path["y"]))
        assert step.max() < 0.1 * scene.v_0**2 / scene.g
        assert path["y"].max() == pytest.approx(0.5 * scene.v_0**2 / scene.g, rel=0.05)


def test_formulas_are_in_the_unit_that_is_named_also_where_the_axis_counts_thousands() -> None:
    scene = Phugoid(v_0=250.0, unit="ft/s")
    assert scene.shown.axes["h"].exponent == 3
    climb = 0.6 * 250.0**2 / scene.g / 0.3048
    assert float(scene.shown.values["h_size"].replace("−", "-")) == pytest.approx(-climb, rel=5e-3)


def test_lift_is_upright_to_the_path_and_grows_with_the_square_of_the_speed() -> None:
    """du/dt = -V w, dw/dt = V u - 1: over the weight the lift is V (-w, u), to first order 1 + 2 v'/v_0 long."""
    scene = Phugoid(view="lift", excess=0.3)
    time, shown = scene.sources["time"].data, scene.shown
    V = 1 + time["v"] / scene.v_0
    np.testing.assert_allclose(time["lift"], V**2, rtol=1e-12)
    np.testing.assert_allclose(time["lift_linear"], 1 + 2 * time["v"] / scene.v_0, rtol=1e-12)
    for share in (0.0, 0.3, 0.7):
        now = played(shown, share * shown.axes["t"].place(shown.axes["t"].end))
        assert now["lift_forward"] * now["u"] + now["lift_up"] * now["w"] == pytest.approx(0, abs=1e-12)
        assert math.hypot(now["lift_forward"], now["lift_up"]) == pytest.approx(now["lift"], rel=1e-4)
        assert now["lift_linear"] == pytest.approx(2 * math.sqrt(now["lift"]) - 1)
    assert shown.axes["lift"].end > time["lift"].max()
