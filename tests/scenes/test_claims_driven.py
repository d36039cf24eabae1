"""Each sentence on driven masses and on the absorber is true for random parameters."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from components.scenes.absorber import Absorber
from components.scenes.forced import Forced
from physics.coupled import TwoMassChain
from physics.forced import forced_motion
from tests.grids import WHOLE
from tests.scenes.chains import chain, matrix, number, squares, starts
from tests.scenes.visible_sentences import Draw, visible_text

DRAWS = 200 if WHOLE else 80


def amplitudes(scene: Any) -> list[Any] | None:
    """Xp1, Xp2 by elimination in 40 digits, or None if they do not exist."""
    A = matrix(scene, mp.mpf(scene.omega) ** 2)
    D = mp.det(A)
    return [-scene.F_0 * A[1, 1] / D, scene.F_0 * A[0, 1] / D] if D else None


def system(scene: Any) -> TwoMassChain:
    return TwoMassChain(m1=scene.m1, m2=scene.m2, k1=scene.k1, k2=scene.k2)


def largest(scene: Any, i: int, t: float) -> float:
    """The largest swing of mass i (0, 1) around the time t, from rest: over twenty periods of the drive before it."""
    times = t - 2 * math.pi / scene.omega * np.linspace(0, 20, 801)
    return float(np.abs(forced_motion(system(scene), scene.F_0, scene.omega, times[times >= 0]).x[i]).max())


def driven(draw: Draw) -> Forced:
    values = chain(draw, 0.15)
    scene = Forced(view="formulas", **values)
    kind, j = draw.pick.choice(("far", "near", "at", "none")), draw.pick.choice((0, 1))
    omega = draw.size() if kind == "far" else float(mp.sqrt(squares(scene)[j])) if kind != "none" else 0.0
    omega *= 1 + draw.number(-8, -3) * (kind == "near")
    still = draw.pick.random() < 0.4
    start = {f"{q}{n}_0": 0.0 if still else draw.some(draw.number()) for q in "xv" for n in (1, 2)}
    scene.set({"F_0": draw.some(draw.size()), "omega": omega, **start})
    return scene


def test_what_is_said_of_the_particular_solution() -> None:
    draw, seen = Draw("forced"), set()
    for _ in range(2 * DRAWS):
        scene = driven(draw)
        steady, text, values = scene.shown.forms["steady"], visible_text(scene), scene.shown.values
        seen.add(steady)
        v = forced_motion(system(scene), scene.F_0, scene.omega, np.linspace(0, 7, 9), *starts(scene)).v
        assert (steady == "rest") == (not v.any()) == ("Nothing moves" in text)
        assert ("No drive" in text) == (not scene.F_0 * scene.omega and steady != "rest")
        X = amplitudes(scene)
        if steady in ("finite", "loose") and not (X is None and scene.k2 == 0):
            assert X is not None
            assert [number(values[f"Xp{i}"]) for i in (1, 2)] == pytest.approx([float(x) for x in X], rel=6e-3)
        if steady == "finite":
            still = mp.sqrt(mp.mpf(scene.k2) / scene.m2)
            assert number(values["mark_still"]) == pytest.approx(float(still), rel=6e-3)
            assert abs(matrix(scene, still**2)[1, 1]) < mp.mpf(10) ** -30 * scene.k2, (
                "Xp1 is 0, spring 2 alone holds mass 2"
            )
        assert ("is a wall for" in "".join(text)) == (steady == "finite")
        if steady in ("resonance", "near"):
            assert scene.F_0 and scene.omega
            off = min(abs(mp.sqrt(s) - scene.omega) for s in squares(scene)) / scene.omega
            assert off <= (2.0**-52 if steady == "resonance" else 1e-3 / (2 * math.pi) * 1.01)
    assert seen == {"finite", "loose", "none", "idle", "rest", "resonance", "near"}


def machines(draw: Draw, i: int) -> Absorber:
    """A machine of any size, its absorber tuned, almost tuned, at a resonance, or not."""
    m1, k1 = draw.size(-2, 3), draw.size(0, 6)
    own = math.sqrt(k1 / m1)
    values = {"own": True, "m1": m1, "k1": k1, "F_0": draw.size(), "m2": m1 * draw.size(-3, 1)}
    omega = own * draw.size(-3, 1) if i % 3 else own * draw.size(-0.3, 0.3)
    tuned = values["m2"] * omega**2
    k2 = {0: tuned, 1: tuned * (1 + draw.number(-7, -3)), 2: k1 * draw.size(-3, 1)}[i % 4 % 3]
    scene = Absorber(**values, omega=omega)
    if i % 4 == 0:
        return scene
    if i % 7 == 0:  # at, or next to, a resonance
        slow, fast = TwoMassChain(m1=m1, m2=values["m2"], k1=k1, k2=k2).modes().omega
        omega = draw.pick.choice((slow, fast)) * (1 + draw.some(draw.number(-9, -5)))
    if i % 11 == 0:  # a heavy mass 2 on a stiff spring, some way above the frequency of both as one block
        scene.set({"m2": 10 * m1})
        k2, omega = k1 * draw.size(2, 3), own * math.sqrt(draw.pick.uniform(1.58, 1.68) / 11)
    scene.set({"omega": float(omega), "k2": k2, "tuning": "free"})
    return scene


def test_every_verdict_on_the_absorber_is_decided_by_what_it_says() -> None:
    draw, seen = Draw("absorber"), set()
    for i in range(3 * DRAWS):
        scene = machines(draw, i)
        why = scene.shown.forms["why"]
        seen.add(why)
        X, alone = amplitudes(scene), mp.mpf(scene.F_0) / abs(scene.k1 - scene.m1 * mp.mpf(scene.omega) ** 2)
        resonances = [mp.sqrt(square) for square in squares(scene)]
        near = min(abs(w / scene.omega - 1) for w in resonances)
        if why in ("grow", "beat", "aside"):
            check_growth(scene, why, float(near))
            continue
        assert X is not None
        check_verdict(scene, why, abs(X[0]), scene.k2 * (X[1] - X[0]), alone, float(near))
    assert seen - {"own", "little"} == set(
        ["still", "almost", "same", "less", "more", "adds", "over", "grow", "beat", "aside"]
    )


def check_verdict(scene: Absorber, why: str, swing: Any, pull: Any, alone: Any, near: float) -> None:
    """Away from a resonance: the machine's swing, with the absorber and alone, and the pull of spring 2."""
    same = scene.shown.values["swing"] == scene.shown.values["alone"]
    match why:
        case "still":
            assert abs(scene.m2 * mp.mpf(scene.omega) ** 2 / scene.k2 - 1) < 1e-15
        case "almost":
            assert abs(scene.F_0 + pull) <= 0.0101 * scene.F_0 and swing > 0
        case "same":
            assert abs(swing / alone - 1) <= 0.0101
        case "less":
            assert swing < alone and -2 * scene.F_0 < pull < 0
            assert not (same and scene.shown.values["swing"] != "0.00")
        case "own" | "little":
            assert swing < alone and abs(scene.F_0 + pull) <= 0.011 * scene.F_0
        case "more":
            assert swing > alone and near < 0.2
        case "adds":
            assert swing > alone and near >= 0.2 and pull > 0
        case "over":
            assert swing > alone and near >= 0.2 and pull < -2 * scene.F_0
        case _:
            raise AssertionError(why)


def check_growth(scene: Absorber, why: str, near: float) -> None:
    """At or next to a resonance: over a time in which the beat has not turned, who grows and who stays."""
    assert near < 1.7e-4
    late = 1 / max(near, 1e-12) / scene.omega
    i = 1 if why == "aside" else 0
    half, whole = (largest(scene, i, t) for t in (late / 2, late))
    assert whole > 1.25 * half, (why, half, whole)
    if why == "aside":
        told = number(scene.shown.values["rest1"]) * 10.0 ** scene.shown.axes["X1"].exponent
        assert largest(scene, 0, late) <= 1.006 * told


@pytest.mark.parametrize("omega", [5.0, 30.0, 48.0, 49.0, 50.0, 60.0])
@pytest.mark.parametrize("m2", [1e-9, 1e-6, 1e-4, 1e-3, 2.5e-3])
def test_a_tuned_absorber_however_light_grows_as_is_said(omega: float, m2: float) -> None:
    """The lightest solutions that somebody types: at 48 rad/s the machine swings as if it were alone from the first."""
    scene = Absorber(omega=omega, m2=m2)
    why = scene.shown.forms["why"]
    if why in ("grow", "beat", "aside"):
        check_growth(scene, why, min(abs(float(mp.sqrt(square) / scene.omega) - 1) for square in squares(scene)))
    else:
        assert why == "still" and m2 >= 1e-4


def test_within_an_ulp_of_a_resonance_that_hardly_moves_the_machine_it_is_not_said_to_grow() -> None:
    """As long as doubles resolve the phase, the motion stays within the stated bound; mass 2 goes much farther."""
    ulps = 0
    for omega in (1e-6, *np.geomspace(1e-9, 1e-4, 60).tolist()):
        scene = Absorber(omega=omega)
        ulps += min(abs(mp.sqrt(square) / scene.omega - 1) for square in squares(scene)) < 2.0**-53
        assert scene.shown.forms["why"] in ("aside", "still"), omega
        late = 1e14 / omega
        told = number(scene.shown.values["rest1"]) * 10.0 ** scene.shown.axes["X1"].exponent
        assert largest(scene, 0, late) <= 1.006 * told, omega
        assert largest(scene, 1, late) > 10 * largest(scene, 0, late), omega
    assert ulps > 10
