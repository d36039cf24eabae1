"""One damped oscillator, left alone and driven, in arbitrary precision, to measure others by; independent of
physics.precision.exact and of physics.damped.

Sums of the exponentials of the roots of m s^2 + c s + k, with digits to burn.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.6 and 2.9 to 2.12.
"""

from collections.abc import Sequence
from typing import Any

from physics.damped import DampedOscillator
from physics.driven import Drive, DrivenOscillator
from physics.reference.driven_chain import Point, point

BITS = 6000

Points = dict[str, list[Point]]


def damped_points(oscillator: DampedOscillator, x_0: float, v_0: float, t: Sequence[float]) -> Points:
    """Return a free motion; the size of each value is what both exponentials give it.

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass, the dashpot and the spring.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    t : sequence of float
        A few times in s.

    Returns
    -------
    dict of lists of Point
        x in m, the energies V and E = T + V in J, and the power P in W that the dashpot takes.
    """
    import mpmath as mp

    with mp.workprec(BITS):
        m, c, k, x, v = (mp.mpf(value) for value in (oscillator.m, oscillator.c, oscillator.k, x_0, v_0))
        points: Points = {"x": [], "V": [], "E": [], "P": []}
        for time in map(mp.mpf, t):
            x_now, x_size = free_part(mp, m, c, k, x, v, time)
            v_now, v_size = free_part(mp, m, c, k, v, -(c * v + k * x) / m, time)
            points["x"].append(point(x_now, x_size))
            V, V_size = k * x_now**2 / 2, k * x_size**2 / 2
            points["V"].append(point(V, V_size))
            points["E"].append(point(V + m * v_now**2 / 2, V_size + m * v_size**2 / 2))
            points["P"].append(point(c * v_now**2, c * v_size**2))
        return points


def free_part(mp: Any, m: Any, c: Any, k: Any, start: Any, rate: Any, t: Any) -> tuple[Any, Any]:
    """Return anything that obeys m x'' + c x' + k x = 0; all numbers are mpmath's.

    Parameters
    ----------
    mp : MPContext
        The context of mpmath.
    m, c, k : mpf
        The mass in kg, the damping in N s/m and the stiffness in N/m.
    start, rate : mpf
        The value and its rate of change at t = 0.
    t : mpf
        The time in s.

    Returns
    -------
    tuple of two mpf
        The value, and its size: that of both exponentials, or of start and slope where they have not parted.
    """
    root = mp.sqrt(c * c - 4 * m * k)
    p, q = (-c + root) / (2 * m), (-c - root) / (2 * m)
    slope = abs(start) + abs(rate - mp.re(p) * start) * t
    if p == q:
        return mp.exp(p * t) * (start + (rate - p * start) * t), mp.exp(p * t) * slope
    A, B = (rate - q * start) / (p - q), (p * start - rate) / (p - q)
    value = mp.re(A * mp.exp(p * t) + B * mp.exp(q * t))
    apart = abs(A) * mp.exp(mp.re(p) * t) + abs(B) * mp.exp(mp.re(q) * t)
    return value, min(apart, mp.exp(mp.re(p) * t) * slope) if abs(p - q) * t < 1 else apart


def driven_points(
    oscillator: DrivenOscillator, omega: float, size: float, kind: Drive, x_0: float, v_0: float, t: Sequence[float]
) -> Points:
    """Return the motion under a drive that begins at t = 0.

    The size is that of the free motion, and of what the drive can have done by then.

    Parameters
    ----------
    oscillator : DrivenOscillator
        The mass, the dashpot and the spring.
    omega, size, kind
        The drive, as in `DrivenOscillator.response`.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    t : sequence of float
        A few times in s.

    Returns
    -------
    dict of lists of Point
        x in m.
    """
    import mpmath as mp

    with mp.workprec(BITS):
        m, c, k, w, of, x, v = (mp.mpf(a) for a in (oscillator.m, oscillator.c, oscillator.k, omega, size, x_0, v_0))
        F = _force(mp, kind, of, w, c, k)
        own = mp.sqrt(k / m)
        points: Points = {"x": []}
        for time in map(mp.mpf, t):
            free, free_size = free_part(mp, m, c, k, x, v, time)
            pushed, most = mp.mpf(0), mp.mpf(0)
            if F and w:
                pushed = mp.im(F / m * _from_rest(mp, m, c, k, w, time))
                impulse = min(time, 2 / own if own else time)
                most = abs(F) / m * min(time**2 / 2, time * impulse, 2 / abs(own**2 - w**2) if own != w else mp.inf)
                most = max(min(most, 4 * abs(F) / (c * w) * (1 + w / own) if c else most), abs(pushed))
            points["x"].append(point(free + pushed, free_size + most))
        return points


def _force(mp: Any, kind: Drive, size: Any, w: Any, c: Any, k: Any) -> Any:
    return {"force": mp.mpc(size), "base": mp.mpc(k, c * w) * size, "unbalance": mp.mpc(size * w * w)}[kind]


def _from_rest(mp: Any, m: Any, c: Any, k: Any, w: Any, t: Any) -> Any:
    """The second divided difference of exp(z t) at i w and both roots; equal roots are separated by a small amount."""
    root = mp.sqrt(mp.mpc(c * c - 4 * m * k))
    n, p, q = mp.mpc(0, w), (-c + root) / (2 * m), (-c - root) / (2 * m)
    hair = mp.mpf(2) ** (-BITS // 3) * (1 + abs(p))
    p, q = (p + hair, q - hair) if p == q or n in (p, q) else (p, q)
    parts = ((n, p, q), (p, n, q), (q, n, p))
    return sum(mp.exp(z * t) / ((z - a) * (z - b)) for z, a, b in parts)


def response_points(oscillator: DrivenOscillator, kind: Drive, omega: Sequence[float]) -> Points:
    """Return the steady response; sizes are the errors that a rounded r = omega/omega_n causes.

    Parameters
    ----------
    oscillator : DrivenOscillator
        The mass, the dashpot and the spring.
    kind : {"force", "base", "unbalance"}
        The drive.
    omega : sequence of float
        A few frequencies in rad/s.

    Returns
    -------
    dict of lists of Point
        M, which is |X| over F_0/k, over Y or over mu e/m, and the lag in rad.
    """
    import mpmath as mp

    with mp.workprec(BITS // 4):
        m, c, k = (mp.mpf(a) for a in (oscillator.m, oscillator.c, oscillator.k))
        points: Points = {"M": [], "lag": []}
        for w in map(mp.mpf, omega):
            D = mp.mpc(k - m * w * w, c * w)
            X = _force(mp, kind, mp.mpf(1), w, c, k) / D * {"force": k, "base": mp.mpf(1), "unbalance": m}[kind]
            r = w * mp.sqrt(m / k)
            turned = -mp.arg(X)
            bend = c * w * (k + m * w * w) / abs(D) ** 2
            points["M"].append(point(abs(X), abs(X) * (1 + r * r * k / abs(D) / 5)))
            points["lag"].append(point(turned if X else mp.mpf(0), abs(turned) + 1 + bend / 10))
        return points
