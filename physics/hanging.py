"""Energy of a mass that hangs on a spring (lecture D31, slides 4 to 6).

    ////////           natural length
       |            ------------------------
       \\                                   delta_st = m g/k
       / k          ------- static equilibrium, x = 0
       \\                                   x, downward
      [m]           -------

Counted from equilibrium V = k (x + delta_st)^2/2 - k delta_st^2/2 - m g x, and because k delta_st = m g
this is V = k x^2/2: gravity moves the equilibrium and drops out of the motion, omega_n = sqrt(k/m) does not
contain g. d/dt (T + V) = m x' x'' + k x x' = 0 is the equation of motion; T and V are exchanged at 2 omega_n.

T_max = V_max holds for this datum only. With the spring's energy k (x + delta_st)^2/2 and the weight's -m g x
counted separately, V is k x^2/2 + k delta_st^2/2: larger by the constant m g delta_st/2.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from physics.energy import half_square
from physics.motion import ExactMotion, computed_by
from physics.oscillator import Oscillator, OscillatorMotion
from physics.precision.exact import Array, exact, precise, rounded, snapped, split, two_sum
from physics.valid import check_not_negative, check_positive, finite_array, in_range, keep_doubles

Datum = Literal["equilibrium", "separate"]


@dataclass(frozen=True, kw_only=True)
class HangingMass:
    """A mass that hangs on a spring.

    Parameters
    ----------
    m : float
        The mass in kg, above 0.
    k : float
        The stiffness in N/m, above 0.
    g : float
        Gravity in m/s^2, 0 or more.

    Raises
    ------
    ValueError
        If a number is not possible.
    """

    m: float
    k: float
    g: float

    def __post_init__(self) -> None:
        keep_doubles(self, "m", "k", "g")
        check_positive("a mass in kg", m=self.m)
        check_positive("the stiffness in N/m that a weight hangs on", k=self.k)
        check_not_negative("gravity in m/s^2", g=self.g)

    @cached_property
    def oscillator(self) -> Oscillator:
        """The motion about equilibrium; without g."""
        return Oscillator(m=self.m, k=self.k)

    @property
    def omega_n(self) -> float:
        """Natural frequency in rad/s."""
        return self.oscillator.omega_n

    @cached_property
    def weight(self) -> float:
        """m g in N, rounded once."""
        with precise():
            return rounded("the weight m g", exact(self.m) * exact(self.g))

    @cached_property
    def delta_st(self) -> float:
        """Static deflection m g/k in m, rounded once."""
        with precise():
            return rounded("the static deflection", exact(self.m) * exact(self.g) / exact(self.k))

    @cached_property
    def datum_shift(self) -> float:
        """V counted separately less V counted from equilibrium: k delta_st^2/2 = (m g)^2/(2 k) in J."""
        with precise():
            return rounded("the energy k delta_st^2/2", (exact(self.m) * exact(self.g)) ** 2 / (2 * exact(self.k)))

    def motion(self, x_0: float, v_0: float, t: ArrayLike) -> OscillatorMotion:
        """Return the free motion about equilibrium, within 2 u of the amplitudes.

        Parameters
        ----------
        x_0 : float
            The displacement from equilibrium in m at t = 0, downward.
        v_0 : float
            The velocity in m/s at t = 0, downward.
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        OscillatorMotion
            x, v and a, each (n,).

        Raises
        ------
        ValueError
            If a number is not finite, or x, v or a leaves the range of doubles.
        """
        return self.oscillator.motion(x_0, v_0, t)

    def well(self, x: ArrayLike, datum: Datum = "equilibrium") -> Array:
        """Return V(x), off by at most 2 u: no term cancels another.

        Parameters
        ----------
        x : array_like, shape (n,)
            Displacements from equilibrium in m, downward.
        datum : {"equilibrium", "separate"}
            V counted from equilibrium, k x^2/2, or both energies counted separately: larger by `datum_shift`.

        Returns
        -------
        ndarray, shape (n,)
            V in J.

        Raises
        ------
        ValueError
            If a number is not finite, or k x^2/2 or `datum_shift` leaves the range of doubles.
        """
        V = half_square("V", self.k, finite_array("x", x))
        return V + self.datum_shift if datum == "separate" else V

    def spring(self, x: ArrayLike) -> Array:
        """Return the energy of the spring, counted from its natural length; off by at most 4 u.

        Parameters
        ----------
        x : array_like, shape (n,)
            Displacements from equilibrium in m, downward.

        Returns
        -------
        ndarray, shape (n,)
            k (x + delta_st)^2/2 in J.

        Raises
        ------
        ValueError
            If a number is not finite, or an energy leaves the range of doubles.
        """
        with precise():
            deflection, rest = split(snapped(exact(self.m) * exact(self.g) / exact(self.k)))
        with np.errstate(over="ignore", invalid="ignore"):
            stretch, error = two_sum(finite_array("x", x), deflection)
            stretch += error + rest
        return half_square("of the spring", self.k, stretch)

    def spring_along(self, x: ExactMotion) -> ExactMotion:
        """Return the energy of the spring along a motion.

        Parameters
        ----------
        x : ExactMotion
            The displacement from equilibrium in m, downward.

        Returns
        -------
        ExactMotion
            The energy in J; its values are those of `spring`.

        Raises
        ------
        ValueError
            If the weight or `datum_shift` leaves the range of doubles.
        """
        energy = 0.5 * self.k * x**2 + self.weight * x + self.datum_shift
        return computed_by(lambda t: self.spring(x.at(t)), energy)

    def gravity(self, x: ArrayLike) -> Array:
        """Return the energy in gravity, counted from x = 0.

        Parameters
        ----------
        x : array_like, shape (n,)
            Displacements from equilibrium in m, downward.

        Returns
        -------
        ndarray, shape (n,)
            -m g x in J.

        Raises
        ------
        ValueError
            If a number is not finite, or the weight or an energy leaves the range of doubles.
        """
        with np.errstate(over="ignore"):
            return in_range("the energy of gravity", -self.weight * finite_array("x", x))
