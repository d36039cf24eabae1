"""Two masses and two springs, driven (lecture D34, slides 6 to 9).

    wall --k1-- [m1] --k2-- [m2]        F_0 sin(omega t) on m1, to the right; no friction

    m1 x1'' = -k1 x1 - k2 (x1 - x2) + F_0 sin(omega t)
    m2 x2'' =  k2 (x1 - x2)

Particular solution, x_i = Xp_i sin(omega t):

    Xp1 = (k2 - m2 omega^2) F_0/D,   Xp2 = k2 F_0/D,   D = m1 m2 (omega^2 - omega_-^2)(omega^2 - omega_+^2).

Near a natural frequency the lecture's split, total = complementary + particular, is a difference of two huge
motions. So the motion is formed mode by mode: the free motion of the start plus the response g from rest,
which grows like t at resonance and needs no particular solution.
"""

import math
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from physics.coupled import (
    FreeModes,
    Mode,
    Motion,
    Terms,
    TwoMassChain,
    Vector,
    each_mass,
    motion_of,
    started,
)
from physics.curves import Curve, combined, product, response, turning
from physics.exact import PI, Array, exact, precise, rounded, snapped, split
from physics.valid import check_finite, check_not_negative, finite_array

REST = (0.0, 0.0)
_CANCELS = Decimal("1e-3")  # of x_c and x_p, what is left of them after a period of the drive
_COMFORT = Decimal("1e40")  # factors of D within this and its inverse cannot over- or underflow


def particular_solution(chain: TwoMassChain, F_0: float, omega: ArrayLike) -> Array:
    """Amplitudes Xp1, Xp2 in m, signed: (2,) for a drive frequency omega in rad/s, (2, n) for n of them.

    +inf where no steady amplitude exists, at a natural frequency exactly, whichever sign it has on the two
    sides. One frequency is worked out in rational numbers and rounded once; a curve is within 8 ulp.
    ValueError if an amplitude leaves the range of doubles.
    """
    _check_drive(F_0, omega)
    if np.ndim(omega) == 0:
        return _rounded_amplitudes(chain, F_0, float(np.asarray(omega)))
    frequencies = finite_array("omega", omega)
    if _comfortable(chain, F_0, frequencies):
        return _response_curve(chain, F_0, frequencies)
    return np.array([_rounded_amplitudes(chain, F_0, w) for w in frequencies]).reshape(-1, 2).T


def antiresonance(chain: TwoMassChain) -> float:
    """The frequency sqrt(k2/m2) at which mass 1 stands still, correctly rounded."""
    with precise():
        return float(_antiresonance(chain))


def _antiresonance(chain: TwoMassChain) -> Decimal:
    _, m2, _, k2 = chain.exact_parameters
    with precise():
        return snapped((k2 / m2).sqrt())


def _check_drive(F_0: float, omega: ArrayLike) -> None:
    check_finite("a force in N", F_0=F_0)
    for w in finite_array("omega", np.ravel(np.asarray(omega, dtype=np.float64))):
        check_not_negative("a drive frequency in rad/s", omega=w)


def _amplitudes(chain: TwoMassChain, F_0: float, omega: float) -> tuple[Fraction, Fraction] | None:
    """Xp1 and Xp2, exactly; None at a natural frequency."""
    F, w = Fraction(F_0), Fraction(omega)
    m1, m2, k1, k2 = (Fraction(value) for value in (chain.m1, chain.m2, chain.k1, chain.k2))
    if not F:
        return F, F
    if not k2:
        D = k1 - m1 * w**2
        return (F / D, Fraction(0)) if D else None
    D = (k1 + k2 - m1 * w**2) * (k2 - m2 * w**2) - k2**2
    return ((k2 - m2 * w**2) * F / D, k2 * F / D) if D else None


def _rounded_amplitudes(chain: TwoMassChain, F_0: float, omega: float) -> Array:
    exactly = _amplitudes(chain, F_0, omega)
    if exactly is None:
        return np.array([math.inf, math.inf if chain.k2 else 0.0])
    try:
        return np.array([float(amplitude) for amplitude in exactly])
    except OverflowError:
        raise ValueError(f"the amplitude Xp at omega = {omega} rad/s leaves the range of doubles") from None


def _comfortable(chain: TwoMassChain, F_0: float, omega: Array) -> bool:
    slow, fast = chain.exact_modes
    m1, m2, _, k2 = chain.exact_parameters
    with precise():
        factors = [
            slow.omega,
            fast.omega,
            exact(F_0) / m1,
            exact(F_0) * k2 / (m1 * m2),
            _antiresonance(chain),
        ]
    factors += [exact(w) for w in (np.max(omega, initial=0.0), np.min(omega[omega > 0.0], initial=1.0))]
    return all(1 / _COMFORT < abs(factor) < _COMFORT for factor in factors if factor)


def _response_curve(chain: TwoMassChain, F_0: float, omega: Array) -> Array:
    """Xp1, Xp2 (2, n) from the factors of D and of k2 - m2 omega^2, none of which cancels."""
    slow, fast = chain.exact_modes
    m1, m2, _, k2 = chain.exact_parameters
    with precise():
        unit1, unit2 = float(-exact(F_0) / m1), float(exact(F_0) * k2 / (m1 * m2))
    D = _from_root(omega, fast.omega)
    over = np.ones_like(omega)
    if k2:
        over = _from_root(omega, _antiresonance(chain))
        D *= _from_root(omega, slow.omega)
    with np.errstate(divide="ignore"):
        X = np.array([unit1 * (over / D), unit2 / D])
    return np.where((D == 0.0) & (np.array([[F_0], [unit2]]) != 0.0), math.inf, X)


def _from_root(omega: Array, root: Decimal) -> Array:
    """omega^2 - root^2, to 4 u also next to the root."""
    hi, lo = split(root)
    return ((omega - hi) - lo) * (omega + hi)


@dataclass(frozen=True, eq=False)
class DrivenModes:
    """The motion under F_0 sin(omega t) on mass 1 from any start, mode by mode (j: slow, fast; i: mass).

    x_i(t) = (free motion of the start)_i + F_0 sum_j coupling[j, i] g(t; omega, omega_j), where
    g'' + omega_j^2 g = sin(omega t) from rest. free are the modes of the start alone.
    """

    chain: TwoMassChain
    F_0: float
    omega: float
    x_0: Vector
    v_0: Vector

    @cached_property
    def free(self) -> FreeModes:
        return started(self.chain, self.x_0, self.v_0)

    @cached_property
    def detuning(self) -> Array:
        """omega - omega_j (2,), rounded once: not the difference of two rounded frequencies."""
        with precise():
            return np.array([float(exact(self.omega) - mode.omega) for mode in self.chain.exact_modes])

    @cached_property
    def coupling(self) -> Array:
        """(2 modes, 2 masses) in 1/kg."""
        with precise():
            return np.array(
                [
                    [rounded("a coupling", mode.shape[0] * part / mode.mass) for part in mode.shape]
                    for mode in self.chain.exact_modes
                ]
            )

    @cached_property
    def particular(self) -> Array:
        """Xp1, Xp2."""
        return particular_solution(self.chain, self.F_0, self.omega)

    @cached_property
    def split_is_meaningful(self) -> bool:
        """Whether x_c and x_p are worth drawing: they cancel to no less than 1/1000 within a period of the
        drive.

        From rest the total grows to about |omega - omega_j| times a period of what either has; at resonance
        x_p does not exist.
        """
        if _amplitudes(self.chain, self.F_0, self.omega) is None:
            return False
        with precise():
            shares = [
                2 * PI * abs(exact(self.omega) - mode.omega)
                for mode in self.chain.exact_modes
                if mode.shape[0] and self.F_0
            ]
            return all(share >= _CANCELS * exact(self.omega) for share in shares)

    def motion(self, t: ArrayLike) -> Motion:
        """The motion at times t (n,), within 16 u of its envelope at every detuning."""
        t = finite_array("t", t)
        return motion_of([*self.free.terms(t), *self._driven(t)], t)

    def complementary(self, t: ArrayLike) -> Array:
        """x_c (2, n), the free motion that remains without the particular one; ValueError at resonance."""
        t = finite_array("t", t)
        X = self._exact_particular()
        with precise():
            v_0 = [v - exact(self.omega) * part for v, part in zip(self.v_0, X, strict=True)]
        return motion_of(started(self.chain, self.x_0, (v_0[0], v_0[1])).terms(t), t).x

    def particular_motion(self, t: ArrayLike) -> Array:
        """x_p (2, n) = Xp sin(omega t); ValueError at resonance."""
        omega = exact(self.omega)
        with precise():
            rows = [[part * omega] for part in self._exact_particular()]
        return combined(rows, [turning(omega, finite_array("t", t))[1]], ("x1 of x_p", "x2 of x_p"))

    def work(self, t: ArrayLike) -> Array:
        """The work of the drive since t = 0, (n,) in J.

        Mode by mode the integral of sin(omega t) p'(t) is p' g' + omega_n^2 p g for its free part p, and
        (g'^2 + omega_n^2 g^2)/2 for its response; no displacement and no spring enters.
        """
        t = finite_array("t", t)
        row: list[Decimal] = []
        curves: list[Curve] = []
        for (mode, q, v), terms in zip(self.free.each(), self.free.terms(t), strict=True):
            for factor, curve in self._works(mode, q, v, terms.curves, t):
                row.append(factor)
                curves.append(curve)
        return combined([row], curves, ("the work of the drive",))[0] if row else np.zeros_like(t)

    def _driven(self, t: Array) -> list[Terms]:
        result = []
        for mode in self.chain.exact_modes:
            if not (self.omega and mode.shape[0]):
                continue
            with precise():
                share = exact(self.F_0) * mode.shape[0] / mode.mass
                none = Decimal(0)
                rows = [(part * share, none) for part in mode.rows]
                rows += [(none, part * share) for part in mode.shape]
            result.append(Terms(response(exact(self.omega), mode.omega, t), rows))
        return result

    def _works(
        self, mode: Mode, q: Decimal, v: Decimal, free: tuple[Curve, Curve], t: Array
    ) -> list[tuple[Decimal, Curve]]:
        if not (self.omega and mode.shape[0]):
            return []
        g, speed = response(exact(self.omega), mode.omega, t)
        cosine, sine = free
        with precise():
            F, square = exact(self.F_0) * mode.shape[0], mode.omega**2
            half = F / mode.mass / 2
            factors = (v, -square * q, square * q, square * v, half, half * square)
            first, second = (cosine, sine, cosine, sine, speed, g), (speed, speed, g, g, speed, g)
            return [(F * c, product(a, b)) for c, a, b in zip(factors, first, second, strict=True)]

    def _exact_particular(self) -> tuple[Decimal, Decimal]:
        exactly = _amplitudes(self.chain, self.F_0, self.omega)
        if exactly is None:
            raise ValueError(
                f"omega = {self.omega} rad/s is a natural frequency: no particular solution exists"
            )
        with precise():
            X1, X2 = (Decimal(part.numerator) / Decimal(part.denominator) for part in exactly)
            return X1, X2


def driven_modes(
    chain: TwoMassChain, F_0: float, omega: float, x_0: ArrayLike = REST, v_0: ArrayLike = REST
) -> DrivenModes:
    """The modes of the chain under F_0 sin(omega t) on mass 1, F_0 in N, omega >= 0 in rad/s."""
    _check_drive(F_0, omega)
    return DrivenModes(chain, float(F_0), float(omega), each_mass("x_0", x_0), each_mass("v_0", v_0))


def forced_motion(
    chain: TwoMassChain,
    F_0: float,
    omega: float,
    t: ArrayLike,
    x_0: ArrayLike = REST,
    v_0: ArrayLike = REST,
) -> Motion:
    """The motion under F_0 sin(omega t) on mass 1, at rest in equilibrium at t = 0 unless told otherwise."""
    return driven_modes(chain, F_0, omega, x_0, v_0).motion(t)


def drive_work(
    chain: TwoMassChain,
    F_0: float,
    omega: float,
    t: ArrayLike,
    x_0: ArrayLike = REST,
    v_0: ArrayLike = REST,
) -> Array:
    """The work of the drive since t = 0, (n,) in J; see DrivenModes.work."""
    return driven_modes(chain, F_0, omega, x_0, v_0).work(t)


def steady_start(
    chain: TwoMassChain, F_0: float, omega: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    """(x_0, v_0) = (0, omega Xp), from which x_p is the whole motion; ValueError at resonance."""
    modes = driven_modes(chain, F_0, omega)
    with precise():
        v1_0, v2_0 = (rounded("omega Xp", exact(modes.omega) * part) for part in modes._exact_particular())
    return REST, (v1_0, v2_0)
