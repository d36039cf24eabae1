"""The live class over HTTP: who comes in, what is heard, how the lead is passed on, and how a lost class comes back;
its streams, with slow readers, several tabs and sleeping phones.
"""

import asyncio
import base64
import re
import socket
import time
from csv import DictReader

import pytest

from components.live_class import follower_routes, instructor_routes, lead_routes
from components.live_class import registry as registries
from components.live_class import room as rooms
from components.live_class.codes import Keys, code_of, join_key
from components.live_class.room import name_of
from components.serving import worker_process
from components.serving.shell import version
from components.serving.worker_process import ReadingProcess
from tests.live_class.caller import CHOICE, NUMBER, OWN, Answered, Class, Remote, Stream, called, events_of, until
from tests.live_class.served import Valkey, made, served, taught
from tests.page.scripts import text_of
from tests.serving.visitor import Visitor


async def test_what_the_instructor_shows_reaches_followers_as_the_same_message() -> None:
    async with taught() as (server, url, lesson):
        stream = await lesson.follow()
        for header in ("text/event-stream", "X-Accel-Buffering: no", "no-store", f"Lecture-Version: {version()}"):
            assert header in stream.headers
        stranger, visitor = [await Visitor.arrive(url, "scene=coupled") for _ in range(2)]
        await stranger.send({"type": "lead", "code": lesson.code, "key": "x" * 32})
        await stranger.send({"type": "set", "values": {"k2": 1.5}})
        await visitor.send({"type": "lead", "code": lesson.code, "key": lesson.key})
        first = await stream.until(lambda event: event.get("picture"))
        await visitor.move("k2", 3.5)
        told = await stream.until(lambda event: event.get("picture") and event != first)
        sheet, data = told["picture"]["sheet"], base64.b64decode(told["picture"]["data"])
        text = text_of({"sheet": sheet, "data": data}, await visitor.dictionary(sheet))
        assert len(data) < 3800 and b'"k2":3.5' in text and b'"answer":null' in text
        await visitor.move("k2", -1.0)  # refusals are not sent to the class
        late = await lesson.follow()
        assert (await late.until(lambda event: event.get("picture")))["picture"] == told["picture"]
        assert len([event for event in stream.heard if "picture" in event]) == 2
        assert b"oscillations_followers 2.0" in server.context.metrics.text()
        await asyncio.gather(visitor.depart(), stranger.depart())


async def test_a_follower_learns_what_is_said_of_its_answer_when_it_is_shown_and_the_instructor_gets_a_table() -> None:
    async with taught() as (_, _, lesson):
        await lesson.order("put", **CHOICE)
        token, answer = await lesson.token(), {**CHOICE, "option": 1}
        for option in (1, 0):
            await lesson.voted(token, **CHOICE, option=option)
        early = await lesson.ask("answer", "POST", answer, token)
        assert early[:2] == (204, "")  # not shown yet, or taken back before the phone knows
        await lesson.order("show")
        # Nothing is sent for another question.
        for asked, status in (({**NUMBER, "text": "2"}, 204), ({**CHOICE, "option": 7}, 400), (answer, 200)):
            reply = await lesson.ask("answer", "POST", asked, token)
            assert reply.status == status
        assert reply.json["type"] == "taught" and reply.json["lesson"]["right"] is False
        table = await lesson.ask("answers.csv")
        assert table.headers["Content-Type"] == "text/csv; charset=utf-8"
        (row,) = DictReader(table.text.splitlines())
        assert (row["question"], row["right"]) == ("How long does one swing take?", "yes")


async def test_pages_without_a_stream_poll_and_get_all_news(monkeypatch: pytest.MonkeyPatch) -> None:
    """An instructor's page gets its own news one by one, and none of another replica. It sends a walk that waits for
    others once more, and gives up after a final refusal.
    """
    async with taught() as (server, _, lesson):
        token, path, registry = await lesson.token(), "now?after=", server.classes.registry
        await lesson.order("put", **CHOICE)
        first, known = (await lesson.ask(path, word=token)).json, (await lesson.ask(path)).json["number"]
        assert first["question"]["step"] == first["question"]["card"]["id"] == "d31-03"
        assert (await lesson.ask(path + first["number"], word=token)).status == 204
        await lesson.voted(token, **CHOICE, option=1)
        registry.rooms[lesson.code].deliver({"deed": b'"next"'})
        heard = []
        while (answer := await lesson.ask(path + known)).status == 200:
            known = answer.json["number"]
            heard.append((answer.json.get("answers", False), answer.json.get("deed", "")))
        assert heard == [(True, ""), (False, "next")]
        for page, word in (("x.9", lesson.key), (first["number"], token)):
            assert "deed" not in (await lesson.ask(path + page, word=word)).text
        monkeypatch.setattr(registry.bank, "worker", ReadingProcess("none"))
        monkeypatch.setattr(worker_process, "WAITING", 0)
        refused = await lesson.order("walk", name="mine", text="")
        assert (refused.status, refused.headers["Retry-After"]) == (429, "1")
        assert refused.json["sentence"] == worker_process.BUSY


async def test_codes_cannot_be_guessed_and_a_class_that_mistypes_comes_in(monkeypatch: pytest.MonkeyPatch) -> None:
    hits = 10 * follower_routes.MISSES * 4 * 60 / 30**4
    assert hits < 1 and follower_routes.MISSES >= 300
    monkeypatch.setattr(follower_routes, "MISSES", 4)
    async with taught(trusted_proxies=("127.0.0.1",)) as (_, url, lesson):

        async def enter(code: str, address: str, word: str = "") -> int:
            return (await called(url, f"/class/{code}/token", "POST", word=word, X_Forwarded_For=address)).status

        wrong, secret = "2222" if lesson.code != "2222" else "3333", lesson.opened["address"].partition("join=")[2]
        assert [await enter(wrong, f"198.51.100.{i}") for i in range(6)] == [404] * 4 + [429] * 2
        assert await enter(lesson.code, "198.51.100.9") == 429  # the correct code does not reveal that it is correct
        assert await enter(lesson.code.lower(), "203.0.113.9") == 200
        assert await enter(lesson.code, "198.51.100.9", secret) == 200  # a QR code does not count as a guess
        assert [await enter(lesson.code, "198.51.100.9", word) for word in (lesson.key, "x" * 12)] == [429] * 2
        monkeypatch.setattr(follower_routes, "ALL_MISSES", 6)
        assert [await enter(wrong, f"192.0.{i}.1") for i in range(3)] == [404, 404, 429]
        assert await enter(lesson.code, "203.0.113.9") == 429


async def test_a_remote_control_is_let_in_by_its_digits_and_has_the_answer_and_notes_that_phones_have_not() -> None:
    noted = OWN["mine"] + 'notes = """\nShow the *real* spring.\n\nThen wait."""\n'
    async with taught() as (_, _, lesson):
        leader, stream, secret = await lesson.lead(), await lesson.follow(), {"address": await Remote.secret(lesson)}
        remote = Remote(lesson, **(await lesson.ask("remote", "PUT", secret, word="")).json)
        assert (await lesson.ask("remote", "PUT", secret, word="")).status == 403
        assert (await leader.until(lambda event: event.get("remotes")))["remotes"] == [remote.digits]
        assert (await remote.ask()).json is None and (await remote.ask(method="POST", deed="next")).status == 403
        assert (await remote.decide(digits="10" if remote.digits != "10" else "11")).status == 409
        assert (await remote.decide()).json["control"]
        other = await Remote.wait(lesson)
        assert other and (await other.decide("DELETE")).status == 204
        refused = await other.ask()
        assert refused.status == 403 and refused.json["sentence"].startswith("The lecturer's screen has not")
        for name, text in (("noted", noted), ("why", OWN["why"])):
            await lesson.order("walk", name=name, text=text)
        await lesson.order("put", walk="noted", step="one")
        view = (await remote.ask()).json
        assert view["question"]["lesson"] is None
        assert [one["right"] for one in view["lesson"]["verdicts"]] == [True, False, False]
        assert view["notes"] == ['Show the <span class="v">real</span> spring.', "Then wait."]
        assert (await remote.ask(f"remote?after={view['number']}")).status == 204
        for asked, given in ((NUMBER, "2"), ({"walk": "why", "step": "why"}, "secret")):
            await lesson.order("put", **asked)
            await lesson.voted(await lesson.token(), **asked, text=given)
            now = (await remote.ask()).json["tally"]["now"]
            assert now["answered"] == 1 and now["numbers"] == []  # none of them single
        assert [one["step"] for one in (await remote.ask("steps")).json] == ["why", "vote"]
        for done in ({"deed": "next"}, {"deed": "go", "step": "vote"}):
            assert (await remote.ask(method="POST", **done)).status == 204
            await leader.until(lambda event, done=done: done.items() <= event.items())
        for deed, words in (("allow", [True]), ("remove", [])):
            assert (await remote.ask(method="POST", deed=deed, text="secret")).status == 204
            assert [one["shown"] for one in (await remote.ask()).json["tally"]["now"]["words"]] == words
        await lesson.order("show")
        await stream.until(lambda event: event.get("question", {}).get("split"))
        assert not any("real" in str(event) or "secret" in str(event) for event in stream.heard)


async def test_another_computer_leads_with_a_word_that_is_good_once() -> None:
    async with taught() as (_, url, lesson):
        other, link = await Class.open(url), {"query": "scene=coupled&k2=3", "shown": {"d31/d31-03": 2}}

        async def new_word() -> str:
            return str((await lesson.ask("word", "POST", link)).json["address"].rpartition("/")[2])

        async def take(address: str, of: Class = lesson) -> Answered:
            return await of.ask("word", "PUT", {"word": address.rpartition("-")[2]}, word="")

        used = await new_word()
        moved = await called(url, f"/{used.lower()}")
        there = f"./?class={lesson.code}&lead={used.rpartition('-')[2]}"
        assert (moved.status, moved.headers["Location"]) == (302, there)
        taken = (await take(used.lower())).json
        assert taken["key"] == lesson.key and link.items() <= taken.items()
        replaced, good = await new_word(), await new_word()
        for of, word in ((lesson, used), (lesson, replaced), (other, good)):
            refused = await take(word, of)
            assert (refused.status, refused.json["sentence"]) == (403, lead_routes.NO_WORD)
        assert (await take(good)).status == 200  # a wrong code does not use it up


@pytest.mark.parametrize("public", ["", "https://lecture.example/osc/"])
async def test_neither_the_address_to_join_at_nor_the_clock_takes_a_session(public: str) -> None:
    async with taught(public_url=public) as (server, url, lesson):
        assert lesson.opened["address"] == f"{public or url}{lesson.code}?join={join_key(lesson.key)}"
        assert "<script" not in lesson.opened["square"] and lesson.opened["square"].startswith("<svg")
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
        clock = float((await called(url, "/class/time")).text)
        assert abs(clock / 1000 - time.time()) < 600
        assert (await called(url, "/?class=K7HM")).status == 200 and not server.lecture.get_sessions("/")


async def test_a_class_is_opened_with_the_instructors_passphrase_where_there_is_one() -> None:
    async with served(class_passphrase="swinging über springs") as (server, url):
        forged = Keys().new()  # by a server with another passphrase
        assert (await reopened(url, code_of(forged), forged)).status == 409
        server.classes.openings.most = 2
        for word, sentence in (("", "Opening a class here needs"), ("wrong%20words", "This is not the instructors'")):
            answer = await called(url, "/class", "POST", word=word)
            assert answer.status == 401 and answer.json["sentence"].startswith(sentence)
        assert (await called(url, "/class", "POST", word="wrong")).status == 429
        for _ in range(3):  # wrong passphrases from the same network do not block the right one
            opened = await called(url, "/class", "POST", word="swinging%20%C3%BCber%20springs")
            assert opened.status == 200
        assert await server.classes.registry.store.rooms() == 3


SECRET = "a secret of these tests alone"
COPIES = "answers?question=d31/d31-03/1"


async def reopened(url: str, code: str, key: str) -> Answered:
    return await called(url, f"/class/{code}/lead", "PUT", {}, key)


async def test_a_restarted_server_has_the_room_its_answers_and_its_phones_again() -> None:
    async with taught() as (_, url, lesson):
        tokens = [await lesson.token() for _ in range(3)]
        await lesson.order("put", **CHOICE)
        for token, option in zip(tokens, (0, 1, 1), strict=True):
            await lesson.voted(token, **CHOICE, option=option)
        kept = (await lesson.ask(COPIES)).json
    async with served() as (_, url):
        lesson.url = url
        assert (await lesson.order("withdraw")).status == 404
        again = await reopened(url, lesson.code, lesson.key)
        assert again.json["address"].partition("?")[2] == lesson.opened["address"].partition("?")[2]
        assert (await lesson.ask("now", word=tokens[0])).status == 200
        assert (await lesson.vote(tokens[0], **CHOICE, option=2)).status == 503  # the phone tries again
        await lesson.order("put", **CHOICE)
        await lesson.voted(tokens[0], **CHOICE, option=2)
        assert (await reopened(url, lesson.code, lesson.key)).status == 200  # as often as requested
        await lesson.order("show")
        phone = await lesson.follow()
        assert (await lesson.order("restore", answers=kept)).status == 204
        await phone.until(lambda event: (event.get("question", {}).get("split") or {}).get("options") == [0, 2, 1])
        assert (await lesson.tally())["now"]["options"] == [0, 2, 1]


async def test_a_class_is_reopened_only_with_its_key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(instructor_routes, "MOST_OPENED", 12)
    async with taught() as (server, url, lesson):
        other, forged = await Class.open(url), Keys().new()
        for code, key in (
            (lesson.code, other.key), (lesson.code, forged), (lesson.code, ""), ("ZZZZ", forged), ("0000", forged),
            (lesson.code, f"{lesson.key}="), (lesson.code, "x" * 5000),
        ):  # fmt: skip
            refused = await reopened(url, code, key)
            assert refused.status == 409 and refused.json["sentence"].startswith("This is not the key of a class")
        assert await server.classes.registry.store.rooms() == 2
        with monkeypatch.context() as patch:
            patch.setattr(Keys, "code_of", lambda keys, key: lesson.code)
            refused = await reopened(url, lesson.code, forged)
            assert refused.status == 409 and refused.json["sentence"].startswith("Another class has this code")
        assert (await lesson.order("withdraw")).status == (await other.order("withdraw")).status == 204
        statuses = [(await reopened(url, code_of(key), key)).status for key in (Keys().new() for _ in range(3))]
        assert statuses == [200, 200, 429]  # reopened classes count like new ones


async def test_answers_given_back_are_those_of_phones(monkeypatch: pytest.MonkeyPatch) -> None:
    """A server with a secret knows its names even after a restart; otherwise it accepts what connected phones could
    send. Answers that fit no question do not count.
    """
    monkeypatch.setattr(registries, "SPARE", 2)
    async with taught(bokeh_secret_key=SECRET) as (_, url, lesson):
        own = {(await lesson.token()).partition(".")[0]: {**CHOICE, "option": i} for i in range(8)}
    async with served(bokeh_secret_key=f"{SECRET}, another") as (_, url):
        assert (await reopened(url, lesson.code, lesson.key)).status == 409
    made_up = {f"{i:011x}abcdefgh": {**CHOICE, "option": 1} for i in range(8)}
    async with served(bokeh_secret_key=SECRET) as (_, url):
        assert (await reopened(url, lesson.code, lesson.key)).status == 200
        lesson.url = url
        refused = await lesson.order("restore", answers=made_up)
        assert refused.status == 409 and refused.json["sentence"].startswith("6 answers were not kept: more than")
        assert (await lesson.order("restore", answers=own)).status == 204
        copies = (await lesson.ask(COPIES)).json
        assert len(copies) == 2 + 8 and own.keys() <= copies.keys()
        await lesson.order("put", **CHOICE)
        assert (await lesson.tally())["now"]["options"] == [1, 1 + 2, 1]


def picture(sheet: object) -> dict[str, bytes]:
    return {"picture": b'{"sheet":"%s","data":"%s"}' % (str(sheet).encode(), b"A" * 4000)}


@pytest.mark.parametrize("leads", [False, True])
async def test_slow_readers_get_the_latest_and_each_deed_once(leads: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """A connection that nobody reads is closed."""
    async with taught() as (server, _, lesson):
        quick, word = await lesson.follow(), lesson.key if leads else await lesson.token()
        room, slow = server.classes.registry.rooms[lesson.code], socket.socket()  # a stream that nobody reads
        slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        slow.connect(("127.0.0.1", server.port))
        slow.sendall(events_of(lesson.url, lesson.code, word))
        await until(lambda: room.is_led if leads else room.followers == 2)
        room.deliver({"deed": b'"back"'})
        for i in range(400):
            room.deliver(picture(i))
            await asyncio.sleep(0)
        room.deliver({"deed": b'"next"'})
        await quick.until(lambda event: event.get("picture", {}).get("sheet") == "399")
        slow.settimeout(30)
        read = b""
        while (b'"deed":"next"' if leads else b'"sheet":"399"') not in read:
            read += await asyncio.to_thread(slow.recv, 65536)
        seen = [int(number) for number in re.findall(rb'"sheet":"(\d+)"', read)]
        assert len(seen) < 200 and seen == sorted(seen) and seen[-1] == 399
        assert read.count(b'"deed":"back"') == read.count(b'"deed":"next"') == leads
        monkeypatch.setattr(follower_routes, "GIVEN_UP", 0.3)
        async with asyncio.timeout(30):
            while len(room.listeners) > 1:
                room.deliver(picture("s"))
                await asyncio.sleep(0.01)
        assert not quick.ended
        slow.close()


async def test_many_streams_of_a_phone_take_one_place(valkey: Valkey, monkeypatch: pytest.MonkeyPatch) -> None:
    """The newest streams of a phone stay open, and so do those of others. Asleep, it is none."""
    monkeypatch.setattr(follower_routes, "MOST_STREAMS", 2)
    async with (
        made(valkey.url) as store,
        made(valkey.url) as other,
        served(store=store) as (server, url),
        served(other) as (_, second),
    ):
        lesson = await Class.open(url)
        leader, token = await lesson.lead(), await lesson.token()
        friend, there = await lesson.follow(second), await Stream.open(second, lesson.code, token)
        tabs = [await Stream.open(url, lesson.code, token) for _ in range(6)]
        await until(lambda: sum(tab.ended for tab in tabs) >= 4)
        room = server.classes.registry.rooms[lesson.code]
        assert (room.followers, room.places) == (1, 2) and not tabs[-1].ended and not friend.ended
        await leader.until(lambda event: event.get("here") == 2)
        assert max(event.get("here", 0) for event in leader.heard) == 2  # never three
        await asyncio.gather(*(tab.close() for tab in (*tabs, there)))
        await leader.until(lambda event: event is leader.heard[-1] and event.get("here") == 1)
        await until(lambda: len(room.streams) == 1)  # the leader's


async def test_a_vote_is_of_somebody_who_follows_or_was_here_a_moment_ago(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rooms, "SILENCE", 0.05)
    async with taught() as (server, _, lesson):
        stream, registry = await lesson.follow(), server.classes.registry
        token, stranger = stream.word, (await lesson.ask("token", "POST", word="")).json["token"]
        # The first one is sent before its question is restored.
        for word, sentence in ((token, "The class has no question yet"), (stranger, "This phone does not follow")):
            refused = await lesson.vote(word, **CHOICE, option=0)
            assert refused.status == 503 and refused.json["sentence"].startswith(sentence)
            await lesson.order("put", **CHOICE)
        await asyncio.sleep(0.2)
        await lesson.voted(token, **CHOICE, option=0)
        await stream.close()
        await until(lambda: not registry.rooms[lesson.code].follows(name_of(token)))
        assert (await lesson.vote(token, **CHOICE, option=1)).status == 503
        await registry.store.name(lesson.code, "another replica", [name_of(token)])
        await lesson.voted(token, **CHOICE, option=1)
        assert (await lesson.tally())["now"]["options"] == [0, 1, 0]


async def test_one_client_does_not_fill_a_vote(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registries, "SPARE", 2)
    async with taught() as (server, _, lesson):
        await lesson.order("put", **CHOICE)
        late, room = await lesson.token(), server.classes.registry.rooms[lesson.code]
        for option in (1, *[0] * 10):  # joins, votes and leaves or falls asleep
            token = await lesson.token()
            await lesson.voted(token, **CHOICE, option=option)
            del room.polls[name_of(token)]
        await lesson.voted(late, **CHOICE, option=2)
        now = (await lesson.tally())["now"]
        assert now["answered"] <= 2 + 2 * 3 and now["options"][1:] == [1, 1]
