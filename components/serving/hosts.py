"""The host names of a server. Other names are rejected, so that no other site can read a page by DNS rebinding."""

from __future__ import annotations

from collections.abc import Collection
from ipaddress import ip_address
from urllib.parse import urlsplit

from bokeh.server.util import check_allowlist


def answers_to(host: str, allowed: Collection[str]) -> bool:
    """Return True if a page may be requested under `host`, the Host header.

    IP addresses and this machine's own name are always allowed, because nobody can make them point elsewhere.
    """
    try:
        name = urlsplit(f"//{host}").hostname or ""
    except ValueError:
        return False
    return name == "localhost" or _is_address(name) or is_named(host, allowed)


def is_named(host: str, allowed: Collection[str]) -> bool:
    return bool(check_allowlist(host.lower(), allowed))


def _is_address(name: str) -> bool:
    try:
        ip_address(name)
    except ValueError:
        return False
    return True
