"""Columns of numbers as they cross: in whole steps of a range, as differences, the bytes of one weight together.

What is drawn needs no doubles: 65535 steps over three heights of the frame are 70 steps a pixel. Neighbours on a curve
differ little, their differences less; each column is sent as those differences, of the order up to MOST_ORDER, that
are shortest. A motion that follows its two parts is their sum but for rounding: what is left of it is sent.
static/columns.js reads it; tests/reference/columns.json are cases of both.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from components.page.picture import Ruler

Floats = NDArray[np.float64]
Steps = NDArray[np.int32]

COARSE = 2**16 - 1
"""Steps of a column that is drawn."""
FINE = 2**24 - 1
"""Steps of numbers that more is made of than a curve: as fine as float32."""
MOST_ORDER = 5
SUM = 8
"""Added to the order of a column from which the two before it have been taken."""
APART = 4
"""Steps by which a column may be off from a sum by rounding."""


def span(ruler: Ruler) -> tuple[float, float]:
    """The range of the steps of what is drawn on an axis: its frame, and as much again on either side."""
    low, high = sorted((ruler.start, ruler.end))
    return low - (high - low), high + (high - low)


def steps(values: Floats, low: float, high: float, count: int) -> Steps:
    """The nearest of `count` + 1 places from low to high; what is outside is at the first or the last."""
    half = high / 2 - low / 2  # all of it may be more than a double holds
    if not half > 0:
        return np.zeros(len(values), np.int32)
    shares = (np.minimum(np.maximum(values, low), high) / 2 - low / 2) / half
    return np.rint(count * shares).astype(np.int32)


def encoded(columns: Sequence[Steps]) -> bytes:
    """The order of each column's differences, a byte each, then four times as many bytes as there are numbers: all
    first bytes of the differences, all second ones, and so on. A difference d >= 0 is 2d, one below is -2d - 1."""
    rests = [_rest(column, columns[max(0, i - 2) : i]) for i, column in enumerate(columns)]
    filled = [rest for rest in rests if len(rest)]
    if not filled:
        return bytes(len(columns))
    starts = np.cumsum([0, *map(len, filled[:-1])])
    orders, shortest = _shortest(np.concatenate(filled), starts)
    found = iter(orders.tolist())
    whole = zip(columns, rests, strict=True)
    head = bytes((next(found) if len(rest) else 0) + (0 if rest is column else SUM) for column, rest in whole)
    return head + shortest.astype("<u4").view(np.uint8).reshape(-1, 4).T.tobytes()


def _rest(column: Steps, before: Sequence[Steps]) -> Steps:
    """What is left of a column without the two before it, where it seems to be their sum; else the column."""
    if not (len(before) == 2 and len(before[0]) == len(before[1]) == len(column) > APART):
        return column
    rest = column - before[0] - before[1]
    some = rest[:: len(rest) // APART].tolist()
    return rest if max(some) - min(some) <= APART else column


def _shortest(numbers: Steps, starts: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    """Of each column, which begin at `starts`, the order whose differences have the fewest bits, and these."""
    candidates, bits = [], []
    for order in range(MOST_ORDER + 1):
        if order:
            numbers = _differences(numbers, starts)
        candidates.append((numbers << 1) ^ (numbers >> 31))
        bits.append(np.add.reduceat(np.log2(1 + candidates[-1].astype(np.float32)), starts))
    orders = np.argmin(bits, axis=0)
    lengths = np.diff(starts, append=len(numbers))
    return orders, np.choose(np.repeat(orders, lengths), candidates)


def _differences(numbers: Steps, starts: NDArray[np.int64]) -> Steps:
    """From each number to the next; the first of a column stays."""
    result = numbers.copy()
    result[1:] -= numbers[:-1]
    result[starts] = numbers[starts]
    return result
