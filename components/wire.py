"""How a message crosses the wire: as one JSON text and one array, since every array of its own costs two frames."""

from __future__ import annotations

import json
from typing import Any

import numpy as np


def packed(message: dict[str, Any]) -> dict[str, Any]:
    """`message` in two parts: its columns end to end as `numbers`; all else, and their lengths, as the JSON `facts`."""
    columns = message["columns"]
    lengths = {source: {name: len(column) for name, column in data.items()} for source, data in columns.items()}
    numbers = [column for data in columns.values() for column in data.values()]
    facts = json.dumps({**message, "columns": lengths}, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
    return {"facts": facts, "numbers": np.concatenate(numbers) if numbers else np.empty(0, np.float32)}
