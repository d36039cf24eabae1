"""Deferred expressions: placeholders for the values of a case. A paper is written with them once; each picture computes
them.

`c = deferred(DampedShown)` has the type of a case, so mypy checks every name. `f"{c.omega_d}"` is a live number in a
text, `56 * c.side` a number of a shape, `c.kind == "over"` a condition.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from inspect import get_annotations
from typing import Any, Generic, NamedTuple, TypeAlias, TypeVar, cast, overload

from components.language.expressions import Expression, Number, named
from components.paper.plot_axes import PlotAxis
from components.quantities.axes import Axis
from components.quantities.formatting import plus, three
from physics.motion import added as added_motions

C = TypeVar("C")
V = TypeVar("V")
Axes: TypeAlias = Mapping[str, Axis]
"""The axes of a picture as drawn, by name."""
Compute: TypeAlias = Callable[[Any, Axes], Any]
"""A function that returns a value for a case and the axes of its picture."""
Write: TypeAlias = Callable[[float, Axes], str]
"""A function that formats a number."""


def _write_three(value: float, axes: Axes) -> str:
    return three(value)


def _write_plus(value: float, axes: Axes) -> str:
    return plus(value)


FORMATS: Mapping[str, Write] = {"": _write_three, "+": _write_plus}
"""The ways to write a number: three digits, or three digits as a further term of a sum."""


class Attribute(Generic[V]):
    """An attribute of a case, computed once, when it is first read.

    If it is `optional` it may be None; parts of the picture that need it are then not drawn. `called` is its name in
    pictures and files, if
    that differs from its name in the class. If it has a `meaning`, `scene.numbers` lists it, with its SI `unit`.
    """

    def __init__(
        self,
        compute: Callable[[Any], V | None],
        optional: bool = False,
        called: str = "",
        unit: str = "",
        meaning: str = "",
    ) -> None:
        self.compute, self.optional, self.called, self.unit, self.meaning = compute, optional, called, unit, meaning
        self.name = f"attribute {id(self)}"
        """Its key among the values of a case: an intermediate result has no name in the class."""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name, self.called = name, self.called or name

    @overload
    def __get__(self, case: None, owner: type) -> Attribute[V]: ...
    @overload
    def __get__(self, case: object, owner: type) -> V: ...
    def __get__(self, case: Any, owner: type) -> Any:
        if case is None:
            return self
        value = vars(case)[self.name] = self.compute(case)
        return value

    def of(self, case: Any) -> Any:
        """Return its value for a case."""
        known = vars(case)
        if self.name not in known:
            known[self.name] = self.compute(case)
        return known[self.name]

    def where(self, condition: Callable[[Any], object]) -> Attribute[V]:
        """Return the attribute that is None unless the condition holds."""
        return Attribute(lambda case: self.of(case) if condition(case) else None, optional=True)

    def _combined(self, other: Attribute[Any] | float, do: Callable[[Any, Any], Any]) -> Attribute[V]:
        def compute(case: Any) -> Any:
            a, b = self.of(case), other.of(case) if isinstance(other, Attribute) else other
            return None if a is None or b is None else do(a, b)

        return Attribute(compute, self.optional or (isinstance(other, Attribute) and other.optional))

    def __add__(self, other: Attribute[Any] | float) -> Attribute[V]:
        return self._combined(other, lambda a, b: a + b)

    def __sub__(self, other: Attribute[Any] | float) -> Attribute[V]:
        return self._combined(other, lambda a, b: a - b)

    def __neg__(self) -> Attribute[V]:
        return self._combined(-1.0, lambda a, b: a * b)


class Attributes(Generic[C]):
    """Makes attributes of cases of a class: after `value = Attributes(MyCase)`, `side = value(lambda c: c.m**0.15)`.

    A number of the scene has a unit and a meaning: `tau = value(lambda c: c.one.period, "s", "natural period")`.
    """

    def __init__(self, kind: type[C]) -> None:
        self.kind = kind

    def __call__(
        self, compute: Callable[[C], V], unit: str = "", meaning: str = "", *, called: str = ""
    ) -> Attribute[V]:
        return Attribute(compute, False, called, unit, meaning)

    def optional(
        self, compute: Callable[[C], V | None], unit: str = "", meaning: str = "", *, called: str = ""
    ) -> Attribute[V]:
        """Return an attribute that may be None."""
        return Attribute(compute, True, called, unit, meaning)

    def pair(
        self,
        compute: Callable[[C], Sequence[V] | None],
        unit: str = "",
        meanings: tuple[str, str] = ("", ""),
        *,
        called: tuple[str, str] = ("", ""),
    ) -> tuple[Attribute[V], Attribute[V]]:
        """Return two attributes from one sequence, both None if it is None."""
        both = Attribute(compute)

        def part(i: int) -> Attribute[V]:
            def one(case: C) -> V | None:
                found = both.of(case)
                return None if found is None else found[i]

            return Attribute(one, True, called[i], unit, meanings[i])

        return part(0), part(1)


class CountedNumber(NamedTuple):
    """A number of a picture: an expression, and the axis in whose unit it is given, if any."""

    of: ExpressionRecord
    axis: PlotAxis | None


class FormWords(NamedTuple):
    """A choice between texts: the expression that decides, and the possible words."""

    of: ExpressionRecord
    words: dict[str, None]

    def word(self, value: object) -> str:
        """Return the word that a value chooses: a string chooses itself, True and False choose "yes" and "no".

        If there is only one word, a true value chooses it. The result is "" if no word is chosen.
        """
        if isinstance(value, str):
            return value if value in self.words else ""
        if value is None and "yes" not in self.words:
            return ""
        holds = value is not None and value is not False
        if "yes" in self.words:
            return "yes" if holds else "no"
        (word,) = self.words
        return word if holds else ""


@dataclass(eq=False)
class Book:
    """A record of everything that a paper uses from the cases of a class, by the name in the picture."""

    kind: type
    numbers: dict[str, CountedNumber] = field(default_factory=dict)
    texts: dict[str, tuple[ExpressionRecord, Write]] = field(default_factory=dict)
    forms: dict[str, FormWords] = field(default_factory=dict)
    flags: dict[str, ExpressionRecord] = field(default_factory=dict)
    plots: dict[str, Any] = field(default_factory=dict)
    """The plots of the paper: `components.paper.plots.BuiltPlot` by name."""

    def part(self, names: frozenset[str]) -> Book:
        """Return the record of only these names, and of the plots among these parts of a sheet."""

        def kept(known: dict[str, V]) -> dict[str, V]:
            return {name: one for name, one in known.items() if name in names}

        plots = {name: one for name, one in self.plots.items() if f"plot:{name}" in names}
        return Book(self.kind, kept(self.numbers), kept(self.texts), kept(self.forms), kept(self.flags), plots)

    def number(self, of: ExpressionRecord, axis: PlotAxis | None) -> str:
        """Return the name of a number in the picture. If it is used on a second axis, the name of that axis is
        appended."""
        axis = axis.counting if axis else None
        for name in (of.name, f"{of.name}_{axis.name if axis else 'si'}"):
            known = self.numbers.setdefault(name, CountedNumber(of, axis))
            if known.of.text == of.text and known.axis is axis:
                return name
        raise ValueError(f"{of.text} and {known.of.text} have the same name {name}")

    def text(self, of: ExpressionRecord, write: Write) -> str:
        """Return the notation of a live number for a text."""
        known, way = self.texts.setdefault(of.name, (of, write))
        if known.text != of.text or way != write:
            raise ValueError(f"{of.text} is written in two ways: make another attribute for the second")
        return rf"\val{{{of.name}}}"

    def form(self, of: ExpressionRecord, words: Iterable[str], name: str = "") -> str:
        """Return the name of the picture's form that has the word which an expression chooses."""
        name = name or of.name
        known = self.forms.setdefault(name, FormWords(of, {}))
        known.words.update(dict.fromkeys(words))
        if known.of.text != of.text or (len(known.words) > 1 and {"shown", "formula"} & known.words.keys()):
            raise ValueError(f"the form {name} is used in two ways")
        return name

    def flagged(self, numbers: Iterable[str], texts: Iterable[str]) -> list[str]:
        """Return the scalars that are 0 while one of these numbers and texts is missing."""
        known = [self.numbers[name].of for name in numbers if name in self.numbers]
        known += [self.texts[name][0] for name in texts if name in self.texts]
        found = {f"has_{one.optional.name}": one.optional for one in known if one.optional}
        self.flags.update(found)
        return list(found)


@dataclass(frozen=True, eq=False)
class ExpressionRecord:
    """An expression in attributes of a case: its text, its name in a picture, and the function that computes it.

    `optional` is the part of it that may be None, if there is one.
    """

    book: Book
    text: str
    name: str
    compute: Compute
    optional: ExpressionRecord | None = None

    def then(self, text: str, name: str, do: Callable[[Any], Any], optional: bool = False) -> Deferred:
        """Return the expression `do(value)` of this expression's value; None stays None."""

        def compute(case: Any, axes: Axes) -> Any:
            value = self.compute(case, axes)
            return None if value is None else do(value)

        return made(self.book, text, re.sub(r"\W", "_", name), compute, optional, self.optional)

    def expression(self, axis: PlotAxis | None = None) -> Expression:
        """Return it as a number of a shape, in the unit of an axis or in SI units."""
        return named(self.book.number(self, axis))


class Deferred:
    """An expression of a case, not yet computed. It has no public attributes itself, because each name means an
    attribute of the value."""

    def __init__(self, recorded: ExpressionRecord) -> None:
        self._recorded = recorded

    def __getattr__(self, name: str) -> Deferred:
        if name.startswith("_"):
            raise AttributeError(name)
        own = self._recorded
        return own.then(f"{own.text}.{name}", f"{own.name}_{name}", lambda value: getattr(value, name))

    def __getitem__(self, key: int) -> Deferred:
        own = self._recorded

        def item(value: Sequence[Any]) -> Any:
            return value[key] if key < len(value) else None

        return own.then(f"{own.text}[{key}]", f"{own.name}{key}", item, optional=True)

    def __format__(self, form: str) -> str:
        return self._recorded.book.text(self._recorded, FORMATS[form])

    def __add__(self, other: Number) -> Expression:
        return self._recorded.expression() + other

    def __sub__(self, other: Number) -> Expression:
        return self._recorded.expression() - other

    def __rsub__(self, other: Number) -> Expression:
        return other - self._recorded.expression()

    def __mul__(self, other: Number) -> Expression:
        return self._recorded.expression() * other

    def __truediv__(self, other: float) -> Expression:
        return self._recorded.expression() / other

    def __neg__(self) -> Expression:
        return -self._recorded.expression()

    __radd__, __rmul__ = __add__, __mul__

    def __eq__(self, other: object) -> Any:
        own = self._recorded
        return own.then(f"{own.text} == {other!r}", f"{own.name}_{other}", lambda value: value == other)

    def __ne__(self, other: object) -> Any:
        own = self._recorded
        return own.then(f"{own.text} != {other!r}", f"{own.name}_not_{other}", lambda value: value != other)

    __hash__ = object.__hash__

    def __bool__(self) -> bool:
        raise TypeError(f"{self._recorded.text} has no value yet: make what depends on it an attribute of the case")


def made(
    book: Book, text: str, name: str, compute: Compute, optional: bool, inherited: ExpressionRecord | None = None
) -> Deferred:  # fmt: skip
    """Return a deferred expression. It may be None if it is `optional`, or if its part `inherited` is None."""
    own = ExpressionRecord(book, text, name, compute)
    return Deferred(ExpressionRecord(book, text, name, compute, own if optional else inherited))


def added(parts: Sequence[ExpressionRecord]) -> Deferred:
    """Return the sum of motions, or None if one of them is None."""

    def compute(case: Any, axes: Axes) -> Any:
        motions = [one.compute(case, axes) for one in parts]
        return None if None in motions else added_motions(*motions)

    text, name = " + ".join(one.text for one in parts), "_".join(one.name for one in parts)
    inherited = next((one.optional for one in parts if one.optional), None)
    return made(parts[0].book, text, name, compute, False, inherited)


class DeferredCase:
    """A placeholder for a case of a class. Raises AttributeError for unknown names."""

    def __init__(self, kind: type) -> None:
        self._kind = kind

    def __getattr__(self, name: str) -> Deferred:
        known = getattr(self._kind, name, None)
        if name.startswith("_") or (known is None and name not in fields(self._kind)):
            raise AttributeError(f"a {self._kind.__name__} has no {name}")
        optional = isinstance(known, Attribute) and known.optional
        called = known.called if isinstance(known, Attribute) else name
        return made(book_of(self._kind), name, called, lambda case, axes: getattr(case, name), optional)


@cache
def fields(kind: type) -> tuple[str, ...]:
    """Return the names that a class and its bases annotate: the parameters of its cases."""
    return tuple(name for owner in reversed(kind.__mro__) for name in get_annotations(owner))


@cache
def attributes(kind: type) -> tuple[Attribute[Any], ...]:
    """Return the attributes of cases of a class, in their order."""
    members = (one for owner in reversed(kind.__mro__) for one in vars(owner).values())
    return tuple(one for one in members if isinstance(one, Attribute))


def names(kind: type) -> set[str]:
    """Return the names by which a paper can write the numbers of cases of a class."""
    others = {name for owner in kind.__mro__ for name, one in vars(owner).items() if not isinstance(one, Attribute)}
    return others | {one.called for one in attributes(kind)} | set(fields(kind))


@cache
def book_of(kind: type) -> Book:
    return Book(kind)


def deferred(kind: type[C]) -> C:
    """Return a placeholder for a case, which mypy treats as a case."""
    return cast(C, DeferredCase(kind))


def computed(case: object, name: str, compute: Compute, optional: bool = False) -> Deferred:
    """Return a deferred value under its own name, computed from a case and the axes of its picture."""
    assert isinstance(case, DeferredCase)
    return made(book_of(case._kind), name, name, compute, optional)


def recorded(one: object) -> ExpressionRecord:
    """Return the record of a deferred expression. Raises TypeError for anything else."""
    if not isinstance(one, Deferred):
        raise TypeError(f"{one!r} is not an expression of a case")
    return one._recorded


def number(one: object) -> Expression:
    """Return an attribute or a motion as a number of a shape, in SI units."""
    return recorded(one).expression()
