"""The guided walks, each a data file: questions, what is covered until they are answered, and what it means."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

from components.walks.walk import Walk

Walks: TypeAlias = Mapping[str, Walk]
Query: TypeAlias = Mapping[str, Sequence[bytes]]
