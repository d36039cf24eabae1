"""Encoded numbers: steps and second differences are decoded exactly by the page's own scripts."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from components.language.signals import Sampled
from components.quantities.axes import Axis
from components.scene.picture import Picture
from components.state.encoding import COARSE, view_of
from components.state.wire import packed
from tests.page.scripts import unpacked

AXES = {"x": "x", "w": "x"}


def read(picture: Picture, preset_dictionary: bytes = b"") -> Any:
    """A picture as the page has it."""
    view, numbers = view_of(picture, {"time": AXES, "other": AXES})
    packet = packed({"view": view}, numbers, preset_dictionary=preset_dictionary)  # type: ignore[arg-type]
    return unpacked(packet, preset_dictionary)["view"]


COLUMN = arrays.arrays(float, st.integers(0, 40), elements=st.floats(-20, 20))


@given(COLUMN, COLUMN, st.booleans())
def test_columns_come_back_to_half_a_step_of_three_heights(first: Any, second: Any, down: bool) -> None:
    axis = Axis(1.5, -1.5) if down else Axis(-1.5, 1.5)
    columns = read(Picture(columns={"time": {"x": first}, "other": {"w": second}}, axes={"x": axis}))["columns"]
    for found, meant in ((columns["time"]["x"], first), (columns["other"]["w"], second)):
        near = np.abs(meant) < 4.4  # three heights; the rest is outside
        np.testing.assert_allclose(np.array(found)[near], meant[near], rtol=0, atol=0.501 * 9 / COARSE)
        assert np.all((np.abs(np.array(found)) > 4.3) | near) and np.all((found * meant > 0) | near)


@given(arrays.arrays(float, st.integers(2, 40), elements=st.floats(-1e6, 1e6)))
def test_samples_of_a_signal_come_back_as_fine_as_float32(values: Any) -> None:
    signal = Sampled(period=6.28, y=tuple(values.tolist()), dy=tuple((2 * values).tolist()), drift=0.5)
    found = read(Picture(columns={}, axes={}, signals={"x": signal}))["signals"]["x"]
    step = float(np.ptp(values)) * 2.0**-24 + 1e-9
    np.testing.assert_allclose(found["y"], values, rtol=0, atol=step)
    np.testing.assert_allclose(found["dy"], 2 * values, rtol=0, atol=2 * step)
