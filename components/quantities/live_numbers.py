r"""Live numbers, each declared once: its text, its readout, its heading in a file and its cover follow.

A scene has a class of them. In a text, `f"{Numbers.zeta} is small"`, a declaration stands as `\val{zeta}`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from functools import cache
from typing import Any, Generic, Self, TypeVar

from components.quantities.axes import Axis
from components.quantities.numbers import three
from components.quantities.readouts import Readout

Case = TypeVar("Case")


@dataclass(eq=False, kw_only=True)
class Named:
    """A declaration, known by the name under which its class has it."""

    name: str = field(default="", init=False)

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __str__(self) -> str:
        return rf"\val{{{self.name}}}"


@dataclass(eq=False)
class AxisUnit(Named):
    """The unit in which an axis is written; `write` writes a number that is counted on it."""

    axis: str
    form: Callable[[Axis], str] = lambda axis: axis.full_unit
    write: Callable[[Axis, float], str] = Axis.number

    def text(self, case: object, axes: Mapping[str, Axis]) -> str:
        return self.form(axes[self.axis])


@dataclass(eq=False)
class LiveNumber(Named, Generic[Case]):
    """A number of a case, in SI units: None where there is none, a text where it stands for itself.

    With a symbol it is compared with that of another picture. `form` writes it, or the axis that it is counted on;
    its text ends with its unit where it is `whole`; `angle` and `also` are those of its readout.
    """

    value: Callable[[Case], float | Decimal | str | None]
    symbol: str = ""
    unit: str = ""
    tint: str = "ink"
    form: Callable[[Any], str] = three
    axis: AxisUnit | None = None
    whole: bool = False
    angle: bool = False
    also: tuple[str, ...] = ()

    @classmethod
    def both(cls, values: Callable[[Case], Any], form: Callable[[Any], str] = three, **rest: Any) -> list[Self]:
        """Numbers of the slow and the fast mode, or of mass 1 and mass 2."""
        first, second = (lambda case: values(case)[0]), (lambda case: values(case)[1])
        return [cls(first, form=form, **rest), cls(second, form=form, **rest)]

    @property
    def aloud(self) -> str:
        """A text with its unit, as it is read aloud."""
        unit = f"{{{self.axis.name}}}" if self.axis else self.unit
        return f"{{{self.name}}}" if self.whole else f"{{{self.name}}} {unit}".rstrip()

    def text(self, case: Case, axes: Mapping[str, Axis]) -> str:
        value = self.value(case)
        if value is None or isinstance(value, str):
            return value or ""
        text, unit = self.form(value), self.unit
        if self.axis:
            text, unit = self.axis.write(axes[self.axis.axis], float(value)), self.axis.text(case, axes)
        return f"{text} {unit}" if self.whole else text

    def readout(self, case: Case) -> Iterator[Readout]:
        value = self.value(case) if self.symbol else None
        if value is not None and not isinstance(value, str):
            yield Readout(self.name, self.symbol, float(value), self.unit, self.tint, self.angle, self.also)


class LiveNumbers(Generic[Case]):
    """The live numbers of a scene, or some that scenes share: a class that is read and never made."""

    @classmethod
    def texts(cls, case: Case, axes: Mapping[str, Axis]) -> dict[str, str]:
        return {one.name: one.text(case, axes) for one in cls._declared()}

    @classmethod
    def readouts(cls, case: Case) -> tuple[Readout, ...]:
        numbers = (one for one in cls._declared() if isinstance(one, LiveNumber))
        return tuple(readout for one in numbers for readout in one.readout(case))

    @classmethod
    @cache
    def _declared(cls) -> list[LiveNumber[Any] | AxisUnit]:
        known = {name: one for owner in reversed(cls.__mro__) for name, one in vars(owner).items()}
        return [one for one in known.values() if isinstance(one, (LiveNumber, AxisUnit))]
