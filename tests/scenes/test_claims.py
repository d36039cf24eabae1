"""Sentences of the scenes are true in any state, by an independent computation: one law over a table of claims.

Each check gets a scene, the form of its sentence that is visible, and its words. All forms of a sentence are seen.
"""

import itertools
import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from components.chain import of_scene
from components.scenes import SCENES
from components.scenes.modes.hunt import FOUND
from physics.coupled import TwoMassChain, free_modes, free_motion
from physics.damped import DampedOscillator
from physics.forced import forced_motion
from tests.grids import sample
from tests.physics.truth import steady
from tests.scenes.checks import SIZES, harmonics, in_any_state, modes_of, number, numbers, said, wordings

Check = Callable[[Any, str, str], object]
ULP = 2.0**-52
ROUNDING = 1e-13


def oscillator_arrow(s: Any, form: str, text: str) -> None:
    still = not s.v_0 and not (s.k and s.x_0)
    assert ("nothing moves" in text) == still and (form == "drift") == (not s.k and s.v_0 != 0)
    if form in ("right", "wrong", "zero"):
        turn = s.x_0 * math.sqrt(s.k / s.m)
        same = s.v_0 != 0 and math.isclose(math.atan(turn / s.v_0), math.atan2(turn, s.v_0), abs_tol=1e-12)
        assert (form == "right") == same and (form == "zero") == (s.v_0 == 0)


def energies(s: Any, form: str, text: str) -> None:
    """The largest energies, from a period of the motion."""
    w, delta = math.sqrt(s.k / s.m), s.m * s.g / s.k
    turn = np.linspace(0.0, 2 * math.pi, 4001)
    x = s.x_0 * np.cos(turn) + s.v_0 / w * np.sin(turn)
    T = s.m * (s.v_0 * np.cos(turn) - w * s.x_0 * np.sin(turn)) ** 2 / 2
    V = s.k * (x + delta) ** 2 / 2 - s.m * s.g * x
    moves = bool(s.x_0 or s.v_0)
    assert ("Nothing moves" in text) == (not moves)
    assert ("are one" in text) == (form == "weightless") == (s.datum == "separate" and not s.g and moves)
    if form == "separate":
        assert V.max() - T.max() == pytest.approx(s.k * delta**2 / 2, rel=1e-3, abs=2e-6 * T.max())
    if form == "equilibrium":
        assert s.k * np.abs(x).max() ** 2 / 2 == pytest.approx(T.max(), rel=1e-5)


def end_of_damped(s: Any, form: str, text: str) -> None:
    """The end of a damped motion; test_numbers compares the times in its sentence."""
    if not s.k or not (s.x_0 or s.v_0) or not s.c:
        spring = "plain" if s.x_0 or s.v_0 else "rest"
        assert form == (spring if s.k else "still" if not s.v_0 else "glide" if s.c else "drift")
        return
    zeta, told = s.c / (2 * math.sqrt(s.m * s.k)), numbers(text)
    if form in ("swing", "hardly"):
        delta = 2 * math.pi * zeta / math.sqrt(1 - zeta**2)
        assert zeta < 1 and ("all but" in text) == (form == "swing" and delta < 0.005)
        if form == "hardly":
            assert told[0] == pytest.approx(100 * math.exp(-delta / 2), rel=0.02)
            return
        kept = [-math.expm1(-n * delta) if "all but" in text else math.exp(-n * delta) for n in (1, 2)]
        longer = math.expm1(-0.5 * math.log1p(-(zeta**2)))
        assert told == pytest.approx([100 * one for one in (*kept, longer)], rel=6e-3)
        return
    assert zeta > 1 - 1e-5
    root = math.sqrt(max(zeta**2 - 1, 0.0)) if abs(zeta - 1) > 1e-6 else 0.0
    thrown = -s.v_0 * math.copysign(1, s.x_0) / (abs(s.x_0) * math.sqrt(s.k / s.m)) if s.x_0 else math.nan
    if abs(thrown / (zeta + root) - 1) > 1e-5:  # closer to it, rounding decides
        assert (form == "crosses") == (thrown > zeta + root)
    assert (form == "never") == (not s.x_0) and (form == "out") == (thrown < 0)
    assert form != "thrice" or not s.v_0


def largest_power(s: Any, form: str, text: str) -> None:
    """The power is largest before x = 0 on its way there, but not close to it."""
    if not (s.c and s.k) or not (s.x_0 or s.v_0):
        return
    rates = (s.c + math.sqrt(abs(s.c**2 - 4 * s.m * s.k))) / s.m + math.sqrt(s.k / s.m)
    t = np.linspace(0.0, 40.0 / rates, 20_001)
    motion = DampedOscillator(m=s.m, c=s.c, k=s.k).motion(s.x_0, s.v_0, t)
    top = int(np.argmax(np.abs(motion.v)))
    assert (form == "at_start") == (top == 0) or top == 1
    zeta = s.c / (2 * math.sqrt(s.m * s.k))
    assert (form != "fastest" or zeta > 0.9) and (form != "before" or zeta < 1.1)
    if form == "before" and zeta < 0.9:
        assert motion.x[top] * motion.v[top] < 0 and (motion.x[top:] * motion.x[top] < 0).any()


def balance(s: Any, form: str, text: str) -> None:
    """Which force balances the push of a sine, in the steady motion."""
    impulsive = s.kind == "force" and s.push.startswith("impulse")
    size, once = s.J if impulsive else getattr(s, SIZES[s.kind]), s.kind == "force" and s.push in ("step", "impulse")
    if not size or not (s.omega or once):
        assert form == ("idle" if s.omega else "still") and ("No push" in text) == (form == "idle")
        return
    if s.kind == "force" and s.push != "sine":
        assert form == ("once" if once else "others")
        return
    r, zeta = s.omega / math.sqrt(s.k / s.m), s.c / (2 * math.sqrt(s.m * s.k))
    spring, dashpot = abs((1 - r) * (1 + r)), 2 * zeta * r
    if form.startswith(("grows", "nearly", "near")):
        assert not s.c and abs(r - 1) < 0.02 and (form == "near" or form.endswith("_on") == bool(s.x_0 or s.v_0))
    elif s.kind == "base":
        more = math.hypot(1, dashpot) / math.hypot(spring, dashpot)
        assert ("as far as its base" in text) == (form == "alike") <= (s.shown.values["M"] == "1.00")
        assert form == "alike" or (form == "more") == (more > 1) == (r < math.sqrt(2))
        assert (form == "isolated") == (r > math.sqrt(2) and not s.c and form != "alike")
    elif form in ("spring", "inertia"):
        assert dashpot <= spring and form in text and (form == "spring") == (r < 1)
    else:
        assert dashpot >= spring and (form == "alone") == ("alone" in text) == (spring < 0.02 * min(dashpot, 1.0))


def harmonic_at_peak(s: Any, form: str, text: str) -> None:
    if form in ("sine", "idle", "once", "grows"):
        assert ("does not repeat" in text) == (form == "once") and (form == "grows") <= (not s.c)
        return
    r, zeta = s.omega / math.sqrt(s.k / s.m), s.c / (2 * math.sqrt(s.m * s.k))
    found, at = int(s.numbers["strongest"].value), s.numbers.get("on_peak")
    f, X = harmonics(s, max(400, found + 2))
    assert f"armonic {found} " in text
    if s.c or abs(found * r - 1) > 1e-9:  # closer to a resonance without a dashpot, doubles lose its digits
        assert X[found - 1] == pytest.approx(np.max(np.where(f > 1e-12 * f[0], X, 0.0)), rel=1e-6)
        assert s.numbers["X_strongest"].value == pytest.approx(X[found - 1], rel=1e-6)
    if at is None:
        assert form == ("wide" if zeta > 0.35 else "between")
        return
    n, top = int(at.value), math.sqrt(max(1 - 2 * zeta**2, 0.0))
    below = math.hypot(1 - (n * r) ** 2, 2 * zeta * n * r)
    assert abs(n * r - top) < 0.021 or 0.7 * below <= 2 * zeta * math.sqrt(1 - zeta**2)
    f, _ = harmonics(s, n + 1)
    assert (form == "missing") == (f[n - 1] < 1e-12 * f[0]) and (form == "hit") == (n == found and form != "missing")


def matrix(s: Any, square: Any) -> mp.matrix:
    """The matrix of the equations of both amplitudes, for a squared frequency."""
    m1, m2, k1, k2 = (mp.mpf(getattr(s, name)) for name in ("m1", "m2", "k1", "k2"))
    return mp.matrix([[m1 * square - k1 - k2, k2], [k2, m2 * square - k2]])


def squares(s: Any) -> list[Any]:
    """Both squared natural frequencies."""
    return [omega**2 for omega in modes_of(s).omega]


def starts(s: Any) -> tuple[list[float], list[float]]:
    return [s.x1_0, s.x2_0], [getattr(s, "v1_0", 0.0), getattr(s, "v2_0", 0.0)]


def sizes(s: Any) -> Any:
    """The amplitudes of both modes (2, 2 masses)."""
    return np.abs(free_modes(of_scene(s), *starts(s)).amplitude)


def beats(s: Any, form: str, text: str) -> None:
    slow, fast = (float(mp.sqrt(square)) for square in squares(s))
    moved = free_motion(of_scene(s), *starts(s), np.linspace(0.0, 7.0, 9)).v
    assert (form == "rest") == (not np.any(moved)) == ("Nothing moves" in text)
    assert (form == "both") == ("Beat period" in text) and (form != "drift" or not (s.k1 and s.k2))
    if form == "both":
        assert number(text.removeprefix("Beat period ").removesuffix(" s")) == pytest.approx(
            2 * math.pi / (fast - slow), rel=6e-3
        )
    if form in ("both", "apart"):
        assert (fast - slow <= 0.2 * (fast + slow) * (1 + 1e-9)) == (form == "both")
        found = sizes(s)
        assert np.max(found.min(axis=0) / found.max(axis=0)) > 0.99e-3


def found_line(s: Any, form: str, text: str) -> None:
    """The path fills the parallelogram of both modes: its width decides, not what is drawn of it."""
    size = sizes(s)
    slow, fast = (float(np.hypot(*row)) for row in size)
    most = max(slow, fast) or 1.0
    lesser = min(slow, fast) / most
    width = abs(np.linalg.det(size * [[1, 1], [1, -1 if s.k1 and s.k2 else 1]])) / most**2
    path = s.shown.sources["path"]
    match form:
        case "slow" | "fast":
            assert max(lesser, width) <= FOUND * (1 + 1e-6) and (slow > fast) == (form == "slow")
        case "thin":
            assert lesser > FOUND * (1 - 1e-6) and width <= FOUND * (1 + 1e-6)
        case "mixed":
            assert width > FOUND * (1 - 1e-6)
        case "drift":
            start = math.hypot(s.x1_0, s.x2_0)
            centred = np.array([path["x1"] - path["x1"].mean(), path["x2"] - path["x2"].mean()])
            off = np.linalg.svd(centred, compute_uv=False)[1]
            assert not (s.k1 and s.k2) and off < 1e-9 * np.abs(centred).max() * len(path["x1"]) + ROUNDING * start
        case _:
            assert form == "rest" and not np.ptp(path["x1"])


def both_rows(s: Any, form: str, text: str) -> None:
    both, at = squares(s), mp.mpf(s.omega) ** 2
    off = [abs(mp.sqrt(square) - s.omega) for square in both]
    is_mode = [d <= math.ulp(s.omega) for d in off]
    if form.startswith("same"):
        j = ("same_slow", "same_fast").index(form)
        A = matrix(s, both[j])
        assert is_mode[j] and s.k2
        assert abs(mp.det(A)) <= mp.mpf(10) ** -25 * max(abs(A[0, 0] * A[1, 1]), abs(A[0, 1] ** 2))
        assert s.shown.values["row1"] == s.shown.values["row2"]
    elif form in ("alone_1", "alone_2", "every"):
        A = matrix(s, both[form == "alone_1"])
        alone = {"alone_1": ((1, 0),), "alone_2": ((0, 1),), "every": ((1, 0), (0, 1))}[form]
        assert all(mp.norm(A * mp.matrix(shape)) <= mp.mpf(10) ** -30 * (1 + mp.norm(A)) for shape in alone)
        assert not s.k2 and any(is_mode) and (form == "every") == (mp.norm(A) < mp.mpf(10) ** -30)
    elif form.startswith("near"):
        A = matrix(s, at)
        rows = -A[0, 0] / A[0, 1], -A[1, 0] / A[1, 1]
        assert abs(rows[0] - rows[1]) <= 0.0101 * max(map(abs, rows)) and min(off) <= 1.01e-3 * s.omega
    else:
        assert not any(is_mode) and abs(mp.det(matrix(s, at))) > 0, "only rest obeys both"


def force_of_hand(s: Any, *_: str) -> None:
    square, r = mp.mpf(s.omega) ** 2, mp.mpf(s.ratio)
    missing = [abs(value) for value in matrix(s, square) * mp.matrix([1, r])]
    terms = [max(s.m1 * square, abs(s.k2 * (r - 1) - s.k1)), max(s.m2 * square * abs(r), abs(s.k2 * (r - 1)))]
    share = max(miss / size if size else mp.mpf(bool(miss)) for miss, size in zip(missing, terms, strict=True))
    match s.shown.values["you_add"]:
        case "no extra force: a mode":
            assert any(abs(mp.sqrt(one) - s.omega) <= math.ulp(s.omega) for one in squares(s)) or share <= 1e-11
        case "almost no extra force":
            assert share <= 0.00501
        case told:
            assert told == "force of your hand" and share > 0.00499


def root_below_b(s: Any, form: str, text: str) -> None:
    m1, m2, k1, k2 = (mp.mpf(getattr(s, name)) for name in ("m1", "m2", "k1", "k2"))
    b = m1 * k2 + m2 * (k1 + k2)
    gap = b - mp.sqrt(b**2 - 4 * m1 * m2 * k1 * k2)
    assert form == ("wall" if gap > 0 else "zero")
    assert not gap or number(s.shown.values["gap"]) == pytest.approx(float(gap), rel=6e-3)


LIMITS: dict[str, Callable[..., tuple[float, float, float, float]]] = {
    "apart": lambda m1, m2, k1, k2: (math.sqrt(k2 / m2), k1 / k2, math.sqrt(k1 / m1), -m1 * k2 / (m2 * k1)),
    "rigid": lambda m1, m2, k1, k2: (math.sqrt(k1 / (m1 + m2)), 1, math.sqrt(k2 * (1 / m1 + 1 / m2)), -m1 / m2),
    "series": lambda m1, m2, k1, k2: (
        math.sqrt(k1 * k2 / ((k1 + k2) * m2)), 1 + k1 / k2, math.sqrt((k1 + k2) / m1), -m1 * k2 / (m2 * (k1 + k2))
    ),
    "stand": lambda m1, m2, k1, k2: (math.sqrt(k1 / m1), 1, math.sqrt(k2 / m2), -m1 / m2),
    "free": lambda m1, m2, k1, k2: (0, 1, math.sqrt(k2 * (1 / m1 + 1 / m2)), -m1 / m2),
    "loose": lambda m1, m2, k1, k2: (0, math.inf, math.sqrt(k1 / m1), 0),
}  # fmt: skip
"""The formulas in the texts of each limit of a sweep: omega_-, its X2/X1, omega_+, its X2/X1."""


def limit_of_sweep(power: int, s: Any, form: str, text: str) -> None:
    far = s.at({**s.values, s.swept: 10.0**power})
    slow, slow_ratio, fast, fast_ratio = LIMITS[form](far.m1, far.m2, far.k1, far.k2)
    found = squares(far)
    both = [float(mp.sqrt(square)) for square in found]
    assert both == pytest.approx([slow, fast], rel=1e-3, abs=1e-9 * both[1]), s.swept
    if form != "loose":
        shapes = [float(-matrix(far, one)[0, 0] / matrix(far, one)[0, 1]) for one in found]
        assert shapes == pytest.approx([slow_ratio, fast_ratio], rel=1e-3), s.swept


def steady_of(s: Any) -> Any:
    """Xp1, Xp2 without dashpots, or None if they do not exist."""
    return steady(*(mp.mpf(getattr(s, name)) for name in ("m1", "m2", "k1", "k2", "F_0", "omega")))


def particular_solution(s: Any, form: str, text: str) -> None:
    told = s.shown.values
    assert (form == "braked") == bool((s.c1 or s.c2) and s.F_0 and s.omega) or form == "rest"
    if s.c1 or s.c2:
        return
    v = forced_motion(of_scene(s), s.F_0, s.omega, np.linspace(0, 7, 9), *starts(s)).v
    assert (form == "rest") == (not v.any()) == ("Nothing moves" in text)
    assert ("No drive" in text) == (not s.F_0 * s.omega and form != "rest")
    assert ("is a wall for" in text) == (form == "finite")
    X = steady_of(s)
    if form in ("finite", "loose") and not (X is None and s.k2 == 0):
        assert X and [number(told[f"Xp{i}"]) for i in (1, 2)] == pytest.approx([float(x) for x in X], rel=6e-3)
    if form == "finite":
        assert number(told["mark_still"]) == pytest.approx(math.sqrt(s.k2 / s.m2), rel=6e-3)
    if s.F_0 and s.omega and s.k2:
        off = min(abs(mp.sqrt(square) - s.omega) for square in squares(s))
        assert (form == "resonance") == (off <= math.ulp(s.omega))
        assert form != "near" or off <= 1e-3 / (2 * math.pi) * 1.01 * s.omega
        assert form != "resonance" or (told["D"], told["Xp1"]) == ("0.00", "+∞")


def verdict_on_absorber(s: Any, form: str, text: str) -> None:
    """Away from a resonance by the machine's swing, with the absorber and alone, and the pull of spring 2."""
    dashpot = s.c if s.damping == "added" else 0.0
    attached = s.tuning != "detached" and bool(s.k2 or dashpot)
    assert (form == "detached") == (not attached) and (form == "damped") == bool(attached and dashpot)
    if form in ("damped", "detached"):
        return
    resonances = [mp.sqrt(square) for square in squares(s)]
    near = float(min(abs(w / s.omega - 1) for w in resonances))
    if form in ("grow", "beat", "aside"):
        check_growth(s, form, near)
        return
    X = steady_of(s)
    assert X is not None
    swing, pull, shown = abs(X[0]), s.k2 * (X[1] - X[0]), s.shown.values
    stiff = abs(s.k1 - s.m1 * mp.mpf(s.omega) ** 2)
    alone = mp.mpf(s.F_0) / stiff if stiff else mp.inf
    hardly_left = swing < alone and abs(s.F_0 + pull) <= 0.011 * s.F_0
    told_apart = shown["swing"] != shown["alone"] or shown["swing"] == "0.00"
    true = {
        "still": lambda: abs(s.m2 * mp.mpf(s.omega) ** 2 / s.k2 - 1) < 1e-15,
        "almost": lambda: abs(s.F_0 + pull) <= 0.0101 * s.F_0 and swing > 0,
        "same": lambda: abs(swing / alone - 1) <= 0.0101,
        "less": lambda: swing < alone and -2 * s.F_0 < pull < 0 and told_apart,
        "own": lambda: hardly_left,
        "little": lambda: hardly_left,
        "more": lambda: swing > alone and near < 0.2,
        "adds": lambda: swing > alone and near >= 0.2 and pull > 0,
        "over": lambda: swing > alone and near >= 0.2 and pull < -2 * s.F_0,
    }
    assert true[form](), form


def largest(s: Any, i: int, t: float) -> float:
    """The largest swing of mass i (0, 1) around the time t, from rest: over twenty periods of the drive before it."""
    times = t - 2 * math.pi / s.omega * np.linspace(0, 20, 801)
    return float(np.abs(forced_motion(of_scene(s), s.F_0, s.omega, times[times >= 0]).x[i]).max())


def check_growth(s: Any, form: str, near: float) -> None:
    """At or next to a resonance: over a time in which the beat has not turned, who grows and who stays."""
    assert near < 1.7e-4
    late = 1 / max(near, 1e-12) / s.omega
    i = 1 if form == "aside" else 0
    half, whole = (largest(s, i, t) for t in (late / 2, late))
    assert whole > 1.25 * half, (form, half, whole)
    if form == "aside":
        told = number(s.shown.values["rest1"]) * 10.0 ** s.shown.axes["X1"].exponent
        assert largest(s, 0, late) <= 1.006 * told


def machines() -> Iterator[dict[str, Any]]:
    """A machine with an absorber that is tuned, almost tuned or not, driven next to its own frequency, far from it, and
    at a resonance.
    """
    offs = (0.0, 1e-9, 1e-6, -1e-4, 1e-2, 0.5)
    for share, pace, off in itertools.product((1e-3, 0.16, 10.0), (0.1, 0.38, 0.8, 1.0, 1.2), offs):
        omega, m2 = 50.0 * pace, 100.0 * share
        yield {"omega": omega, "m2": m2, "k2": m2 * omega**2 * (1 + off)}
        yield {"omega": omega, "m2": m2, "k2": 250e3 * (1 + off) * 200}
        slow, fast = TwoMassChain(m1=100, m2=m2, k1=250e3, k2=m2 * omega**2).modes().omega.tolist()
        yield from ({"omega": one * (1 + off), "m2": m2, "k2": m2 * omega**2} for one in (slow, fast))


def pushes() -> Iterator[dict[str, Any]]:
    """Pushes whose harmonics are on the peak of the response, next to it, or have none there."""
    for push, n, off, zeta in itertools.product(
        ("square", "triangle", "pulses", "impulses"), (1, 3, 5), (0.0, 0.01, 0.2), (0.0, 0.01, 0.2, 0.6)
    ):
        yield {"push": push, "m": 1.0, "k": 36.0, "omega": 6.0 / n * (1 + off), "zeta": zeta, "keep": "zeta"}


NEARLY_CRITICAL = [
    {"zeta": 1 + off, "keep": "zeta", "x_0": 0.1, "v_0": -0.1 * share * math.sqrt(39.48)}
    for off in (-9e-7, -3.6e-8, 0.0, 5e-7)
    for share in (0.0, 0.1, 0.9, 0.999, 1.01, 3.0)
]
WEAK = [{"zeta": 10.0**power, "keep": "zeta"} for power in range(-12, 0)]
RESONANT = [
    {"kind": kind, "c": 0.0, "x_0": x_0, "omega": math.sqrt(39.48) * (1 + off)}
    for kind in SIZES
    for x_0 in (0.0, 0.1)
    for off in (0.0, 1e-12, -1e-6, 1e-3, 1e-2)
]
AT_ROOT = [{"kind": "base", "omega": omega, "c": c} for omega in (math.sqrt(78.96), 10.0) for c in (0.0, 1.0)]
LINES = [{"x1_0": 1.0, "x2_0": ratio * (1 + off)} for ratio in (2.0, -1.0) for off in (0.0, 1e-6, 1e-3, 1e-2, 0.1)]
THIN = {"m1": 1e6, "k1": 1e6, "m2": 1.0, "k2": 1.0, "x1_0": 0.0, "x2_0": 1.0}
ENDS = [
    {"keep": "zeta", "zeta": 0.95},
    *({"k": 0.0, "c": c, "v_0": v_0} for c in (0.0, 1.0) for v_0 in (0.0, 1.0)),
    *({"x_0": x_0, "v_0": v_0, "c": 40.0} for x_0 in (0.0, 0.1) for v_0 in (0.0, 1.0)),
]
IDLE = [{"F_0": 0.0}, {"omega": 0.0}, {"push": "step"}, {"keep": "zeta", "zeta": 0.3, "omega": 6.9}]
DATUMS = [
    {"datum": datum, "g": g, "x_0": x_0} for datum in ("separate", "slide") for g in (0.0, 9.81) for x_0 in (0, 0.1)
]
MODES_ALONE = [{"k2": 0.0, "omega": omega} for omega in (0.0, 2**0.5)] + [{"k1": 0.0, "k2": 0.0, "omega": 0.0}]
AT_MODES = [{"omega": omega} for omega in (1.0, 2.0, 1.0001, 2.0002, 2**0.5)]
SWEEPS = [{"swept": name, **without} for name in ("m1", "m2", "k1", "k2") for without in ({}, {"k1": 0.0}, {"k2": 0.0})]
DRIVES = [{"F_0": F_0, "omega": omega, "x1_0": x1_0} for F_0, omega in ((0, 1), (1, 0)) for x1_0 in (0.0, 0.1)]
GOLDEN = (math.sqrt(5) - 1) / 2
NEXT = [{"omega": math.nextafter(omega, end)} for omega in (GOLDEN, 1 + GOLDEN) for end in (0.0, omega, 2.0)]
"""A resonance between two doubles: only these two are at most an ulp away."""
MACHINES = [
    *({"own": True, "tuning": "free", **one} for one in machines()),
    *({"damping": "added"}, {"tuning": "detached"}),
    *({"omega": omega, "m2": m2} for omega in (5.0, 48.0, 49.0, 50.0) for m2 in (1e-9, 1e-4, 2.5e-3)),
    *({"omega": omega} for omega in (1e-9, 1e-6, 3e-5)),
]
"""The lightest absorbers that somebody types: at 48 rad/s the machine swings as if it were alone from the first."""
NOT_DRAWN = {"near"}
"""The sentence about a driven mass whose response overflows next to a resonance, but not at it."""
CLAIMS: list[tuple[str, str, str, Check, list[dict[str, Any]]]] = [
    ("oscillator", "why", "motion", oscillator_arrow, [{"k": 0.0, "v_0": 0.0}]),
    ("energy", "claim", "energy", energies, DATUMS),
    ("damped", "said", "motion", end_of_damped, [*NEARLY_CRITICAL, *WEAK, *ENDS]),
    ("damped", "fastest", "energy", largest_power, [{"v_0": 2.0, "zeta": 0.306, "keep": "zeta"}, *ENDS]),
    ("driven", "holds", "response", balance, [*RESONANT, *AT_ROOT, *IDLE]),
    ("driven", "meets", "harmonics", harmonic_at_peak, [*sample(list(pushes()), 3), *IDLE]),
    ("coupled", "beat", "motion", beats, [{"x1_0": 0.0}]),
    ("modes", "verdict", "hunt", found_line, [*LINES, THIN, {"x1_0": 0.0, "x2_0": 0.0}]),
    ("modes", "agree", "guess", both_rows, [*MODES_ALONE, *AT_MODES]),
    ("modes", "", "guess", force_of_hand, []),
    ("modes", "below", "solve", root_below_b, []),
    *(("modes", end, "sweep", partial(limit_of_sweep, at), SWEEPS) for end, at in (("low", -14), ("high", 14))),
    ("forced", "steady", "formulas", particular_solution, [*DRIVES, *NEXT, {"k2": 0.0}]),
    ("absorber", "why", "goals", verdict_on_absorber, MACHINES),
]
"""A scene, a sentence, a view that shows it, its check, and states that have all its forms, with the presets."""


@pytest.mark.parametrize(("slug", "name", "view", "check", "rare"), CLAIMS, ids=lambda one: str(one)[:20])
def test_what_is_said_is_true_in_any_state(
    slug: str, name: str, view: str, check: Check, rare: list[dict[str, Any]]
) -> None:
    kind, seen = SCENES[slug], set[str]()

    def told(scene: Any) -> tuple[str, str]:
        return (scene.shown.forms[name], said(scene, name)) if name else ("", "")

    def compare(scene: Any, form_and_text: tuple[str, str]) -> None:
        seen.add(form_and_text[0])
        with mp.workdps(40):
            check(scene, *form_and_text)

    in_any_state(kind, told, compare, 120, rare=rare, view=view)
    assert not wordings(kind, name) - seen - NOT_DRAWN
