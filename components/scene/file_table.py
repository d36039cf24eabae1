"""Tables that only files have, in place of what a plot draws in pieces."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

from components.scene.traces import Columns


@dataclass(frozen=True, eq=False)
class FileTable:
    """A table of a file, computed when a file is written.

    `instead` are the sources that it replaces, `units` the SI unit of each column. `drawn` names the columns of these
    sources that a column belongs to, where they have other names: it is hidden with each. `note` explains the rows.
    """

    instead: tuple[str, ...]
    columns: Callable[[], Columns]
    units: Mapping[str, str]
    drawn: Mapping[str, tuple[str, ...]]
    note: str = ""

    def seen(self, sources: Mapping[str, Columns]) -> Columns:
        """Return the columns of which something is drawn."""
        known = {name for source in self.instead for name in sources.get(source, {})}
        visible = [name for name in self.units if known.issuperset(self.drawn.get(name, (name,)))]
        return {name: self._computed[name] for name in visible}

    @cached_property
    def _computed(self) -> Columns:
        return self.columns()
