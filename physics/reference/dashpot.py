"""The motion of one mass with a dashpot in arbitrary precision, independent of physics.damped.

The roots of m r^2 + c r + k, the particular solution by complex division, and the two constants from the initial
conditions.

Source: J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.6 and 2.9.
"""

from typing import Any

from physics.integrators.problem import Problem

DIGITS = 120


def dashpot_rows(problem: Problem) -> list[tuple[Any, Any, Any]]:
    """Return x1 in m, v1 in m/s and the energy in J at the output times of a `problem` with two different roots.

    They are numbers of mpmath.
    """
    import mpmath

    with mpmath.workdps(DIGITS):
        mp = mpmath.mp
        m, k, c, F, w = (
            mp.mpf(value) for value in (problem.chain.m1, problem.chain.k1, problem.c, problem.F_0, problem.omega)
        )
        root = mp.sqrt(c * c - 4 * m * k)
        slow, fast = (-c + root) / (2 * m), (-c - root) / (2 * m)
        X = F / mp.mpc(k - m * w * w, c * w) if F else mp.mpc(0)
        x, v = mp.mpf(problem.x_0[0]) - X.imag, mp.mpf(problem.v_0[0]) - w * X.real
        A, B = (v - fast * x) / (slow - fast), (v - slow * x) / (fast - slow)
        rows = []
        for t in map(mp.mpf, problem.t.tolist()):
            parts = (A * mp.exp(slow * t), B * mp.exp(fast * t), X * mp.expj(w * t))
            now = parts[0] + parts[1] + parts[2].imag
            rate = slow * parts[0] + fast * parts[1] + (w * parts[2]).real
            rows.append((now, rate, (m * rate**2 + k * now**2) / 2))
        return rows
