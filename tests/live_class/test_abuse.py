"""Every message of a class, sent by anybody, wrong or too often: a sentence, and bounds for what is stored."""

import asyncio
import gc
import sys
from collections import Counter
from collections.abc import Awaitable, Callable
from functools import partial
from itertools import pairwise
from types import CoroutineType, FrameType, FunctionType, ModuleType
from typing import Any, get_args

import pytest
from tornado.web import RequestHandler

from components.language.class_messages import YEAR_2100, Order
from components.live_class import follower_routes, instructor_routes, lead_routes, registry, remotes, room
from components.live_class.codes import join_key
from components.live_class.routes import CODE, LiveClass
from components.live_class.store import MemoryStore
from components.serving.visitors import Rate
from tests.grids import WHOLE
from tests.live_class.caller import CHOICE, MESSAGES, SKETCH, Answered, Class, Remote
from tests.live_class.served import BANK, Valkey, contents, made, served, set_limits, taught

METHODS = ("get", "head", "post", "put", "delete", "patch", "options")
NAMES = {" ".join(name.split(" ")[:2]): name for name in reversed(MESSAGES)}
"""The first message of each route."""
ROUTES = [route for route in NAMES if "/class" in route]
OF_A_CODE = [route for route in ROUTES if "CODE" in route]
OF_A_MEMBER = [route for route in OF_A_CODE if MESSAGES[NAMES[route]].word in ("key", "phone", "remote")]
WITH_BODY = [route for route in ROUTES if MESSAGES[NAMES[route]].body]
LIMITED = [route for route in ROUTES if route not in ("GET /class/time", "PUT /class/CODE/remote")]


def test_the_table_has_each_route_and_order_of_the_product() -> None:
    orders = {order.__struct_config__.tag for order in get_args(Order)}
    assert orders == {name.split(" ")[2] for name in MESSAGES if name.startswith("POST /class/CODE/lead")}
    plain = {"/CODE(/?)": "/CODE", "/CODE-([0-9A-Za-z]{8})": "/CODE-WORD"}
    of = [(route.replace(CODE, "CODE"), handler) for route, handler, *_ in LiveClass(MemoryStore(), BANK).routes()]
    assert set(NAMES) == {
        f"{method.upper()} {plain.get(route, route)}"
        for route, handler in of
        for method in METHODS
        if getattr(handler, method) is not getattr(RequestHandler, method)
    }


Act = Callable[[Class, str], Awaitable[list[Answered | None]]]


def sending(**given: Any) -> Act:
    return lambda on, route: asyncio.gather(on.send(NAMES[route], **given))


async def no_word(on: Class, route: str) -> list[Answered | None]:
    """The answers are the same for a code of no class, so nobody learns which codes are taken."""
    codes, answers = (on.code, "2222" if on.code != "2222" else "3333"), list[Answered | None]()
    for word in ("", "x" * 32, "made.up", on.words["another key"], on.words["another phone"]):
        there, nowhere = [await on.send(NAMES[route], code=code, word=word) for code in codes]
        assert there and nowhere and there[:2] == nowhere[:2]
        answers += [there, nowhere]
    return answers


async def other_member(on: Class, route: str) -> list[Answered | None]:
    """No member of a class can do what another may, but all can follow."""
    own = MESSAGES[NAMES[route]].word
    others = {"key": ("phone", "remote"), "phone": (), "remote": ("key", "phone")}[own]
    return [await on.send(NAMES[route], word=on.words[other]) for other in others]


async def too_many(on: Class, route: str) -> list[Answered | None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Rate, "admit", lambda *_: 1.0)
        for module in (follower_routes, lead_routes):
            patch.setattr(module, "MISSES", 1)
        await on.send("PUT /class/CODE/word")  # a wrong guess
        refused = await on.send(NAMES[route], **({"word": ""} if route == "POST /class/CODE/token" else {}))
    assert refused and float(refused.headers["Retry-After"]) >= 1
    return [refused]


async def no_place(on: Class, route: str) -> list[Answered | None]:
    """The instructor needs no place."""
    answers = []
    for limit in ("MOST_FOLLOWERS", "ALL_FOLLOWERS"):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(follower_routes, limit, 1)
            answers.append(await on.send(NAMES[route], word=on.words["new phone"]))
            assert (await on.ask("now")).status == 200
    return answers


NOT_YOURS = {403, 404, 409}
NO_MESSAGES: list[Any] = [b"", [], {"type": 5}, b'{"type": "\xff"}', b"[" * 5000]
ABUSES: dict[str, tuple[Act, list[str], set[int]]] = {
    "another site": (sending(Origin="https://elsewhere.example"), ROUTES, {403}),
    "another host": (sending(Host="elsewhere.example"), ROUTES, {403}),
    "another method": (sending(method="PATCH"), ROUTES, {405}),
    "no word": (no_word, [one for one in OF_A_CODE if one != "POST /class/CODE/token"], NOT_YOURS),
    "the word of another member": (other_member, OF_A_MEMBER, NOT_YOURS),
    "a closed class": (sending(), OF_A_CODE, NOT_YOURS | {410}),
    "too large": (sending(body={"type": "x" * 64_000}), WITH_BODY, {413}),
    **{f"the body {body!s:.12}": (sending(body=body), WITH_BODY, {400}) for body in NO_MESSAGES},
    "too many": (too_many, LIMITED, {429}),
    "no place": (no_place, ["GET /class/CODE/events", "GET /class/CODE/now"], {503}),
}
"""How each abuse is sent, its routes, and the allowed statuses of the answers."""

ALONE = ("no word", "a closed class", "too many", "no place")


@pytest.mark.parametrize("alone", ["none", *ALONE])
async def test_every_route_answers_an_abuse_in_a_sentence(alone: str, subtests: pytest.Subtests) -> None:
    async with taught() as (server, url, lesson):
        other = await Class.open(url)
        for one in (lesson, other):
            await one.order("put", **CHOICE)
        key, token, kept = lesson.key, await other.token(), server.classes.registry.store
        words = {"key": key, "new key": key, "join": join_key(key), "remote": (await Remote.pair(lesson)).key}
        words |= {"phone": await lesson.token(), "another key": other.key, "another phone": token}
        words["new phone"] = (await lesson.ask("token", "POST", word="")).json["token"]
        attacker = Class(url, lesson.opened)
        attacker.words = words
        if alone == "a closed class":
            await lesson.order("end")
        server.classes.rate.most = 30 if alone == "no word" else 1e6
        codes = lesson.code, other.code
        before = [*[await contents(kept, code) for code in codes], await kept.rooms()]
        for abuse in [alone] if alone in ABUSES else [name for name in ABUSES if name not in ALONE]:
            act, routes, statuses = ABUSES[abuse]
            for route in routes:
                with subtests.test(f"{abuse}: {route}"):
                    for answer in await act(attacker, route):
                        assert answer and answer.status in statuses and answer.json["sentence"].endswith(".")
        assert [*[await contents(kept, code) for code in codes], await kept.rooms()] == before
        if alone == "no word":  # strangers do not use up the limit of the instructor
            assert (await lesson.ask("lead")).status == 200
        await other.voted(token, **CHOICE, option=2)
        assert (await other.tally())["now"]["options"] == [0, 0, 1]


NAME, GOOD = "0" * 11 + "abcdefgh", {**CHOICE, "option": 1}
LEAD, ANSWER = "POST /class/CODE/lead", "PUT /class/CODE/answer"


def sketch(**curves: list[float]) -> dict[str, Any]:
    return {**SKETCH, "curves": curves}


def restored(**fields: Any) -> dict[str, Any]:
    return {"type": "restore", "answers": {NAME: {**GOOD, **fields}}}


REFUSED: list[tuple[str, Any, int]] = [
    *((LEAD, {"type": "countdown", "seconds": wrong}, 400) for wrong in (601, -1, 1e9, "30", None)),
    *((LEAD, {"type": "screen", **wrong}, 400) for wrong in ({"next": "x" * 61}, {"deeds": ["fly"]}, {"next": 1})),
    (LEAD, {"type": "put", "walk": "mine", "step": "one"}, 409),
    (LEAD, {"type": "put", **CHOICE, "vote": 10}, 400),
    (LEAD, {"type": "walk", "name": "mine", "text": 'title = "t"\n[[step]]\nid = "one"\nfrom = "d31-99"\n'}, 409),
    (LEAD, {"type": "walk", "name": "mine", "text": "x" * 48_001}, 400),
    (LEAD, {"type": "moderate", "text": "x" * 81, "shows": True}, 400),
    *((LEAD, restored(at=at), 400) for at in (1e300, -1, YEAR_2100 + 1)),
    *((LEAD, restored(**wrong), 400) for wrong in ({"here": 10**30}, {"option": 10}, {"who": "me"}, {"vote": 10})),
    *((LEAD, restored(**wrong), 400) for wrong in ({"text": "x" * 81}, {"curves": {"x": [0] * 102}})),
    (LEAD, restored(walk="none"), 409),
    *((LEAD, {"type": "restore", "answers": wrong}, 400) for wrong in ({"me": GOOD}, {f"{NAME}x": GOOD}, {NAME: []})),
    *(("PUT /class/CODE/lead", wrong, 400) for wrong in ({"control": "x"}, {"control": "a" * 65}, {"key": "x"})),
    *((ANSWER, {**CHOICE, "option": 0, "sure": wrong}, 400) for wrong in (4, -1, "certain", 10**40)),
    *((ANSWER, {**CHOICE, **wrong}, 409) for wrong in ({}, {"option": 7}, {"sure": 2}, {"option": 0, "vote": 2})),
    *((ANSWER, {**CHOICE, "text": text}, status) for text, status in (("x" * 81, 400), ("x" * 10_000, 413))),
    *((ANSWER, sketch(Xp1=wrong), 400) for wrong in ([500] * 102, [1101] * 101)),
    (ANSWER, sketch(Xp1=[5] * 100), 409),
    (ANSWER, sketch(a=[5] * 101, b=[5] * 101, c=[5] * 101), 400),
    (ANSWER, sketch(Xp1=[1e3] * 101, Xp2=[-1e-7] * 101), 400),
    (ANSWER, sketch(Xp1=[500] * 5000), 413),
    ("PUT /class/CODE/word", {"word": "x" * 21}, 400),
    ("POST /class/CODE/word", {"query": "x" * 4001}, 400),
    ("PUT /class/CODE/tickets", {"digits": "100"}, 400),
    ("POST /class/CODE/remote", {"deed": "fly"}, 400),
]


async def test_what_is_no_message_of_a_page_is_refused_and_nothing_is_stored(subtests: pytest.Subtests) -> None:
    async with taught() as (server, url, lesson):
        client = Class(url, lesson.opened)
        client.words = {"remote": (await Remote.pair(lesson)).key, "key": lesson.key, "phone": await lesson.token()}
        stored = partial(contents, server.classes.registry.store, lesson.code)
        for route, body, status in REFUSED:
            await lesson.order("put", **(SKETCH if body.get("walk") == "d34" else CHOICE))
            before = await stored()
            with subtests.test(f"{route} {str(body)[:60]}"):
                answer = await client.send(NAMES[route], body=body)
                assert answer and answer.status == status and answer.json["sentence"].endswith(".")
                assert await stored() == before


NO_DATA = (type, ModuleType, FunctionType, FrameType, CoroutineType, asyncio.Task, asyncio.AbstractEventLoop)
OFTEN_REFUSED = {
    "POST /class/CODE/answer",
    "PUT /class/CODE/word", "PUT /class/CODE/word of none", "PUT /class/CODE/tickets", "DELETE /class/CODE/tickets",
    "POST /class/CODE/token of none", "GET /class/CODE/now of none",
}  # fmt: skip
"""Guesses and messages of strangers."""
ROUND = 18 if WHOLE else 9
"""Messages of a kind that are sent before the bytes are first counted, and between two counts."""
STEADY = 2000
"""Bytes that a round may add although nothing is stored per message: filling caches and growing lists."""


def bytes_of(root: object) -> int:
    """Return the bytes of all objects reachable from one."""
    seen, todo, total = set[int](), [root], 0
    while todo:
        one = todo.pop()
        if id(one) not in seen and not isinstance(one, NO_DATA):
            seen.add(id(one))
            total += sys.getsizeof(one)
            todo += gc.get_referents(one)
    return total


@pytest.mark.parametrize("kind", ["memory", pytest.param("valkey", marks=pytest.mark.slow)])
async def test_many_messages_leave_no_more_than_some(
    kind: str, valkey: Valkey, subtests: pytest.Subtests, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After some messages a small limit is reached: twice or three times as many add nothing."""
    set_limits(monkeypatch, 300_000, 50_000)
    monkeypatch.setattr(follower_routes, "MOST_FOLLOWERS", 4)
    monkeypatch.setattr(registry, "SPARE", 2)
    monkeypatch.setattr(instructor_routes, "MOST_OPENED", 4)
    monkeypatch.setattr(room, "KEPT", 4)
    monkeypatch.setattr(remotes, "DIGITS", range(10, 14))
    async with (
        made(valkey.url if kind == "valkey" else "") as kept,
        served(kept, trusted_proxies=("127.0.0.1",)) as (server, url),
    ):
        rooms = server.classes.registry
        for i, name in enumerate(MESSAGES):
            code, key = await rooms.open()
            sender = Class(url, {"code": code, "key": key}, f"198.51.{i}.1")
            await sender.order("put", **CHOICE)
            sizes, statuses = list[int](), Counter[int]()
            for turn in range(3):
                for number in range(turn * ROUND, (turn + 1) * ROUND):
                    answer = await sender.send(name, number)
                    statuses[answer.status if answer else 0] += 1
                sizes.append(bytes_of(rooms) + (valkey.bytes() if kind == "valkey" else 0))
            with subtests.test(name):
                assert min(statuses) < 400 or name in OFTEN_REFUSED
                assert min(more - some for some, more in pairwise(sizes)) < STEADY
            await sender.order("end")
