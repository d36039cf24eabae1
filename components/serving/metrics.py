"""Metrics of one process, for Prometheus."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Mapping
from time import monotonic

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram, Info, ProcessCollector, generate_latest

BUCKETS = (0.005, 0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.5, 1.0, 2.0, 5.0)

BETWEEN = 0.1
"""Seconds between measurements of the event loop's delay."""

Looked = Mapping[str, tuple[str, Callable[[], float]]]
"""Functions that compute metrics on request, by name, with descriptions."""


class Metrics:
    """The metrics of one server. Each server has its own, so that two in one process do not mix."""

    def __init__(self, version: str, **now: tuple[str, Callable[[], float]]) -> None:
        """Counters of events; `now` are values that are computed on request."""
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

        self.lag = Histogram(
            "oscillations_loop_lag_seconds",
            "Delay of the event loop in seconds",
            buckets=BUCKETS,
            registry=self._registry,
        )
        errors = Counter(
            "oscillations_errors",
            "Errors in the log; those of visitors count once per place in the code",
            registry=self._registry,
        )
        self.errors = _Counting(errors)
        Info("oscillations_build", "Version of the server", registry=self._registry).info({"version": version})

    async def watch(self) -> None:
        """Measure the delay of the event loop until cancelled."""
        while True:
            due = monotonic() + BETWEEN
            await asyncio.sleep(BETWEEN)
            self.lag.observe(max(0.0, monotonic() - due))

    def text(self) -> bytes:
        return generate_latest(self._registry)


class _Counting(logging.Handler):
    """Counts log records of level ERROR."""

    def __init__(self, counter: Counter) -> None:
        super().__init__(logging.ERROR)
        self._counter = counter

    def emit(self, record: logging.LogRecord) -> None:
        self._counter.inc()
