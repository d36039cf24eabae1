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
from numpy.typing import ArrayLike, NDArray

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
from physics.curves import Curve, combined, early, is_early, product, response, turning
from physics.exact import (
    PI,
    Array,
    Pair,
    exact,
    pair_product,
    precise,
    rounded,
    snapped,
    split,
    two_product,
    two_sum,
)
from physics.valid import check_finite, check_not_negative, finite_array

REST = (0.0, 0.0)
NONE = Decimal(0)
_CANCELS = Decimal("1e-3")  # of x_c and x_p, what is left of them after a period of the drive
_COMFORT = Decimal("1e40")  # factors of D within this and its inverse cannot over- or underflow


def particular_solution(chain: TwoMassChain, F_0: float, omega: ArrayLike) -> Array:
    """Amplitudes Xp1, Xp2 in m, signed: (2,) for a drive frequency omega in rad/s, (2, n) for n of them.

    +inf where no steady amplitude exists, at a natural frequency exactly, whichever sign it has on the two
    sides. One frequency is worked out in rational numbers and rounded once; a curve is within 2 ulp.
    ValueError if an amplitude leaves the range of doubles.
    """
    frequencies = _checked_drive(F_0, omega)
    if np.ndim(omega) == 0:
        return _rounded_amplitudes(chain, F_0, frequencies[0])
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


def _checked_drive(F_0: float, omega: ArrayLike) -> Array:
    """omega (n,), one frequency included."""
    check_finite("a force in N", F_0=F_0)
    frequencies = finite_array("omega", omega)
    check_not_negative("a drive frequency in rad/s", omega=float(np.min(frequencies, initial=0.0)))
    return frequencies


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
    X1, X2 = exactly
    return np.array(
        [_nearest(f"Xp1 at omega = {omega} rad/s", X1), _nearest(f"Xp2 at omega = {omega} rad/s", X2)]
    )


def _nearest(quantity: str, value: Fraction) -> float:
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{quantity} leaves the range of doubles") from None


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
    D = _from_root(omega, fast.omega)
    over1 = over2 = np.ones_like(omega), np.zeros_like(omega)
    if k2:
        over1 = _from_root(omega, _antiresonance(chain))
        D = pair_product(D, _from_root(omega, slow.omega))
    with precise():
        units = split(-exact(F_0) / m1), split(exact(F_0) * k2 / (m1 * m2))
    at_root = D[0] == 0.0
    D = np.where(at_root, 1.0, D[0]), D[1]
    X = np.array(
        [_quotient(pair_product(unit, over), D) for unit, over in zip(units, (over1, over2), strict=True)]
    )
    return np.where(at_root & (X != 0.0), math.inf, X)


def _from_root(omega: Array, root: Decimal) -> Pair:
    """omega^2 - root^2 from its two factors: exact digits also next to the root."""
    hi, lo = split(root)
    return pair_product(_plus(omega, -hi, -lo), _plus(omega, hi, lo))


def _plus(omega: Array, hi: float, lo: float) -> Pair:
    s, e = two_sum(omega, hi)
    return two_sum(s, e + lo)


def _quotient(a: Pair, b: Pair) -> Array:
    """a/b, the quotient of the leading parts corrected once."""
    first = a[0] / b[0]
    p, e = two_product(first, b[0])
    result: Array = first + ((a[0] - p) - e + a[1] - first * b[1]) / b[0]
    return result


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
        start = self._early(t)
        x, v, e = (np.empty((2, t.size)) for _ in range(3))
        for where, terms in ((start, self._from_rest), (~start, self._driven)):
            if not np.any(where):
                continue
            part = motion_of([*self.free.terms(t[where]), *terms(t[where])], t[where])
            x[:, where], v[:, where], e[:, where] = part.x, part.v, part.e
        return Motion(t, x, v, e)

    @cached_property
    def complementary_modes(self) -> FreeModes:
        """The modes of x_c, the free motion that remains without the particular one; ValueError at resonance."""
        X = self._exact_particular()
        with precise():
            v1_0, v2_0 = (v - exact(self.omega) * part for v, part in zip(self.v_0, X, strict=True))
        return started(self.chain, self.x_0, (v1_0, v2_0))

    def complementary(self, t: ArrayLike) -> Array:
        """x_c (2, n); ValueError at resonance."""
        t = finite_array("t", t)
        return motion_of(self.complementary_modes.terms(t), t).x

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

    def _early(self, t: Array) -> NDArray[np.bool_]:
        if not self.omega:
            return np.zeros(t.shape, dtype=np.bool_)
        return is_early(self._frequencies, t)

    @property
    def _frequencies(self) -> list[Decimal]:
        return [exact(self.omega), *(mode.omega for mode in self.chain.exact_modes)]

    def _from_rest(self, t: Array) -> list[Terms]:
        """At first the modes all but cancel in mass 2, which starts like t^5: series give its motion."""
        m1, m2, _, k2 = self.chain.exact_parameters
        curves = early(self._frequencies, t, 5), early(self._frequencies, t, 4)
        with precise():
            push = exact(self.F_0) * k2 / (m1 * m2)
        nothing, x2, v2 = (NONE, NONE), (push, NONE), (NONE, push)
        rest = [
            Terms(curves, [x1, nothing, e2, v1, nothing]) for curves, (x1, _, e2, v1, _) in self._driven(t)
        ]
        return [*rest, Terms(curves, [nothing, x2, nothing, nothing, v2])]

    def _driven(self, t: Array) -> list[Terms]:
        result = []
        for mode in self.chain.exact_modes:
            if not (self.omega and mode.shape[0]):
                continue
            with precise():
                share = exact(self.F_0) * mode.shape[0] / mode.mass
                rows = [(part * share, NONE) for part in mode.rows]
                rows += [(NONE, part * share) for part in mode.shape]
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


def determinant(chain: TwoMassChain, omega: float) -> float:
    """D = det A at a frequency in rad/s, correctly rounded; ValueError if it leaves the range of doubles."""
    m1, m2, k1, k2, w = (Fraction(value) for value in (chain.m1, chain.m2, chain.k1, chain.k2, omega))
    try:
        return float((k1 + k2 - m1 * w**2) * (k2 - m2 * w**2) - k2**2)
    except OverflowError:
        raise ValueError(f"D at omega = {omega} rad/s leaves the range of doubles") from None


def driven_modes(
    chain: TwoMassChain, F_0: float, omega: float, x_0: ArrayLike = REST, v_0: ArrayLike = REST
) -> DrivenModes:
    """The modes of the chain under F_0 sin(omega t) on mass 1, F_0 in N, omega >= 0 in rad/s."""
    _checked_drive(F_0, omega)
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
