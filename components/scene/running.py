"""Background work of a scene, such as a measurement: it can be started, watched and left."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

from components.language.picture import Progress
from components.quantities.parameters import Values

Later = Callable[[Callable[[], None]], object]


class Running(ABC):
    """The work that a scene has done for one visitor's page; the scene names the class of its work."""

    def __init__(self, network: Callable[[], str] = lambda: "") -> None:
        """`network` is the visitor's network, or "" if unknown."""
        self.network = network
        self.heard: Callable[[], object] = lambda: None
        """Called where there is something new, from any thread."""

    @classmethod
    @abstractmethod
    def pending(cls) -> int:
        """The number of works that run or wait in this process, for all visitors."""

    @abstractmethod
    def progress(self, scene: Any) -> Progress:
        """The progress of a scene's work."""

    @abstractmethod
    def news(self, scene: Any) -> Values:
        """Values of parameters with the results so far."""

    @abstractmethod
    def obey(self, order: str, scene: Any) -> None:
        """Start, cancel or skip. ValueError, in words, where that cannot be."""

    @abstractmethod
    def close(self) -> None:
        """The visitor has left."""
