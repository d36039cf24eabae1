"""What an attack found."""

from __future__ import annotations

from typing import NamedTuple


class Finding(NamedTuple):
    name: str
    held: bool
    detail: str = ""
