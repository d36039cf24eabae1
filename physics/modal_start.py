"""The free motion of two masses, begun by its modes: amplitude and phase of each (lecture D34, slides 3 to 5).

    x_i(t) = sum_j A_j shape_j[i] sin(omega_j t + phi_j)

A is counted on mass 1, or on mass 2 where mass 1 rests in that mode (k2 = 0), as coordinates are in physics.coupled.
A mode of frequency zero is at rest at A sin(phi): a drift with a velocity has neither amplitude nor phase.
"""

from __future__ import annotations

import math
from decimal import Decimal

from physics.coupled import FreeModes, TwoMassChain
from physics.precision.exact import PI, exact, precise, rounded

Pair = tuple[float, float]
QUARTER = math.pi / 2
SMALLEST = Decimal("1e-90")
"""A term of the series below this adds nothing to 80 digits."""


def modes_given(chain: TwoMassChain, amplitude: Pair, phase: Pair) -> FreeModes:
    """Return the free motion with given amplitudes and phases.

    Parameters
    ----------
    chain : TwoMassChain
        The masses and springs.
    amplitude, phase : tuple of two floats
        Amplitudes in m and phases in rad of the slow and the fast mode.

    Returns
    -------
    FreeModes
        The coordinates of both modes at t = 0.
    """
    coordinate, velocity = [], []
    for mode, A, phi in zip(chain.exact_modes, amplitude, phase, strict=True):
        sine, cosine = _sine_cosine(exact(phi))
        with precise():
            coordinate.append(exact(A) * sine)
            velocity.append(exact(A) * mode.omega * cosine)
    return FreeModes(chain, (coordinate[0], coordinate[1]), (velocity[0], velocity[1]))


def start_given(free: FreeModes) -> tuple[Pair, Pair]:
    """Return the displacements (m) and the velocities (m/s) of both masses at t = 0 of the motion `free`, rounded once.

    ValueError if one leaves the range of doubles.
    """
    with precise():
        x = [sum((mode.shape[i] * q for mode, q, _ in free.each()), Decimal(0)) for i in (0, 1)]
        v = [sum((mode.shape[i] * rate for mode, _, rate in free.each()), Decimal(0)) for i in (0, 1)]
    (x1, x2), (v1, v2) = (
        [rounded(name, value) for value in values] for name, values in (("a displacement", x), ("a velocity", v))
    )
    return (x1, x2), (v1, v2)


def amplitudes_and_phases(free: FreeModes) -> tuple[Pair, Pair]:
    """Return the amplitudes (m) and the phases (rad) of the slow and the fast mode of the motion `free`.

    ValueError if a mode drifts, which has neither, or an amplitude leaves the range of doubles.
    """
    found = []
    for j, (mode, q, v) in enumerate(free.each()):
        if not mode.omega and v:
            raise ValueError(
                "a mode of frequency 0 rad/s drifts. A drift has no amplitude and no phase: starting values are needed"
            )
        with precise():
            size = (q**2 + (v / mode.omega) ** 2).sqrt() if mode.omega else abs(q)
        phase = float(free.phase[j]) if mode.omega else math.copysign(QUARTER, q)
        found.append((rounded("an amplitude", size), phase))
    (A_slow, phi_slow), (A_fast, phi_fast) = found
    return (A_slow, A_fast), (phi_slow, phi_fast)


def _sine_cosine(angle: Decimal) -> tuple[Decimal, Decimal]:
    """The series, after whole turns are removed."""
    with precise():
        rest = angle - 2 * PI * (angle / (2 * PI)).to_integral_value()
        sums, term, n = [Decimal(0), Decimal(0)], Decimal(1), 0
        while abs(term) > SMALLEST:
            sums[n % 2] += -term if n % 4 > 1 else term
            n += 1
            term = term * rest / n
        return sums[1], sums[0]
