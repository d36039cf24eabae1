"""Signals at an instant, against the exact numbers of the curves that they draw."""

from __future__ import annotations

import pytest

from components.layout.sheet import axes_of_columns
from components.quantities.instant import instant
from components.scene import Scene
from components.scenes import SCENES


@pytest.mark.parametrize("kind", SCENES.values(), ids=SCENES.keys())
def test_a_signal_has_the_values_of_its_curve(kind: type[Scene]) -> None:
    axes = axes_of_columns(kind.sheet())
    for values in ({}, *kind.presets.values()):
        picture = kind.at(values).shown
        for source, traces in picture.traces.items():
            for name in axes.get(source, {}).keys() & set(traces.names):
                axis = picture.axes[axes[source][name]]
                exact = axis.places(traces.columns[name])
                for i in (0, len(exact) // 3, -1):
                    now = instant(picture.signals, picture.scalars, picture.axes["t"].place(traces.t[i]))
                    size = axis.ruler.end - axis.ruler.start
                    assert now[traces.signals.get(name, name)] == pytest.approx(exact[i], abs=1e-6 * abs(size)), name
