"""Scene modes through its callbacks: four views of one chain."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from components.controls import apply_message
from components.scenes import SCENES
from components.scenes.modes import VIEWS, Modes
from components.url import read_query, write_query
from tests.scene_checks import check_picture

views = pytest.mark.parametrize("task", VIEWS)
GOLDEN = (math.sqrt(5) - 1) / 2


# Guess


def test_the_guess_of_the_mockup() -> None:
    values = Modes().shown.values
    assert [values[name] for name in ("a11", "a12", "a22", "D", "square")] == [
        "−0.220",
        "2.00",
        "0.890",
        "−4.20",
        "2.89",
    ]
    assert [values[name] for name in ("row1", "row2", "apart")] == ["+0.110", "−2.25", "2.36"]
    assert [values[f"{row}{i}_N"] for row in ("need", "give", "add") for i in (1, 2)] == [
        "−5.78 N",
        "+2.31 N",
        "−7.60 N",
        "+3.60 N",
        "+1.82 N",
        "−1.29 N",
    ]
    assert (values["omega_slow"], values["omega_fast"]) == ("1.00", "2.00")
    assert (values["r_slow"], values["r_fast"]) == ("+2.00", "−1.00")
    assert (values["k1k2"], values["k2k2"]) == ("8.00", "−4.00")


def test_curves_cross_at_the_modes_and_D_vanishes_there() -> None:
    scene = Modes()
    det = scene.sources["det"].data
    signs = np.flatnonzero(np.diff(np.sign(det["D"])))
    np.testing.assert_allclose(det["w"][signs], [1.0, 2.0], atol=0.02)
    np.testing.assert_allclose(det["D"], 2 * det["w"] ** 4 - 10 * det["w"] ** 2 + 8, atol=1e-12)
    line, below, above = (scene.sources[name].data for name in ("row1", "row2_below", "row2_above"))
    straight = np.poly1d(np.polyfit(line["w"] ** 2, line["row1"], 1))
    for branch, name, square, ratio in ((below, "row2_below", 1.0, 2.0), (above, "row2_above", 4.0, -1.0)):
        gap = branch[name] - straight(branch["w"] ** 2)
        crossing = np.interp(0.0, gap, branch["w"] ** 2)
        assert crossing == pytest.approx(square, abs=0.01)
        assert straight(crossing) == pytest.approx(ratio, abs=0.01)


@pytest.mark.parametrize(("mode", "omega", "ratio"), [("slow", 1.0, 2.0), ("fast", 2.0, -1.0)])
def test_at_a_mode_the_rows_are_one_equation_and_nothing_is_to_be_added(mode: str, omega: float, ratio: float) -> None:
    shown = Modes(omega=omega, ratio=ratio).shown
    assert shown.forms["agree"] == f"same_{mode}"
    assert shown.values["D"] == "0.00"
    assert [shown.values[f"add{i}_N"] for i in (1, 2)] == ["+0.00 N", "+0.00 N"]
    assert shown.values["you_add"] == "nothing: a mode"


def test_the_flag_leads_to_a_mode_that_no_double_holds() -> None:
    """m1 = m2, k1 = k2: the golden ratio. The flag sets the nearest double, and the buttons its shape."""
    scene = Modes()
    scene.set(Modes.presets["Equal (slide 8)"])
    assert scene.shown.scalars["w_slow_si"] == pytest.approx(GOLDEN, rel=1e-15)
    scene.omega = scene.shown.scalars["w_slow_si"]
    assert scene.shown.forms["agree"] == "same_slow"
    assert apply_message(scene, {"type": "act", "name": "row1"}) == {}
    assert scene.ratio == pytest.approx(1 / GOLDEN, rel=1e-14)
    assert scene.shown.values["add2_N"] == "+0.00 N"


def test_nearly_a_mode_is_said_to_be_near() -> None:
    shown = Modes(omega=1.0005).shown
    assert shown.forms["agree"] == "near_slow"
    assert shown.values["you_add"] == "what you must add"


def test_names_of_known_values_give_way_to_the_number_at_the_guess() -> None:
    assert Modes().shown.scalars["D0_clear"] == Modes().shown.scalars["held_clear"] == 1
    assert Modes(m2=0.05).shown.scalars["D0_clear"] == 0
    assert Modes(omega=1.5).shown.scalars["held_clear"] == 0


def test_as_a_mass_wants_takes_its_force_away() -> None:
    for i in (1, 2):
        scene = Modes()
        assert apply_message(scene, {"type": "act", "name": f"row{i}"}) == {}
        assert scene.shown.values[f"add{i}_N"] == "+0.00 N"
        assert scene.shown.values[f"add{3 - i}_N"] != "+0.00 N"


def test_no_ratio_says_that_mass_1_rests() -> None:
    scene = Modes(k2=1.0, omega=1.0)
    assert scene.shown.forms["row2"] == "pole"
    errors = apply_message(scene, {"type": "act", "name": "row2"})
    assert "X₁ = 0" in errors["action"]
    assert scene.ratio == -0.8


def test_the_longest_arrow_fits_and_their_lengths_are_the_forces() -> None:
    scalars = Modes(omega=0.7, ratio=3.0).shown.scalars
    arrows = np.array([scalars[f"{row}{i}"] for i in (1, 2) for row in ("need", "give")])
    forces = np.array([-2 * 0.49 / 3, -4 / 3 + 2 * (1 - 1 / 3), -0.49, -2 * (1 - 1 / 3)])
    np.testing.assert_allclose(arrows, 0.17 * forces / np.abs(forces).max(), rtol=1e-12, atol=1e-15)


def test_a_moving_guess_swings_at_the_trial_frequency() -> None:
    shown = Modes(instant="moving").shown
    _, omega, phase = shown.signals["x2"]["sines"][0]
    assert (omega * 10 ** -shown.axes["t"].exponent, phase) == (1.7, math.pi / 2)
    assert "t" not in Modes().shown.axes


# Solve


def test_the_lectures_numbers() -> None:
    values = Modes(task="solve").shown.values
    assert [values[n] for n in ("m1m2", "b", "k1k2_", "Delta", "root", "difference", "coupling")] == [
        "2.00",
        "10.0",
        "8.00",
        "36.0",
        "6.00",
        "−2.00",
        "32.0",
    ]
    assert [values[n] for n in ("gamma", "delta", "slow_ratio", "fast_ratio", "product")] == [
        "−0.500",
        "1.50",
        "+2.00",
        "−1.00",
        "−2.00",
    ]


def test_arrows_of_a_mode_turn_together_or_opposite() -> None:
    signals = Modes(task="solve").shown.signals
    for mode, sign in (("slow", 1), ("fast", -1)):
        one, two = (signals[f"x{i}_{mode}"]["sines"][0] for i in (1, 2))
        assert one[1:] == two[1:]
        assert math.copysign(1, two[0] / one[0]) == sign


def test_no_wall_is_said() -> None:
    shown = Modes(task="solve", k1=0.0).shown
    assert shown.forms["below"] == "zero"
    assert shown.values["slow_omega"] == "0.00"


# Sweep


@pytest.mark.parametrize("swept", ["m1", "m2", "k1", "k2"])
def test_a_sweep_passes_through_the_chain(swept: str) -> None:
    scene = Modes(task="sweep", swept=swept)
    run = scene.sources["omega_sweep"].data
    assert np.log10(run["p"][-1] / run["p"][0]) == pytest.approx(6)
    now = getattr(scene, swept)
    for mode, omega in (("slow", 1.0), ("fast", 2.0)):
        between = np.exp(np.interp(np.log(now), np.log(run["p"]), np.log(run[f"omega_{mode}"])))
        assert between == pytest.approx(omega, rel=1e-3)
    ratios = scene.sources["ratio_sweep"].data
    mass_ratio = (ratios["p"] if swept == "m1" else 2.0) / (ratios["p"] if swept == "m2" else 1.0)
    np.testing.assert_allclose(ratios["ratio_slow"] * ratios["ratio_fast"], mass_ratio, rtol=1e-12)


def test_asymptotes_are_met_at_the_ends() -> None:
    scene = Modes(task="sweep")
    run, low, high = (scene.sources[f"omega_{part}"].data for part in ("sweep", "low", "high"))
    for mode in ("slow", "fast"):
        assert low[f"omega_{mode}"][0] == pytest.approx(run[f"omega_{mode}"][0], rel=1e-3)
        assert high[f"omega_{mode}"][-1] == pytest.approx(run[f"omega_{mode}"][-1], rel=2e-3)
    assert (scene.shown.forms["low"], scene.shown.forms["high"]) == ("apart", "rigid")


def test_the_held_frequencies_cross_where_the_lecture_says() -> None:
    """m1 k2 = m2 (k1 + k2): 2 k2 = 4 + k2."""
    shown = Modes(task="sweep").shown
    assert 10 ** shown.scalars["cross"] == pytest.approx(4.0, rel=1e-3)


def test_without_coupling_there_are_no_ratios_to_draw() -> None:
    scene = Modes(task="sweep", k2=0.0, swept="m1")
    assert scene.sources["ratio_sweep"].data == {}
    assert scene.shown.forms["low"] == "apart"


# Hunt


def test_the_path_is_the_motion() -> None:
    scene = Modes(task="hunt", k2=3.0, x2_0=-0.4)
    data = scene.sources["path"].data

    def rates(_: float, y: np.ndarray) -> list[float]:
        x1, x2, v1, v2 = y
        pull = 3.0 * (x2 - x1)
        return [v1, v2, (-4.0 * x1 + pull) / 2.0, -pull]

    motion = solve_ivp(rates, (0, data["t"][-1]), [1.0, -0.4, 0, 0], "DOP853", data["t"], rtol=1e-12, atol=1e-12).y
    np.testing.assert_allclose([data["x1"], data["x2"]], motion[:2], atol=1e-8)


@pytest.mark.parametrize(
    ("start", "verdict"),
    [
        ((1, 2), "slow"),
        ((-0.5, -1), "slow"),
        ((1, 1.96), "slow"),
        ((1, -1), "fast"),
        ((1, 0.5), "mixed"),
        ((1, 1.8), "mixed"),
        ((0, 0), "rest"),
    ],
)
def test_a_straight_line_is_marked(start: tuple[float, float], verdict: str) -> None:
    scene = Modes(task="hunt", x1_0=start[0], x2_0=start[1])
    assert scene.shown.forms["verdict"] == verdict
    path = scene.sources["path"].data
    if verdict in ("slow", "fast"):
        width, length = np.linalg.svd(np.array([path["x1"], path["x2"]]), compute_uv=False)[::-1]
        assert width < 0.05 * length


def test_shares_are_told() -> None:
    values = Modes(task="hunt", x1_0=1.0, x2_0=0.0).shown.values
    assert (values["share_slow"], values["share_fast"]) == ("11.1 %", "88.9 %")


def test_the_answer_is_nowhere_before_it_is_asked_for() -> None:
    scene = Modes(task="hunt")
    shown = scene.shown
    assert scene.sources["answer"].data == {}
    assert shown.forms["answer"] == ""
    assert not {name for name in shown.values if name.startswith(("answer", "omega", "r_"))}
    scene.answer = "shown"
    assert (scene.shown.values["answer_slow"], scene.shown.values["answer_fast"]) == ("+2.00", "−1.00")
    line = scene.sources["answer"].data
    np.testing.assert_allclose(line["slow2"] / line["slow1"], 2.0)
    np.testing.assert_allclose(line["fast2"] / line["fast1"], -1.0)


def test_every_start_is_a_line_where_a_spring_is_missing() -> None:
    for missing in ("k1", "k2"):
        assert Modes(task="hunt", **{missing: 0.0}).shown.forms["verdict"] == "drift"


# All views


@views
def test_presets_in_every_view(task: str) -> None:
    scene = Modes(task=task)
    for label in scene.presets:
        assert apply_message(scene, {"type": "preset", "label": label}) == {}
        assert (scene.preset(), scene.task) == (label, task)
        check_picture(scene)


@views
def test_one_solve_for_a_change_of_view(task: str) -> None:
    scene = Modes(task="solve" if task == "guess" else "guess")
    pictures: list[object] = []
    scene.on_picture(pictures.append)
    assert apply_message(scene, {"type": "choose", "name": "task", "value": task}) == {}
    assert len(pictures) == 1
    assert scene.shown.forms[task] == "shown"


@views
def test_a_link_brings_back_the_view(task: str) -> None:
    scene = Modes(task=task, k1=0.3, omega=0.4, ratio=7.0, swept="m1", x2_0=-0.2, instant="moving")
    query = write_query(scene)
    link = read_query({k: [v.encode()] for k, v in (pair.split("=") for pair in query.split("&"))}, SCENES)
    assert link.problems == []
    again = Modes()
    again.set(link.values)
    assert again.param.values() | {"name": ""} == scene.param.values() | {"name": ""}


@views
def test_bad_input_leaves_the_view_as_it_was(task: str) -> None:
    scene = Modes(task=task)
    before = scene.shown
    for name, text in (("m1", "0"), ("k2", "-1"), ("ratio", "inf"), ("omega", "-2"), ("x1_0", "far")):
        assert list(apply_message(scene, {"type": "typed", "name": name, "text": text})) == [name]
    assert apply_message(scene, {"type": "choose", "name": "swept", "value": "omega"})
    assert scene.shown is before


@views
def test_corners_are_drawn_or_refused_in_words(task: str) -> None:
    """Any combination of values that physics allows."""
    pick = random.Random(task)
    sizes = (1e-300, 1e-150, 1e-12, 1.0, 1e12, 1e150, 1e300)
    drawn = 0
    for _ in range(60):
        values = {name: pick.choice(sizes) for name in ("m1", "m2")}
        values |= {name: pick.choice((0.0, *sizes)) for name in ("k1", "k2", "omega", "x1_0", "x2_0")}
        choices = {"swept": pick.choice(("m1", "m2", "k1", "k2")), "instant": pick.choice(("full", "moving"))}
        scene = Modes()
        try:
            scene.set(
                {
                    **values,
                    **choices,
                    "ratio": pick.choice((-1, 1)) * pick.choice(sizes),
                    "answer": "shown",
                    "task": task,
                }
            )
        except ValueError as reason:
            assert "range of doubles" in str(reason)
            continue
        drawn += 1
        check_picture(scene)
    assert drawn > 20
