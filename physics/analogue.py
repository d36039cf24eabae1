"""Analogues: oscillating systems by their parameters, their coordinate, and the quantities in the roles of m and k.

Formulas are functions of 80-digit decimals and rounded once. The systems of lecture D31, slide 7, are in
physics.analogues.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from math import sin
from types import SimpleNamespace
from typing import Any

from physics.pendulum import Pendulum
from physics.precision.exact import exact, precise, rounded
from physics.valid import DOUBLES, check_finite, check_positive

Formula = Callable[[Any], Decimal]


@dataclass(frozen=True)
class Parameter:
    """A parameter above 0, or a whole number from 1 on.

    Attributes
    ----------
    name : str
        Its name in the formulas of the code.
    symbol : str
        Its symbol in LaTeX.
    unit : str
        Its unit; empty for a plain number.
    default : float
        Its default in that unit.
    whole : bool
        True if only whole numbers are allowed.
    """

    name: str
    symbol: str
    unit: str
    default: float
    whole: bool = False


@dataclass(frozen=True)
class Constant:
    """A constant of the system, which visitors cannot change.

    Attributes
    ----------
    name : str
        Its name in the formulas of the code.
    symbol : str
        Its symbol in LaTeX.
    unit : str
        Its unit.
    value : float
        Its value in that unit.
    """

    name: str
    symbol: str
    unit: str
    value: float


@dataclass(frozen=True, kw_only=True)
class Analogue:
    """One system: its parameters, its coordinate, and the quantities in the roles of m and k (formulas in LaTeX).

    Attributes
    ----------
    slug, name : str
        Its short name in the code, and its name for readers.
    parameters : tuple of Parameter
        What visitors can change.
    constants : tuple of Constant
        What they cannot change.
    coordinate, unit : str
        The symbol of the coordinate in LaTeX, and its unit.
    swing : float
        A small first displacement, in that unit.
    inertia_formula, stiffness_formula : str
        The quantities in the roles of m and k.
    inertia_unit, stiffness_unit : str
        Their units.
    T_formula, V_formula, omega_formula : str
        Kinetic energy, potential energy and natural frequency.
    inertia_of, stiffness_of : callable
        Both quantities as decimals, from a record of all numbers by name.
    length_of : callable or None
        The length in m of the simple pendulum with the same motion at any angle, from the same record; None if the
        system is linear.
    """

    slug: str
    name: str
    parameters: tuple[Parameter, ...]
    constants: tuple[Constant, ...] = ()
    coordinate: str
    unit: str
    swing: float  # a small first displacement, in that unit
    inertia_formula: str
    stiffness_formula: str
    inertia_unit: str
    stiffness_unit: str
    T_formula: str
    V_formula: str
    omega_formula: str
    inertia_of: Formula
    stiffness_of: Formula
    length_of: Formula | None = None  # of the simple pendulum with the same motion at any angle

    @property
    def defaults(self) -> dict[str, float]:
        """The default of every parameter."""
        return {parameter.name: parameter.default for parameter in self.parameters}

    def at(self, p: Mapping[str, float]) -> "Tuned":
        """Return the system with numbers for its parameters.

        Parameters
        ----------
        p : mapping of str to float
            The number of each parameter by name, in its unit.

        Returns
        -------
        Tuned
            The system with these numbers and its constants.

        Raises
        ------
        ValueError
            If a number is not possible.
        """
        for parameter in self.parameters:
            value = p[parameter.name]
            check_positive(f"{self.name}, {parameter.unit or 'a number'}", **{parameter.name: value})
            if parameter.whole and not float(value).is_integer():
                raise ValueError(f"{self.name}, {parameter.name} = {value!r}: only whole numbers from 1 on are allowed")
        numbers = {constant.name: constant.value for constant in self.constants}
        numbers |= {parameter.name: p[parameter.name] for parameter in self.parameters}
        return Tuned(self, SimpleNamespace(**{name: exact(value) for name, value in numbers.items()}))


@dataclass(frozen=True)
class Tuned:
    """One system with a number for each parameter and constant.

    Attributes
    ----------
    system : Analogue
        The system.
    values : SimpleNamespace
        The numbers as decimals, by name.
    """

    system: Analogue
    values: SimpleNamespace

    @cached_property
    def _inertia(self) -> Decimal:
        with precise():
            return self.system.inertia_of(self.values)

    @cached_property
    def _stiffness(self) -> Decimal:
        with precise():
            return self.system.stiffness_of(self.values)

    @property
    def inertia(self) -> float:
        """The quantity in the role of m."""
        return _above_0(f"{self.system.name}: the role of m", self._inertia)

    @property
    def stiffness(self) -> float:
        """The quantity in the role of k."""
        return _above_0(f"{self.system.name}: the role of k", self._stiffness)

    @property
    def omega_n(self) -> float:
        """Natural frequency in rad/s."""
        with precise():
            return rounded(
                f"{self.system.name}: the natural frequency omega_n", (self._stiffness / self._inertia).sqrt()
            )

    def energy(self, q_0: float) -> float:
        """Return T + V of the linear system released at rest from q_0: stiffness q_0^2/2.

        Parameters
        ----------
        q_0 : float
            The first displacement, in the unit of the coordinate.

        Returns
        -------
        float
            The energy in J, or in J/m^2 if the stiffness is in N/m^3; rounded once.

        Raises
        ------
        ValueError
            If q_0 is not finite, or the energy leaves the range of doubles.
        """
        check_finite(f"a start in {self.system.unit}", q_0=q_0)
        with precise():
            return rounded("the energy", self._stiffness * exact(q_0) ** 2 / 2)

    def exact_energy(self, q_0: float) -> float:
        """Return T + V at any angle, stiffness (1 - cos q_0) for a pendulum; for a linear system it is `energy`.

        Parameters
        ----------
        q_0 : float
            The first displacement, in the unit of the coordinate.

        Returns
        -------
        float
            The energy in J, or in J/m^2 if the stiffness is in N/m^3.

        Raises
        ------
        ValueError
            If q_0 is not finite, or the energy leaves the range of doubles.
        """
        if self.system.length_of is None or not q_0:
            return self.energy(q_0)
        with precise():
            share = exact(sin(q_0 / 2)) / exact(q_0 / 2)
            return rounded("the energy", exact(self.energy(q_0)) * share**2)

    @property
    def pendulum(self) -> Pendulum | None:
        """The simple pendulum with the same motion at every amplitude; None if the system is linear."""
        if self.system.length_of is None:
            return None
        with precise():
            length = self.system.length_of(self.values)
        return Pendulum(l=rounded("the pendulum's length", length), g=float(self.values.g))


def _above_0(quantity: str, value: Decimal) -> float:
    """The double nearest to a positive value; ValueError where that is 0 or infinite."""
    if not float(value):
        raise ValueError(f"{quantity} = {value:.3e} leaves {DOUBLES}")
    return rounded(quantity, value)
