"""One damped oscillator under a push that is not a sine, in arbitrary precision; independent of physics.pushed.

The motion is the sum of what each edge of the push starts: divided differences of exp(z t) over the roots of
m s^2 + c s + k, with one node at 0 more for an edge, and two more for a change of slope. For the pushes and their
source see physics.periodic.
"""

from collections.abc import Iterator, Sequence
from typing import Any

from physics.damped import DampedOscillator
from physics.periodic import PeriodicPush
from physics.reference.damped import Points, free_part
from physics.reference.driven_chain import point

BITS = 1000


def pushed_points(
    oscillator: DampedOscillator, push: PeriodicPush, x_0: float, v_0: float, largest: float, t: Sequence[float]
) -> Points:
    """Return the motion under a push.

    Parameters
    ----------
    oscillator : DampedOscillator
        The mass, the dashpot and the spring.
    push : PeriodicPush
        The push, which begins at t = 0.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    largest : float
        The largest |x| in m from rest: with the size of the free motion it is the size of a value.
    t : sequence of float
        A few times in s.

    Returns
    -------
    dict of lists of Point
        x in m.
    """
    import mpmath as mp

    with mp.workprec(BITS):
        m, c, k, x, v = (mp.mpf(one) for one in (oscillator.m, oscillator.c, oscillator.k, x_0, v_0))
        points: Points = {"x": []}
        for time in map(mp.mpf, t):
            free, size = free_part(mp, m, c, k, x, v, time)
            parts = (size * _left(mp, m, c, k, time - at, zeros) for at, zeros, size in _edges(mp, push, time))
            points["x"].append(point(free + mp.fsum(parts), size + mp.mpf(largest)))
        return points


def _edges(mp: Any, push: PeriodicPush, end: Any) -> Iterator[tuple[Any, int, Any]]:
    """The times in s of all edges until the end, with their order: 0 for an impulse, 1 for an edge, 2 for a slope."""
    F, T = mp.mpf(push.size), 2 * mp.pi / mp.mpf(push.omega)
    if push.kind in ("impulse", "step"):
        yield mp.mpf(0), int(push.kind == "step"), F
        return
    quarter, w = mp.mpf(1) / 4, mp.mpf(push.width)
    each = {
        "square": [(0, 1, 2 * F), (2 * quarter, 1, -2 * F)],
        "triangle": [(quarter, 2, -8 * F / T), (3 * quarter, 2, 8 * F / T)],
        "pulses": [(0, 1, F), (w, 1, -F)],
        "impulses": [(0, 0, F)],
    }[push.kind]
    if push.kind == "square":
        yield mp.mpf(0), 1, -F
    if push.kind == "triangle":
        yield mp.mpf(0), 2, 4 * F / T
    for period in range(int(end / T) + 1):
        yield from (((period + share) * T, zeros, size) for share, zeros, size in each if (period + share) * T < end)


def _left(mp: Any, m: Any, c: Any, k: Any, t: Any, zeros: int) -> Any:
    """The motion that an edge of this order and of size 1 starts; equal nodes are separated by a small amount."""
    root = mp.sqrt(mp.mpc(c * c - 4 * m * k))
    hair = mp.mpf(2) ** (-BITS // 6) / (t or 1)
    nodes: list[Any] = []
    for z in (*(mp.mpc(0),) * zeros, (-c + root) / (2 * m), (-c - root) / (2 * m)):
        while any(abs(z - other) < hair / 2 for other in nodes):
            z += hair
        nodes.append(z)
    parts = (mp.exp(z * t) / mp.fprod(z - other for other in nodes if other is not z) for z in nodes)
    return mp.re(mp.fsum(parts)) / m
