"""Messages as the browser reads them, in Python: inflated, and their columns as numbers again."""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from components.page.picture import Ruler
from components.places import COARSE, FINE, span
from components.wire import Packet

Whole = NDArray[np.int64]


def inflated(packet: Packet, usual: bytes) -> bytes:
    """The line of JSON, and the columns."""
    return zlib.decompressobj(-15, *([usual] if usual else [])).decompress(packet["data"])


def with_numbers(view: Mapping[str, Any], data: bytes) -> dict[str, Any]:
    """The view with numbers in place of what it says of its columns and samples."""
    columns = [drawn for source in view["columns"].values() for drawn in source.values()]
    sampled = [signal for signal in view["signals"].values() if signal["kind"] == "sampled"]
    counts = [count for _, count in columns]
    counts += [signal[name]["count"] for signal in sampled for name in ("y", "dy")]
    whole = iter(decoded(data, counts))
    rulers = {name: Ruler(**ruler) for name, ruler in view["axes"].items()}
    drawn = {
        source: {name: _placed(next(whole), rulers[axis]) for name, (axis, _) in given.items()}
        for source, given in view["columns"].items()
    }
    signals = dict(view["signals"])
    for name, signal in signals.items():
        if signal["kind"] == "sampled":
            signals[name] = {**signal, **{part: _samples(next(whole), signal[part]) for part in ("y", "dy")}}
    return {**view, "columns": drawn, "signals": signals}


def decoded(data: bytes, counts: list[int]) -> list[Whole]:
    """The steps of each column."""
    orders, rest = data[: len(counts)], np.frombuffer(data[len(counts) :], np.uint8)
    assert len(rest) == 4 * sum(counts)
    folded = rest.reshape(4, -1).T.copy().view("<u4").ravel().astype(np.int64)
    differences = (folded >> 1) ^ -(folded & 1)
    found, start = [], 0
    for order, count in zip(orders, counts, strict=True):
        column = differences[start : start + count]
        for _ in range(order):
            column = np.cumsum(column)
        found.append(column)
        start += count
    return found


def _placed(whole: Whole, ruler: Ruler) -> NDArray[np.float32]:
    return _between(*span(ruler), whole / COARSE).astype(np.float32)


def _samples(whole: Whole, sent: Mapping[str, float]) -> list[float]:
    return [float(value) for value in _between(sent["low"], sent["high"], whole / FINE)]


def _between(low: float, high: float, shares: NDArray[np.float64]) -> NDArray[np.float64]:
    return low * (1 - shares) + high * shares
