r"""Declarations of the parts of a picture: axes, signals, scalars, columns, forms, texts and live numbers, each once.

A scene has one or more classes of them: `class Numbers(Declared[Case])`. `Numbers.texts(case, axes)` computes the
values of a case. Refer to a number as `Numbers.zeta` everywhere; mypy then catches undefined names. In a text,
`f"{Numbers.zeta} is small"`, a declaration becomes `\val{zeta}`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from functools import cache
from typing import Any, Generic, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from components.language.expressions import check_free
from components.language.picture import Digits
from components.language.signals import AnySignal
from components.quantities.axes import Axis
from components.quantities.formatting import three
from components.quantities.readouts import Readout, SceneNumber, scene_number

Case = TypeVar("Case")
Value = TypeVar("Value")
One = TypeVar("One", bound="Named")
Key = TypeVar("Key")
AxesInForce = Mapping[str, Axis]
"""The axes of a picture, by name."""


@dataclass(eq=False, kw_only=True)
class Named:
    """A declaration, known by the name under which its class has it."""

    name: str = field(default="", init=False)

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __str__(self) -> str:
        return rf"\val{{{self.name}}}"

    @classmethod
    def some(cls, count: int, *each: Any, **rest: Any) -> list[Self]:
        """Declarations that differ only in their names."""
        return [cls(*each, **rest) for _ in range(count)]

    @classmethod
    def each(cls, keys: Iterable[Key], called: str = "", **rest: Any) -> Family[Key, Self]:
        """A family of such declarations."""
        return Family(keys, lambda key: cls(**rest), called)


@dataclass(eq=False)
class DrawnAxis(Named):
    """An axis of a picture; call it with the current axes to get the actual one."""

    def __call__(self, axes: AxesInForce) -> Axis:
        return axes[self.name]


@dataclass(eq=False)
class Signal(Named, Generic[Case]):
    """A number that depends on time, or None. In texts it is formatted for the axis `on`."""

    value: Callable[[Case, AxesInForce], AnySignal | None] = lambda case, axes: None
    on: DrawnAxis | None = None
    signed: bool = False


@dataclass(eq=False)
class Scalar(Named, Generic[Case]):
    """A number that shapes and marks use, or None; a shape that needs it for `show` is drawn unless it is 0."""

    value: Callable[[Case, AxesInForce], float | None] = lambda case, axes: None


@dataclass(eq=False)
class Column(Named, Generic[Case]):
    """A column of a source, in SI units, or None; `called` is its name if another source already has a column of this
    name.
    """

    source: str
    value: Callable[[Case], NDArray[np.float64] | None] = lambda case: None
    called: str = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = self.called or name


@dataclass(eq=False)
class Form(Named, Generic[Case]):
    """The current variant of a formula or sentence; "" hides it. A form with one variant is "shown"."""

    value: Callable[[Case], str | bool]

    def variant(self, case: Case) -> str:
        value = self.value(case)
        return value if isinstance(value, str) else "shown" if value else ""


@dataclass(eq=False)
class Text(Named, Generic[Case]):
    """A text that is part of other texts; None if there is none, or if other code makes it."""

    value: Callable[[Case, AxesInForce], str | None] = lambda case, axes: None

    def text(self, case: Case, axes: AxesInForce) -> str | None:
        return self.value(case, axes)


class Family(dict[Key, One]):
    """Declarations of one kind by key: `side[1]` of the family `side` is called side1, `at["slow"]` at_slow; `called`
    is another pattern, "x{}_{}" for keys (1, "slow")."""

    def __init__(self, keys: Iterable[Key], make: Callable[[Key], One], called: str = "") -> None:
        super().__init__({key: make(key) for key in keys})
        self.called = called

    def __set_name__(self, owner: type, name: str) -> None:
        for key, one in self.items():
            pattern = self.called or (f"{name}{{}}" if isinstance(key, int) else f"{name}_{{}}")
            one.__set_name__(owner, pattern.format(*(key if isinstance(key, tuple) else (key,))))


@dataclass(eq=False)
class AxisUnit(Named):
    """The unit of an axis; `write` formats a number of that axis."""

    axis: DrawnAxis
    form: Callable[[Axis], str] = lambda axis: axis.full_unit
    write: Callable[[Axis, float], str] = Axis.number

    def text(self, case: object, axes: AxesInForce) -> str:
        return self.form(self.axis(axes))


@dataclass(eq=False)
class LiveNumber(Named, Generic[Case]):
    """A number of a case in SI units, or None; if the value is a string, it is shown unchanged.

    With a symbol, it is listed when pictures are compared. `form`, or the axis `axis`, formats it. `whole`: its text
    includes the unit. `angle`: compared modulo a turn. `also`: other names that show the same value.
    If it has a `meaning`, `scene.numbers` lists it, with its SI `unit`.
    """

    value: Callable[[Case], float | Decimal | str | None]
    symbol: str = ""
    unit: str = ""
    tint: str = "ink"
    form: Callable[[Any], str] = three
    axis: AxisUnit | None = None
    whole: bool = False
    angle: bool = False
    also: tuple[Named, ...] = ()
    meaning: str = ""

    @classmethod
    def both(
        cls,
        values: Callable[[Case], Any],
        form: Callable[[Any], str] = three,
        meanings: tuple[str, str] = ("", ""),
        **rest: Any,
    ) -> list[Self]:
        """Numbers of the slow and the fast mode, or of mass 1 and mass 2."""
        each = (lambda case: values(case)[0]), (lambda case: values(case)[1])
        return [cls(one, form=form, meaning=meaning, **rest) for one, meaning in zip(each, meanings, strict=True)]

    @property
    def aloud(self) -> str:
        """Return its text and unit for a screen reader."""
        unit = f"{{{self.axis.name}}}" if self.axis else self.unit
        return f"{{{self.name}}}" if self.whole else f"{{{self.name}}} {unit}".rstrip()

    def text(self, case: Case, axes: AxesInForce) -> str:
        value = self.value(case)
        if value is None or isinstance(value, str):
            return value or ""
        text, unit = self.form(value), self.unit
        if self.axis:
            text, unit = self.axis.write(self.axis.axis(axes), float(value)), self.axis.text(case, axes)
        return f"{text} {unit}" if self.whole else text

    def readout(self, case: Case) -> Iterator[Readout]:
        value = self.value(case) if self.symbol else None
        if value is not None and not isinstance(value, str):
            also = tuple(one.name for one in self.also)
            yield Readout(self.name, self.symbol, float(value), self.unit, self.tint, self.angle, also)


class Declared(Generic[Case]):
    """The declarations of a scene, or declarations that several scenes share. The class is never instantiated. A signal
    comes after the signals that it uses."""

    def __init_subclass__(cls, **rest: Any) -> None:
        super().__init_subclass__(**rest)
        check_free(cls.__name__, (one.name for one in cls._all(Named)))

    @classmethod
    def signals(cls, case: Case, axes: AxesInForce) -> dict[str, AnySignal]:
        return {one.name: value for one in cls._all(Signal) if (value := one.value(case, axes)) is not None}

    @classmethod
    def live(cls, axes: AxesInForce) -> dict[str, Digits]:
        """Return the formats of the signals that occur in texts."""
        return {one.name: one.on(axes).digits(one.signed) for one in cls._all(Signal) if one.on}

    @classmethod
    def scalars(cls, case: Case, axes: AxesInForce) -> dict[str, float]:
        return {one.name: float(value) for one in cls._all(Scalar) if (value := one.value(case, axes)) is not None}

    @classmethod
    def columns(cls, case: Case) -> dict[str, dict[str, NDArray[np.float64]]]:
        """The columns by source."""
        found: dict[str, dict[str, NDArray[np.float64]]] = {}
        for one in cls._all(Column):
            if (column := one.value(case)) is not None:
                found.setdefault(one.source, {})[one.name] = column
        return found

    @classmethod
    def forms(cls, case: Case) -> dict[str, str]:
        return {one.name: one.variant(case) for one in cls._all(Form)}

    @classmethod
    def texts(cls, case: Case, axes: AxesInForce) -> dict[str, str]:
        every = cls._all(LiveNumber, AxisUnit, Text)
        return {one.name: text for one in every if (text := one.text(case, axes)) is not None}

    @classmethod
    def readouts(cls, case: Case) -> tuple[Readout, ...]:
        return tuple(readout for one in cls._all(LiveNumber) for readout in one.readout(case))

    @classmethod
    def numbers(cls, case: Case) -> dict[str, SceneNumber]:
        """Return the numbers of the scene, by name; numbers with no current value are missing."""
        known = [one for one in cls._all(LiveNumber) if one.meaning]
        found = {one.name: scene_number(one.value(case), one.unit, one.meaning) for one in known}
        return {name: number for name, number in found.items() if number}

    @classmethod
    @cache
    def _all(cls, *kinds: type[Named]) -> list[Any]:
        """Return the declarations of these kinds, in order, after those of the base classes."""
        known = {name: one for owner in reversed(cls.__mro__) for name, one in vars(owner).items()}
        every = (one.values() if isinstance(one, Family) else (one,) for one in known.values())
        return [one for members in every for one in members if isinstance(one, kinds)]


def by_name(given: Mapping[One, Value]) -> dict[str, Value]:
    """Return values by the names of their declarations."""
    return {one.name: value for one, value in given.items()}
