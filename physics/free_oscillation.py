"""Free motion of an oscillator from its initial conditions, as motions that can be drawn and played.

The equations are in physics.oscillator (lecture D31, slides 1 to 3); if k = 0, the mass drifts at constant speed.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from math import floor, pi
from operator import attrgetter

import numpy as np

from physics.motion import Elementary, ExactMotion, Harmonic, computed_by, constant, remembered
from physics.oscillator import Oscillator, OscillatorConstants, OscillatorMotion
from physics.precision.exact import Array, exact, precise, rounded, sin_cos
from physics.sampling import Sinusoid

QUARTER = pi / 2
NAMES = ("displacement", "velocity", "acceleration")


@dataclass(frozen=True, kw_only=True)
class FreeOscillation:
    """A motion of an oscillator from x(0) = x_0 (m), x'(0) = v_0 (m/s).

    Parameters
    ----------
    oscillator : Oscillator
        The mass on its spring.
    x_0, v_0 : float
        The displacement in m and the velocity in m/s at t = 0.
    """

    oscillator: Oscillator
    x_0: float
    v_0: float

    @cached_property
    def constants(self) -> OscillatorConstants:
        """The constants of both forms of the solution."""
        return self.oscillator.constants(self.x_0, self.v_0)

    def amplitude(self, derivative: int) -> float:
        """Return C, omega C or omega^2 C, of x, v or a; of a free mass |x_0|, its constant speed, or 0.

        Parameters
        ----------
        derivative : {0, 1, 2}
            0 for x, 1 for v, 2 for a.

        Returns
        -------
        float
            The amplitude in m, m/s or m/s^2.

        Raises
        ------
        ValueError
            If the amplitude leaves the range of doubles.
        """
        if derivative not in self._amplitudes:
            self._amplitudes[derivative] = self._amplitude(derivative)
        return self._amplitudes[derivative]

    @cached_property
    def _amplitudes(self) -> dict[int, float]:
        """The amplitudes that are known already."""
        return {}

    def _amplitude(self, derivative: int) -> float:
        if not self.oscillator.k:
            return (abs(self.x_0), abs(self.v_0), 0.0)[derivative]
        with precise():
            size = exact(self.oscillator.omega_n) ** derivative * exact(self.constants.C)
            return rounded(f"the largest {NAMES[derivative]}", size)

    @cached_property
    def E(self) -> float:
        """The energy in J, rounded once; V is 0 at x = 0."""
        one = self.oscillator
        with precise():
            return rounded(
                "the energy", (exact(one.m) * exact(self.v_0) ** 2 + exact(one.k) * exact(self.x_0) ** 2) / 2
            )

    @cached_property
    def x(self) -> ExactMotion:
        """The displacement in m."""
        return self._motion_of("x", 0, (self.x_0, self.v_0))

    @cached_property
    def v(self) -> ExactMotion:
        """The velocity in m/s."""
        return self._motion_of("v", 1, (self.v_0, 0.0))

    @cached_property
    def a(self) -> ExactMotion:
        """The acceleration in m/s^2."""
        return self._motion_of("a", 2, (0.0, 0.0))

    @cached_property
    def sine(self) -> ExactMotion:
        """x over its amplitude; it must oscillate, if only with the amplitude 0."""
        return self._turning("sine", self.constants.phi)

    @cached_property
    def cosine(self) -> ExactMotion:
        """v over its amplitude; it must oscillate, if only with the amplitude 0."""
        return self._turning("cosine", self.constants.phi + QUARTER)

    @cached_property
    def T(self) -> ExactMotion:
        """The kinetic energy in J; it must oscillate."""
        return computed_by((0.5 * self.oscillator.m * self.v**2).at, self.E * self.cosine**2)

    @cached_property
    def V(self) -> ExactMotion:
        """The energy of the spring in J, from x = 0; it must oscillate."""
        return computed_by((0.5 * self.oscillator.k * self.x**2).at, self.E * self.sine**2)

    def _turning(self, symbol: str, phase: float) -> ExactMotion:
        omega = self.oscillator.omega_n
        return Elementary(
            symbol=symbol, exact=lambda t: sin_cos(omega, 0.0, t, phase)[0], size=lambda: 1.0, omega=omega,
            played=Harmonic((Sinusoid(1.0, omega, phase),)), amplitude=lambda: constant(1.0),
        )  # fmt: skip

    def _motion_of(self, symbol: str, derivative: int, line: tuple[float, float]) -> ExactMotion:
        """One of x, v and a, a sine a quarter turn ahead for each derivative; of a free mass a line."""
        omega, size = self.oscillator.omega_n, self.amplitude(derivative)
        sine = Sinusoid(size, omega, self.constants.phi + derivative * QUARTER)
        value, motion = attrgetter(symbol), self._motion
        return Elementary(
            symbol=symbol, exact=lambda t: np.asarray(value(motion(t))), size=lambda: size, omega=omega,
            played=Harmonic((sine,)) if omega else Harmonic((), line), amplitude=lambda: constant(size),
            square=lambda: 0.5 * constant(size) ** 2,
        )  # fmt: skip

    @cached_property
    def _motion(self) -> Callable[[Array], OscillatorMotion]:
        """The motion at given times, which x, v and a share."""
        return remembered(partial(self.oscillator.motion, self.x_0, self.v_0))

    def last_peak(self, end: float) -> float:
        """Return the last time in periods, up to `end` in s, at which x is largest; negative if it never is.

        Parameters
        ----------
        end : float
            The last time in s.

        Returns
        -------
        float
            The time of the peak in periods; the motion starts at t = 0.
        """
        first = ((QUARTER - self.constants.phi) % (2 * pi)) / (2 * pi)
        return first + floor(end / self.oscillator.period - first)
