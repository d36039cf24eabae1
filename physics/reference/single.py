"""One oscillator, the pendulum, the phugoid and the steady motion in arbitrary precision, to measure others by.

Independent of physics.precision.exact: mpmath, and the lecture's own formulas (D31, D34), with many spare digits.
"""

from collections.abc import Sequence
from decimal import Decimal
from functools import lru_cache
from math import log10
from typing import Any

from physics.coupled import TwoMassChain
from physics.hanging import HangingMass
from physics.oscillator import Oscillator
from physics.pendulum import Pendulum
from physics.precision.exact import precise
from physics.reference.driven_chain import EXACT, Point, point

DIGITS = 60
LINEAR = 1e-30  # smaller swings have the linear shape to twice that

Points = dict[str, list[Point]]


def oscillator_points(oscillator: Oscillator, x_0: float, v_0: float, t: Sequence[float]) -> Points:
    """Return a free motion without damping.

    Parameters
    ----------
    oscillator : Oscillator
        The mass and the spring.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    t : sequence of float
        A few times in s.

    Returns
    -------
    dict of lists of Point
        x in m, v in m/s and a in m/s^2. Sizes are amplitudes; for x of a free mass the size of its terms.
    """
    import mpmath as mp

    omega_n = oscillator.omega_n
    with mp.workdps(DIGITS + _turns(omega_n, t)):
        omega = mp.sqrt(mp.mpf(oscillator.k) / mp.mpf(oscillator.m))
        A, v = mp.mpf(x_0), mp.mpf(v_0)
        C = mp.hypot(A, v / omega) if omega else mp.mpf(0)
        points: Points = {"x": [], "v": [], "a": []}
        for time in map(mp.mpf, t):
            c, s = mp.cos(omega * time), mp.sin(omega * time)
            x = A * c + (v / omega * s if omega else v * time)
            points["x"].append(point(x, C if omega else abs(A) + abs(v * time)))
            points["v"].append(point(v * c - A * omega * s, omega * C if omega else abs(v)))
            points["a"].append(point(-(omega**2) * x, omega**2 * C))
    return points


def hanging_points(mass: HangingMass, x_0: float, v_0: float, t: Sequence[float], separate: bool) -> Points:
    """Return the motion and the energies of a hanging mass.

    Parameters
    ----------
    mass : HangingMass
        The mass, the spring and gravity.
    x_0, v_0 : float
        The displacement in m from equilibrium and the velocity in m/s at t = 0.
    t : sequence of float
        A few times in s.
    separate : bool
        True if V is the sum of spring and gravity; else it is 0 at equilibrium.

    Returns
    -------
    dict of lists of Point
        x in m; T, V and the energies of spring and gravity in J. Sizes are the largest values that they reach.
    """
    found = oscillator_points(mass.oscillator, x_0, v_0, t)
    m, k, g = map(Decimal, (mass.m, mass.k, mass.g))
    states = list(zip(found["x"], found["v"], strict=True))
    with precise():
        deflection = m * g / k
        shift = k * deflection**2 / 2 if separate else Decimal(0)
        largest = [k * x.size**2 / 2 for x, _ in states]
        return {
            "x": found["x"],
            "T": [Point(m * v.value**2 / 2, E) for (_, v), E in zip(states, largest, strict=True)],
            "V": [Point(k * x.value**2 / 2 + shift, E + shift) for (x, _), E in zip(states, largest, strict=True)],
            "spring": [
                Point(k * (x.value + deflection) ** 2 / 2, k * (x.size + deflection) ** 2 / 2) for x, _ in states
            ],
            "gravity": [Point(-m * g * x.value, m * g * x.size) for x, _ in states],
        }


def _turns(omega: float, t: Sequence[float]) -> int:
    """Digits of the phase before its point."""
    largest = max(map(abs, t), default=0.0)
    return round(max(0.0, log10(omega) + log10(largest))) if omega and largest else 0


def pendulum_points(pendulum: Pendulum, theta_0: float, t: Sequence[float]) -> list[Point]:
    """Return theta in rad of the swing from rest.

    Parameters
    ----------
    pendulum : Pendulum
        The pendulum.
    theta_0 : float
        The initial angle in rad.
    t : sequence of float
        A few times in s.

    Returns
    -------
    list of Point
        theta in rad; sizes are theta_0.
    """
    import mpmath as mp

    small = max(abs(theta_0), LINEAR)
    with mp.workdps(DIGITS + _turns(pendulum.omega_0, t) - 2 * round(log10(small))):
        omega = mp.sqrt(mp.mpf(pendulum.g) / mp.mpf(pendulum.l))
        if abs(theta_0) < LINEAR:
            return [point(theta_0 * mp.cos(omega * mp.mpf(time)), abs(theta_0)) for time in t]
        return [point(swing(mp, omega, theta_0, mp.mpf(time))[0], abs(theta_0)) for time in t]


def swing(mp: Any, omega: Any, theta_0: float, t: Any) -> tuple[Any, Any, Any]:
    """Return the motion of a pendulum from rest by Jacobi functions, in the working precision of mp.

    Parameters
    ----------
    mp : MPContext
        The context of mpmath; its precision has to outlast theta_0^2.
    omega : mpf
        The frequency of small swings in rad/s.
    theta_0 : float
        The initial angle in rad.
    t : mpf
        The time in s.

    Returns
    -------
    tuple of three mpf
        theta in rad, theta' in rad/s and theta'' in rad/s^2.
    """
    k, k_prime = mp.sin(abs(mp.mpf(theta_0)) / 2), mp.cos(mp.mpf(theta_0) / 2)
    argument = mp.fmod(omega * t, 2 * mp.pi * period_ratio(mp, theta_0))
    sn, cn, dn = (mp.ellipfun(name, argument, m=1 - k_prime**2) for name in ("sn", "cn", "dn"))
    side = mp.sign(theta_0)
    theta = side * 2 * mp.atan2(k * cn, k_prime)
    return theta, -side * 2 * omega * k * k_prime * sn / dn, -(omega**2) * mp.sin(theta)


def period_ratio(mp: Any, theta_0: float) -> Any:
    """Return T/T_0 of a pendulum at rest at theta_0 in rad, as a number of the context mp."""
    return 1 / mp.agm(1, mp.cos(mp.mpf(theta_0) / 2))


def steady_points(chain: TwoMassChain, c: float, F_0: float, omega: Sequence[float]) -> list[list[Point]]:
    """Return the steady amplitudes of both masses at frequencies that are not natural ones.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    c : float
        The damping parallel to spring 2 in N s/m.
    F_0 : float
        The amplitude of the force on mass 1 in N.
    omega : sequence of float
        A few frequencies in rad/s.

    Returns
    -------
    list of two lists of Point
        X1 and X2 in m: signed without damping, else moduli. Sizes are |X|.
    """
    import mpmath as mp

    with mp.workprec(EXACT):
        rows = [[X.real if not c else abs(X) for X in steady(mp, chain, c, F_0, w)] for w in omega]
        return [[point(X, abs(X)) for X in mass] for mass in zip(*rows, strict=True)]


def stroke_points(chain: TwoMassChain, c: float, F_0: float, omega: Sequence[float]) -> list[Point]:
    """Return |X2 - X1| at a few frequencies.

    Parameters
    ----------
    chain, c, F_0, omega
        As in `steady_points`.

    Returns
    -------
    list of Point
        The strokes in m, which are their own sizes.
    """
    import mpmath as mp

    with mp.workprec(EXACT):
        pairs = [steady(mp, chain, c, F_0, w) for w in omega]
        return [point(abs(two - one), abs(two - one)) for one, two in pairs]


def steady(mp: Any, chain: TwoMassChain, c: float, F_0: float, omega: float) -> tuple[Any, Any]:
    """Return the steady motion from Newton's laws as two linear equations.

    Parameters
    ----------
    mp : MPContext
        The context of mpmath.
    chain, c, F_0
        As in `steady_points`.
    omega : float
        The frequency of the drive in rad/s.

    Returns
    -------
    tuple of two mpc
        X1 and X2 in m of x_i = Im(X_i exp(i omega t)).
    """
    m1, m2, k1, k2, damping, F, w = map(mp.mpf, (chain.m1, chain.m2, chain.k1, chain.k2, c, F_0, omega))
    link = mp.mpc(k2, damping * w)
    a, d = k1 + link - m1 * w**2, link - m2 * w**2
    det = a * d - link**2
    return d * F / det, link * F / det


FLIGHT_DIGITS = 40
ORDER = 48
FREE_FALL = 1e-12  # below this speed the lift is 1e-24 of the weight


def flight_points(v_0: float, g: float, excess: float, t: Sequence[float]) -> Points:
    """Return h' and v' of the exact phugoid.

    Taylor series of du/dt = -V w, dw/dt = V u - 1 (lecture D31, slide 10, beyond it) over half a period from the
    start, mirrored from there on.

    Parameters
    ----------
    v_0, g : float
        The speed of level flight in m/s, and gravity in m/s^2.
    excess : float
        The initial excess of speed over v_0.
    t : sequence of float
        A few times in s.

    Returns
    -------
    dict of lists of Point
        h in m with the size v_0^2/g, v in m/s with the size v_0.
    """
    import mpmath as mp

    if abs(excess) < LINEAR:
        return _ripple(mp, v_0, g, excess, t)
    pieces, half = _half_flight(excess)
    points: Points = {"h": [], "v": []}
    with mp.workdps(_flight_digits(excess) + _turns(g / v_0, t)):
        length = mp.mpf(v_0) ** 2 / mp.mpf(g)
        for time in t:
            rest = mp.fmod(mp.mpf(time) * mp.mpf(g) / mp.mpf(v_0), 2 * half)
            rest = min(rest, 2 * half - rest)
            start, u, w = next(piece for piece in reversed(pieces) if piece[0] <= rest)
            u_now, w_now = (mp.polyval(series, rest - start, asc=True) for series in (u, w))
            points["h"].append(point(length * (1 - u_now**2 - w_now**2) / 2, length))
            points["v"].append(point(mp.mpf(v_0) * (mp.hypot(u_now, w_now) - 1), v_0))
    return points


def _ripple(mp: Any, v_0: float, g: float, excess: float, t: Sequence[float]) -> Points:
    with mp.workdps(DIGITS + _turns(g / v_0, t)):
        speed, weight = mp.mpf(v_0), mp.mpf(g)
        gains = [excess * speed * mp.cos(mp.sqrt(2) * weight / speed * mp.mpf(time)) for time in t]
        return {
            "h": [point(-speed / weight * gain, speed**2 / weight) for gain in gains],
            "v": [point(gain, speed) for gain in gains],
        }


def _flight_digits(excess: float) -> int:
    return FLIGHT_DIGITS - 2 * round(min(0.0, log10(abs(excess))))


@lru_cache(maxsize=16)
def _half_flight(excess: float) -> tuple[list[tuple[Any, list[Any], list[Any]]], Any]:
    """(start, series of u, series of w) from the start until the flight is level again, and that time."""
    import mpmath as mp

    digits = _flight_digits(excess)
    with mp.workdps(digits):
        t, u_0, w_0 = mp.mpf(0), 1 + mp.mpf(excess), mp.mpf(0)
        pieces: list[tuple[Any, list[Any], list[Any]]] = []
        climbs = excess > 0
        while True:
            falls = mp.hypot(u_0, w_0) < FREE_FALL
            u, w = ([u_0], [w_0, mp.mpf(-1)]) if falls else _series(mp, u_0, w_0)
            pieces.append((t, u, w))
            step = _step(mp, u, w, digits) if not falls else (w_0 if climbs else mp.mpf(2 * FREE_FALL))
            u_1, w_1 = mp.polyval(u, step, asc=True), mp.polyval(w, step, asc=True)
            if len(pieces) > 1 and w_1 * (1 if climbs else -1) <= 0:
                return pieces, t + _level(mp, w, step)
            t, u_0, w_0 = t + step, u_1, w_1


def _series(mp: Any, u_0: Any, w_0: Any) -> tuple[list[Any], list[Any]]:
    """Taylor coefficients of u and w: each order of the equations, and of V^2 = u^2 + w^2, gives the next."""
    u, w, V = [u_0], [w_0], [mp.hypot(u_0, w_0)]
    for n in range(ORDER):
        u.append(-mp.fdot(V, w[::-1]) / (n + 1))
        w.append((mp.fdot(V, u[n::-1]) - (n == 0)) / (n + 1))
        V.append((mp.fdot(u, u[::-1]) + mp.fdot(w, w[::-1]) - mp.fdot(V[1:], V[:0:-1])) / (2 * V[0]))
    return u, w


def _step(mp: Any, u: list[Any], w: list[Any], digits: int) -> Any:
    """The largest step for which the last term stays below the digits."""
    last = max(abs(u[-1]), abs(w[-1]))
    return (mp.mpf(10) ** (5 - digits) / last) ** (mp.mpf(1) / ORDER)


def _level(mp: Any, w: list[Any], step: Any) -> Any:
    """The zero of w: Newton's method from the zero of the chord over the step."""
    rate = [n * c for n, c in enumerate(w)][1:]
    root = step * w[0] / (w[0] - mp.polyval(w, step, asc=True))
    for _ in range(8):
        root -= mp.polyval(w, root, asc=True) / mp.polyval(rate, root, asc=True)
    return root
