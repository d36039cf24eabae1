"""The guided walks, one data file each: questions, the parts hidden until they are answered, and explanations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

from components.walks.walk import Walk

Walks: TypeAlias = Mapping[str, Walk]
Query: TypeAlias = Mapping[str, Sequence[bytes]]
