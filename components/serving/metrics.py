"""Figures of one process, for Prometheus."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram, ProcessCollector, generate_latest

BUCKETS = (0.005, 0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.5, 1.0, 2.0, 5.0)

Looked = Mapping[str, tuple[str, Callable[[], float]]]
"""Figures that are looked up when they are asked for, by name, each with what it says."""


class Metrics:
    """Each server has its own, so that two in one process do not mix."""

    def __init__(self, **now: tuple[str, Callable[[], float]]) -> None:
        """What is counted as it happens; `now` are figures that are looked up when they are asked for."""
        self._registry = CollectorRegistry()
        ProcessCollector(registry=self._registry)
        for name, (about, value) in now.items():
            Gauge(f"oscillations_{name}", about, registry=self._registry).set_function(value)
        self.arrivals = Counter("oscillations_arrivals", "Pages opened", registry=self._registry)
        self.change = Histogram(
            "oscillations_change_seconds",
            "From a change's arrival to its answer",
            buckets=BUCKETS,
            registry=self._registry,
        )
        self.refused = Counter(
            "oscillations_refused", "Requests and sockets refused, by status or code", ["what"], registry=self._registry
        )

    def text(self) -> bytes:
        return generate_latest(self._registry)
