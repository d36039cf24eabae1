"""All messages that an anonymous visitor can send to a live class: one that it has opened, or another."""

from __future__ import annotations

from collections.abc import Awaitable, Callable

from components.live_class.codes import Keys, code_of, join_key
from tests.live_class.caller import Answered, Class, Stream, called
from tests.live_class.served import CHOICE

SKETCH = {"walk": "d34", "step": "d34-14", "curves": {"Xp1": [500] * 101}}
NUMBER = {"walk": "d31", "step": "d31-02"}
STEPS = [{"walk": "d31", "step": f"d31-{i:02}"} for i in (2, 3)] + [{"walk": "d34", "step": "d34-14"}]
SIGNS = "23456789ABCDEFGHJKMNPRSTUVWXYZ"
MINE = 'title = "{}"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'


def code(number: int) -> str:
    """A code that almost certainly belongs to no class; each number gives another."""
    return "".join(SIGNS[number // 30**i % 30] for i in range(4))


class Client:
    """A client that leads a class and sends any message any number of times."""

    def __init__(self, url: str, lesson: Class, address: str) -> None:
        self.url = url
        self.lesson = lesson
        self.address = address

    async def ask(self, path: str, method: str = "GET", body: object = None, word: str = "") -> Answered:
        return await called(self.url, path, method, body, word, X_Forwarded_For=self.address)

    async def lead(self, path: str, method: str = "GET", body: object = None) -> Answered:
        return await self.ask(f"/class/{self.lesson.code}/{path}", method, body, self.lesson.key)

    async def enter(self) -> Answered:
        """Join with a new phone by the QR code."""
        return await self.ask(f"/class/{self.lesson.code}/token", "POST", word=join_key(self.lesson.key))

    async def phone(self) -> str:
        """Return the token of a new phone."""
        token: str = (await self.enter()).json["token"]
        return token

    async def follow(self, path: str, method: str = "GET", body: object = None) -> Answered:
        """Ask for news with a new phone, and then send something else."""
        token = await self.phone()
        await self.ask(f"/class/{self.lesson.code}/now", word=token)
        return await self.ask(f"/class/{self.lesson.code}/{path}", method, body, token)

    async def stream(self, word: str) -> None:
        """Open a stream and leave."""
        stream = await Stream(self.url, self.lesson.code, word).open()
        await stream.close()

    async def learn(self, answer: object) -> Answered:
        await self.lesson.order("show")
        return await self.follow("answer", "POST", answer)

    async def come_and_go(self) -> None:
        await self.stream(await self.phone())

    async def open_and_end(self) -> None:
        opened = await self.ask("/class", "POST")
        if opened.status == 200:
            await Class(self.url, opened.json).order("end")

    async def restore(self, number: int) -> Answered:
        names = [f"{60 * number + i:011x}abcdefgh" for i in range(60)]
        return await self.lesson.order("restore", answers={name: {**SKETCH, "vote": number % 9 + 1} for name in names})

    async def reopen(self) -> Answered:
        key = Keys().new()
        return await self.ask(f"/class/{code_of(key)}/lead", "PUT", {}, key)

    async def pair(self) -> Answered:
        """Take a ticket and wait to be admitted."""
        secret = (await self.lead("tickets", "POST")).json["address"].partition("remote=")[2]
        return await self.ask(f"/class/{self.lesson.code}/remote", "PUT", {"address": secret})

    async def control(self, path: str, method: str = "GET", body: object = None) -> Answered:
        """Admit a phone, which replaces the last one."""
        paired = (await self.pair()).json
        if "digits" not in paired:
            return await self.lead(path)
        await self.lead("tickets", "PUT", {"digits": paired["digits"]})
        return await self.ask(f"/class/{self.lesson.code}/{path}", method, body, paired["key"])


Send = Callable[[Client, int], Awaitable[Answered | None]]
CLOCK = {"t": 1.0, "rate": 1.0, "end": 20.0, "at": 0.0}
MESSAGES: dict[str, Send] = {
    "POST /class": lambda client, n: client.ask("/class", "POST"),
    "GET /class/time": lambda client, n: client.ask("/class/time"),
    "GET /class/CODE/lead": lambda client, n: client.lead("lead"),
    "PUT /class/CODE/lead": lambda client, n: client.reopen(),
    "POST /class/CODE/lead clock": lambda client, n: client.lesson.order("clock", **{**CLOCK, "t": float(n)}),
    "POST /class/CODE/lead put": lambda client, n: client.lesson.order("put", **STEPS[n % 3], vote=n % 9),
    "POST /class/CODE/lead walk": lambda client, n: client.lesson.order(
        "walk", name=f"mine-{n}", text=MINE.format("x" * 90) + f"# {n}".ljust(20_000, "x")
    ),
    "POST /class/CODE/lead show": lambda client, n: client.lesson.order("show"),
    "POST /class/CODE/lead close": lambda client, n: client.lesson.order("close"),
    "POST /class/CODE/lead sure": lambda client, n: client.lesson.order("sure"),
    "POST /class/CODE/lead countdown": lambda client, n: client.lesson.order("countdown", seconds=n, closes=n % 2 == 0),
    "POST /class/CODE/lead moderate": lambda client, n: client.lesson.order("moderate", text=f"{n}", shows=n % 2 == 0),
    "POST /class/CODE/lead withdraw": lambda client, n: client.lesson.order("withdraw"),
    "POST /class/CODE/lead screen": lambda client, n: client.lesson.order("screen", next=f"{n}".ljust(60, "x")),
    "POST /class/CODE/lead restore": lambda client, n: client.restore(n),
    "GET /class/CODE/tally": lambda client, n: client.lead("tally"),
    "GET /class/CODE/answers": lambda client, n: client.lead(f"answers?question=d34/d34-14/{n % 9 + 1}"),
    "GET /class/CODE/answers of none": lambda client, n: client.lead(f"answers?question=d34/none-{n}/1"),
    "GET /class/CODE/answers.csv": lambda client, n: client.lead("answers.csv"),
    "GET /class/CODE/summary": lambda client, n: client.lead("summary"),
    "GET /class/CODE/stored": lambda client, n: client.lead("stored"),
    "POST /class/CODE/word": lambda client, n: client.lead("word", "POST", {"query": f"{n}".ljust(4000, "x")}),
    "PUT /class/CODE/word": lambda client, n: client.lead("word", "PUT", {"word": f"{n}"}),
    "PUT /class/CODE/word of none": lambda client, n: client.ask(f"/class/{code(n)}/word", "PUT", {"word": ""}),
    "POST /class/CODE/tickets": lambda client, n: client.lead("tickets", "POST"),
    "PUT /class/CODE/tickets": lambda client, n: client.lead("tickets", "PUT", {"digits": f"{n % 90 + 10}"}),
    "DELETE /class/CODE/tickets": lambda client, n: client.lead("tickets", "DELETE", {"digits": f"{n % 90 + 10}"}),
    "PUT /class/CODE/remote": lambda client, n: client.pair(),
    "GET /class/CODE/remote": lambda client, n: client.follow("remote"),
    "POST /class/CODE/remote": lambda client, n: client.control("remote", "POST", {"deed": "next"}),
    "GET /class/CODE/steps": lambda client, n: client.control("steps"),
    "POST /class/CODE/token": lambda client, n: client.enter(),
    "POST /class/CODE/token of none": lambda client, n: client.ask(f"/class/{code(n)}/token", "POST"),
    "GET /class/CODE/now": lambda client, n: client.follow("now"),
    "GET /class/CODE/now of none": lambda client, n: client.ask(f"/class/{code(n)}/now", word=f"{n}.x"),
    "PUT /class/CODE/answer": lambda client, n: client.follow("answer", "PUT", {**CHOICE, "option": n % 3}),
    "POST /class/CODE/answer": lambda client, n: client.learn({**CHOICE, "option": n % 3}),
    "GET /CODE": lambda client, n: client.ask(f"/{code(n)}"),
    "HEAD /CODE": lambda client, n: client.ask(f"/{code(n)}", "HEAD"),
    "GET /CODE-WORD": lambda client, n: client.ask(f"/{code(n)}-ABCDEFGH"),
    "HEAD /CODE-WORD": lambda client, n: client.ask(f"/{code(n)}-ABCDEFGH", "HEAD"),
    "GET /class/CODE/events": lambda client, n: client.come_and_go(),
    "GET /class/CODE/events of the leader": lambda client, n: client.stream(client.lesson.key),
    "POST /class/CODE/lead end": lambda client, n: client.open_and_end(),
}
"""Messages by method and route, with whatever distinguishes several of one route; `n` makes each one different.

An order to a class has its type in the name.
"""
