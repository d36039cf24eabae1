"""Who asks: the address of a visitor behind proxies, and how many pages one network may open."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from ipaddress import IPv4Network, IPv6Network, ip_address, ip_network
from time import monotonic

Network = IPv4Network | IPv6Network

MINUTE = 60.0
OF_A_NETWORK = {4: 24, 6: 56}
"""Bits of an address that a network of visitors shares, by the version of the protocol."""
MOST_NETWORKS = 10_000


def networks(names: Sequence[str]) -> tuple[Network, ...]:
    """Addresses and networks by their names; ValueError for what is neither."""
    return tuple(ip_network(name) for name in names)


def visitor(peer: str, forwarded: str, trusted: Sequence[Network]) -> str:
    """The address that a request comes from: what the nearest proxy that is not trusted says of itself counts for
    nothing, so that nobody chooses an address."""
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


class Arrivals:
    """Lets each network open so many pages a minute, all at once if it likes: a class comes through one address."""

    def __init__(self, most: int, clock: Callable[[], float] = monotonic) -> None:
        self.most = most
        self._clock = clock
        self._left: dict[Network, tuple[float, float]] = {}
        """Of each network that has come lately, how many it may open yet, and when that was."""

    def admit(self, address: str) -> float:
        """Count a page that is opened; where it is one too many, in how many seconds it may be."""
        now, network = self._clock(), _network_of(address)
        if len(self._left) >= MOST_NETWORKS:
            self._left = {one: (left, seen) for one, (left, seen) in self._left.items() if now - seen < MINUTE}
        left, seen = self._left.get(network, (float(self.most), now))
        left = min(float(self.most), left + (now - seen) * self.most / MINUTE)
        if left < 1:
            self._left[network] = left, now
            return (1 - left) * MINUTE / self.most
        self._left[network] = left - 1, now
        return 0.0


def _network_of(address: str) -> Network:
    """The network of a visitor; a socket of the machine's own has no address and is one of its own."""
    try:
        version = ip_address(address).version
    except ValueError:
        return ip_network("127.0.0.1")
    return ip_network(f"{address}/{OF_A_NETWORK[version]}", strict=False)
