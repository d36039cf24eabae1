"""Means of neighbouring rows of a record: exponentials keep their exponents, and only their amplitudes change."""

import cmath


def before_means(amplitude: complex, exponent: complex, step: float, size: int) -> complex:
    """Return the amplitude Z of rows Z e^(p t), `step` s apart, from the amplitude of the means of `size` rows.

    The mean of the rows around t is Z e^(p t) sinh(size p step/2)/(size sinh(p step/2)).
    """
    half = exponent * step / 2
    return amplitude if size == 1 or half == 0 else amplitude * size * cmath.sinh(half) / cmath.sinh(size * half)
