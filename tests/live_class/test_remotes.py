"""Waiting remote controls: the page that leads the class gets the current list at any time."""

from __future__ import annotations

from contextlib import AsyncExitStack

import pytest

from components.live_class import remotes
from components.live_class.remotes import begun, decided, is_in, new_digits, waits
from components.live_class.room import ClassRoom
from tests.live_class.listening import Listener, replicas, until
from tests.live_class.stores import KINDS, made, valkey_running


def told(listener: Listener) -> list[tuple[str, ...]]:
    return [news.remotes for news in listener.news if news.remotes is not None]


def test_two_phones_that_wait_at_once_are_both_asked_for() -> None:
    room, leader, follower = ClassRoom("K7HM", {}), Listener(leads=True), Listener()
    room.listeners |= {leader, follower}
    room.deliver(begun("47", "one"))
    room.deliver(begun("12", "two"))
    assert told(leader) == [("47",), ("12", "47")] and not told(follower)
    assert room.whole(leads=True).remotes == ("12", "47") and room.whole().remotes is None
    room.deliver(decided(room.parts, "12", is_in=True))
    assert is_in(room.parts, "two") and not is_in(room.parts, "one") and waits(room.parts, "one")
    room.deliver(decided(room.parts, "47", is_in=False))
    assert not is_in(room.parts, "one") and not waits(room.parts, "one") and is_in(room.parts, "two")
    assert told(leader)[2:] == [("47",), ()]
    for digits in ("12", "47", "99"):
        with pytest.raises(ValueError, match="No remote control with"):
            decided(room.parts, digits, is_in=True)


def test_who_waits_longer_than_a_minute_is_asked_for_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    room, leader = ClassRoom("K7HM", {}), Listener(leads=True)
    room.listeners.add(leader)
    room.deliver(begun("47", "one"))
    number = room.number
    room.look()
    assert len(leader.news) == 1
    monkeypatch.setattr(remotes, "time", lambda: 4e9)
    room.look()
    assert told(leader) == [("47",), ()] and room.number != number  # a page that only polls gets it too
    with pytest.raises(ValueError, match="No remote control with"):
        decided(room.parts, "47", is_in=True)


def test_no_two_phones_show_the_same_digits() -> None:
    all_but_one = {f"{n}" for n in range(10, 100)} - {"47"}
    assert new_digits(all_but_one) == "47"
    with pytest.raises(ValueError, match="Too many remote controls"):
        new_digits(all_but_one | {"47"})


@pytest.mark.parametrize("kind", KINDS)
async def test_a_phone_that_waits_is_known_to_a_replica_that_comes_later(kind: str) -> None:
    with valkey_running() as valkey:
        async with AsyncExitStack() as opened:
            stores = [await opened.enter_async_context(made(kind, valkey.url)) for _ in range(1 + (kind == "valkey"))]
            registries = await opened.enter_async_context(replicas(*stores))
            code, key = await registries[0].open()
            await registries[0].publish(await registries[0].room(code), begun("47", "one"))
            room = await registries[-1].led(code, key)
            assert room.whole(leads=True).remotes == ("47",)
            await registries[-1].publish(room, decided(room.parts, "47", is_in=True))
            first = await registries[0].room(code)
            await until(lambda: is_in(first.parts, "one"))
