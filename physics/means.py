"""Means of neighbouring rows of a record: exponentials keep their exponents, and only their amplitudes change.

Source: S. W. Smith, The Scientist and Engineer's Guide to Digital Signal Processing (1997), chapter 15 (imaginary p).
"""

import cmath


def before_means(amplitude: complex, exponent: complex, step: float, size: int) -> complex:
    """Return the amplitude of the rows of a record from that of means of them.

    The mean of the rows Z e^(p t) around t is Z e^(p t) sinh(size p step/2)/(size sinh(p step/2)).

    Parameters
    ----------
    amplitude : complex
        The amplitude of the means, in the unit of the rows.
    exponent : complex
        The exponent p in 1/s.
    step : float
        The time in s between two rows.
    size : int
        The number of rows in a mean.

    Returns
    -------
    complex
        The amplitude Z of the rows.
    """
    half = exponent * step / 2
    return amplitude if size == 1 or half == 0 else amplitude * size * cmath.sinh(half) / cmath.sinh(size * half)
