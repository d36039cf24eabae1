"""Checks of numbers against the limits of physics; each raises a ValueError that names the value and the limit."""

from collections.abc import Sequence
from math import isfinite
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

Scalar = TypeVar("Scalar", np.float64, np.complex128)

DOUBLES = "the range of doubles, about 5e-324 to 1.8e308 in SI units"
"""The range of the numbers that can be computed with, in words."""


def check_positive(kind: str, **values: float) -> None:
    """Check that values are finite and above 0, as in check_positive("a mass in kg", m=m)."""
    for name, value in values.items():
        if not (isfinite(value) and value > 0):
            raise ValueError(f"{name} = {value!r}: {kind} is a finite number above 0")


def check_not_negative(kind: str, **values: float) -> None:
    """Check that values are finite and 0 or more."""
    for name, value in values.items():
        if not (isfinite(value) and value >= 0):
            raise ValueError(f"{name} = {value!r}: {kind} is a finite number, 0 or more")


def check_finite(kind: str, **values: float) -> None:
    """Check that values are neither infinite nor NaN."""
    for name, value in values.items():
        if not isfinite(value):
            raise ValueError(f"{name} = {value!r}: {kind} is a finite number")


def finite_array(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """The values as an array (n,) of finite doubles."""
    array = np.atleast_1d(np.asarray(values, dtype=np.float64))
    if array.ndim != 1:
        raise ValueError(f"{name} has the shape {array.shape}: one dimension is allowed")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} = {float(array[~np.isfinite(array)][0])!r}: only finite numbers are allowed")
    return array


def in_range(quantity: str, result: NDArray[Scalar]) -> NDArray[Scalar]:
    """A result computed with overflow ignored; ValueError names the quantity where it left the range of doubles."""
    if not np.isfinite(result).all():
        raise ValueError(f"{quantity} leaves {DOUBLES}")
    return result


def rows_in_range(quantities: Sequence[str], results: NDArray[np.float64]) -> NDArray[np.float64]:
    """Results of several quantities, a row (n,) each; ValueError names the first that left the range of doubles."""
    if not np.isfinite(results).all():
        for quantity, row in zip(quantities, results, strict=True):
            in_range(quantity, row)
    return results
