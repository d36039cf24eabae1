"""A sheet rejects a block that would never be visible."""

from __future__ import annotations

import pytest

from components.layout.sheet import column, row, words


def test_a_block_that_its_neighbours_leave_no_room_is_refused() -> None:
    high = words("A plot.", grow=300)
    with pytest.raises(ValueError, match="A block with grow=1 has no room beside one with grow=300: give it more"):
        column(row(words("Beside another.")), high)
    assert column(row(words("Beside another."), grow=250), words("As high as its text."), high)
