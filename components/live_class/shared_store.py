"""Rooms in Valkey or Redis, which several replicas share: each is a hash with an end, and all that is new is published.

What must not happen twice or in halves is a script, which the store runs as one.
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
    ALONE,
    LIFE,
    MOST_BYTES,
    MOST_ROOMS,
    MOST_VOTES,
    OF_A_ROOM,
    OF_THE_STORE,
    QUIET,
    SEEN,
    AwayError,
    FullError,
    Hear,
    Parts,
    Store,
)  # fmt: skip

CHANNEL = "class"
"""On which all that is new of all rooms is published."""
PATIENCE = 2.0
"""Seconds for an answer."""
PULSE = 5.0
"""Seconds of silence after which a connection that only listens is asked whether it is there, and for its answer."""

SLICE = 500
"""Answers that are read at once."""

OF_A_ROOM_KEYS = """
local function keys_of(code)
  local keys = {}
  for _, kind in ipairs({'room', 'led', 'here', 'names', 'size', 'questions'}) do
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
end
"""
"""The beginning of the scripts below: all that there is of a room ends at the same time."""
OPEN = """
local code, now, most, life, alone, quiet = unpack(ARGV, 1, 6)
redis.call('setrange', 'class:room:', 0, '') -- writes nothing, and is refused by a store that is full
redis.call('zremrangebyscore', 'class:rooms', '-inf', now)
if redis.call('zcard', 'class:rooms') >= tonumber(most) then
  local found = redis.call('zrangebyscore', 'class:rooms', '-inf', now + alone / 1000 - quiet, 'LIMIT', 0, 1)
  if found[1] then forget(found[1]) end
end
if redis.call('zcard', 'class:rooms') >= tonumber(most) or redis.call('exists', KEYS[1]) == 1 then return 0 end
forget(code)
redis.call('hset', KEYS[1], unpack(ARGV, 7))
redis.call('set', 'class:led:' .. code, '1', 'PX', life)
lives(code, tonumber(alone), now)
return 1
"""
KEEP = """
local code, now, life, alone, news = unpack(ARGV, 1, 5)
if redis.call('exists', KEYS[1]) == 0 then return 0 end
if #ARGV > 5 then redis.call('hset', KEYS[1], unpack(ARGV, 6)) end
redis.call('set', 'class:led:' .. code, '1', 'PX', life)
lives(code, tonumber(alone), now)
if news ~= '' then redis.call('publish', 'class', news) end
return 1
"""
END = "forget(ARGV[1])"
VOTE = """
local voter, answer, most, question, size = unpack(ARGV, 1, 5)
if redis.call('exists', KEYS[1]) == 0 then return 0 end
local before = redis.call('hstrlen', KEYS[2], voter)
if before == 0 and redis.call('hlen', KEYS[2]) >= tonumber(most) then return 0 end
local more = #answer - before
if tonumber(redis.call('get', KEYS[4]) or 0) + more > tonumber(size) then return -1 end
redis.call('hset', KEYS[2], voter, answer)
redis.call('zadd', KEYS[3], 'NX', redis.call('zcard', KEYS[3]), question)
redis.call('incrby', KEYS[4], more)
for i = 2, 4 do redis.call('pexpire', KEYS[i], redis.call('pttl', KEYS[1])) end
return 1
"""
UNVOTE = """
redis.call('decrby', KEYS[2], redis.call('hstrlen', KEYS[1], ARGV[1]))
redis.call('hdel', KEYS[1], ARGV[1])
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
        self, url: str, life: float = LIFE, rooms: int = MOST_ROOMS, alone: float = ALONE, size: int = MOST_BYTES
    ) -> None:
        self._life, self._alone = int(1000 * life), int(1000 * min(alone, life))
        self._most, self._size = rooms, size
        self._redis = _client(url, retries=1)  # on a new connection, where the store has come back
        # What was published while this one was lost has to be looked up: so that is an error at once.
        self._listener = _client(url, retries=0)
        self._open, self._keep, self._present, self._end = (
            self._redis.register_script(OF_A_ROOM_KEYS + script) for script in (OPEN, KEEP, PRESENT, END)
        )
        self._vote = self._redis.register_script(VOTE)
        self._unvote = self._redis.register_script(UNVOTE)

    async def open(self, code: str, parts: Parts) -> bool:
        given: list[Any] = [code, time(), self._most, self._life, self._alone, QUIET, *_flat(parts)]
        async with _asked():
            return bool(await self._open([_key("room", code)], given))

    async def parts(self, code: str) -> Parts:
        async with _asked():
            return _named(await self._redis.hgetall(_key("room", code)))

    async def keep(self, code: str, parts: Parts) -> bool:
        news = _published(code, parts) if parts else b""
        async with _asked():
            given = [code, time(), self._life, self._alone, news, *_flat(parts)]
            return bool(await self._keep([_key("room", code)], given))

    async def tell(self, code: str, parts: Parts) -> None:
        async with _asked():
            await self._redis.publish(CHANNEL, _published(code, parts))

    async def end(self, code: str) -> None:
        async with _asked():
            await self._end([], [code])
        await self.tell(code, {})

    async def rooms(self) -> int:
        async with _asked():
            return int(await self._redis.zcount("class:rooms", time(), "+inf"))

    async def vote(self, code: str, question: str, voter: str, answer: bytes, most: int = MOST_VOTES) -> bool:
        keys = [_key("room", code), _key("votes", code, question), _key("questions", code), _key("size", code)]
        async with _asked():
            found = int(await self._vote(keys, [voter, answer, most, question, self._size]))
        if found < 0:
            raise FullError(OF_A_ROOM)
        return bool(found)

    async def unvote(self, code: str, question: str, voter: str) -> None:
        async with _asked():
            await self._unvote([_key("votes", code, question), _key("size", code)], [voter])

    async def votes(self, code: str, question: str) -> Parts:
        async with _asked():
            found = self._redis.hscan_iter(_key("votes", code, question), count=SLICE)
            return {voter.decode(): answer async for voter, answer in found}

    async def questions(self, code: str) -> list[str]:
        async with _asked():
            names: Any = await self._redis.zrange(_key("questions", code), 0, -1)
            return [name.decode() for name in names]

    async def present(self, code: str, replica: str, names: Collection[str]) -> int:
        now = time()
        async with _asked():
            given: list[Any] = [code, now, self._alone, replica, _named_now(names), int(bool(names))]
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
        key = f"class:count:{name}:{int(time() // seconds)}"
        async with _asked():
            if not more:  # which is read of a full store too
                return int(await self._redis.get(key) or 0)
            pipe = self._redis.pipeline()
            pipe.incrby(key, more)
            pipe.pexpire(key, int(1000 * seconds))
            return int((await pipe.execute())[0])

    async def lend(self, name: str, value: bytes, seconds: float) -> None:
        async with _asked():
            await self._redis.set(f"class:lent:{name}", value, px=int(1000 * seconds))

    async def take(self, name: str) -> bytes:
        async with _asked():
            value: Any = await self._redis.getdel(f"class:lent:{name}")
            return value or b""

    async def time(self) -> float:
        begun = time()
        async with _asked():
            seconds, micros = await self._redis.time()
        return float(seconds + micros / 1e6 + (time() - begun) / 2)

    async def listen(self, hear: Hear, ready: Callable[[], None]) -> None:
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
                    hear(code, parts)

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
        raise AwayError("The store that replicas share does not answer.") from error
    except OutOfMemoryError as error:
        raise FullError(OF_THE_STORE) from error
    except RedisError as error:  # while it starts: it may answer later
        raise AwayError(f"The store that replicas share refuses: {error}.") from error


def _key(*names: str) -> str:
    """The name of a value in the store: class:room:CODE."""
    return ":".join(("class", *names))


def _flat(parts: Parts) -> list[Any]:
    return [each for item in parts.items() for each in item]


def _named(fields: Any) -> dict[str, bytes]:
    return {name.decode(): value for name, value in fields.items()}


def _named_now(names: Collection[str]) -> bytes:
    """Names that a replica tells, and until when that holds."""
    return msgspec.msgpack.encode((time() + SEEN, list(names)))


def _still_named(told: Any) -> set[str]:
    """All names that any replica has told of late."""
    known = [msgspec.msgpack.decode(each, type=tuple[float, list[str]]) for each in told]
    return {name for until, names in known if until > time() for name in names}


def _published(code: str, parts: Parts) -> bytes:
    return msgspec.msgpack.encode((code, dict(parts)))
