"""What one oscillating system is: its parameters, its coordinate, and what plays m and k there.

Formulas are functions of 80-digit decimals and rounded once.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from math import sin
from types import SimpleNamespace
from typing import Any

from physics.exact import exact, precise, rounded
from physics.pendulum import Pendulum
from physics.valid import check_finite, check_positive

Formula = Callable[[Any], Decimal]


@dataclass(frozen=True)
class Parameter:
    """A parameter above 0, or a whole number from 1 on."""

    name: str
    symbol: str
    unit: str
    default: float
    whole: bool = False


@dataclass(frozen=True)
class Constant:
    """A number that the system needs and that nobody moves."""

    name: str
    symbol: str
    unit: str
    value: float


@dataclass(frozen=True, kw_only=True)
class Analogue:
    """One system: its parameters, its coordinate, and what plays m and k there (formulas in LaTeX)."""

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

    def inertia(self, p: Mapping[str, float]) -> float:
        """What plays m, for parameters by name."""
        with precise():
            return _above_0(f"{self.name}: what plays m", self.inertia_of(self._values(p)))

    def stiffness(self, p: Mapping[str, float]) -> float:
        """What plays k."""
        with precise():
            return _above_0(f"{self.name}: what plays k", self.stiffness_of(self._values(p)))

    def omega_n(self, p: Mapping[str, float]) -> float:
        """Natural frequency in rad/s."""
        values = self._values(p)
        with precise():
            ratio = self.stiffness_of(values) / self.inertia_of(values)
            return rounded(f"{self.name}: omega_n", ratio.sqrt())

    def energy(self, p: Mapping[str, float], q_0: float) -> float:
        """T + V in J of the linear system released at rest from q_0: stiffness q_0^2/2."""
        check_finite(f"a start in {self.unit}", q_0=q_0)
        with precise():
            return rounded("the energy", self.stiffness_of(self._values(p)) * exact(q_0) ** 2 / 2)

    def exact_energy(self, p: Mapping[str, float], q_0: float) -> float:
        """The same of a pendulum at any angle, stiffness (1 - cos q_0); of a linear system no other."""
        if self.length_of is None or not q_0:
            return self.energy(p, q_0)
        with precise():
            share = exact(sin(q_0 / 2)) / exact(q_0 / 2)
            return rounded("the energy", exact(self.energy(p, q_0)) * share**2)

    def pendulum(self, p: Mapping[str, float]) -> Pendulum | None:
        """The simple pendulum that moves alike at every amplitude; None where the system is linear."""
        if self.length_of is None:
            return None
        values = self._values(p)
        with precise():
            return Pendulum(l=rounded("the pendulum's length", self.length_of(values)), g=float(values.g))

    def _values(self, p: Mapping[str, float]) -> SimpleNamespace:
        for parameter in self.parameters:
            value = p[parameter.name]
            check_positive(f"{self.name}, {parameter.unit or 'a number'}", **{parameter.name: value})
            if parameter.whole and not float(value).is_integer():
                raise ValueError(f"{parameter.name} = {value!r}: only whole numbers from 1 on are allowed")
        numbers = {constant.name: constant.value for constant in self.constants}
        numbers |= {parameter.name: p[parameter.name] for parameter in self.parameters}
        return SimpleNamespace(**{name: exact(value) for name, value in numbers.items()})


def _above_0(quantity: str, value: Decimal) -> float:
    """The double nearest to a positive value; ValueError where that is 0 or infinite."""
    if not float(value):
        raise ValueError(f"{quantity} = {value:.3e} leaves the range of doubles")
    return rounded(quantity, value)
