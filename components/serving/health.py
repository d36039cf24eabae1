"""The addresses for a proxy, a container engine and Prometheus, under any name of this machine."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from ipaddress import ip_address

from prometheus_client import CONTENT_TYPE_LATEST
from tornado.web import HTTPError

from components.serving.handlers import LectureHandler
from components.serving.visitors import Network


class Health(LectureHandler):
    """A handler that is requested every few seconds and therefore not logged."""

    log_level = logging.DEBUG

    def prepare(self) -> None:
        self.set_header("Cache-Control", "no-store")


class Liveness(Health):
    """The handler that answers as long as the event loop runs."""

    def get(self) -> None:
        self.write({self.request.path: True})

    head = get


class Readiness(Health):
    """The handler of readiness: 200 if the server takes new visitors, 503 when it is about to end."""

    def get(self) -> None:
        ready = not self.context.ending.is_set()
        self.set_status(200 if ready else 503)
        self.write({self.request.path: ready})

    head = get


class Figures(Health):
    """The handler of the metrics, for this machine and METRICS_FOR; others get 404."""

    def initialize(self, readers: Sequence[Network]) -> None:
        self._readers = readers

    def prepare(self) -> None:
        super().prepare()
        asked_by, headers = self.visitor, self.request.headers
        # The client of an untrusted proxy is unknown.
        unknown = asked_by == self.request.remote_ip and "X-Forwarded-For" in headers
        if unknown or not any(ip_address(asked_by) in network for network in self._readers):
            raise HTTPError(404)

    def get(self) -> None:
        self.set_header("Content-Type", CONTENT_TYPE_LATEST)
        self.write(self.context.metrics.text())
