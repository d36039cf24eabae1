"""The server and clients other than our page."""

from __future__ import annotations

from tests.serving.server import Server
from tools.attack.protocol import attack


def test_no_abuse_of_the_protocol_gets_through(server: Server) -> None:
    found = attack(server.url, short=True)
    assert [finding for finding in found if not finding.passed] == []
    assert len(found) > 90
