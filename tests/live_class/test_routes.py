"""The live class over HTTP: who comes in, what is heard, what is refused."""

from __future__ import annotations

import asyncio
import base64
import io
from csv import DictReader
from datetime import UTC, datetime

import pytest

from components.live_class import follower_routes
from components.live_class.codes import join_key
from components.serving import worker_process
from components.serving.worker_process import ReadingProcess
from tests.live_class.caller import Class, Stream, called
from tests.live_class.listening import until
from tests.live_class.served import CHOICE, served, teaching
from tests.page.scripts import text_of
from tests.serving.visitor import Visitor


async def test_what_the_instructor_shows_reaches_followers_as_the_same_message() -> None:
    async with teaching() as (server, url):
        lesson = await Class.open(url)
        stream = await lesson.follow()
        assert "text/event-stream" in stream.headers and "X-Accel-Buffering: no" in stream.headers
        assert "no-store" in stream.headers
        visitor = await Visitor.arrive(url, "scene=coupled")
        await visitor.send({"type": "lead", "code": lesson.code, "key": lesson.key})
        first = await stream.until(lambda event: event.get("picture"))
        await visitor.send({"type": "set", "values": {"k2": 3.5}})
        told = await stream.until(lambda event: event.get("picture") and event != first)
        assert len(told["picture"]["data"]) < 5000
        text = text_of(
            {"sheet": told["picture"]["sheet"], "data": base64.b64decode(told["picture"]["data"])},
            await visitor.dictionary(told["picture"]["sheet"]),
        )
        assert b'"k2":3.5' in text and b'"answer":null' in text
        await visitor.send({"type": "set", "values": {"k2": -1.0}})  # refusals are not sent to the class
        late = await lesson.follow()
        whole = await late.until(lambda event: event.get("picture"))
        assert whole["picture"] == told["picture"]
        assert server.context.metrics.text().count(b"oscillations_followers 2.0") == 1
        assert len(server.lecture.get_sessions("/")) == 1
        for each in (stream, late):
            await each.close()
        await visitor.depart()


async def test_a_session_that_lacks_the_key_shows_nothing() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        stream = await lesson.follow()
        visitor = await Visitor.arrive(url, "scene=coupled")
        await visitor.send({"type": "lead", "code": lesson.code, "key": "x" * 32})
        await visitor.send({"type": "set", "values": {"k2": 3.5}})
        assert (await lesson.order("clock", t=1.0, rate=0.0, end=20.0, at=0.0)).status == 204
        await stream.until(lambda event: event.get("clock"))
        assert not any("picture" in event for _, event in stream.heard)
        wrong = Class(url, {**lesson.opened, "key": "x" * 32})
        assert (await wrong.order("end")).status == 404
        assert (await called(url, f"/class/{lesson.code}/tally", word=await lesson.token())).status == 404
        assert (await called(url, f"/class/{lesson.code}/lead", "POST", {"type": "end"})).status == 404
        await stream.close()
        await visitor.depart()


async def test_a_follower_answers_once_and_learns_what_is_said_of_it_when_it_is_shown() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        assert (await lesson.order("put", **CHOICE)).status == 204
        token = await lesson.token()
        assert (await lesson.vote(token, **CHOICE, option=1)).status == 204
        assert (await lesson.vote(token, **CHOICE, option=0)).status == 204
        now = (await lesson.tally())["now"]
        assert (now["answered"], now["options"]) == (1, [1, 0, 0])
        path = f"/class/{lesson.code}/answer"
        assert (await called(url, path, "POST", {**CHOICE, "option": 0}, token)).status == 409
        gone = await called(url, path, "POST", {**CHOICE, "step": "d31-02", "text": "2"}, token)
        assert gone.status == 204  # nothing is sent for another question, whether its answer is shown or not
        for wrong, status in (
            ({**CHOICE, "option": 7}, 409), ({**CHOICE, "option": 0, "who": "me"}, 400), ([], 400),
            ({**CHOICE, "option": 0, "vote": 2}, 409), ({**CHOICE, "text": "x" * 9000}, 413),
        ):  # fmt: skip
            answer = await called(url, path, "PUT", wrong, token)
            assert answer.status == status and answer.json["sentence"].endswith(".")
        assert (await called(url, path, "PUT", {**CHOICE, "option": 0}, "made.up")).status == 404
        await lesson.order("show")
        assert (await lesson.vote(token, **CHOICE, option=2)).status == 409
        taught = (await called(url, path, "POST", {**CHOICE, "option": 1}, token)).json
        assert taught["type"] == "taught" and taught["lesson"]["right"] is False
        csv = await called(url, f"/class/{lesson.code}/answers.csv", word=lesson.key)
        (row,) = DictReader(io.StringIO(csv.text))
        at = datetime.strptime(row.pop("time"), "%Y-%m-%dT%H:%M:%SZ").replace(tzinfo=UTC)
        assert abs((datetime.now(UTC) - at).total_seconds()) < 60
        assert row == {
            "phone": "1", "here": row["here"], "walk": "d31", "step": "d31-03", "vote": "1", "unit": "", "right": "yes",
            "sure": "",
            "question": "How long does one swing take?", "answer": "Just as long as it did before",
        }  # fmt: skip


async def test_a_follower_without_a_stream_polls_and_gets_all_news() -> None:
    async with teaching() as (server, url):
        lesson = await Class.open(url)
        token = await lesson.token()
        await lesson.order("put", **CHOICE)
        first = await called(url, f"/class/{lesson.code}/now", word=token)
        assert first.json["question"]["step"] == first.json["question"]["card"]["id"] == "d31-03"
        path = f"/class/{lesson.code}/now?after={first.json['number']}"
        assert (await called(url, path, word=token)).status == 204
        await lesson.order("withdraw")
        assert (await called(url, path, word=token)).json["question"]["step"] == ""
        assert server.classes.registry.followers == 1


async def test_an_instructor_without_a_stream_gets_private_news_one_by_one() -> None:
    async with teaching() as (server, url):
        lesson = await Class.open(url)
        await lesson.order("put", **CHOICE)
        path = f"/class/{lesson.code}/now?after="
        known = (await called(url, path, word=lesson.key)).json["number"]
        assert await lesson.vote(await lesson.token(), **CHOICE, option=1)
        room = server.classes.registry.rooms[lesson.code]
        for deed in ("next", "next"):
            room.deliver({"deed": f'"{deed}"'.encode()})
        heard = []
        while (answer := await called(url, path + known, word=lesson.key)).status == 200:
            known = answer.json["number"]
            heard.append((answer.json.get("answers", False), answer.json.get("deed", "")))
        assert heard == [(True, ""), (False, "next"), (False, "next")]
        late = await lesson.lead()
        await late.until(lambda event: event.get("question"))
        assert not any(event.get("deed") for _, event in late.heard)
        await late.close()
        other = await called(url, path + "x.9", word=lesson.key)
        assert other.status == 200 and "deed" not in other.json
        token = await lesson.token()
        assert "deed" not in (await called(url, path + f"{room.number[:-1]}0", word=token)).text


async def test_codes_cannot_be_guessed_and_a_class_that_mistypes_comes_in(monkeypatch: pytest.MonkeyPatch) -> None:
    hits = 10 * follower_routes.MISSES * 4 * 60 / 30**4
    assert hits < 1 and follower_routes.MISSES >= 300
    monkeypatch.setattr(follower_routes, "MISSES", 4)

    async with teaching(trusted_proxies=("127.0.0.1",)) as (_, url):
        lesson = await Class.open(url)

        async def enter(code: str, address: str) -> int:
            return (await called(url, f"/class/{code}/token", "POST", X_Forwarded_For=address)).status

        wrong = "2222" if lesson.code != "2222" else "3333"
        assert [await enter(wrong, f"198.51.100.{i}") for i in range(6)] == [404] * 4 + [429] * 2
        assert await enter(lesson.code, "198.51.100.9") == 429  # the correct code does not reveal that it is correct
        assert await enter(lesson.code.lower(), "203.0.113.9") == 200
        path, secret = f"/class/{lesson.code}/token", lesson.opened["address"].partition("join=")[2]
        for word, status in (
            (secret, 200),
            (lesson.key, 429),
            ("x" * 12, 429),
            ("", 429),
        ):  # a QR code does not count as a guess
            assert (await called(url, path, "POST", word=word, X_Forwarded_For="198.51.100.9")).status == status
        monkeypatch.setattr(follower_routes, "ALL_MISSES", 6)
        assert [await enter(wrong, f"192.0.{i}.1") for i in range(3)] == [404, 404, 429]
        assert await enter(lesson.code, "203.0.113.9") == 429


async def test_a_remote_control_is_let_in_once_by_the_digits_that_it_shows() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        leader = await lesson.lead()
        path, tickets, steps = (f"/class/{lesson.code}/{one}" for one in ("remote", "tickets", "steps"))
        ticket = (await called(url, tickets, "POST", word=lesson.key)).json
        assert ticket["square"].startswith("<svg")
        secret = ticket["address"].partition("remote=")[2]
        paired = (await called(url, path, "PUT", {"address": secret})).json
        assert (await called(url, path, "PUT", {"address": secret})).status == 403
        assert (await leader.until(lambda event: event.get("remotes")))["remotes"] == [paired["digits"]]
        late = await lesson.lead()  # the instructor's page learns it too after an outage or a reload
        assert (await late.until(lambda event: "remotes" in event))["remotes"] == [paired["digits"]]
        assert (await called(url, path, word=paired["key"])).json is None
        assert (await called(url, path, "POST", {"deed": "next"}, paired["key"])).status == 403
        other = "10" if paired["digits"] != "10" else "11"
        assert (await called(url, tickets, "PUT", {"digits": other}, lesson.key)).status == 409
        control = (await called(url, tickets, "PUT", {"digits": paired["digits"]}, lesson.key)).json["control"]
        handed = (await called(url, f"/class/{lesson.code}/word", "POST", {"query": ""}, lesson.key)).json["address"]
        word = {"word": handed.rpartition("-")[2]}
        assert (await called(url, f"/class/{lesson.code}/word", "PUT", word)).json["control"] == control
        assert (await called(url, path, word=paired["key"])).json["question"]["step"] == ""
        assert (await called(url, path, "POST", {"deed": "next"}, paired["key"])).status == 204
        await leader.until(lambda event: event.get("deed") == "next")
        assert (await called(url, steps, word=paired["key"])).json == []
        await lesson.order("put", walk="d34", step="d34-02")
        listed = (await called(url, steps, word=paired["key"])).json
        assert len(listed) == 21 and listed[0] == {"step": "d34-01", "title": "A spring feels only its own stretch"}
        assert listed[6]["title"].endswith('<span class="v">m</span><sub>2</sub>')
        there = {"deed": "go", "step": "d34-04"}
        assert (await called(url, path, "POST", there, paired["key"])).status == 204
        assert there.items() <= (await leader.until(lambda event: event.get("deed") == "go")).items()
        for word in ("", await lesson.token(), lesson.key):
            assert (await called(url, steps, word=word)).status == 403
        ticket = (await called(url, tickets, "POST", word=lesson.key)).json
        other = (await called(url, path, "PUT", {"address": ticket["address"].partition("remote=")[2]})).json
        assert (await called(url, tickets, "DELETE", {"digits": other["digits"]}, lesson.key)).status == 204
        refused = await called(url, path, word=other["key"])
        assert refused.status == 403 and refused.json["sentence"].startswith("The lecturer's screen has not")
        await asyncio.gather(leader.close(), late.close())


async def test_a_class_that_ends_says_so_and_the_end_of_a_server_lets_its_followers_go() -> None:
    streams: list[Stream] = []
    async with served() as (_, url):
        lesson, other = await Class.open(url), await Class.open(url)
        streams += [await lesson.follow(), await other.follow()]
        await lesson.order("end")
        await streams[0].until(lambda event: event.get("ended"))
        assert (await called(url, f"/class/{lesson.code}/token", "POST")).status == 404
        assert not streams[1].ended
    await until(lambda: all(stream.ended for stream in streams))
    for stream in streams:
        await stream.close()


async def test_the_page_of_a_follower_has_no_session_and_another_site_leads_nothing() -> None:
    async with teaching() as (server, url):
        page = await called(url, "/?class=K7HM")
        assert page.status == 200 and not server.lecture.get_sessions("/")
        assert "script-src 'self' 'sha256-" in page.headers["Content-Security-Policy"]
        answer = await called(url, "/class", "POST", Origin="https://elsewhere.example")
        assert answer.status == 403
        lesson = await Class.open(url)
        assert lesson.opened["address"] == f"{url}{lesson.code}?join={join_key(lesson.key)}"
        assert "<script" not in lesson.opened["square"] and lesson.opened["square"].startswith("<svg")


async def test_the_address_to_join_at_is_the_public_one() -> None:
    async with teaching(public_url="https://lecture.example/osc/") as (_, url):
        lesson = await Class.open(url)
        assert lesson.opened["address"] == f"https://lecture.example/osc/{lesson.code}?join={join_key(lesson.key)}"


async def test_the_address_takes_the_code_and_says_what_is_none() -> None:
    async with teaching() as (_, url):
        for path, to in (
            ("/EUW5", "./?class=EUW5"), ("/euw5/", "../?class=EUW5"),
            ("/eUw5?join=a1&x=%26", "./?class=EUW5&join=a1&x=%26"),
        ):  # fmt: skip
            for method in ("GET", "HEAD"):
                answer = await called(url, path, method)
                assert (answer.status, answer.headers["Location"]) == (302, to)
        for path, sentence in (("/EUWO", follower_routes.NO_CODE), ("/EUW55", "There is no such page here.")):
            answer = await called(url, path)
            assert answer.status == 404 and sentence in answer.text


async def test_a_class_is_opened_with_the_instructors_passphrase_where_there_is_one() -> None:
    async with teaching(class_passphrase="swinging über springs") as (server, url):
        server.classes.openings.most = 2
        for word, sentence in (("", "Opening a class here needs"), ("wrong%20words", "This is not the instructors'")):
            answer = await called(url, "/class", "POST", word=word)
            assert answer.status == 401 and answer.json["sentence"].startswith(sentence)
        assert (await called(url, "/class", "POST", word="wrong")).status == 429
        for _ in range(3):  # failed guesses from this network do not block a phone with a valid token
            opened = await called(url, "/class", "POST", word="swinging%20%C3%BCber%20springs")
            assert opened.status == 200
        assert await server.classes.registry.store.rooms() == 3


async def test_a_walk_that_waits_for_others_is_refused_for_a_moment_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """An instructor's page sends it once more, and gives up after a final refusal."""

    async with teaching() as (server, url):
        lesson = await Class.open(url)
        monkeypatch.setattr(server.classes.registry.bank, "worker", ReadingProcess("none"))
        monkeypatch.setattr(worker_process, "WAITING", 0)
        refused = await lesson.order("walk", name="mine", text="")
        assert (refused.status, refused.headers["Retry-After"]) == (429, "1") and refused.json[
            "sentence"
        ] == worker_process.BUSY
