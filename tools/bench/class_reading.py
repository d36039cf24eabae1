"""The time for which a class of many sketches holds the event loop: `python -m tools.bench.class_reading`.

For each request: the seconds until the answer, and the longest turn of the event loop meanwhile; for one client, then
for some at once of one network, then of as many networks.
"""

from __future__ import annotations

import asyncio
import gc
import logging
from time import monotonic, thread_time

from components.live_class.store import MemoryStore
from tests.live_class.caller import SKETCH, Class, called, drawn
from tests.live_class.served import READ, fill, served

AT_ONCE = 4


class BlockedTime:
    """The longest turn of the event loop, in CPU seconds of its thread."""

    def __init__(self) -> None:
        self.longest = 0.0

    async def look(self) -> None:
        while True:
            begun = thread_time()
            await asyncio.sleep(0)
            self.longest = max(self.longest, thread_time() - begun)


async def measured(lesson: Class, path: str, addresses: list[str]) -> tuple[float, float]:
    held, begun = BlockedTime(), monotonic()
    looking = asyncio.create_task(held.look())
    asked = f"/class/{lesson.code}/{path.format(**SKETCH)}"
    requests = [called(lesson.url, asked, word=lesson.key, X_Forwarded_For=address) for address in addresses]
    assert all(answer.status == 200 for answer in await asyncio.gather(*requests))
    looking.cancel()
    return monotonic() - begun, held.longest


async def main() -> None:
    logging.disable()
    kept = MemoryStore(size=2**30)
    async with served(kept, trusted_proxies=("127.0.0.1",)) as (_, url):
        lesson = await Class.open(url)
        await fill(lesson, kept, {**SKETCH, **drawn(500)})
        gc.collect()
        gc.freeze()  # as the server does at its start
        print("| request | clients | networks | s | longest turn, ms |\n|---|---|---|---|---|")
        for path in READ:
            for clients, networks in ((1, 1), (AT_ONCE, 1), (AT_ONCE, AT_ONCE)):
                addresses = [f"198.51.{i % networks}.1" for i in range(clients)]
                seconds, longest = await measured(lesson, path, addresses)
                print(f"| {path} | {clients} | {networks} | {seconds:.2f} | {1000 * longest:.0f} |")


if __name__ == "__main__":
    asyncio.run(main())
