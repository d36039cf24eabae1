"""Tables for files that replace the sources of a plot, for curves that the plot draws in several pieces."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

from components.scene.traces import Columns


@dataclass(frozen=True, eq=False)
class FileTable:
    """A table of a file, computed when a file is written.

    `instead`  the sources that it replaces
    `units`    the SI unit of each column
    `drawn`    the names that columns have in these sources, if they differ; hiding one of these hides the column
    `note`     a sentence that explains the rows
    """

    instead: tuple[str, ...]
    columns: Callable[[], Columns]
    units: Mapping[str, str]
    drawn: Mapping[str, tuple[str, ...]]
    note: str = ""

    def seen(self, sources: Mapping[str, Columns]) -> Columns:
        """Return the columns of which at least a part is visible in the plot."""
        known = {name for source in self.instead for name in sources.get(source, {})}
        visible = [name for name in self.units if known.issuperset(self.drawn.get(name, (name,)))]
        return {name: self._computed[name] for name in visible}

    @cached_property
    def _computed(self) -> Columns:
        return self.columns()
