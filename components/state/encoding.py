"""The encoding of a picture: the signals that the browser draws, and the numbers of curves that have no signal.

Drawing does not need doubles. The numbers are integers from 0 to 65535 over three times the height of the frame: about
70 steps per pixel.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import accumulate, pairwise

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from components.language.picture import Drawn, PagePicture, Ruler, Trace
from components.language.signals import AnySignal, Sampled, Samples
from components.quantities.axes import TIME_AXIS, Axis
from components.scene.picture import Picture
from components.scene.traces import Columns
from components.state.wire import Steps

Floats = NDArray[np.float64]
ColumnAxes = Mapping[str, Mapping[str, str]]
"""The axis that each column of each source is drawn on."""

COARSE = 2**16 - 1
"""Largest integer of a column that is drawn."""
FINE = 2**24 - 1
"""Largest integer of the samples of a signal. They are as precise as float32, because other numbers are computed from
them."""


def view_of(picture: Picture, axes: ColumnAxes, left_out: tuple[str, ...] = ()) -> tuple[PagePicture, list[Steps]]:
    """Return the message part for a picture, and the numbers after it: its columns, then the samples of signals."""
    columns, numbers = columns_of(picture.columns, axes, picture.axes)
    signals, runs = signals_of(picture.signals)
    view = PagePicture(
        columns=columns,
        axes={name: axis.ruler for name, axis in picture.axes.items()},
        time=TIME_AXIS if TIME_AXIS in picture.axes else "",
        pace=picture.pace,
        signals=signals,
        traces=traces_of(picture),
        scalars=picture.scalars,
        values=picture.values,
        live=picture.live,
        forms=picture.forms,
        notes=picture.notes,
        onward=picture.onward,
        left_out=left_out,
    )
    return view, [*numbers, *runs]


def traces_of(picture: Picture) -> dict[str, Trace]:
    """Return the signals that the browser draws over time, by source."""
    return {
        source: Trace(picture.ends[source], one.count, one.names, dict(one.signals))
        for source, one in picture.traces.items()
    }


def columns_of(
    given: Mapping[str, Columns], drawn_on: ColumnAxes, axes: Mapping[str, Axis]
) -> tuple[dict[str, dict[str, Drawn]], list[Steps]]:
    """Return the columns of the message, and their numbers: coordinates on their axes."""
    columns: dict[str, dict[str, Drawn]] = {}
    values: list[Floats] = []
    on: dict[str, list[int]] = {}
    for source, drawn in drawn_on.items():
        known = given.get(source, {})
        for name, axis in drawn.items():
            if name in known:
                columns.setdefault(source, {})[name] = Drawn(axis, len(known[name]))
                on.setdefault(axis, []).append(len(values))
                values.append(known[name])
    numbers: dict[int, Steps] = {}
    for axis, places in on.items():  # one axis at a time: a scene may have a hundred columns
        ends = accumulate((len(values[i]) for i in places), initial=0)
        stand = axes[axis].places(np.concatenate([values[i] for i in places]))
        found = steps(stand, *span(axes[axis].ruler), COARSE)
        numbers |= {i: found[start:end] for i, (start, end) in zip(places, pairwise(ends), strict=True)}
    return columns, [numbers[i] for i in range(len(values))]


def signals_of(given: Mapping[str, AnySignal]) -> tuple[dict[str, AnySignal], list[Steps]]:
    """Return the signals for the message, and the numbers of sampled signals."""
    signals: dict[str, AnySignal] = {}
    numbers: list[Steps] = []
    for name, signal in given.items():
        if isinstance(signal, Sampled):
            signal, runs = _run_of(signal)
            numbers += runs
        signals[name] = signal
    return signals, numbers


def _run_of(signal: Sampled) -> tuple[Sampled, list[Steps]]:
    """Return the signal without its samples (only their ranges), and the samples."""
    told: dict[str, Samples] = {}
    numbers: list[Steps] = []
    for name in ("y", "dy"):
        values = np.asarray(getattr(signal, name))
        low, high = float(values.min()), float(values.max())
        told[name] = Samples(len(values), low, high)
        numbers.append(steps(values, low, high, FINE))
    return replace(signal, **told), numbers


def span(ruler: Ruler) -> tuple[float, float]:
    """Return the range that the integers of an axis cover: its frame, and as much again on either side."""
    low, high = sorted((ruler.start, ruler.end))
    return low - (high - low), high + (high - low)


def steps(values: Floats, low: float, high: float, count: int) -> Steps:
    """Return the nearest of `count` + 1 equal steps from low to high; numbers outside are clipped."""
    half = high / 2 - low / 2  # high - low could overflow
    if not half > 0:
        return np.zeros(len(values), np.int32)
    shares = (np.minimum(np.maximum(values, low), high) / 2 - low / 2) / half
    return np.rint(count * shares).astype(np.int32)
