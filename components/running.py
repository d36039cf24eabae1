"""Work that a scene has done for it beside its pictures, such as a measurement: it is started, watched and left."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

from components.page.picture import Progress

Later = Callable[[Callable[[], None]], object]


class Running(ABC):
    """The work of one visitor's scene.

    `later` runs a function under the page's own lock: for what comes from another thread.
    """

    def __init__(self, scene: Any) -> None:
        """`scene` is of the class that names this work; each of them knows what it needs of it."""
        self.later: Later = lambda act: act()
        self.network: Callable[[], str] = lambda: ""
        """Where the visitor comes from; "" where that is not known."""

    @classmethod
    @abstractmethod
    def pending(cls) -> int:
        """How much of this work runs or waits in this process, for all visitors."""

    @property
    @abstractmethod
    def progress(self) -> Progress:
        """How far it has come."""

    @abstractmethod
    def obey(self, order: str) -> None:
        """Start, cancel or skip. ValueError, in words, where that cannot be."""

    @abstractmethod
    def close(self) -> None:
        """The visitor has left."""
