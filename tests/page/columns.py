"""Messages as the browser reads them, in Python: inflated, and their columns as numbers again."""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from components.page.picture import Ruler
from components.places import COARSE, FINE, SUM, span
from components.wire import Packet

Whole = NDArray[np.int64]


def inflated(packet: Packet, usual: bytes) -> bytes:
    """The line of JSON, and the columns."""
    return zlib.decompressobj(-15, *([usual] if usual else [])).decompress(packet["data"])


def with_numbers(view: Mapping[str, Any], data: bytes) -> dict[str, Any]:
    """The view with numbers in place of what it says of its columns and samples."""
    return whole([view], view["axes"], data)[0]


def whole(parts: Sequence[Mapping[str, Any]], axes: Mapping[str, Any], data: bytes) -> list[dict[str, Any]]:
    """The same of parts whose numbers follow one another, on the same axes: a view, and what is held beside it."""
    runs = iter(decoded(data, [count for part in parts for count in _counts(part)]))
    rulers = {name: Ruler(**ruler) for name, ruler in axes.items()}
    return [_filled(part, rulers, runs) for part in parts]


def _counts(part: Mapping[str, Any]) -> Iterator[int]:
    yield from (count for source in part["columns"].values() for _, count in source.values())
    yield from (signal[name]["count"] for signal in _sampled(part) for name in ("y", "dy"))


def _sampled(part: Mapping[str, Any]) -> list[dict[str, Any]]:
    return [signal for signal in part["signals"].values() if signal["kind"] == "sampled"]


def _filled(part: Mapping[str, Any], rulers: Mapping[str, Ruler], runs: Iterator[Whole]) -> dict[str, Any]:
    drawn = {
        source: {name: _placed(next(runs), rulers[axis]) for name, (axis, _) in given.items()}
        for source, given in part["columns"].items()
    }
    signals = dict(part["signals"])
    for name, signal in signals.items():
        if signal["kind"] == "sampled":
            signals[name] = {**signal, **{run: _samples(next(runs), signal[run]) for run in ("y", "dy")}}
    return {**part, "columns": drawn, "signals": signals}


def decoded(data: bytes, counts: list[int]) -> list[Whole]:
    """The steps of each column."""
    orders, rest = data[: len(counts)], np.frombuffer(data[len(counts) :], np.uint8)
    assert len(rest) == 4 * sum(counts)
    folded = rest.reshape(4, -1).T.copy().view("<u4").ravel().astype(np.int64)
    differences = (folded >> 1) ^ -(folded & 1)
    found: list[Whole] = []
    start = 0
    for order, count in zip(orders, counts, strict=True):
        column = differences[start : start + count]
        for _ in range(order % SUM):
            column = np.cumsum(column)
        found.append(column + found[-2] + found[-1] if order >= SUM else column)
        start += count
    return found


def _placed(whole: Whole, ruler: Ruler) -> NDArray[np.float32]:
    return _between(*span(ruler), whole / COARSE).astype(np.float32)


def _samples(whole: Whole, sent: Mapping[str, float]) -> list[float]:
    return [float(value) for value in _between(sent["low"], sent["high"], whole / FINE)]


def _between(low: float, high: float, shares: NDArray[np.float64]) -> NDArray[np.float64]:
    return low * (1 - shares) + high * shares
