"""Background work of a scene, such as a measurement that takes some seconds."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

from components.language.picture import Progress
from components.quantities.parameters import Values

Later = Callable[[Callable[[], None]], object]


class Running(ABC):
    """Background work for the page of one visitor. A scene names its class in `work`."""

    def __init__(self, network: Callable[[], str] = lambda: "") -> None:
        """`network` is the visitor's network, or "" if unknown."""
        self.network = network
        self.notify: Callable[[], object] = lambda: None
        """Called when there is news, from any thread."""

    @classmethod
    @abstractmethod
    def pending(cls) -> int:
        """Return how many jobs of all visitors run or wait in this process."""

    @abstractmethod
    def progress(self, scene: Any) -> Progress:
        """Return the progress of the work of a scene."""

    @abstractmethod
    def news(self, scene: Any) -> Values:
        """Return the parameters that show the results so far, with their values."""

    @abstractmethod
    def obey(self, order: str, scene: Any) -> None:
        """Start, cancel or skip the work. Raises ValueError, with a reason, if that is not possible."""

    @abstractmethod
    def close(self) -> None:
        """Stop, because the visitor has left."""
