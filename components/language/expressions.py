"""Numbers that the browser computes for every frame. They are polynomials, so the browser runs no code from
messages."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol, TypeAlias

from msgspec import Struct

PAGE_NUMBERS = frozenset({"speed"})
"""Names of the page's own live numbers, which a scene may not use: the speed of the clock."""


def check_free(owner: str, names: Iterable[str]) -> None:
    """Raise ValueError if a name is one of the page's own live numbers."""
    if taken := PAGE_NUMBERS.intersection(names):
        raise ValueError(f"{owner}: the page has a live number “{min(taken)}” of its own: choose another name.")


class Name(Protocol):
    """Any object with a name, such as a declaration of a scene."""

    @property
    def name(self) -> str: ...


def called(one: Name | None) -> str:
    """Return the name of an object in messages; "" for none."""
    return one.name if one else ""


class Product(Struct, frozen=True, array_like=True):
    """A coefficient times named quantities."""

    factor: float
    names: tuple[str, ...] = ()


class Expression(Struct, frozen=True):
    """A sum of products of named quantities: signals, scalars, W and H, the frames of plots.

    An operator returns NotImplemented for other types, so that they can define the reflected one.
    """

    terms: tuple[Product, ...]

    def __add__(self, other: Number) -> Expression:
        if not isinstance(other, (int, float, Expression)):
            return NotImplemented
        return Expression(self.terms + as_expression(other).terms)

    __radd__ = __add__

    def __neg__(self) -> Expression:
        return self * -1

    def __sub__(self, other: Number) -> Expression:
        if not isinstance(other, (int, float, Expression)):
            return NotImplemented
        return self + -as_expression(other)

    def __rsub__(self, other: Number) -> Expression:
        return as_expression(other) - self

    def __mul__(self, other: Number) -> Expression:
        if not isinstance(other, (int, float, Expression)):
            return NotImplemented
        right = as_expression(other).terms
        return Expression(tuple(Product(a.factor * b.factor, a.names + b.names) for a in self.terms for b in right))

    __rmul__ = __mul__

    def __truediv__(self, other: float) -> Expression:
        return self * (1 / other)


Number: TypeAlias = float | Expression
"""A number of a shape: fixed, or computed for every frame."""


def as_expression(value: Number) -> Expression:
    return value if isinstance(value, Expression) else Expression((Product(float(value)),))


def named(name: str) -> Expression:
    """A quantity that the browser supplies: the size of a stage, the frame of a plot."""
    return Expression((Product(1.0, (name,)),))


def var(one: Name) -> Expression:
    """A declared quantity."""
    return named(one.name)


def names_in(value: Number) -> frozenset[str]:
    """Return the names of the quantities that a number uses."""
    return (
        frozenset(name for term in value.terms for name in term.names) if isinstance(value, Expression) else frozenset()
    )
