"""The driven mass: its sentences and its polygon over random parameters, its presets, its powers and its limits."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.layout.sheet import blocks
from components.scene import Scene
from components.scenes import SCENES
from components.scenes.driven.case import LEFT, RIGHT
from components.scenes.driven.forces import BASE, PX
from physics.bode import driven_resonances
from physics.driven import Drive, DrivenOscillator
from physics.magnification import highest, magnification
from tests.grids import tries
from tests.page.scripts import each
from tests.scenes.chains import number
from tests.scenes.presets import readout, taken
from tests.scenes.visible_sentences import read, visible_text

DRIVEN = SCENES["driven"]
KINDS = ("force", "base", "unbalance")
SIZES = {"force": "F_0", "base": "Y", "unbalance": "moment"}


def sentence(scene: Scene) -> str:
    texts = (item for block in blocks(DRIVEN.sheet()) for item in getattr(block, "items", ()))
    (variants,) = (item.variants for item in texts if item.name == "holds")
    return read(scene, variants[scene.shown.forms["holds"]])


def corners(scene: Scene) -> dict[str, float]:
    """The numbers of the polygon of the forces."""
    return {name.removeprefix("polygon_"): one for name, one in scene.shown.scalars.items() if "polygon" in name}


def steady(scene: Any) -> complex:
    """X, from the linear equation."""
    size, w = getattr(scene, SIZES[scene.kind]), scene.omega
    force = {"force": size, "base": complex(scene.k, scene.c * w) * size, "unbalance": size * w * w}[scene.kind]
    return complex(force / complex(scene.k - scene.m * w * w, scene.c * w))


def forces(scene: Any) -> tuple[complex, complex, complex, complex]:
    """Spring, dashpot, inertia and push of the steady swing."""
    X, w = steady(scene), scene.omega
    return (
        scene.k * X,
        1j * scene.c * w * X,
        -scene.m * w * w * X,
        scene.k * X + 1j * scene.c * w * X - scene.m * w * w * X,
    )


@pytest.mark.parametrize("zeta", [0.0, 0.05, 1.0])
@pytest.mark.parametrize("beside", [-9e-4, -1e-5, 0.0, 1e-5, 4e-4, 9e-4])
def test_it_swings_as_far_as_its_base_only_where_its_number_says_so(zeta: float, beside: float) -> None:
    scene = DRIVEN(kind="base", zeta=zeta, omega=(math.sqrt(2.0) + beside) * math.sqrt(39.48))
    assert ("as far as its base" in sentence(scene)) == (scene.shown.values["M"] == "1.00"), sentence(scene)


@pytest.mark.parametrize("values", [{"window": 1e-3}, {"c": 0.0, "omega": 6.2895}, {"c": 1e-9, "omega": 6.2833}])
def test_parts_that_are_not_drawn_are_far_larger_than_their_sum(values: dict[str, float]) -> None:
    """However small they are: in a short window from rest the sum is smaller still."""
    scene = DRIVEN(**values)
    (told,) = (note for note in scene.shown.notes if "not drawn" in note)
    assert "far larger than their sum" in told
    assert abs(steady(scene)) > 4 * np.abs(scene.sources["time"].data["x"]).max()


SOME = st.floats(-1.0, 1.0).map(lambda power: 10.0**power)


@settings(max_examples=tries(100), deadline=None)
@given(st.sampled_from(KINDS), SOME, SOME, st.floats(0.05, 2.4), st.floats(0.01, 40))
def test_its_sentence_is_true(kind: str, m: float, k: float, r: float, zeta: float) -> None:
    scene = DRIVEN(kind=kind, m=m, k=k, zeta=zeta, omega=r * math.sqrt(k / m))
    told, (spring, dashpot, inertia, push) = sentence(scene), forces(scene)
    if kind == "base":
        more = abs(steady(scene)) / scene.Y
        stronger = abs(magnification(r, 1.1 * zeta, "base")[0])
        assert told.startswith("Below √2") == (r < math.sqrt(2.0) - 1e-3) and (more > 1) == (r < math.sqrt(2.0))
        assert (stronger < more) == (r < math.sqrt(2.0))
        return
    along = abs(spring + inertia)
    if "spring balances" in told or "inertia balances" in told:
        assert along >= abs(dashpot) and ("spring" in told) == (abs(spring) > abs(inertia))
    else:
        assert "dashpot" in told and abs(dashpot) >= along
        assert ("At resonance" in told) == ("alone" in told) == (along < 0.02 * min(abs(dashpot), abs(spring)))
    assert abs(push) == pytest.approx(math.hypot(along, abs(dashpot)))


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
        assert lag % (2 * math.pi) == pytest.approx(readout(scene, "phi"), abs=1e-9)
    first = abs(steady(scene)) * (scene.m / scene.moment if kind == "unbalance" else scene.k / scene.F_0)
    assert at["up"] == pytest.approx(abs(steady(scene)) / scene.Y if kind == "base" else first)


@pytest.mark.parametrize("kind", KINDS)
def test_on_a_phone_it_is_drawn_within_its_stage(kind: str) -> None:
    """No part of it, including its circle, overlaps the formulas below; a label fits above its highest arrow."""
    height, names = 260.0, {"wide": 0, "narrow": 1, "W": 358, "H": 260, "response.y0": 0, "response.y1": 0}
    for r, zeta in itertools.product((0.05, 0.5, 0.9, 1.0, 1.4, 2.4), (0.01, 0.2, 1.0, 1.5)):
        scene = DRIVEN(kind=kind, zeta=zeta, omega=r * math.sqrt(39.48))
        at, named = corners(scene), {**scene.shown.scalars, **names}
        tail, push = each("static/core/signals.polynomial", ((one, named) for one in (BASE, PX)))
        unit = push * at["scale"]
        assert tail + unit * max(1.0, -at["end"]) < height, (r, zeta)
        assert tail - unit * max(at["up"], at["end"]) > 18, (r, zeta)


def test_the_presets_are_as_they_say() -> None:
    def size(label: str) -> float:
        return float(
            abs(magnification(taken("driven", label).value.omega / math.sqrt(39.48), taken("driven", label).zeta)[0])
        )

    assert size("Below") == pytest.approx(1.72, abs=5e-3) and size("Resonance") == pytest.approx(2.5, abs=5e-3)
    assert 0.49 * size("Below") == pytest.approx(0.842, abs=2e-3) and 4 * size("Above") == pytest.approx(1.29, abs=5e-3)
    assert readout(taken("driven", "Below"), "phi") == pytest.approx(0.502, abs=1e-3)
    assert readout(taken("driven", "Above"), "phi") == pytest.approx(2.88, abs=5e-3)
    assert size("Strong dashpot") == pytest.approx(0.625, abs=5e-4) and highest(0.8) is None
    beats = taken("driven", "Beats")
    x = beats.shown.sources["time"]["x"]
    assert abs(steady(beats)) == pytest.approx(0.267, abs=5e-4)
    assert np.abs(x).max() == pytest.approx(0.505, abs=3e-3)
    assert 2 * math.pi / (math.sqrt(39.48) - beats.omega) == pytest.approx(10.0, abs=0.01)
    for zeta, ratio in ((0.2, 0.704), (1.0, 0.942), (0.05, 0.646)):
        assert abs(magnification(1.6, zeta, "base")[0]) == pytest.approx(ratio, abs=5e-4)
    assert abs(magnification(1.5, 0.2, "unbalance")[0]) == pytest.approx(1.62, abs=5e-3)
    assert highest(0.2, "unbalance") == pytest.approx((1.04, 2.55), abs=5e-3)


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


@pytest.mark.parametrize("omega", [0.01, 0.05, 0.1, 0.2])
def test_the_quasi_static_limit_is_seen(omega: float) -> None:
    """So slow a push is followed at once: from a tenth of the window on x is a line, the static one to 1 %."""
    scene = DRIVEN(omega=omega)
    t, low, high = shown_x(scene)
    later, static = t > 0.1 * scene.shown.axes["t"].end, scene.F_0 / scene.k
    assert np.array_equal(low[later], high[later]), "a line"
    np.testing.assert_allclose(low[later], static * np.sin(omega * t[later]), atol=0.02 * static)
    rings = np.any(low != high)
    assert rings == any(note.startswith("At first x rings") for note in scene.shown.notes)
    assert not any(note.startswith("The motion is too fast") for note in scene.shown.notes)
    assert "x" in DRIVEN(omega=1e6).shown.traces["time"].names, "what is too fast is too small to be seen"


@settings(max_examples=tries(200), deadline=None)
@given(st.sampled_from(KINDS), st.sampled_from([-1, 1]), st.floats(-17, -1), st.booleans())
def test_next_to_resonance_it_says_how_it_grows_at_first_and_how_far(
    kind: str, side: int, power: float, started: bool
) -> None:
    scene = DRIVEN(
        kind=kind, omega=math.sqrt(39.48) * (1 + side * 10**power), c=0.0, x_0=0.1 * started, view="formulas"
    )
    told, forms = sentence(scene), scene.shown.forms
    one = DrivenOscillator(m=scene.m, c=0.0, k=scene.k)
    exactly = one.at_resonance(scene.omega)
    assert (forms["size"] == "grows") == exactly and ("no steady size" in visible_text(scene)) == exactly
    if "grow" not in told and "adds" not in told:
        return
    assert ("at first" in told or "At first" in told) == (forms["size"] == "nearly") == (not exactly)
    if not exactly:
        size = abs(one.response(scene.omega, getattr(scene, SIZES[kind]), kind))
        assert readout(scene, "X") == size and f"X={scene.shown.values['X']}" in "".join(visible_text(scene).split())
    growth, period = number(scene.shown.values["growth"]), 2 * math.pi / scene.omega
    swings = np.linspace(0, 6 * period, 6000)
    x = one.motion(scene.omega, getattr(scene, SIZES[kind]), t=swings, kind=kind).x
    tops = [np.abs(x[1000 * i : 1000 * (i + 1)]).max() for i in range(6)]
    assert np.diff(tops)[1:] == pytest.approx(growth, rel=0.02)


@settings(max_examples=tries(100), deadline=None)
@given(st.floats(0.021, 0.59), SOME)
def test_both_points_of_half_power_lie_on_the_power_at_one_height(zeta: float, m: float) -> None:
    scene = DRIVEN(zeta=zeta, m=m)
    at, axes, data = scene.shown.scalars, scene.shown.axes, scene.sources["below"].data
    width = axes["r"].end / axes["r"].place(axes["r"].end) * (at["half_high"] - at["half_low"])
    assert width == pytest.approx(2 * scene.value.zeta * math.sqrt(scene.k / scene.m), rel=1e-9)
    r = np.array([at["half_low"], at["half_high"]]) * axes["r"].factor * math.sqrt(scene.m / scene.k)
    M = np.abs(magnification(r, scene.value.zeta))
    assert axes["M"].place(0.25 / scene.value.zeta) == pytest.approx(at["half_peak"])
    np.testing.assert_allclose(2 * scene.value.zeta * (r * M) ** 2, 0.25 / scene.value.zeta, rtol=1e-9)
    share = data["power"] * 2 * scene.value.zeta
    lost = (np.asarray(data["omega"]) * np.asarray(data["M"])) ** 2
    np.testing.assert_allclose(share, lost * (scene.m / scene.k) * (2 * scene.value.zeta) ** 2, rtol=1e-9)
    assert share.max() == pytest.approx(1.0, rel=1e-6)


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
