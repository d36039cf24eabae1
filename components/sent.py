"""A picture as it is sent: what the browser shows of it, and its numbers in steps."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import accumulate, pairwise

import numpy as np
from msgspec.structs import replace

from components.axes import TIME_AXIS, Axis
from components.page.picture import Drawn, View
from components.page.signals import AnySignal, Sampled, Samples
from components.places import COARSE, FINE, Floats, Steps, span, steps
from components.scene import Picture
from components.traces import Columns

ColumnAxes = Mapping[str, Mapping[str, str]]
"""The axis that each column of each source is drawn on."""


def view_of(picture: Picture, axes: ColumnAxes, left_out: tuple[str, ...] = ()) -> tuple[View, list[Steps]]:
    """The view of a picture, and the numbers that follow it: its columns, then the runs of its signals."""
    rulers = {name: axis.ruler for name, axis in picture.axes.items()}
    columns, numbers = columns_of(picture.columns, axes, picture.axes)
    signals, runs = signals_of(picture.signals)
    numbers += runs
    view = View(
        columns=columns,
        axes=rulers,
        time=TIME_AXIS if TIME_AXIS in picture.axes else "",
        pace=picture.pace,
        signals=signals,
        scalars=picture.scalars,
        values=picture.values,
        live=picture.live,
        forms=picture.forms,
        notes=picture.notes,
        left_out=left_out,
    )
    return view, numbers


def columns_of(
    given: Mapping[str, Columns], drawn_on: ColumnAxes, axes: Mapping[str, Axis]
) -> tuple[dict[str, dict[str, Drawn]], list[Steps]]:
    """What is said of each column, and its numbers: where they stand on the axis that they are drawn on."""
    columns: dict[str, dict[str, Drawn]] = {}
    values: list[Floats] = []
    on: dict[str, list[int]] = {}
    for source, drawn in drawn_on.items():
        known = given.get(source, {})
        for column, axis in drawn.items():
            if column in known:
                columns.setdefault(source, {})[column] = Drawn(axis, len(known[column]))
                on.setdefault(axis, []).append(len(values))
                values.append(known[column])
    numbers: dict[int, Steps] = {}
    for axis, places in on.items():  # all that are drawn on one at once: a scene may have a hundred
        ends = accumulate((len(values[i]) for i in places), initial=0)
        stand = axes[axis].places(np.concatenate([values[i] for i in places]))
        found = steps(stand, *span(axes[axis].ruler), COARSE)
        numbers |= {i: found[start:end] for i, (start, end) in zip(places, pairwise(ends), strict=True)}
    return columns, [numbers[i] for i in range(len(values))]


def signals_of(given: Mapping[str, AnySignal]) -> tuple[dict[str, AnySignal], list[Steps]]:
    """The signals as they are told, and the numbers of those that are sampled."""
    signals: dict[str, AnySignal] = {}
    numbers: list[Steps] = []
    for name, signal in given.items():
        if isinstance(signal, Sampled):
            signal, runs = _run_of(signal)
            numbers += runs
        signals[name] = signal
    return signals, numbers


def _run_of(signal: Sampled) -> tuple[Sampled, list[Steps]]:
    """The signal with runs in place of its numbers, and these."""
    told: dict[str, Samples] = {}
    numbers: list[Steps] = []
    for name in ("y", "dy"):
        values = np.asarray(getattr(signal, name))
        low, high = float(values.min()), float(values.max())
        told[name] = Samples(len(values), low, high)
        numbers.append(steps(values, low, high, FINE))
    return replace(signal, **told), numbers
