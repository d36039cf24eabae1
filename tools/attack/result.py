"""The result of one attack."""

from __future__ import annotations

from typing import NamedTuple


class AttackResult(NamedTuple):
    name: str
    passed: bool
    detail: str = ""
