"""Visitors: their addresses behind proxies, and the rate at which a network may open pages."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Sequence
from ipaddress import IPv4Network, IPv6Network, ip_address, ip_network
from time import monotonic

from tornado.httputil import HTTPServerRequest

Network = IPv4Network | IPv6Network

MINUTE = 60.0
OF_A_NETWORK = {4: 24, 6: 56}
"""Bits of an address that a visitor's network shares, by version of the protocol."""
MOST_NAMES = 100_000
"""Maximum number of names that a rate counts (25 MB). Beyond it, new names have to wait."""


def networks(names: Sequence[str]) -> tuple[Network, ...]:
    """Parse addresses and networks. Raises ValueError for other text."""
    return tuple(ip_network(name) for name in names)


def visitor(peer: str, forwarded: str, trusted: Sequence[Network]) -> str:
    """Return the address of a request's client. Headers set before the nearest untrusted proxy are ignored, so that
    nobody can choose an address."""
    found = peer
    for hop in (peer, *(part.strip() for part in reversed(forwarded.split(",")))):
        try:
            address = ip_address(hop)
        except ValueError:
            break
        found = hop
        if not any(address in network for network in trusted):
            break
    return found


def address_of(request: HTTPServerRequest, trusted: Sequence[Network]) -> str:
    """Return the address that a request comes from."""
    return visitor(request.remote_ip or "", ",".join(request.headers.get_list("X-Forwarded-For")), trusted)


class Rate:
    """A limit per minute for each name. All events of a minute may come at once."""

    def __init__(self, most: int, clock: Callable[[], float] = monotonic) -> None:
        self.most = most
        self._clock = clock
        self._left: OrderedDict[str, tuple[float, float]] = OrderedDict()
        """The remaining count of each name and the time of its last update, oldest first."""

    def __len__(self) -> int:
        return len(self._left)

    def admit(self, name: str) -> float:
        """Count one event and return 0. If the limit is reached, return the seconds until it is possible."""
        seconds = self.wait(name)
        if not seconds:
            self.charge(name, 1.0)
        return seconds

    def wait(self, name: str) -> float:
        """Return the seconds until one more time is possible, 0 if it is possible now."""
        self._forget()
        if name not in self._left and len(self) >= MOST_NAMES:
            return MINUTE
        return max(0.0, 1.0 - self.left(name)) * MINUTE / self.most

    def left(self, name: str) -> float:
        """Return the remaining number of events."""
        now = self._clock()
        left, seen = self._left.get(name, (float(self.most), now))
        return min(float(self.most), left + (now - seen) * self.most / MINUTE)

    def charge(self, name: str, amount: float) -> None:
        """Count this many events, even if they exceed the limit."""
        self._left[name] = self.left(name) - amount, self._clock()
        self._left.move_to_end(name)

    def _forget(self) -> None:
        """Forget the names that have their full count again."""
        now = self._clock()
        while self._left:
            name, (_, seen) = next(iter(self._left.items()))
            if now - seen < MINUTE:
                return
            left = self.left(name)
            del self._left[name]
            if left < self.most:  # its count can be below zero, for more than a minute
                self._left[name] = left, now


class Arrivals(Rate):
    """The limit of pages that a network may open. A whole class can have one address."""

    def admit(self, name: str) -> float:
        """`name` is the address of a visitor."""
        return super().admit(str(network_of(name)))


def network_of(address: str) -> Network:
    """Return the network of a visitor; a Unix socket has no address and counts as one network."""
    try:
        version = ip_address(address).version
    except ValueError:
        return ip_network("127.0.0.1")
    return ip_network(f"{address}/{OF_A_NETWORK[version]}", strict=False)
