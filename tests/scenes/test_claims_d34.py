"""Each sentence of the scenes of D34 is true for random parameters, by an independent computation."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from components.scenes.coupled import Coupled
from components.scenes.modes import ModesScene
from components.scenes.modes.hunt import FOUND
from physics.coupled import TwoMassChain, free_motion
from tests.grids import WHOLE
from tests.scenes.chains import chain, matrix, number, squares, starts
from tests.scenes.visible_sentences import Draw, visible_text

DRAWS = 150 if WHOLE else 60


def test_what_is_said_of_beats() -> None:
    draw, seen = Draw("beats"), set()
    for i in range(DRAWS):
        values = chain(draw, 0.1)
        if i % 3 == 0 and values["k1"] and values["k2"]:  # a light mass tuned to a heavy one
            values |= {"m2": draw.size(-4, -1) * values["m1"]}
            values |= {"k2": values["k1"] * values["m2"] / values["m1"]}
        still = draw.pick.random() < 0.15
        start = {f"{q}{n}_0": 0.0 if still else draw.some(draw.number()) for q in "xv" for n in (1, 2)}
        scene = Coupled(**values, **start)
        beat, period = scene.shown.forms["beat"], scene.shown.values["beat_period"]
        seen.add(beat)
        slow, fast = (float(mp.sqrt(square)) for square in squares(scene))
        moved = free_motion(TwoMassChain(**values), *starts(scene), np.linspace(0.0, 7.0, 9)).v
        assert (beat == "rest") == (not np.any(moved)) == ("Nothing moves" in visible_text(scene))
        assert (period == "none") == (beat != "both")
        if beat == "both":
            assert number(period.removesuffix(" s")) == pytest.approx(2 * math.pi / (fast - slow), rel=6e-3)
        if beat in ("both", "apart"):
            assert (fast - slow <= 0.2 * (fast + slow) * (1 + 1e-9)) == (beat == "both")
            amplitude = amplitudes(scene)
            assert np.max(amplitude.min(axis=0) / amplitude.max(axis=0)) > 0.99e-3
        if beat == "drift":
            assert not (scene.k1 and scene.k2)
    assert seen >= {"both", "apart", "drift", "rest"}
    assert "Nothing moves" in visible_text(Coupled(x1_0=0.0))
    assert Coupled(m1=1.0, m2=1.0, k1=1.0, k2=1e12).shown.forms["beat"] == "apart"
    for label in ("Slow", "Fast"):
        assert Coupled(**Coupled.presets[label]).shown.forms["beat"] == "one"


def amplitudes(scene: Any) -> np.ndarray:
    """Of both modes (2, 2 masses), by mass-weighted eigenvectors in float64."""
    root = np.sqrt([scene.m1, scene.m2])
    K = np.array([[scene.k1 + scene.k2, -scene.k2], [-scene.k2, scene.k2]]) / np.outer(root, root)
    squared, vectors = np.linalg.eigh(K)
    x, v = (np.array(part) * root for part in starts(scene))
    omega = np.sqrt(np.maximum(squared, 0.0))
    rates = np.divide(vectors.T @ v, omega, out=np.zeros(2), where=omega > 1e-6 * omega[1])
    sizes = np.where(omega > 1e-6 * omega[1], np.hypot(vectors.T @ x, rates), 0.0)
    return np.abs(vectors.T * sizes[:, None] / root)


def test_a_line_is_found_where_the_path_is_one_and_one_mode_alone_swings() -> None:
    """The path fills the parallelogram of both modes; the drawn time does not affect its measured width."""
    draw, seen = Draw("hunt"), set()
    for i in range(300):
        values = chain(draw, 0.05)
        scene = ModesScene(view="hunt", **values)
        ratios = mode_ratios(values)
        start = (draw.some(draw.number(-1, 1), 0.1), draw.some(draw.number(-1, 1), 0.1))
        if i % 2 and ratios:
            start = (1.0, draw.pick.choice(ratios) * (1 + draw.number(-4, 0)))
        scene.set({"x1_0": start[0], "x2_0": start[1]})
        verdict = scene.shown.forms["verdict"]
        seen.add(verdict)
        size = amplitudes(ModesScene(**values, x1_0=start[0], x2_0=start[1]))
        signs = np.array([[1, 1], [1, 1 if not ratios else -1]])
        slow, fast = (float(np.hypot(*row)) for row in size)
        ways = size * signs
        width = abs(np.linalg.det(ways)) / max(slow, fast) ** 2 if max(slow, fast) else 0.0
        lesser = min(slow, fast) / max(slow, fast) if max(slow, fast) else 0.0
        if verdict in ("slow", "fast"):
            assert lesser <= FOUND * (1 + 1e-6) and width <= FOUND * (1 + 1e-6) and (slow > fast) == (verdict == "slow")
        elif verdict == "thin":
            assert lesser > FOUND * (1 - 1e-6) and width <= FOUND * (1 + 1e-6)
        elif verdict == "mixed":
            assert width > FOUND * (1 - 1e-6)
        elif verdict == "drift":
            path = scene.sources["path"].data
            centred = np.array([path["x1"] - path["x1"].mean(), path["x2"] - path["x2"].mean()])
            assert np.linalg.svd(centred, compute_uv=False)[1] < 1e-9 * np.abs(centred).max() * len(path["x1"])
        else:
            assert verdict == "rest" and not np.ptp(scene.sources["path"].data["x1"])
    assert seen == {"slow", "fast", "mixed", "thin", "drift", "rest"}


def mode_ratios(values: dict[str, float]) -> list[float]:
    if not (values["k1"] and values["k2"]):
        return []
    gamma = values["m1"] / (2 * values["m2"]) - (values["k1"] + values["k2"]) / (2 * values["k2"])
    delta = math.sqrt(gamma**2 + values["m1"] / values["m2"])
    return [-gamma + delta, -gamma - delta]


def guesses(draw: Draw) -> ModesScene:
    """A chain at, near or far from a mode, with an arbitrary shape or that of a mode."""
    values = chain(draw, 0.2)
    scene = ModesScene(view="guess", **values)
    kind = draw.pick.choice(("at", "near", "far"))
    j = draw.pick.choice((0, 1))
    omega = float(mp.sqrt(squares(scene)[j]))
    if kind == "near":
        omega *= 1 + draw.number(-6, -2.5)
    ratios = mode_ratios(values)
    ratio = ratios[j] if ratios and draw.pick.random() < 0.5 else draw.number()
    scene.set({"omega": draw.size() if kind == "far" else omega, "ratio": ratio})
    return scene


def test_what_is_said_of_both_rows() -> None:
    draw, seen = Draw("rows"), set()
    for _ in range(3 * DRAWS):
        scene = guesses(draw)
        agree = scene.shown.forms["agree"]
        seen.add(agree)
        at = mp.mpf(scene.omega) ** 2
        both = squares(scene)
        off = [abs(mp.sqrt(square) - scene.omega) for square in both]
        one_ulp = [d <= math.ulp(scene.omega) for d in off]
        if agree.startswith("same"):
            j = ("same_slow", "same_fast").index(agree)
            A = matrix(scene, both[j])
            assert one_ulp[j] and scene.k2
            assert abs(mp.det(A)) <= mp.mpf(10) ** -25 * max(abs(A[0, 0] * A[1, 1]), abs(A[0, 1] ** 2))
            assert all(any(abs(entry) > 0 for entry in A[i, :]) for i in (0, 1)), "both are equations"
            assert scene.shown.values["row1"] == scene.shown.values["row2"]
        elif agree in ("alone_1", "alone_2", "every"):
            A = matrix(scene, both[int(agree == "alone_1")])
            alone = {"alone_1": ((1, 0),), "alone_2": ((0, 1),), "every": ((1, 0), (0, 1))}[agree]
            shapes = [mp.matrix(shape) for shape in alone]
            assert all(mp.norm(A * shape) <= mp.mpf(10) ** -30 * (1 + mp.norm(A)) for shape in shapes)
            assert not scene.k2 and any(one_ulp)
            assert (agree == "every") == (mp.norm(A) < mp.mpf(10) ** -30)
        elif agree.startswith("near"):
            A = matrix(scene, at)
            rows = -A[0, 0] / A[0, 1], -A[1, 0] / A[1, 1]
            assert abs(rows[0] - rows[1]) <= 0.0101 * max(map(abs, rows))
            assert min(off) <= 1.01e-3 * scene.omega
        else:
            assert agree in ("apart", "pole")
            assert not any(one_ulp), scene.param.values()
            A = matrix(scene, at)
            assert abs(mp.det(A)) > 0, "only rest obeys both"
    assert seen >= {"same_slow", "same_fast", "alone_1", "alone_2", "every", "near_slow", "near_fast", "apart", "pole"}


def test_what_a_hand_must_add() -> None:
    draw, seen = Draw("hand"), set()
    for _ in range(3 * DRAWS):
        scene = guesses(draw)
        told = scene.shown.values["you_add"]
        seen.add(told)
        square, r = mp.mpf(scene.omega) ** 2, mp.mpf(scene.ratio)
        missing = [abs(value) for value in matrix(scene, square) * mp.matrix([1, r])]
        needed = [scene.m1 * square, scene.m2 * square * abs(r)]
        springs = [abs(scene.k2 * (r - 1) - scene.k1), abs(scene.k2 * (r - 1))]
        sizes = map(max, needed, springs)
        parts = [miss / size if size else mp.mpf(bool(miss)) for miss, size in zip(missing, sizes, strict=True)]
        if told == "no extra force: a mode":
            exact_mode = any(abs(mp.sqrt(s) - scene.omega) <= math.ulp(scene.omega) for s in squares(scene))
            assert exact_mode or max(parts) <= 1e-11
        elif told == "almost no extra force":
            assert max(parts) <= 0.00501
        else:
            assert max(parts) > 0.00499
    assert seen == {"no extra force: a mode", "almost no extra force", "force of your hand"}


def test_the_root_is_below_b_by_a_number_that_is_seen() -> None:
    draw = Draw("solve")
    for i in range(DRAWS):
        values = chain(draw, 0.1) | ({"k2": draw.size(-12, -6)} if i % 3 == 0 else {})
        scene = ModesScene(view="solve", **values)
        m1, m2, k1, k2 = (mp.mpf(values[name]) for name in ("m1", "m2", "k1", "k2"))
        b = m1 * k2 + m2 * (k1 + k2)
        gap = b - mp.sqrt(b**2 - 4 * m1 * m2 * k1 * k2)
        assert scene.shown.forms["below"] == ("wall" if gap > 0 else "zero")
        if gap > 0:
            assert number(scene.shown.values["gap"]) == pytest.approx(float(gap), rel=6e-3)


FORMULAS = {
    "apart": lambda m1, m2, k1, k2: (math.sqrt(k2 / m2), k1 / k2, math.sqrt(k1 / m1), -m1 * k2 / (m2 * k1)),
    "rigid": lambda m1, m2, k1, k2: (math.sqrt(k1 / (m1 + m2)), 1, math.sqrt(k2 * (1 / m1 + 1 / m2)), -m1 / m2),
    "series": lambda m1, m2, k1, k2: (
        math.sqrt(k1 * k2 / ((k1 + k2) * m2)), 1 + k1 / k2, math.sqrt((k1 + k2) / m1), -m1 * k2 / (m2 * (k1 + k2))
    ),
    "stand": lambda m1, m2, k1, k2: (math.sqrt(k1 / m1), 1, math.sqrt(k2 / m2), -m1 / m2),
    "free": lambda m1, m2, k1, k2: (0, 1, math.sqrt(k2 * (1 / m1 + 1 / m2)), -m1 / m2),
    "loose": lambda m1, m2, k1, k2: (0, math.inf, math.sqrt(k1 / m1), 0),
}  # fmt: skip
"""The formulas in the texts of each limit: omega_-, its X2/X1, omega_+, its X2/X1."""


def test_the_limits_of_a_sweep_are_those_of_its_formulas() -> None:
    draw, seen = Draw("sweep"), set()
    for _ in range(DRAWS):
        values = chain(draw, 0.2)
        swept = draw.pick.choice(("m1", "m2", "k1", "k2"))
        scene = ModesScene(view="sweep", swept=swept, **values)
        for end, far in (("low", -1), ("high", 1)):
            kind = scene.shown.forms[end]
            seen.add(kind)
            there = values | {swept: 10.0 ** (far * 14)}
            slow, slow_ratio, fast, fast_ratio = FORMULAS[kind](*(there[name] for name in ("m1", "m2", "k1", "k2")))
            limit = ModesScene(**there)
            both = [float(mp.sqrt(square)) for square in squares(limit)]
            assert both == pytest.approx([slow, fast], rel=1e-3, abs=1e-9 * both[1]), (kind, swept)
            if kind not in ("loose",):
                shapes = [float(-matrix(limit, s)[0, 0] / matrix(limit, s)[0, 1]) for s in squares(limit)]
                assert shapes == pytest.approx([slow_ratio, fast_ratio], rel=1e-3), (kind, swept)
        coupled = bool(values["k2"]) or swept == "k2"
        assert ("mirror each other" in visible_text(scene)) == coupled == ("avoid each other" in visible_text(scene))
    assert seen == FORMULAS.keys()
