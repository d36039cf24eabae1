"""Which names a server answers to: a page of another site must not read it under a name of its own (DNS rebinding)."""

from __future__ import annotations

from collections.abc import Collection
from ipaddress import ip_address
from urllib.parse import urlsplit

from bokeh.server.util import check_allowlist


def answers_to(host: str, allowed: Collection[str]) -> bool:
    """Whether a page may be asked for under `host`, the request's own header.

    Addresses and this machine's own name cannot be made to point elsewhere, so they need no permission.
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
