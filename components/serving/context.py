"""The context of a server's handlers."""

from __future__ import annotations

import asyncio
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from urllib.parse import urlsplit

from components.serving.admission import Admission
from components.serving.hosts import is_named
from components.serving.metrics import Metrics
from components.serving.settings import Settings
from components.serving.visitors import Network


@dataclass(frozen=True, kw_only=True)
class Context:
    """The settings of a server, its host names, its visitors, and its counters."""

    settings: Settings
    hosts: Collection[str]
    """The names that visitors use for the server, as host:port."""
    trusted: Sequence[Network]
    """The trusted proxies, whose X-Forwarded-For is believed."""
    admission: Admission
    metrics: Metrics
    secret: bytes
    """The key that signs tokens."""
    ending: asyncio.Event = field(default_factory=asyncio.Event)
    """Set as soon as the server should get no new visitors."""

    def goes_by(self, origin: str) -> bool:
        """Return True if an origin belongs to this server."""
        return is_named(urlsplit(origin).netloc, self.hosts)
