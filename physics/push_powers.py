"""Mean powers of a motion under a push that repeats: what the push puts in, and what the dashpot takes.

The dashpot takes c v^2, which is integrated between the edges of the push, where v is smooth. The push puts in what the
dashpot takes and what the energy (m v^2 + k x^2)/2 gains; an impulse changes it at once. For the motion see
physics.steady_motions.
"""

import math

import numpy as np

from physics.forced_vibration import MeanPowers
from physics.steady_motions import SteadyMotion

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)
_FEWEST = 4  # times in a period


def mean_powers(motion: SteadyMotion, x_0: float, v_0: float, end: float, count: int) -> MeanPowers:
    """Return the mean powers of the last period before each time; before t = 0 there are none.

    Parameters
    ----------
    motion : SteadyMotion
        The oscillator and its push.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    end : float
        The last time in s.
    count : int
        The least number of times.

    Returns
    -------
    MeanPowers
        Times in s and powers in W.
    """
    one, period = motion.oscillator, motion.period
    turns = end / period
    per = max(_FEWEST, math.ceil(count / max(turns, 1.0)))
    even, edges = min(turns, 1.0) * np.arange(per) / per, [float(piece.begin) for piece in motion.push.pieces]
    shares = np.unique([*even, *(edge for edge in edges if edge < turns), turns % 1.0])
    widths = np.diff(shares, append=1.0)
    begun = np.arange(math.floor(turns) + 1)
    inner = (shares[:, None] + widths[:, None] * (1 + _NODES) / 2).ravel()
    _, fast = motion.after(x_0, v_0, np.repeat(begun, inner.size), np.tile(inner * period, begun.size))
    x, v = motion.after(x_0, v_0, np.repeat(begun, shares.size), np.tile(shares * period, begun.size))
    pieces = one.c * (fast**2).reshape(-1, _NODES.size) @ _WEIGHTS * np.tile(widths, begun.size) * period / 2
    lost, energy = np.concatenate([[0.0], np.cumsum(pieces)[:-1]]), (one.m * v**2 + one.k * x**2) / 2
    earlier = [(0.0, (one.m * v_0**2 + one.k * x_0**2) / 2)] * shares.size
    lost_before, energy_before = np.array([*earlier, *zip(lost, energy, strict=True)])[: lost.size].T
    P_lost = (lost - lost_before) / period
    t = (begun[:, None] + shares).ravel()
    seen = t <= turns
    return MeanPowers(t[seen] * period, (P_lost + (energy - energy_before) / period)[seen], P_lost[seen])
