"""Rooms in Valkey or Redis, which several replicas share: each room is a hash with an expiry time, and each change is
published. Operations that must be atomic are scripts, which the store runs as a unit.
"""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Collection
from contextlib import asynccontextmanager
from time import time
from typing import Any

import msgspec
from redis.asyncio import Redis
from redis.asyncio.retry import Retry
from redis.backoff import NoBackoff
from redis.exceptions import ConnectionError, OutOfMemoryError, RedisError, TimeoutError

from components.live_class.store import (
    ALL_BYTES,
    ALONE,
    LIFE,
    MOST_BYTES,
    MOST_COUNTS,
    MOST_ROOMS,
    MOST_VOTES,
    OF_A_ROOM,
    OF_A_VOTE,
    OF_AN_ANSWER,
    OF_COUNTS,
    OF_THE_STORE,
    QUIET,
    RESERVE,
    SEEN,
    SLOTS,
    FullError,
    Parts,
    Receive,
    Store,
    UnreachableError,
    size_of,
    slot_of,
)  # fmt: skip

CHANNEL = "class"
"""The channel on which all changes of all rooms are published."""
PATIENCE = 2.0
"""Seconds to wait for an answer of the store."""
PULSE = 5.0
"""Seconds of silence after which a listening connection is tested, and seconds for its answer."""

SLICE = 500
"""Answers that are read together."""

OF_A_ROOM_KEYS = """
local function keys_of(code)
  local keys = {}
  for _, kind in ipairs({'room', 'led', 'here', 'names', 'questions'}) do
    keys[#keys + 1] = 'class:' .. kind .. ':' .. code
  end
  for _, question in ipairs(redis.call('zrange', 'class:questions:' .. code, 0, -1)) do
    keys[#keys + 1] = 'class:votes:' .. code .. ':' .. question
  end
  return keys
end
local function lives(code, ms, now)
  local led = 'class:led:' .. code
  ms = math.min(ms, redis.call('pttl', led))
  if ms <= 0 then return end
  for _, key in ipairs(keys_of(code)) do if key ~= led then redis.call('pexpire', key, ms) end end
  redis.call('zadd', 'class:rooms', now + ms / 1000, code)
end
local function forget(code)
  redis.call('del', unpack(keys_of(code)))
  redis.call('zrem', 'class:rooms', code)
  redis.call('hdel', 'class:taken', code)
end
local function forget_ended(now)
  for _, code in ipairs(redis.call('zrangebyscore', 'class:rooms', '-inf', now)) do forget(code) end
end
local function owner_of(code) return redis.call('hget', 'class:room:' .. code, 'owner') or code end
local function size_of(code)
  return tonumber(string.match(redis.call('hget', 'class:taken', code) or '0', '^%d+'))
end
local function take(code, more)
  redis.call('hset', 'class:taken', code, string.format('%d %s', math.max(0, size_of(code) + more), owner_of(code)))
end
local function exceeds_share(code, more, limit, now)
  if more <= 0 then return false end
  forget_ended(now)
  local owner, own, all = owner_of(code), 0, 0
  for _, taken in ipairs(redis.call('hvals', 'class:taken')) do
    local size, whose = string.match(taken, '^(%d+) (.*)$')
    all = all + size
    if whose == owner then own = own + size end
  end
  return own + more > limit - all
end
"""
"""The common beginning of the scripts below. All keys of a room expire at the same time. `class:taken` has the number
of bytes of each room, and its owner.
"""
OPEN = """
local code, now, most, life, alone, quiet, size = unpack(ARGV, 1, 7)
redis.call('setrange', 'class:room:', 0, '') -- writes nothing, and is refused by a store that is full
forget_ended(now)
if redis.call('zcard', 'class:rooms') >= tonumber(most) then
  local found = redis.call('zrangebyscore', 'class:rooms', '-inf', now + alone / 1000 - quiet, 'LIMIT', 0, 1)
  if found[1] then forget(found[1]) end
end
if redis.call('zcard', 'class:rooms') >= tonumber(most) or redis.call('exists', KEYS[1]) == 1 then return 0 end
forget(code)
redis.call('hset', KEYS[1], unpack(ARGV, 8))
take(code, size)
redis.call('set', 'class:led:' .. code, '1', 'PX', life)
lives(code, tonumber(alone), now)
return 1
"""
KEEP = """
local code, now, life, alone, news, limit = unpack(ARGV, 1, 6)
if redis.call('exists', KEYS[1]) == 0 then return 0 end
local more = 0
for i = 7, #ARGV, 2 do
  if redis.call('hexists', KEYS[1], ARGV[i]) == 0 then more = more + #ARGV[i] end
  more = more + #ARGV[i + 1] - redis.call('hstrlen', KEYS[1], ARGV[i])
end
if exceeds_share(code, more, tonumber(limit), now) then return -1 end
if #ARGV > 6 then
  redis.call('hset', KEYS[1], unpack(ARGV, 7))
  take(code, more)
end
redis.call('set', 'class:led:' .. code, '1', 'PX', life)
lives(code, tonumber(alone), now)
if news ~= '' then redis.call('publish', 'class', news) end
return 1
"""
END = "forget(ARGV[1])"
VOTE = """
local code, now, voter, answer, most, question, size, limit, replace, of_answer, of_vote = unpack(ARGV)
if redis.call('exists', KEYS[1]) == 0 then return 0 end
local more = #answer
if redis.call('hexists', KEYS[2], voter) == 1 then
  if replace == '0' then return 1 end
  more = more - redis.call('hstrlen', KEYS[2], voter)
else
  if redis.call('hlen', KEYS[2]) >= tonumber(most) then return 0 end
  more = more + of_answer
end
if not redis.call('zscore', KEYS[3], question) then more = more + of_vote end
if size_of(code) + more > tonumber(size) or exceeds_share(code, more, tonumber(limit), now) then return -1 end
redis.call('hset', KEYS[2], voter, answer)
redis.call('zadd', KEYS[3], 'NX', redis.call('zcard', KEYS[3]), question)
take(code, more)
for i = 2, 3 do redis.call('pexpire', KEYS[i], redis.call('pttl', KEYS[1])) end
return 1
"""
UNVOTE = """
local code, voter, of_answer = unpack(ARGV)
if redis.call('hexists', KEYS[1], voter) == 0 then return end
take(code, -(redis.call('hstrlen', KEYS[1], voter) + of_answer))
redis.call('hdel', KEYS[1], voter)
"""
COUNT = """
local name, now, seconds, more, slot, slots, most = unpack(ARGV)
if more ~= '0' then redis.call('setrange', 'class:count:', 0, '') end -- is refused by a store that is full
if not redis.call('zscore', 'class:counts', name) then
  redis.call('zremrangebyscore', 'class:counts', '-inf', now)
  if redis.call('zcard', 'class:counts') >= tonumber(most) then return -1 end
end
if more ~= '0' then
  local lasts = seconds * (1 + 1 / slots)
  redis.call('hincrby', KEYS[1], slot, more)
  redis.call('pexpire', KEYS[1], math.ceil(1000 * lasts))
  redis.call('zadd', 'class:counts', now + lasts, name)
end
local times, kept = 0, redis.call('hgetall', KEYS[1])
for i = 1, #kept, 2 do
  if tonumber(kept[i]) >= slot - slots then times = times + kept[i + 1] else redis.call('hdel', KEYS[1], kept[i]) end
end
return times
"""
TAKE = """
local key, value = unpack(redis.call('hmget', KEYS[1], 'key', 'value'))
if key ~= ARGV[1] then return '' end
redis.call('del', KEYS[1])
return value
"""
PRESENT = """
local code, now, alone, replica, told, is_followed = unpack(ARGV, 1, 6)
if redis.call('exists', KEYS[1]) == 0 then return {} end
redis.call('hset', KEYS[2], replica, told)
redis.call('pexpire', KEYS[2], redis.call('pttl', KEYS[1]))
if is_followed == '1' and redis.call('pttl', KEYS[1]) < alone - math.min(alone / 10, 15000) then
  lives(code, tonumber(alone), now)
end
return redis.call('hvals', KEYS[2])
"""


class SharedStore(Store):
    """A store for any number of replicas; `url` as redis://host:6379/0."""

    def __init__(
        self,
        url: str,
        life: float = LIFE,
        rooms: int = MOST_ROOMS,
        clock: Callable[[], float] = time,
        alone: float = ALONE,
        size: int = MOST_BYTES,
        counts: int = MOST_COUNTS,
    ) -> None:
        self._life, self._alone = int(1000 * life), int(1000 * min(alone, life))
        self._most, self._size, self._most_counts = rooms, size, counts
        self._clock = clock
        self._redis = _client(url, retries=1)  # on a new connection, after the store has come back
        # Changes published while the connection was lost must be looked up, so this is an error at once.
        self._listener = _client(url, retries=0)
        self._open, self._keep, self._present, self._end, self._vote, self._unvote = (
            self._redis.register_script(OF_A_ROOM_KEYS + script) for script in (OPEN, KEEP, PRESENT, END, VOTE, UNVOTE)
        )
        self._count = self._redis.register_script(COUNT)
        self._take = self._redis.register_script(TAKE)

    async def open(self, code: str, parts: Parts) -> bool:
        limits = self._most, self._life, self._alone, QUIET
        given: list[Any] = [code, self._clock(), *limits, size_of(parts), *_flat(parts)]
        async with _asked():
            return bool(await self._open([_key("room", code)], given))

    async def parts(self, code: str) -> Parts:
        async with _asked():
            return _named(await self._redis.hgetall(_key("room", code)))

    async def keep(self, code: str, parts: Parts) -> bool:
        news = _published(code, parts) if parts else b""
        async with _asked():
            given = [code, self._clock(), self._life, self._alone, news, ALL_BYTES, *_flat(parts)]
            found = int(await self._keep([_key("room", code)], given))
        if found < 0:
            raise FullError(OF_THE_STORE)
        return bool(found)

    async def publish(self, code: str, parts: Parts) -> None:
        async with _asked():
            await self._redis.publish(CHANNEL, _published(code, parts))

    async def end(self, code: str) -> None:
        async with _asked():
            await self._end([], [code])
        await self.publish(code, {})

    async def rooms(self) -> int:
        async with _asked():
            return int(await self._redis.zcount("class:rooms", self._clock(), "+inf"))

    async def vote(
        self, code: str, question: str, voter: str, answer: bytes, most: int = MOST_VOTES, replace: bool = True
    ) -> bool:
        keys = [_key("room", code), _key("votes", code, question), _key("questions", code)]
        limits = self._size, ALL_BYTES - RESERVE, int(replace), OF_AN_ANSWER, OF_A_VOTE
        async with _asked():
            found = int(await self._vote(keys, [code, self._clock(), voter, answer, most, question, *limits]))
        if found < 0:
            raise FullError(OF_A_ROOM)
        return bool(found)

    async def unvote(self, code: str, question: str, voter: str) -> None:
        async with _asked():
            await self._unvote([_key("votes", code, question)], [code, voter, OF_AN_ANSWER])

    async def votes(self, code: str, question: str) -> Parts:
        async with _asked():
            found = self._redis.hscan_iter(_key("votes", code, question), count=SLICE)
            return {voter.decode(): answer async for voter, answer in found}

    async def questions(self, code: str) -> list[str]:
        async with _asked():
            names: Any = await self._redis.zrange(_key("questions", code), 0, -1)
            return [name.decode() for name in names]

    async def present(self, code: str, replica: str, names: Collection[str]) -> int:
        async with _asked():
            given: list[Any] = [code, self._clock(), self._alone, replica, _named_now(names), int(bool(names))]
            return len(_still_named(await self._present([_key("room", code), _key("here", code)], given)))

    async def name(self, code: str, replica: str, names: Collection[str]) -> None:
        async with _asked():
            pipe = self._redis.pipeline()
            pipe.hset(_key("names", code), replica, _named_now(names))
            pipe.pexpire(_key("names", code), int(2000 * SEEN))
            await pipe.execute()

    async def named(self, code: str) -> set[str]:
        async with _asked():
            return _still_named(await self._redis.hvals(_key("names", code)))

    async def count(self, name: str, seconds: float, more: int = 1) -> int:
        now = self._clock()
        given: list[Any] = [name, now, seconds, more, slot_of(now, seconds), SLOTS, self._most_counts]
        async with _asked():
            times = int(await self._count([_key("count", name)], given))
        if times < 0:
            raise UnreachableError(OF_COUNTS)
        return times

    async def lend(self, name: str, key: bytes, value: bytes, seconds: float) -> None:
        async with _asked():
            pipe = self._redis.pipeline()
            pipe.hset(_key("lent", name), mapping={"key": key, "value": value})
            pipe.pexpire(_key("lent", name), int(1000 * seconds))
            await pipe.execute()

    async def take(self, name: str, key: bytes) -> bytes:
        async with _asked():
            value: Any = await self._take([_key("lent", name)], [key])
        return bytes(value)

    async def time(self) -> float:
        begun = time()
        async with _asked():
            seconds, micros = await self._redis.time()
        return float(seconds + micros / 1e6 + (time() - begun) / 2)

    async def listen(self, receive: Receive, ready: Callable[[], None]) -> None:
        async with _asked(), self._listener.pubsub() as heard:
            await heard.subscribe(CHANNEL)
            is_asked = False
            while True:
                message = await heard.get_message(timeout=PULSE)
                if message is None and is_asked:
                    raise TimeoutError("It does not answer a ping.")
                is_asked = message is None
                if message is None:
                    await heard.ping()
                elif message["type"] == "subscribe":
                    ready()
                elif message["type"] == "message":
                    code, parts = msgspec.msgpack.decode(message["data"], type=tuple[str, dict[str, bytes]])
                    receive(code, parts)

    async def close(self) -> None:
        await self._listener.aclose()
        await self._redis.aclose()


def _client(url: str, retries: int) -> Redis:
    retry = Retry(NoBackoff(), retries)
    return Redis.from_url(url, socket_timeout=PATIENCE, socket_connect_timeout=PATIENCE, retry=retry)


@asynccontextmanager
async def _asked() -> AsyncIterator[None]:
    try:
        yield
    except (ConnectionError, TimeoutError, OSError) as error:
        raise UnreachableError("The store that replicas share does not answer.") from error
    except OutOfMemoryError as error:
        raise FullError(OF_THE_STORE) from error
    except RedisError as error:  # while it starts; it may answer later
        raise UnreachableError(f"The store that replicas share refuses: {error}.") from error


def _key(*names: str) -> str:
    """Return the name of a value in the store: class:room:CODE."""
    return ":".join(("class", *names))


def _flat(parts: Parts) -> list[Any]:
    return [each for item in parts.items() for each in item]


def _named(fields: Any) -> dict[str, bytes]:
    return {name.decode(): value for name, value in fields.items()}


def _named_now(names: Collection[str]) -> bytes:
    """The names at one replica, and the time until which they are valid."""
    return msgspec.msgpack.encode((time() + SEEN, list(names)))


def _still_named(told: Any) -> set[str]:
    """Return all names that any replica has reported recently."""
    known = [msgspec.msgpack.decode(each, type=tuple[float, list[str]]) for each in told]
    return {name for until, names in known if until > time() for name in names}


def _published(code: str, parts: Parts) -> bytes:
    return msgspec.msgpack.encode((code, dict(parts)))
