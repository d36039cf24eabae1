"""All messages of a live class by route, and a client that sends any of them any number of times."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from components.live_class.codes import SIGNS, Keys, code_of, join_key
from tests.live_class.caller import Answered, Class, Remote, Stream, called
from tests.live_class.served import CHOICE

SKETCH = {"walk": "d34", "step": "d34-14", "curves": {"Xp1": [500] * 101}}
NUMBER = {"walk": "d31", "step": "d31-02"}
STEPS = [{"walk": "d31", "step": f"d31-{i:02}"} for i in (2, 3)] + [{"walk": "d34", "step": "d34-14"}]
MINE = 'title = "{}"\n[[step]]\nid = "one"\nfrom = "d31-03"\n'


class Sent(NamedTuple):
    """A message: whose word it has, its body, and its query; the number makes each one different."""

    word: str = ""
    body: Callable[[int], Any] | None = None
    query: Callable[[int], str] = lambda n: ""


def order(type: str, **fields: Callable[[int], Any]) -> Sent:
    return Sent("key", lambda n: {"type": type, **{name: of(n) for name, of in fields.items()}})


def answers(n: int) -> dict[str, Any]:
    return {f"{60 * n + i:011x}abcdefgh": {**SKETCH, "vote": n % 9 + 1} for i in range(60)}


MESSAGES = {
    "POST /class": Sent(),
    "GET /class/time": Sent(),
    "GET /class/CODE/lead": Sent("key"),
    "PUT /class/CODE/lead": Sent("new key", lambda n: {}),
    "POST /class/CODE/lead clock": order("clock", t=float, rate=float, end=float, at=float),
    "POST /class/CODE/lead put": Sent("key", lambda n: {"type": "put", **STEPS[n % 3], "vote": n % 9}),
    "POST /class/CODE/lead walk": order(
        "walk", name=lambda n: f"mine-{n}", text=lambda n: MINE.format("x" * 90) + f"# {n}".ljust(20_000, "x")
    ),
    "POST /class/CODE/lead show": order("show"),
    "POST /class/CODE/lead close": order("close"),
    "POST /class/CODE/lead sure": order("sure"),
    "POST /class/CODE/lead countdown": order("countdown", seconds=int, closes=lambda n: n % 2 == 0),
    "POST /class/CODE/lead moderate": order("moderate", text=str, shows=lambda n: n % 2 == 0),
    "POST /class/CODE/lead withdraw": order("withdraw"),
    "POST /class/CODE/lead screen": order("screen", next=lambda n: f"{n}".ljust(60, "x")),
    "POST /class/CODE/lead restore": order("restore", answers=answers),
    "GET /class/CODE/tally": Sent("key"),
    "GET /class/CODE/answers": Sent("key", query=lambda n: f"?question=d34/d34-14/{n % 9 + 1}"),
    "GET /class/CODE/answers of none": Sent("key", query=lambda n: f"?question=d34/none-{n}/1"),
    "GET /class/CODE/answers.csv": Sent("key"),
    "GET /class/CODE/summary": Sent("key"),
    "GET /class/CODE/stored": Sent("key"),
    "POST /class/CODE/word": Sent("key", lambda n: {"query": f"{n}".ljust(4000, "x")}),
    "PUT /class/CODE/word": Sent("", lambda n: {"word": f"{n}"}),
    "PUT /class/CODE/word of none": Sent("none", lambda n: {"word": ""}),
    "POST /class/CODE/tickets": Sent("key"),
    "PUT /class/CODE/tickets": Sent("key", lambda n: {"digits": f"{n % 90 + 10}"}),
    "DELETE /class/CODE/tickets": Sent("key", lambda n: {"digits": f"{n % 90 + 10}"}),
    "PUT /class/CODE/remote": Sent("ticket", lambda n: {"address": "x"}),
    "GET /class/CODE/remote": Sent("remote"),
    "POST /class/CODE/remote": Sent("remote", lambda n: {"deed": "next"}),
    "GET /class/CODE/steps": Sent("remote"),
    "POST /class/CODE/token": Sent("join"),
    "POST /class/CODE/token of none": Sent("none"),
    "GET /class/CODE/events": Sent("phone"),
    "GET /class/CODE/events of the leader": Sent("key"),
    "GET /class/CODE/now": Sent("phone"),
    "GET /class/CODE/now of none": Sent("none"),
    "PUT /class/CODE/answer": Sent("phone", lambda n: {**CHOICE, "option": n % 3}),
    "POST /class/CODE/answer": Sent("phone", lambda n: {**CHOICE, "option": n % 3}),
    "GET /CODE": Sent("none"),
    "HEAD /CODE": Sent("none"),
    "GET /CODE-WORD": Sent("none"),
    "HEAD /CODE-WORD": Sent("none"),
    "POST /class/CODE/lead end": order("end"),
}
"""Messages by method and route, with whatever distinguishes several of one route. An order has its type in the name."""


class Client(Class):
    """A class whose instructor sends any message. `words` has the words of members; without it each message of a phone
    has a new one.
    """

    words: Mapping[str, str] = {}

    async def send(self, name: str, n: int = 0, **other: Any) -> Answered | None:
        """Send a message, or one with another code, word, body, method or headers."""
        method, route, *_ = name.split(" ")
        kind, body, query = MESSAGES[name]
        own = {"code": self.code, "body": body(n) if body else None, "method": method}
        own |= {"word": self.words.get(kind, "")} if self.words else await self._new(kind, n)
        sent = {**own, **self.headers, **other}
        code = sent.pop("code")
        if route.endswith("events") and not self.words:
            await (await Stream(self.url, code, sent["word"]).open()).close()
            return None
        return await called(self.url, route.replace("CODE", code).replace("WORD", "ABCDEFGH") + query(n), **sent)

    async def _new(self, kind: str, n: int) -> dict[str, Any]:
        """Return a word of a kind, with the code or the body that belongs to it."""
        match kind:
            case "new key":
                word = Keys().new()
                return {"word": word, "code": code_of(word)}
            case "none":  # almost certainly the code of no class; each number gives another
                return {"word": f"{n}.x", "code": "".join(SIGNS[n // 30**i % 30] for i in range(4))}
            case "phone":  # enters by the QR code and asks for news
                token = (await self.ask("token", "POST", word=join_key(self.key))).json["token"]
                await self.ask("now", word=token)
                return {"word": token}
            case "ticket":
                return {"word": "", "body": {"address": await Remote.secret(self)}}
            case "remote":  # replaces the last one; some are refused, because too many wait
                remote = await Remote.wait(self)
                return {"word": remote.key if remote and (await remote.decide()).status == 200 else ""}
        return {"word": {"key": self.key, "join": join_key(self.key)}.get(kind, "")}
