"""The equations of the walks, at random values, against the physics: what `follows` states is so."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np
import pytest

from physics.analogues import ANALOGUES
from physics.coupled import TwoMassChain, free_modes
from physics.damped import DampedOscillator
from physics.driven import DrivenOscillator, half_power, lag
from physics.energy import chain_energy
from physics.forced import driven_modes, forced_motion, steady_start
from physics.free_decay import FreeDecay
from physics.hanging import HangingMass
from physics.modes import quadratic
from physics.oscillator import Oscillator
from physics.particular import antiresonance, particular_solution
from physics.pendulum import excess
from physics.phugoid import flight, linear_phugoid

plain = TwoMassChain(m1=2, m2=1, k1=4, k2=2)
equal = TwoMassChain(m1=1, m2=1, k1=1, k2=1)
beats = TwoMassChain(m1=1, m2=0.04, k1=0.96, k2=0.04)
machine = TwoMassChain(m1=100, m2=16, k1=250e3, k2=36864)
beat_motion = free_modes(beats, (0.2, 0), (0, 0))
growth = 1 / (2 * (2 + 1 * 2.0**2) * 1.0)


def close(a: float, b: float, tol: float = 1e-9) -> bool:
    return abs(a - b) <= tol * max(1.0, abs(a), abs(b))


rng = np.random.default_rng(31)
m, k, g, x, v, t = rng.uniform(0.5, 3, 6)
o = Oscillator(m=m, k=k)
h = 1e-5
M = o.motion(x, v, [t - h, t, t + h])
w = o.omega_n
c = o.constants(x, v)
m1, m2, k1, k2, x1, x2, F0, W = rng.uniform(0.5, 3, 8)
ch = TwoMassChain(m1=m1, m2=m2, k1=k1, k2=k2)
b = m1 * k2 + m2 * (k1 + k2)
Delta = b * b - 4 * m1 * m2 * k1 * k2
roots = [(b - Delta**0.5) / (2 * m1 * m2), (b + Delta**0.5) / (2 * m1 * m2)]
r = ch.modes().ratio
T = np.linspace(0, 60, 7)
T_ = np.linspace(0, 20, 9)


def A(w: float) -> np.ndarray:
    return np.array([[m1 * w * w - k1 - k2, k2], [k2, m2 * w * w - k2]], dtype=complex)


def D(w: float) -> float:
    return m1 * m2 * w**4 - b * w * w + k1 * k2


def one_oscillator() -> Iterator[tuple[str, bool]]:
    yield (
        "D31-1 m x'' + k x = 0",
        close(m * M.a[1] + k * M.x[1], 0, 1e-12) and close((M.x[2] - 2 * M.x[1] + M.x[0]) / h**2, M.a[1], 1e-4),
    )
    yield "D31-1 tau = 2 pi sqrt(m/k)", close(o.period, 2 * math.pi * math.sqrt(m / k))
    A, B = x, v / w
    yield (
        "D31-2 both forms",
        close(A * math.cos(w * t) + B * math.sin(w * t), M.x[1]) and close(c.C * math.sin(w * t + c.phi), M.x[1]),
    )
    yield "D31-2 atan2, and atan for v0 > 0", close(c.phi, math.atan2(x * w, v)) and close(c.phi, math.atan(x * w / v))
    d = o.constants(x, -v)
    wrong = d.C * np.sin(w * np.linspace(0, 5, 9) + math.atan(x * w / -v))
    yield "D31-2 atan for v0 < 0: upside down", np.allclose(wrong, -o.motion(x, -v, np.linspace(0, 5, 9)).x)
    yield (
        "D31-3 leads",
        close(M.v[1], w * c.C * math.sin(w * t + c.phi + math.pi / 2))
        and close(M.a[1], w * w * c.C * math.sin(w * t + c.phi + math.pi)),
    )


def one_damped() -> Iterator[tuple[str, bool]]:
    c_ = 0.2 * math.sqrt(m * k)
    one = DampedOscillator(m=m, c=c_, k=k)
    zeta, tau = one.zeta, 2 * math.pi / one.omega_d
    at = one.motion(x, v, [t, t + tau, t + 4 * tau])
    a_ = -(c_ * at.v + k * at.x) / m
    near = one.motion(x, v, [t - h, t, t + h])
    yield "D32 m x'' + c x' + k x = 0", close((near.x[2] - 2 * near.x[1] + near.x[0]) / h**2, a_[0], 1e-4)
    yield "D32 zeta, omega_d", close(zeta, c_ / (2 * m * w)) and close(one.omega_d, w * math.sqrt(1 - zeta * zeta))
    delta = zeta * w * tau
    yield "D32 delta", close(delta, one.log_decrement) and np.allclose(at.x[1:] / at.x[0], np.exp([-delta, -4 * delta]))
    energy = [m * near.v[i] ** 2 / 2 + k * near.x[i] ** 2 / 2 for i in (0, 2)]
    yield "D32 energy falls by c x'^2", close((energy[1] - energy[0]) / (2 * h), -c_ * near.v[1] ** 2, 1e-4)
    top = FreeDecay(oscillator=one, x_0=abs(x), v_0=0.0).first_top_speed or 0.0
    there = one.motion(abs(x), 0.0, [top])
    yield "D32 fastest where k x = -c x', above 0", close(k * there.x[0], -c_ * there.v[0]) and there.x[0] > 0
    twice = DampedOscillator(m=m, c=2 * c_, k=k)
    yield "D32 periods", close(one.omega_d / twice.omega_d, math.sqrt((1 - zeta**2) / (1 - 4 * zeta**2)))
    s1, s2 = (-rate for rate in DampedOscillator(m=m, c=3 * math.sqrt(m * k), k=k).rates)
    yield "D32 s1 s2", close(s1 * s2, w * w) and close(s1, -w * (1.5 - math.sqrt(1.25)))
    late = DampedOscillator(m=m, c=2e4 * math.sqrt(m * k), k=k)
    yield "D32 zeta large", close(late.rates[0] * late.c / k, 1, 1e-7) and close(late.rates[1] * m / late.c, 1, 1e-7)


def thrown() -> Iterator[tuple[str, bool]]:
    over = DampedOscillator(m=m, c=3 * math.sqrt(m * k), k=k)
    fast = over.rates[1]
    for start, speed in ((1.0, -1.01 * fast), (1.0, -0.99 * fast), (1.0, 0.5), (2.0, -2.02 * fast)):
        x_t = over.motion(start, speed, np.linspace(0, 60 / over.rates[0], 4000)).x
        crosses = int(np.sum(np.signbit(x_t[1:]) != np.signbit(x_t[:-1])))
        yield f"D32 crosses once where thrown faster than s2 x_0: {start}, {speed}", crosses == (speed < -fast * start)


def one_driven() -> Iterator[tuple[str, bool]]:
    c_, W_ = 0.3 * math.sqrt(m * k), 1.3 * w
    one = DrivenOscillator(m=m, c=c_, k=k)
    zeta, r_ = one.free.zeta, W_ / w
    X = one.response(W_, F0, "force")
    yield "D33 polygon", close(abs(k * X + 1j * c_ * W_ * X - m * W_**2 * X - F0), 0)
    yield "D33 X in r", close(abs(X - F0 / k / (1 - r_**2 + 2j * zeta * r_)), 0)
    yield "D33 lag", close(lag(X), math.atan2(2 * zeta * r_, 1 - r_**2))
    at = one.response(w, F0, "force")
    yield "D33 at resonance", close(abs(at), F0 / (c_ * w)) and close(abs(at), F0 / k / (2 * zeta))
    yield "D33 lag at resonance", close(lag(at), math.pi / 2)
    powers = [abs(one.response(r * w, F0, "force")) ** 2 * r * r for r in (1, *half_power(zeta))]
    yield "D33 half power", close(powers[1], powers[0] / 2) and close(powers[2], powers[0] / 2)
    yield "D33 width", close(half_power(zeta)[1] - half_power(zeta)[0], 2 * zeta)
    T = abs(one.response(W_, 1.0, "base"))
    size = math.sqrt((1 + (2 * zeta * r_) ** 2) / ((1 - r_**2) ** 2 + (2 * zeta * r_) ** 2))
    root = [abs(DrivenOscillator(m=m, c=b_, k=k).response(math.sqrt(2) * w, 1.0, "base")) for b_ in (0.1, 1.0, 9.0)]
    yield "D33 base, every zeta at sqrt 2", close(T, size) and np.allclose(root, 1)
    free = DrivenOscillator(m=m, c=0.0, k=k)
    x_t = free.motion(w, F0, 0.0, 0.0, T_, "force").x
    yield "D33 growth", np.allclose(x_t, F0 / (2 * m * w * w) * (np.sin(w * T_) - w * T_ * np.cos(w * T_)))
    peaks = free.motion(w, F0, 0.0, 0.0, np.array([1.0, 2.0]) * 2 * math.pi / w, "force").x
    yield "D33 each swing adds", close(abs(peaks[1] - peaks[0]), math.pi * F0 / (m * w * w))
    steady = one.motion(w, F0, 0.0, 0.0, np.linspace(200, 220, 4000) / (zeta * w), "force").x
    yield "D33 in the end", close(float(np.abs(steady).max()), F0 / (c_ * w), 1e-4)


def energy_of_one() -> Iterator[tuple[str, bool]]:
    H = HangingMass(m=m, k=k, g=g)
    s = H.delta_st
    yield (
        "D31-4 V with gravity = k x^2/2",
        close(k * (x + s) ** 2 / 2 - k * s * s / 2 - m * g * x, k * x * x / 2) and close(k * s, m * g),
    )
    yield "D31-4 expanded", close(k * (x + s) ** 2 / 2 - k * s * s / 2 - m * g * x, k * x * x / 2 + (k * s - m * g) * x)
    yield "D31-4 m g - k (x + delta_st) = -k x", close(m * g - k * (x + s), -k * x)
    yield "D31-5 d/dt (T + V) = x' (m x'' + k x)", close(m * M.v[1] * M.a[1] + k * M.x[1] * M.v[1], 0, 1e-9)
    E = k * c.C**2 / 4
    p2 = 2 * (w * t + c.phi)
    yield (
        "D31-5 V, T at 2 omega",
        close(k * M.x[1] ** 2 / 2, E * (1 - math.cos(p2))) and close(m * M.v[1] ** 2 / 2, E * (1 + math.cos(p2))),
    )
    yield (
        "D31-6 v_max = omega x_max; V_max apart",
        close(m * (w * c.C) ** 2 / 2, k * c.C**2 / 2) and close(H.datum_shift, k * s * s / 2),
    )


def analogues_and_aircraft() -> Iterator[tuple[str, bool]]:
    p = {n: s_.at(s_.defaults).omega_n ** 2 for n, s_ in ANALOGUES.items()}
    q = {n: {**{c_.name: c_.value for c_ in s_.constants}, **s_.defaults} for n, s_ in ANALOGUES.items()}
    kap = 2 * math.pi / q["wave"]["wavelength"]
    r = q["rocking"]
    yield (
        "D31-7 nine omega_n^2",
        all(
            close(a, b)
            for a, b in (
                (p["spring"], q["spring"]["k"] / q["spring"]["m"]),
                (p["shaft"], q["shaft"]["k_t"] / q["shaft"]["J"]),
                (p["circuit"], 1 / (q["circuit"]["L"] * q["circuit"]["C"])),
                (p["pendulum"], q["pendulum"]["g"] / q["pendulum"]["l"]),
                (p["rocking"], r["m"] * r["g"] * r["d"] / (r["m"] * (r["d"] ** 2 + r["r"] ** 2))),
                (p["floating"], q["floating"]["rho"] * q["floating"]["g"] * q["floating"]["A"] / q["floating"]["m"]),
                (p["string"], (math.pi / q["string"]["L"]) ** 2 * q["string"]["T"] / q["string"]["rho_L"]),
                (p["wave"], q["wave"]["g"] * kap),
                (p["pipe"], (math.pi * q["pipe"]["c"] / q["pipe"]["L"]) ** 2),
            )
        ),
    )
    a0 = 0.02
    yield "D31-7 1 + theta0^2/16", abs(excess(a0) - a0**2 / 16) < 1e-7
    v0, e = 50.0, 1e-4
    ph = linear_phugoid(v0, g)
    yield "D31-8 L/mg = 1 + 2 v'/v0", abs((1 + e) ** 2 - (1 + 2 * e)) < 2 * e**2
    f = flight(v0, g, e, np.array([0.3, 0.3 + 1e-3, 0.3 + 2e-3]))
    gain = f.gain(v0, g)
    yield "D31-9 h'' = 2 g v'/v0", close(f.rates(v0, g)[1][1] / (2 * g * gain[1] / v0), 1, 5e-4)
    yield "D31-9 g h' + v0 v' = 0", close(g * f.h[1] / (-v0 * gain[1]), 1, 5e-4)
    yield "D31-9 h'' + 2 (g/v0)^2 h' = 0", close(f.rates(v0, g)[1][1] / (-2 * (g / v0) ** 2 * f.h[1]), 1, 5e-4)
    yield "D31-10 omega, tau", close(ph.omega, math.sqrt(2) * g / v0) and close(ph.tau, math.sqrt(2) * math.pi * v0 / g)
    yield (
        "D31-10 v' = -(g/v0) h', h' = -(v0 v'_0/g) cos",
        close(gain[1] / (-(g / v0) * f.h[1]), 1, 5e-4)
        and close(f.h[1] / (-(v0 * e * v0 / g) * math.cos(ph.omega * f.t[1])), 1, 5e-4),
    )


def free_chain() -> Iterator[tuple[str, bool]]:
    F = np.array([-k1 * x1 - k2 * (x1 - x2), k2 * (x1 - x2)])
    # at rest at t = 0: x'' from the app's own motion
    mo = free_modes(ch, (x1, x2), (0, 0)).parts([0.0, 1e-4])
    acc = 2 * ((mo[0] + mo[1]).x[:, 1] - np.array([x1, x2])) / 1e-8
    yield "D34-1 m1 x1'' = F1, m2 x2'' = F2", np.allclose(np.array([m1, m2]) * acc, F, rtol=1e-5, atol=1e-5)
    yield (
        "D34-2 A X = 0 at both modes",
        all(
            np.allclose(A(w) @ np.array([1, r]), 0, atol=1e-9)
            for w, r in zip(ch.modes().omega, ch.modes().ratio, strict=True)
        ),
    )
    w = 0.9
    yield (
        "D34-3 D = det A, and D = k2 (k2 - m2 w^2) times the distance",
        close(np.linalg.det(A(w)).real, D(w))
        and close(k2 * (k2 - m2 * w * w) * ((k1 + k2 - m1 * w * w) / k2 - k2 / (k2 - m2 * w * w)), D(w)),
    )
    Q = quadratic(ch)
    yield (
        "D34-3 Delta both ways, sqrt(Delta) < b",
        close(Delta, (m1 * k2 - m2 * (k1 + k2)) ** 2 + 4 * m1 * m2 * k2**2)
        and close(float(Q.Delta), Delta)
        and Delta**0.5 < b,
    )
    yield "D34-3 omega_pm^2", np.allclose(ch.modes().omega ** 2, roots)


def damped_chain() -> Iterator[tuple[str, bool]]:
    c, w = 0.3, 0.9
    Dc = (m1 * w * w - 1j * c * w - k1 - k2) * (m2 * w * w - k2) - k2**2
    yield (
        "D34-N2 D_c = D - i c m2 w^3 + i c k2 w; D even",
        close(abs(Dc - (D(w) - 1j * c * m2 * w**3 + 1j * c * k2 * w)), 0) and close(D(-w), D(w)),
    )
    poly = np.roots([m1 * m2, -1j * c * m2, -b, 1j * c * k2, k1 * k2])
    yield "D34-N2 roots of D_c decay (Im omega > 0)", bool(np.all(poly.imag > 0))


def modes() -> Iterator[tuple[str, bool]]:
    gam = m1 / (2 * m2) - (k1 + k2) / (2 * k2)
    dele = math.sqrt(gam**2 + m1 / m2)
    yield "D34-4 ratios, product", np.allclose(r, [-gam + dele, -gam - dele]) and close(r[0] * r[1], -m1 / m2)
    yield "D34-4 -(X2/X1) = (m1 w^2 - k1 - k2)/k2", np.allclose(-r, (m1 * ch.modes().omega ** 2 - k1 - k2) / k2)
    v1, v2 = rng.uniform(-2, 2, 2)
    fr = free_modes(ch, (x1, x2), (v1, v2))
    Mj = m1 + m2 * r**2
    yield (
        "D34-5 four constants",
        np.allclose(fr.amplitude[:, 0] * np.sin(fr.phase), (m1 * x1 + m2 * r * x2) / Mj)
        and np.allclose(fr.omega * fr.amplitude[:, 0] * np.cos(fr.phase), (m1 * v1 + m2 * r * v2) / Mj)
        and np.allclose(fr.amplitude[:, 1], r * fr.amplitude[:, 0]),
    )
    yield (
        "D34-5 E_j, and their sum",
        np.allclose(fr.energy, Mj * fr.omega**2 * fr.amplitude[:, 0] ** 2 / 2)
        and close(float(chain_energy(ch, fr.parts([t])[0] + fr.parts([t])[1]).total[0]), float(fr.energy.sum())),
    )
    yield "D34-5 orthogonality", close(m1 + m2 * r[0] * r[1], 0) and close(k1 + k2 * (r[0] - 1) * (r[1] - 1), 0)


def beating() -> Iterator[tuple[str, bool]]:
    bw, br = beats.modes().omega, beats.modes().ratio[0]
    bm = beat_motion.parts(T)[0] + beat_motion.parts(T)[1]
    yield (
        "D34-5 beats",
        np.allclose(bm.x[0], 0.2 * np.cos((bw[1] - bw[0]) / 2 * T) * np.cos((bw[1] + bw[0]) / 2 * T), atol=1e-9)
        and np.allclose(
            bm.x[1], br * 0.2 * np.sin((bw[1] - bw[0]) / 2 * T) * np.sin((bw[1] + bw[0]) / 2 * T), atol=1e-9
        ),
    )
    yield (
        "D34-5 beats complete",
        close(beats.m1 * beats.k2, beats.m2 * (beats.k1 + beats.k2)) and close(br, math.sqrt(beats.m1 / beats.m2)),
    )
    yield "d34-11 next: x2 = 5 x1 is the slow mode alone", free_modes(beats, (0.2, 1.0), (0, 0)).energy[1] < 1e-15
    off = TwoMassChain(m1=1, m2=0.04, k1=0.96, k2=0.08)
    yield (
        "d34-10 next: exchange not complete",
        abs(np.subtract(*free_modes(off, (0.2, 0), (0, 0)).amplitude[:, 0])) > 0.02,
    )


def driven_chain() -> Iterator[tuple[str, bool]]:
    Xp = particular_solution(ch, F0, W)
    yield "D34-7 A Xp = (-F0, 0)", np.allclose(A(W) @ Xp, [-F0, 0])
    yield (
        "D34-8 Xp1, Xp2, D factored",
        close(Xp[0], (k2 - m2 * W * W) * F0 / D(W))
        and close(Xp[1], k2 * F0 / D(W))
        and close(D(W), m1 * m2 * (W * W - roots[0]) * (W * W - roots[1])),
    )
    yield "D34-7 omega -> 0: Xp = F0/k1", np.allclose(particular_solution(ch, F0, 0.0), F0 / k1)
    (s0, sv) = steady_start(ch, F0, W)
    dm = driven_modes(ch, F0, W, s0, sv)
    yield (
        "D34-7 x(0) = 0, v(0) = omega Xp: x = x_p",
        np.allclose(dm.motion(T).x, np.outer(Xp, np.sin(W * T)), atol=1e-9),
    )
    dr = driven_modes(ch, F0, W)
    late_, early_ = dr.complementary(np.linspace(2000, 2100, 4000)), dr.complementary(np.linspace(0, 100, 4000))
    yield "D34-7 x_c never dies out", abs(np.abs(late_).max() / np.abs(early_).max() - 1) < 0.05
    wa = antiresonance(ch)
    still = particular_solution(ch, F0, wa)
    yield (
        "D34-8 zero at sqrt(k2/m2), Xp2 = -F0/k2, D = -k2^2",
        close(wa, math.sqrt(k2 / m2))
        and close(still[0], 0, 1e-9)
        and close(still[1], -F0 / k2)
        and close(D(wa), -k2 * k2),
    )
    yield "d34-08 reply: -1 and +1 with a second wall", np.allclose(np.linalg.eigh([[2, -1], [-1, 2]])[1] ** 2, 0.5)


def driven_examples() -> Iterator[tuple[str, bool]]:
    s = 0.37
    yield (
        "D34-8 figure",
        np.allclose(particular_solution(equal, 1.0, s), np.array([1 - s * s, 1]) / (s**4 - 3 * s * s + 1)),
    )
    tt = np.array([3.0, 11.0, 24.0])
    slow = 1 / 6 / 2 * (np.sin(tt) - tt * np.cos(tt))
    fastM, fw = 2 + 1.0, 2.0
    fast = 1 / fastM * (np.sin(tt) - np.sin(fw * tt) / fw) / (fw**2 - 1)
    yield (
        "D34-8 growth at resonance",
        np.allclose(forced_motion(plain, 1.0, 1.0, tt).x[0], slow + fast) and close(growth, 1 / 12),
    )
    yield "d34-16 machine", close(antiresonance(machine), 48.0) and close(36864 * 500 / 36864, 500)
    stiff = TwoMassChain(m1=2, m2=1, k1=4, k2=2e9).modes().omega[0]
    yield "d34-05 reply: k2 -> inf, one block on spring 1", close(stiff, math.sqrt(4 / 3), 1e-6)
    yield "d34-07 reply: mirror image for m1 = 4 m2", close(2 * -2, -4 / 1)
    yield "d34-13 next: Xp1 < 0 at 0.8", particular_solution(equal, 1.0, 0.8)[0] < 0
    lighter = [TwoMassChain(m1=100, m2=mm, k1=250e3, k2=mm * 48.0**2) for mm in (8, 16)]
    yield (
        "d34-16 next: lighter, longer stroke, closer resonances",
        500 / lighter[0].k2 > 500 / lighter[1].k2
        and (min(abs(lighter[0].modes().omega - 48)) < min(abs(lighter[1].modes().omega - 48))),
    )


PARTS = (
    one_oscillator,
    one_damped,
    thrown,
    one_driven,
    energy_of_one,
    analogues_and_aircraft,
    free_chain,
    damped_chain,
    modes,
    beating,
    driven_chain,
    driven_examples,
)


@pytest.mark.parametrize("part", PARTS, ids=lambda part: part.__name__)
def test_what_the_equations_state_is_so(part: Callable[[], Iterator[tuple[str, bool]]]) -> None:
    claims = list(part())
    assert claims and [what for what, so in claims if not so] == []
