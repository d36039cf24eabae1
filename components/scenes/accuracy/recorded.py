"""Series made beforehand by `make bench ARGS=--record`, so that the scene is not empty."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from components.scenes.accuracy.data import Series
from components.scenes.accuracy.measuring import decoded_run
from components.scenes.accuracy.prices import time_text
from physics.integrators.accuracy import SYSTEMS

FOLDER = Path(__file__).with_name("recorded")


@dataclass(frozen=True)
class Recorded:
    """A recorded series: where and when, the time limit of a run in s, and the runs, in Python and compiled."""

    about: dict[str, str]
    seconds: float
    runs: Series
    compiled: Series

    @property
    def limit(self) -> str:
        """The time limit of a run; solvers that choose their steps had longer where they needed it."""
        longest = max((run.time or 0.0 for run in (*self.runs.every, *self.compiled.every)), default=0.0)
        text = f"each run at most {time_text(self.seconds)}"
        return text if longest < 2 * self.seconds else f"{text}, chosen steps up to {time_text(longest)}"

    @property
    def origin(self) -> str:
        """2026-11-21 on such a machine."""
        return f"{self.about['date'].partition(' ')[0]} on {self.about['machine'].rpartition(', ')[0]}"


def records(slug: str) -> Recorded | None:
    """The recorded runs of a system; None where it is a visitor's own."""
    return recorded(slug) if slug in SYSTEMS else None


@cache
def recorded(name: str) -> Recorded:
    """The runs on a system, or those of the study "length"."""
    path = FOLDER / f"{name}.json"
    data = json.loads(path.read_text(encoding="utf-8"))
    runs = [decoded_run(row) for row in data["runs"]]
    python, compiled = (Series(tuple(run for run in runs if run.compiled == kind)) for kind in (False, True))
    return Recorded(data["about"], data["seconds"], python, compiled)


@cache
def digits() -> dict[str, Any]:
    """The study of doubles against 80 digits: by sweep the columns x and error by method, and costs in ms by motion."""
    data: dict[str, Any] = json.loads((FOLDER / "digits.json").read_text(encoding="utf-8"))
    return data
