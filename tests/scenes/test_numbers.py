"""The numbers of the scenes, computed independently: the lecture's formulas in mpmath with many digits.

Each function of `TRUTHS` returns the true values of the numbers of a scene by name, some with the size of the terms
that cancel in it. A name is missing if the physics has no such number for these values, or if the number is computed by
quadrature or root finding that fails there.
"""

import math
import re
from collections.abc import Callable
from operator import attrgetter
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from components.quantities.readouts import SceneNumber
from components.scene import Scene
from components.scenes import SCENES
from physics.analogues import ANALOGUES
from physics.reference.damped import free_part
from tests.physics.truth import Truth as Chain
from tests.physics.truth import steady
from tests.scenes.checks import in_any_state, modes_of
from tests.states import DECADES

Truth = dict[str, Any]
DIGITS = 150
MOST_MASSES = 100
"""The largest chain whose stiffness matrix is diagonalised."""
NEAR = 1e-12
"""The relative distance from a resonance below which doubles do not distinguish the drive from it."""
ROUNDED = 1e-6
"""The relative size of a term that is within rounding errors of a sum: the tolerance is 1e-9."""


def _of(scene: Any, *names: str) -> list[Any]:
    return [mp.mpf(getattr(scene, name)) for name in names]


def oscillator(scene: Any) -> Truth:
    m, k, x, v = _of(scene, "m", "k", "x_0", "v_0")
    if not k:
        return {"drift": v, "top_v": abs(v), "top_a": 0}
    w = mp.sqrt(k / m)
    C = mp.hypot(x, v / w)
    tops = {"top_x": C, "top_v": C * w, "top_a": C * w**2}
    return {"tau": 2 * mp.pi / w, "C": C, "phi": mp.atan2(x, v / w), "drift": 0, **tops}


def energy(scene: Any) -> Truth:
    m, k, g, x, v = _of(scene, "m", "k", "g", "x_0", "v_0")
    w, most = mp.sqrt(k / m), (m * v**2 + k * x**2) / 2
    return {"tau": 2 * mp.pi / w, "delta": m * g / k, "omega_2": 2 * w, "T_max": most, "v_max": mp.sqrt(2 * most / m)}


def damped(scene: Any) -> Truth:
    m, c, k, x, v = _of(scene, "m", "c", "k", "x_0", "v_0")
    root = mp.sqrt(c**2 - 4 * m * k)
    slow, fast = ((c - mp.re(root)) / (2 * m), (c + mp.re(root)) / (2 * m))
    found = {"E_total": (m * v**2 + k * x**2) / 2, "square": k / m, "a": slow, "slow": -slow, "fast": -fast}
    found |= {"rate": c / m, "crossing": fast * abs(x), "glide": abs(v) * m / c if c else mp.inf}
    if not k:
        return found
    w = mp.sqrt(k / m)
    found |= {"omega": w, "zeta": c / (2 * m * w)}
    if turn := mp.im(root) / (2 * m):
        side = (v + slow * x) / turn
        found |= {"omega_d": abs(turn), "tau_d": 2 * mp.pi / turn, "delta": 2 * mp.pi * slow / turn}
        return found | {"C": mp.hypot(x, side), "phi": mp.atan2(x, side)}
    if slow < fast and x:
        A, B = (v + fast * x) / (fast - slow), -(v + slow * x) / (fast - slow)
        found |= {"zero": mp.log(-B / A) / (fast - slow)} if A and B and -B / A > 1 else {}
    return found | {"home": _home(m, c, k, x, v), "home_3": _home(m, 3 * c, k, x, mp.mpf(0))}


def _home(m: Any, c: Any, k: Any, x: Any, v: Any) -> Any:
    """The time after which an overdamped mass is within 1 % of its initial displacement, by bisection."""
    low, high = mp.mpf(0), 100 * c / k + 100 * m / c
    for _ in range(100):
        middle = (low + high) / 2
        there, _ = free_part(mp, m, c, k, x, v, middle)
        low, high = (middle, high) if abs(there) > abs(x) / 100 else (low, middle)
    return low


def driven(scene: Any) -> Truth:
    m, c, k, w = _of(scene, "m", "c", "k", "omega")
    own = mp.sqrt(k / m)
    found: Truth = {"Q": m * own / c if c else mp.inf, "width": c / m}
    roots = mp.sqrt(c**2 - 4 * m * k)
    found |= {"decay": (c - mp.re(roots)) / (2 * m)}
    size = mp.mpf({"force": scene.F_0, "base": scene.Y, "unbalance": scene.moment}[scene.kind])
    push = {"force": size, "base": mp.mpc(k, c * w) * size, "unbalance": size * w**2}[scene.kind]
    if not w:
        return found
    found |= {"growth": mp.pi * abs(push) / (m * w**2), "rate": abs(push) / (2 * m * w)}
    if not c and abs(w / own - 1) < NEAR:
        return found
    X = push / mp.mpc(k - m * w**2, c * w)
    stroke = abs(X - (size if scene.kind == "base" else 0))
    return found | {"X": abs(X), "phi": -mp.arg(X) % (2 * mp.pi), "W": mp.pi * c * w * stroke**2}


def _named(scene: Any, frequencies: tuple[str, str], ratios: tuple[str, str]) -> Truth:
    """The natural frequencies and, if the masses are coupled, X2/X1 of both modes."""
    modes = modes_of(scene)
    found = dict(zip(frequencies, modes.omega, strict=True))
    return found | (dict(zip(ratios, modes.ratio, strict=True)) if scene.k2 else {})


def coupled(scene: Any) -> Truth:
    m1, m2, k1, k2 = _of(scene, "m1", "m2", "k1", "k2")
    x1, x2, v1, v2 = _of(scene, "x1_0", "x2_0", "v1_0", "v2_0")
    found = _named(scene, ("omega_minus", "omega_plus"), ("slow_ratio", "fast_ratio"))
    found["E_total"] = (m1 * v1**2 + m2 * v2**2 + k1 * x1**2 + k2 * (x2 - x1) ** 2) / 2
    modes = modes_of(scene)
    begun = modes.coordinates((x1, x2), (v1, v2))
    for sign, w, ratio, M, one in zip(("minus", "plus"), modes.omega, modes.ratio, modes.mass, begun, strict=True):
        if not k2 or not w:
            continue
        q, rate = one
        X = mp.hypot(q, rate / w)
        # Initial conditions given by modes are rounded, so a small mode has the errors of the sum.
        whole = mp.hypot(m1 * x1, m1 * v1 / w) / M + abs(ratio) * mp.hypot(m2 * x2, m2 * v2 / w) / M
        size = X + ROUNDED * whole
        found |= {f"M_{sign}": M, f"E_{sign}": (M * (rate**2 + w**2 * q**2) / 2, M * w**2 * size**2)}
        found |= {f"X1_{sign}": (X, size), f"X2_{sign}": (ratio * X, abs(ratio) * size)}
        found |= {f"phi_{sign}": (mp.atan2(q, rate / w), size / X)} if X else {}
    return found


def forced(scene: Any) -> Truth:
    m1, m2, k1, k2, F, w, c1, c2 = _of(scene, "m1", "m2", "k1", "k2", "F_0", "omega", "c1", "c2")
    found, modes = _named(scene, ("omega_minus", "omega_plus"), ("ratio_minus", "ratio_plus")), modes_of(scene)
    found |= {"mark_still": mp.sqrt(k2 / m2), "works1": 0, "works2": 0, "work": 0}
    if not (c1 or c2):
        one, two = k1 + k2 - m1 * w**2, k2 - m2 * w**2
        found["D"] = one * two - k2**2, (k1 + k2 + m1 * w**2) * (k2 + m2 * w**2) + k2**2
        if k2:
            j = min((0, 1), key=lambda j: abs(modes.omega[j] - w))
            size = F / (2 * modes.mass[j] * modes.omega[j]) if modes.omega[j] else None
            found |= {f"growth{i}": size * abs(s) for i, s in enumerate(modes.shape[j], 1) if size is not None}
    else:
        found["dies"] = _dies(m1, m2, k1, k2, c1, c2)
    if not w or (any(abs(own / w - 1) < NEAR for own in modes.omega) and not (c1 or c2)):
        return {name: one for name, one in found.items() if name != "D"}
    X1, X2 = steady(m1, m2, k1, k2, F, w, c1, c2)
    if not (c1 or c2):
        return found | {"Xp1": X1, "Xp2": X2}
    found |= {"Xp1": abs(X1), "Xp2": abs(X2), "works1": mp.pi * w * c1 * abs(X1) ** 2}
    found["works2"] = mp.pi * w * c2 * abs(X2 - X1) ** 2
    return found | {"work": found["works1"] + found["works2"], "lag1": mp.arg(X1), "lag2": mp.arg(X2)}


def _dies(m1: Any, m2: Any, k1: Any, k2: Any, c1: Any, c2: Any) -> Any:
    """The time until 1 % is left of the slowest part of a chain with dashpots."""
    square = m1 * k2 + m2 * (k1 + k2) + c1 * c2
    powers = [k1 * k2, c1 * k2 + c2 * k1, square, m1 * c2 + m2 * (c1 + c2), m1 * m2]
    zeros = next(i for i, one in enumerate(powers) if one)
    roots = mp.polyroots(powers[zeros:], maxsteps=500, extraprec=1000, asc=True)
    return mp.inf if zeros else mp.log(100) / min(-mp.re(s) for s in roots)


def modes(scene: Any) -> Truth:
    m1, m2, k1, k2, w, ratio = _of(scene, "m1", "m2", "k1", "k2", "omega", "ratio")
    found = _named(scene, ("omega_slow", "omega_fast"), ("ratio_slow", "ratio_fast"))
    one, two = k1 + k2 - m1 * w**2, k2 - m2 * w**2
    found["D"] = one * two - k2**2, (k1 + k2 + m1 * w**2) * (k2 + m2 * w**2) + k2**2
    if k2:
        found |= {"row1": (one / k2, max(abs(one), k1 + k2) / k2), "gamma": (m1 / m2 - (k1 + k2) / k2) / 2}
        found["delta"] = mp.sqrt(found["gamma"] ** 2 + m1 / m2)
    if abs(two) > NEAR * k2:
        found["row2"] = k2 / two
    X1, X2 = (1, ratio) if abs(ratio) <= 1 else (mp.sign(ratio) / ratio, mp.sign(ratio))
    found["add1_N"] = one * X1 - k2 * X2, abs((k1 + k2 + m1 * w**2) * X1) + abs(k2 * X2)
    found["add2_N"] = two * X2 - k2 * X1, abs((k2 + m2 * w**2) * X2) + abs(k2 * X1)
    return found


def absorber(scene: Any) -> Truth:
    m1, k1, F, w, m2 = _of(scene, "m1", "k1", "F_0", "omega", "m2")
    k2 = mp.mpf(0) if scene.tuning == "detached" else mp.mpf(scene.k2)
    c = mp.mpf(scene.c) if scene.damping == "added" and scene.tuning != "detached" else mp.mpf(0)
    found: Truth = {"mu": m2 / m1, "height": F / k1 * mp.sqrt(1 + 2 * m1 / m2)}
    found["slow"], found["fast"] = Chain(m1, m2, k1, k2).omega
    if c:
        found["dies"] = _dies(m1, m2, k1, k2, mp.mpf(0), c)
    if abs(w**2 * m1 / k1 - 1) > NEAR:
        found["alone"] = abs(F / (k1 - m1 * w**2))
    if c or all(abs(own / w - 1) > NEAR for own in (found["slow"], found["fast"])):
        X1, X2 = steady(m1, m2, k1, k2, F, w, 0, c)
        loose = not k2 and not c
        found |= {"swing": abs(X1), "stroke": 0 if loose else abs(X2 - X1), "pull": m2 * w**2 * abs(X2)}
    return found


def analogues(scene: Any) -> Truth:
    system = ANALOGUES[scene.system]
    tuned = system.at({one.name: getattr(scene, f"{scene.system}_{one.name}") for one in system.parameters})
    w = mp.sqrt(mp.mpf(tuned.stiffness) / mp.mpf(tuned.inertia))
    small = 2 * mp.pi / w
    longer = 1 / mp.agm(1, mp.cos(mp.mpf(math.radians(scene.theta_0)) / 2)) if tuned.pendulum else mp.mpf(1)
    period = small * longer
    return {"omega": w, "small_period": small, "period": period, "frequency": 1 / period, "late": 3 * (period - small)}


def phugoid(scene: Any) -> Truth:
    v, g, excess = _of(scene, "v_0", "g", "excess")
    start = 1 + excess
    C = start - start**3 / 3
    small = mp.sqrt(2) * mp.pi
    return {"gain": excess * v, "omega": mp.sqrt(2) * g / v, "tau": small * v / g, "C": (C, 1)}


def chain(scene: Any) -> Truth:
    m, k, a, N = _of(scene, "m", "k", "a", "N")
    more = {"fixed-fixed": mp.mpf(1), "fixed-free": mp.mpf(1) / 2, "free-free": mp.mpf(0)}[scene.ends]
    own, parts = mp.sqrt(k / m), N + more
    found = {"ceiling": 2 * own, "wave_speed": a * own, "traverse": parts / own, "L": parts * a}
    found |= {"string_slowest": more * own * mp.pi / parts, "string_fastest": own * mp.pi * (N - 1 + more) / parts}
    if scene.starts == "pluck" and scene.ends == "fixed-fixed":
        h, p, v = _of(scene, "h", "p", "v_0")
        found["E"] = m * v**2 / 2 + k * h**2 / 2 * (1 / p + 1 / (N + 1 - p))
    if N <= MOST_MASSES:
        squares = np.linalg.eigvalsh(_springs(int(scene.N), scene.ends))
        found |= {"fastest": own * mp.sqrt(squares[-1]), "slowest": own * mp.sqrt(squares[0]) if more else mp.mpf(0)}
    return found


def _springs(N: int, ends: str) -> Any:
    """The stiffness matrix over k."""
    matrix = 2 * np.eye(N) - np.eye(N, k=1) - np.eye(N, k=-1)
    matrix[-1, -1] -= ends != "fixed-fixed"
    matrix[0, 0] -= ends == "free-free"
    return matrix


def accuracy(scene: Any) -> Truth:
    system = scene.shown_system()
    if not system.c:
        return _named(system.chain, ("slow", "fast"), ("", ""))
    m, c, k = map(mp.mpf, (system.chain.m1, system.c, system.chain.k1))
    root = mp.sqrt(c**2 - 4 * m * k)
    return {"slow": (c - root) / (2 * m), "fast": (c + root) / (2 * m)}


SOLVED = (oscillator, energy, analogues, phugoid, damped, driven, modes, coupled, forced, absorber, chain, accuracy)
TRUTHS: dict[str, Callable[[Any], Truth]] = {one.__name__: one for one in SOLVED}
scenes = pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES.keys())
TOLERANCE = 1e-9
ROOTS = ("slow", "fast", "third", "fourth")
OTHERWISE = {
    # test_single_scenes
    "driven": {"P_in", "P_lost", "on_peak", "strongest", "X_strongest", "misses", "slice_width"},
    "chain": {"E"},  # other than plucked: test_presets
    "modes": {f"{root}_{part}" for root in ROOTS for part in ("rate", "omega", "zeta", "Q", "decay")},  # test_motions
    "phugoid": {"tau_exact", "late"},  # test_single_scenes
    "absorber": {"help_low", "help_high"},  # tests/physics/test_chain, and test_presets
    "analogues": {"inertia", "stiffness"},  # tests/physics/test_one_mass
    "accuracy": {"drift_euler", "drift_verlet", "drift_rk4", "picked_error", "picked_time", "picked_evaluations"},
}
"""Numbers that other tests compare."""
AS_SHOWN = ("", "rad/s", "1/s", "rad")
"""Units in which texts show a number unscaled; other units follow an axis."""


def check(scene: Scene, numbers: dict[str, SceneNumber], truth: Truth) -> set[str]:
    """Compare the numbers of a scene with true ones, and return the names of both."""
    both = numbers.keys() & truth.keys()
    for name in both:
        value, given = numbers[name].value, truth[name]
        true, size = given if isinstance(given, tuple) else (given, abs(given))
        if math.isinf(value):
            assert mp.isinf(true) or abs(true) > 1e300, (name, dict(scene.values))
            continue
        off = abs(value - true)
        if numbers[name].unit == "rad":
            off, size = min(off, abs(off - 2 * mp.pi)), max(size, 1)
        assert off <= TOLERANCE * size or abs(true) < 1e-300, (name, value, mp.nstr(true, 20), dict(scene.values))
    return both


def check_texts(scene: Scene, numbers: dict[str, SceneNumber]) -> None:
    """A shown number differs from the exact one by at most half of its third digit or of its last place."""
    if scene.values["view"] == "solve":
        return  # it leaves the dashpots out, and has its frequencies under the names of those with dashpots
    try:
        told = scene.shown.values
    except ValueError:
        return
    for name, number in numbers.items():
        plain = told.get(name, "").replace("\N{MINUS SIGN}", "-").replace(" ", "")
        if number.unit in AS_SHOWN and re.fullmatch(r"[-+]?\d+(\.\d+)?", plain):
            exact, places = number.value, [-len(plain.partition(".")[2])]
            places += [math.floor(math.log10(abs(exact))) - 2] if exact else []
            assert abs(float(plain) - exact) <= 0.5001 * 10.0 ** max(places), (name, plain, exact)


@scenes
def test_the_numbers_are_those_of_another_route_and_of_the_texts(scene: type[Scene]) -> None:
    seen, known = set[str](), set[str]()

    def compare(one: Scene, numbers: dict[str, SceneNumber]) -> None:
        for name, number in numbers.items():
            assert not math.isnan(number.value), name
            assert number.description and not number.description.endswith("."), name
        with mp.workdps(DIGITS):
            seen.update(check(one, numbers, TRUTHS[scene.slug](one)))
        check_texts(one, numbers)
        known.update(numbers)

    in_any_state(scene, attrgetter("numbers"), compare, 96, DECADES)
    assert known - seen <= OTHERWISE.get(scene.slug, set())
    assert len(seen) >= 2
