"""Rooms in Valkey or Redis, which several replicas share: each is a hash with an end, and all that is new is published.

What must not happen twice or in halves is a script, which the store runs as one.
"""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from time import time
from typing import Any

import msgspec
from redis.asyncio import Redis
from redis.asyncio.retry import Retry
from redis.backoff import NoBackoff
from redis.exceptions import ConnectionError, RedisError, TimeoutError

from components.rooms.store import LIFE, MOST_ROOMS, MOST_VOTES, SEEN, AwayError, Hear, Parts, Store

CHANNEL = "class"
"""On which all that is new of all rooms is published."""
PATIENCE = 2.0
"""Seconds for an answer."""
PULSE = 5.0
"""Seconds of silence after which a connection that only listens is asked whether it is there, and for its answer."""

OPEN = """
redis.call('zremrangebyscore', 'class:rooms', '-inf', ARGV[1])
if redis.call('zcard', 'class:rooms') >= tonumber(ARGV[3]) or redis.call('exists', KEYS[1]) == 1 then return 0 end
redis.call('hset', KEYS[1], unpack(ARGV, 5))
redis.call('pexpire', KEYS[1], ARGV[4])
redis.call('zadd', 'class:rooms', ARGV[2], KEYS[1])
return 1
"""
KEEP = """
if redis.call('exists', KEYS[1]) == 0 then return 0 end
if #ARGV > 3 then redis.call('hset', KEYS[1], unpack(ARGV, 4)) end
redis.call('pexpire', KEYS[1], ARGV[1])
redis.call('zadd', 'class:rooms', ARGV[2], KEYS[1])
if ARGV[3] ~= '' then redis.call('publish', 'class', ARGV[3]) end
return 1
"""
VOTE = """
if redis.call('exists', KEYS[1]) == 0 then return 0 end
local known = redis.call('hexists', KEYS[2], ARGV[1]) == 1
if not known and redis.call('hlen', KEYS[2]) >= tonumber(ARGV[3]) then return 0 end
redis.call('hset', KEYS[2], ARGV[1], ARGV[2])
redis.call('pexpire', KEYS[2], ARGV[4])
redis.call('zadd', KEYS[3], 'NX', redis.call('zcard', KEYS[3]), ARGV[5])
redis.call('pexpire', KEYS[3], ARGV[4])
return 1
"""


class SharedStore(Store):
    """For any number of replicas; `url` as redis://host:6379/0."""

    def __init__(self, url: str, life: float = LIFE, rooms: int = MOST_ROOMS) -> None:
        self._life = int(1000 * life)
        self._most = rooms
        self._redis = _client(url, retries=1)  # on a new connection, where the store has come back
        # What was published while this one was lost has to be looked up: so that is an error at once.
        self._listener = _client(url, retries=0)
        self._open = self._redis.register_script(OPEN)
        self._keep = self._redis.register_script(KEEP)
        self._vote = self._redis.register_script(VOTE)

    async def open(self, code: str, parts: Parts) -> bool:
        end, now = time() + self._life / 1000, time()
        async with _asked():
            return bool(await self._open([_room(code)], [now, end, self._most, self._life, *_flat(parts)]))

    async def parts(self, code: str) -> Parts:
        async with _asked():
            return _named(await self._redis.hgetall(_room(code)))

    async def keep(self, code: str, parts: Parts) -> bool:
        end, news = time() + self._life / 1000, _published(code, parts) if parts else b""
        async with _asked():
            return bool(await self._keep([_room(code)], [self._life, end, news, *_flat(parts)]))

    async def tell(self, code: str, parts: Parts) -> None:
        async with _asked():
            await self._redis.publish(CHANNEL, _published(code, parts))

    async def end(self, code: str) -> None:
        async with _asked():
            questions = [_question(code, question) for question in await self.questions(code)]
            await self._redis.delete(_room(code), _here(code), _questions(code), *questions)
            await self._redis.zrem("class:rooms", _room(code))
        await self.tell(code, {})

    async def vote(self, code: str, question: str, voter: str, answer: bytes) -> bool:
        keys = [_room(code), _question(code, question), _questions(code)]
        async with _asked():
            return bool(await self._vote(keys, [voter, answer, MOST_VOTES, self._life, question]))

    async def votes(self, code: str, question: str) -> Parts:
        async with _asked():
            return _named(await self._redis.hgetall(_question(code, question)))

    async def questions(self, code: str) -> list[str]:
        async with _asked():
            names: Any = await self._redis.zrange(_questions(code), 0, -1)
            return [name.decode() for name in names]

    async def present(self, code: str, replica: str, count: int) -> int:
        now = time()
        async with _asked():
            pipe = self._redis.pipeline()
            pipe.hset(_here(code), replica, f"{count} {now + SEEN}")
            pipe.pexpire(_here(code), int(2000 * SEEN))
            pipe.hvals(_here(code))
            told = [each.split() for each in (await pipe.execute())[-1]]
        return sum(int(number) for number, until in told if float(until) > now)

    async def count(self, name: str, seconds: float, more: int = 1) -> int:
        key = f"class:count:{name}:{int(time() // seconds)}"
        async with _asked():
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
    except RedisError as error:  # while it starts, or where it is full: it may answer later
        raise AwayError(f"The store that replicas share refuses: {error}.") from error


def _room(code: str) -> str:
    return f"class:room:{code}"


def _here(code: str) -> str:
    return f"class:here:{code}"


def _questions(code: str) -> str:
    return f"class:questions:{code}"


def _question(code: str, question: str) -> str:
    return f"class:votes:{code}:{question}"


def _flat(parts: Parts) -> list[Any]:
    return [each for item in parts.items() for each in item]


def _named(fields: Any) -> dict[str, bytes]:
    return {name.decode(): value for name, value in fields.items()}


def _published(code: str, parts: Parts) -> bytes:
    return msgspec.msgpack.encode((code, dict(parts)))
