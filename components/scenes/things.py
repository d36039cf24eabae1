"""The pictures of the start page: the thing that each scene is about, in motion."""

from __future__ import annotations

import numpy as np

from components.scene.thing import HIGH, WIDE, Loop, Thing, arrow, curve, dot, drawn, held, mass, path
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_motion
from physics.damped import DampedOscillator
from physics.magnification import magnification
from physics.phugoid import flight, linear_phugoid


def oscillator() -> str:
    """A mass, an arrow that turns, and a curve, on one level."""
    loop = Loop(3, 36, still=32)
    up = 24 * np.sin(loop.phase())
    at = np.linspace(-1.5, 1.5, 100)
    return drawn(
        loop.translate(126 + 44 * loop.share, 55, curve("m1", 44 * at, 24 * np.sin(2 * np.pi * at))),
        path("ground", "M56 20H126V90H56z"),
        held(35, 106, 44),
        loop.spring(35, 106, up + 40, -90),
        loop.translate(35, 55 - up, mass(22)),
        '<circle class="orbit" cx="90" cy="55" r="24"/>',
        loop.translate(0, 55 - up, path("ln dots m1", "M46 0H126")),
        loop.translate(90, 55, loop.rotate(-np.degrees(loop.phase()), arrow("m1", 24)), dot("ink", 2.5)),
        loop.translate(126, 55 - up, dot("m1")),
    )


def energy() -> str:
    """A hanging mass, and a bar in which its energy of motion and its energy of position have one sum."""
    loop = Loop(3, 36, still=4)
    down = 19 * np.cos(loop.phase())
    return drawn(
        held(58, 13, 58, 180),
        path("eq", "M28 62H88"),
        loop.spring(58, 13, 37 + down, 90),
        loop.translate(58, 62 + down, mass(24)),
        path("fill T", "M118 16H152V100H118z"),
        loop.translate(118, 100, loop.scale(1, np.cos(loop.phase()) ** 2, path("fill V", "M0 0H34V-84H0z"))),
        path("ln ink", "M118 16H152V100H118z"),
        '<text class="math T" x="160" y="32">T</text><text class="math V" x="160" y="98">V</text>',
    )


def analogues() -> str:
    """A pendulum, a floating box and a mass on a spring, in step."""
    loop = Loop(3, 36, still=0)
    out = np.cos(loop.phase())
    return drawn(
        held(42, 14, 44, 180),
        loop.translate(42, 14, loop.rotate(-18 * out, path("ln ink", "M0 0V62"), f'<g class="m1">{_bob()}</g>')),
        loop.translate(102, 48 + 9 * out, mass(28, high=36)),
        path("liquid k", "M78 60H126V106H78z"),
        held(165, 106, 44),
        loop.spring(165, 106, 44 - 14 * out, -90),
        loop.translate(165, 51 + 14 * out, mass(22)),
    )


def _bob() -> str:
    return '<circle class="mass" cy="62" r="10"/>'


def phugoid() -> str:
    """An aircraft on its path: two swings."""
    loop = Loop(8, 96, still=30)
    v_0, g = 60.0, 9.81
    flown = flight(v_0, g, 0.45, 2 * linear_phugoid(v_0, g).tau * loop.share)
    x = 8 + (WIDE - 16) * flown.x / flown.x[-1]
    scale = (WIDE - 16) / flown.x[-1]
    y = 52 - 1.4 * scale * flown.h
    slope = -np.degrees(np.arctan2(1.4 * flown.w, flown.u))
    body = "M14 0C11 -3 5 -3 -6 -2.500L-12 -8H-15L-13 0C-6 3 10 3 14 0zM4 0L-5 7H-9L-4 0z"
    return drawn(
        path("eq", f"M8 52H{WIDE - 8}"),
        curve("m1 faded", x, y),
        loop.translate(x, y, loop.rotate(slope, path("fill m1", body))),
    )


def damped() -> str:
    """A mass with a dashpot, and the curve that it draws."""
    loop = Loop(6, 90, still=32)
    t = 4.5 * loop.share
    one = DampedOscillator(m=1.0, c=0.9, k=39.5)
    up = 22 * one.motion(1.0, 0.0, t).x
    fine = np.linspace(0, 4.5, 130)
    x = 78 + 108 * loop.share
    return drawn(
        held(46, 108, 70),
        loop.spring(30, 108, 46 + up, -90),
        path("liquid T", "M50 78H66V108H50z"),
        path("ln T", "M50 66V107H66V66"),
        loop.translate(
            0, 50 - up, path("ln T", "M42 0H58V34M53 34H63"), '<g transform="translate(30)">', mass(24), "</g>"
        ),
        curve("dash m1", 78 + 24 * fine, 50 - 22 * np.exp(-0.45 * fine)),
        curve("m1", 78 + 24 * fine, 50 - 22 * one.motion(1.0, 0.0, fine).x),
        loop.translate(0, 50 - up, path("ln dots m1", "M42 0H78")),
        loop.translate(x, 50 - up, dot("m1")),
    )


def driven() -> str:
    """A pushed mass, and the dot of its frequency, which goes over the peak and back."""
    loop, zeta = Loop(10, 130, still=54), 0.11
    r = 1.15 - 0.75 * np.cos(loop.phase())
    phase = 2 * np.pi * np.cumsum(r) / np.sum(r) * 10
    phase -= phase[0]
    response = magnification(r, zeta)
    up = 5.4 * np.imag(response * np.exp(1j * phase))
    fine = np.linspace(0.3, 2.05, 100)
    x, size = 112 + 42 * (r - 0.3), 18 * np.abs(response)
    return drawn(
        held(36, 106, 44),
        loop.spring(36, 106, 52 + up, -90),
        loop.translate(36, 44 - up, mass(22)),
        loop.translate(66, 44, loop.scale(1, -np.sin(phase), path("fill F", "M-2 0V12H-5L0 20L5 12H2V0z"))),
        path("hair", "M108 102H186"),
        curve("m1", 112 + 42 * (fine - 0.3), 102 - 18 * np.abs(magnification(fine, zeta))),
        loop.translate(x, 0, path("ln F", "M0 14V102")),
        loop.translate(x, 102 - size, dot("m1")),
    )


def modes() -> str:
    """The slow and the fast mode of one chain."""
    chain = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
    slow, fast = chain.modes().omega
    rows = zip((38, 94), (4.0, 4.0 * slow / fast), ((8, 12), (9, -13)), strict=True)
    return drawn(*(_mode(y, seconds, sizes) for y, seconds, sizes in rows))


def _mode(y: float, seconds: float, sizes: tuple[float, float]) -> str:
    loop = Loop(round(seconds, 2), 36, still=3)
    one, two = (size * np.cos(loop.phase()) for size in sizes)
    speeds = [-size * np.sin(loop.phase()) / 12 for size in sizes]
    head = path("fill slow" if sizes[1] > 0 else "fill fast", "M0 -1H10V-4.500L18 0L10 4.500V1H0z")
    return drawn(
        held(12, y, 30, 90),
        path("hair", f"M12 {y + 11}H180"),
        loop.spring(12, y, 46 + one),
        loop.translate(69 + one, y, mass(22), loop.translate(0, -21, loop.scale(speeds[0], 1, head))),
        loop.spring(80 + one, y, 42 - one + two),
        loop.translate(130 + two, y + 3, mass(16, "m2"), loop.translate(0, -24, loop.scale(speeds[1], 1, head))),
    )


def coupled() -> str:
    """Two masses that take turns, and the beat of the second one."""
    loop = Loop(9, 120, still=20)
    chain = TwoMassChain(m1=1.0, m2=0.1, k1=1.0, k2=0.1)
    lasting = 2 * 2 * np.pi / np.subtract(*chain.modes().omega[::-1])
    motion = free_motion(chain, (1.0, 0.0), (0.0, 0.0), lasting * loop.share)
    one, two = 6 * motion.x
    x, y = 12 + 172 * loop.share, 84 - 1.2 * two
    return drawn(
        held(12, 36, 36, 90),
        path("floor", "M12 50H184"),
        loop.spring(12, 36, 48 + one),
        loop.translate(75 + one, 35, mass(30), loop.spring(15, 5, 39 - one + two)),
        loop.translate(137 + two, 42, mass(16, "m2")),
        curve("m2", x, y),
        loop.translate(x, y, dot("m2")),
    )


def forced() -> str:
    """A push that moves the other mass alone."""
    return drawn(*_at_rest(mass(28), 0))


def absorber() -> str:
    """A machine that stands still, since a small mass swings for it."""
    machine = '<circle class="ring paper-line" r="13"/>'
    return drawn(*_at_rest(mass(44) + machine, 8), '<text class="t0" x="76" y="112">stands still</text>')


def _at_rest(first: str, more: float) -> tuple[str, ...]:
    """A chain that is pushed at the frequency at which its first mass rests."""
    loop = Loop(2.4, 30, still=5)
    wave = np.sin(loop.phase())
    push = path("fill F", "M0 -2.500H16V-6.500L26 0L16 6.500V2.500H0z")
    side = 14 + more
    turning = loop.rotate(-360 * loop.share + 90, path("ln paper-line", "M0 0H10")) if more else ""
    return (
        held(12, 70, 44, 90),
        path("floor", "M12 92H184"),
        loop.spring(12, 74, 66),
        f'<g transform="translate({78 + side} {92 - side})">{first}{turning}</g>',
        loop.translate(78 + side, 92 - 2 * side - 14, loop.scale(wave, 1, push)),
        loop.spring(78 + 2 * side, 80, 38 - more - 15 * wave),
        loop.translate(116 + 2 * side + 11 - more - 15 * wave, 82, mass(20, "m2")),
    )


def chain() -> str:
    """A pulse that runs to the wall and comes back upside down."""
    loop, count = Loop(6, 36, still=8), 9
    masses = UniformChain(N=count, m=1.0, k=1.0)
    up = masses.motion(*masses.pulse(2.5, 1.3, 26.0), 2 * (count + 1) * loop.share).x
    return drawn(
        held(14, 58, 70, 90),
        held(178, 58, 70, -90),
        path("eq", "M14 58H178"),
        *(loop.translate(14 + 164 * (p + 1) / (count + 1), 58 - up[p], mass(9)) for p in range(count)),
    )


def accuracy() -> str:
    """The exact circle, and the spiral of a method that steps along its tangents."""
    steps = 60
    loop = Loop(5, steps, still=52)
    spiral = np.asarray(30 * (1 + 2j * np.pi / steps) ** np.arange(steps + 1), dtype=np.complex128)
    exact = 30 * np.exp(1j * loop.phase())
    x, y = WIDE / 2, HIGH / 2
    return drawn(
        f'<circle class="orbit" cx="{x}" cy="{y}" r="30"/>',
        curve("T", x + spiral.real, y - spiral.imag),
        loop.translate(x + exact.real, y - exact.imag, dot("m1", 5)),
        loop.translate(x + spiral.real, y - spiral.imag, dot("T", 5)),
    )


THINGS: dict[str, Thing] = {
    thing.__name__: thing
    for thing in (
        oscillator,
        energy,
        analogues,
        phugoid,
        damped,
        driven,
        modes,
        coupled,
        forced,
        absorber,
        chain,
        accuracy,
    )
}
"""The picture of each scene by its slug."""
