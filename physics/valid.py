"""Checks of numbers against the limits of physics; each raises a ValueError that names the value and the limit."""

from collections.abc import Sequence
from decimal import Decimal
from math import isfinite
from numbers import Real
from reprlib import repr as excerpt
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

Scalar = TypeVar("Scalar", np.float64, np.complex128)

DOUBLES = "the range of doubles, about 5e-324 to 1.8e308 in SI units"
"""The range of the numbers that can be computed with, in words."""


def is_number(value: object) -> bool:
    """Return True if `value` is a real number that a finite double can hold: no text, array, complex number or bool."""
    if type(value) is float:
        return isfinite(value)
    if isinstance(value, bool) or not isinstance(value, Real | Decimal):
        return False
    try:
        return isfinite(value)
    except (OverflowError, ValueError):  # a larger integer, a signalling NaN
        return False


def shown(value: object) -> str:
    """Return a refused value as a message shows it: at most about 40 characters."""
    return excerpt(value)


def keep_doubles(record: object, *names: str) -> None:
    """Store the numbers of a frozen record as doubles. Other values stay as they are, and the check refuses them."""
    for name in names:
        if is_number(value := getattr(record, name)):
            object.__setattr__(record, name, float(value))


def check_positive(kind: str, **values: float) -> None:
    """Raise ValueError if a value is not a finite number above 0. `kind` says what is needed: "a mass in kg"."""
    for name, value in values.items():
        if not (is_number(value) and value > 0):
            raise ValueError(f"{name} = {shown(value)}: {kind} is a finite number above 0")


def check_not_negative(kind: str, **values: float) -> None:
    """Raise ValueError if a value is not a finite number, 0 or more. `kind` says what is needed: "a force in N"."""
    for name, value in values.items():
        if not (is_number(value) and value >= 0):
            raise ValueError(f"{name} = {shown(value)}: {kind} is a finite number, 0 or more")


def check_finite(kind: str, **values: float) -> None:
    """Raise ValueError if a value is not a finite number. `kind` says what is needed: "a velocity in m/s"."""
    for name, value in values.items():
        if not is_number(value):
            raise ValueError(f"{name} = {shown(value)}: {kind} is a finite number")


def doubles(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return the values as an array of doubles of the same shape.

    ValueError gives their `name` if they are texts, complex numbers, None, or rows of different lengths.
    """
    try:
        given = np.asarray(values)
        numbers = given.dtype.kind in "iuf" or (given.dtype.kind == "O" and all(map(is_number, given.flat)))
    except ValueError:  # rows of different lengths
        numbers = False
    if not numbers:
        raise ValueError(f"{name} = {shown(values)}: only finite numbers are allowed")
    return given.astype(np.float64, copy=False)


def finite_array(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return the values as an array (n,) of finite doubles; ValueError gives their `name` if that is not possible."""
    array = np.atleast_1d(doubles(name, values))
    if array.ndim != 1:
        raise ValueError(f"{name} has the shape {array.shape}: one dimension is allowed")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} = {float(array[~np.isfinite(array)][0])!r}: only finite numbers are allowed")
    return array


def in_range(quantity: str, result: NDArray[Scalar]) -> NDArray[Scalar]:
    """Return a result computed with overflow ignored; ValueError names the `quantity` if it leaves the doubles."""
    if not np.isfinite(result).all():
        raise ValueError(f"{quantity} leaves {DOUBLES}")
    return result


def rows_in_range(quantities: Sequence[str], results: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the results, a row (n,) for each of the quantities; ValueError names the first that leaves the doubles."""
    if not np.isfinite(results).all():
        for quantity, row in zip(quantities, results, strict=True):
            in_range(quantity, row)
    return results
