"""Any course of a class: what the instructor and the phones do at two replicas, on each store, against a model."""

import asyncio
import csv
import io
from collections import Counter, defaultdict
from collections.abc import Coroutine
from contextlib import AsyncExitStack
from datetime import UTC, datetime
from typing import Any

import pytest
from hypothesis import Phase, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule
from hypothesis.stateful import run_state_machine_as_test as run_machine
from msgspec.structs import replace

from components.language import class_messages as said
from components.language.messages import Given
from components.live_class import registry as registry_of
from components.live_class import room as room_of
from components.live_class.registry import ClosedError, Registry
from components.live_class.room import ASKED, KEPT, OBEYED, SILENCE, ClassRoom
from components.live_class.store import Parts
from components.live_class.summary import stored, summary
from components.live_class.votes_csv import votes_csv
from tests.grids import WHOLE
from tests.live_class.caller import OWN, QUESTIONS, Answer, Asked
from tests.live_class.served import BANK, Listener, contents, made

AT, PHONE = st.integers(0, 1), st.integers(0, 4)
GIVEN = st.lists(st.tuples(PHONE, AT, PHONE, st.integers(0, 3), st.sampled_from([0] * 8 + [-1, 1])), max_size=5)
"""Answers: of which phone, at which replica, which one, how sure, and for which vote from the current one on."""
ORDERS = [said.ShowAnswer(), said.ShowAnswer(), said.CloseVote(), said.AskSure(), said.Withdraw()]
LATE = st.sampled_from([-1e12, -6000.0, -100.0, 0.0, 150.0, 9000.0])
LEVELS = {0: "", 1: "guessed", 2: "fairly sure", 3: "certain"}
NEWS = ("picture", "clock", "question", "here", "answered")
Vote = dict[str, tuple[Answer, int, float]]
"""The answers to one vote by phone, each with its confidence and time."""


def name_of(put: said.PutTo) -> str:
    return f"{put.walk}/{put.step}/{put.vote}"


def asked_in(name: str) -> Asked:
    return next(one for one in QUESTIONS if name.startswith(f"{one.walk}/{one.step}/"))


class AnyClass(RuleBasedStateMachine):
    """A class at two replicas."""

    def __init__(self, url: str) -> None:
        super().__init__()
        self.loop, self.opened, self.patch = asyncio.new_event_loop(), AsyncExitStack(), pytest.MonkeyPatch()
        self.patch.setattr(registry_of, "time", lambda: self.now)
        self.patch.setattr(room_of, "monotonic", lambda: self.now)
        self.now, self.marks, self.put, self.is_shown, self.moderated = 1.7e9, 0, said.PutTo(), False, ""
        self.votes, self.tokens, self.words = dict[str, Vote](), list[str](), dict[str, bool]()
        self.wait_for(self.begin(url))

    def wait_for(self, work: Coroutine[Any, Any, Any]) -> Any:
        return self.loop.run_until_complete(asyncio.wait_for(work, 60))

    async def begin(self, url: str) -> None:
        stores = [await self.opened.enter_async_context(made(url)) for _ in range(2 if url else 1)]
        self.registries = [Registry(store, BANK) for store in (stores[0], stores[-1])]
        self.store, self.told = stores[0], [asyncio.Event(), asyncio.Event()]
        self.tasks = [asyncio.create_task(self.listen(at)) for at in (0, 1)]
        await asyncio.gather(*(one.wait() for one in self.told))
        self.code, self.key = await self.registries[0].open()
        await self.enter()

    async def listen(self, at: int) -> None:
        def receive(code: str, parts: Parts) -> None:
            self.registries[at].receive(code, parts)
            if parts.get("mark") == b"%d" % self.marks:
                self.told[at].set()

        await self.registries[at].store.listen(receive, self.told[at].set)

    async def settle(self) -> None:
        """Wait until both replicas have all news."""
        self.marks += 1
        for one in self.told:
            one.clear()
        await self.store.publish("none", {"mark": b"%d" % self.marks})
        await asyncio.gather(*(one.wait() for one in self.told))

    async def enter(self) -> None:
        """Hand over the walks; an instructor's page listens at the first replica, a follower at the second."""
        for name, text in OWN.items():
            for registry in self.registries:  # the second one has it already
                await registry.obey(await registry.led(self.code, self.key), said.HandWalk(name=name, text=text))
            await self.settle()
        self.leader, self.follower = Listener(leads=True), Listener()
        self.rooms[0].listeners.add(self.leader)
        self.rooms[1].listeners.add(self.follower)
        self.follower.news.append(self.rooms[1].whole())
        self.known = self.rooms[0].number
        self.deeds, self.seen = list[tuple[float, str]](), dict[tuple[str, int], float]()

    @property
    def rooms(self) -> list[ClassRoom]:
        return [registry.rooms[self.code] for registry in self.registries]

    def obey(self, at: int, order: said.Order) -> None:
        self.wait_for(self.registries[at].obey(self.rooms[at], order))
        self.wait_for(self.settle())

    def tell(self, deed: str = "") -> None:
        """Note a deed for the instructor's page, or that there are answers, of which only the last time matters."""
        earlier = [one for one in self.deeds if deed or one[1]]
        self.deeds = [*earlier, (self.now, deed)][-KEPT:]

    # the instructor

    @initialize(at=AT, asked=st.sampled_from(QUESTIONS), answered=st.sampled_from([False, False, True]), given=GIVEN)
    def start(self, at: int, asked: Asked, answered: bool, given: Any) -> None:
        """The class has three phones and a question, whose answer it may have seen elsewhere."""
        for phone in range(3):
            self.come(at, phone)
        self.ask(1 - at, asked, 1, answered, given)

    @rule(
        at=AT,
        asked=st.sampled_from([*QUESTIONS, *[None] * len(QUESTIONS)]),
        vote=st.sampled_from([0, 1, 2, 2, 3, 9]),
        answered=st.sampled_from([False, False, False, True]),
        given=GIVEN,
    )
    def ask(self, at: int, asked: Asked | None, vote: int, answered: bool, given: Any) -> None:
        """The next vote on a question has the next number at most. The same vote keeps its settings."""
        before = self.put
        walk, step = (asked.walk, asked.step) if asked else (before.walk or "d31", before.step or "d31-02")
        is_same = (before.walk, before.step) == (walk, step)
        if is_same and self.is_shown and not vote:
            return
        number = min(max(vote, before.vote), before.vote + 1, 9) if is_same else max(vote, 1)
        self.put = said.PutTo(walk=walk, step=step, vote=number, sure=is_same and before.sure)
        if is_same and number == before.vote:
            answered = answered or self.is_shown or before.answered
            self.put = replace(self.put, closed=before.closed, until=before.until, closes=before.closes)
        self.put = replace(self.put, answered=answered, closed=self.put.closed or answered)
        self.is_shown = False
        self.obey(at, said.PutQuestion(walk=walk, step=step, vote=vote, answered=answered))
        self.answer(given)

    @rule(at=AT, orders=st.lists(st.sampled_from(ORDERS), min_size=1, max_size=3), again=st.booleans(), given=GIVEN)
    def lead(self, at: int, orders: list[said.Order], again: bool, given: Any) -> None:
        """Orders for the current question; after each, a reloaded page may put the question once more."""
        for order in orders:
            self.amend(at, order)
            if again and self.put.step:
                self.ask(1 - at, None, self.put.vote, False, [])
            self.answer(given)
            if again and order == said.ShowAnswer():
                self.amend(at, order)

    def amend(self, at: int, what: said.Order) -> None:
        if not self.put.step and what != said.Withdraw():
            with pytest.raises(ValueError, match=r"No question is open now\."):
                self.obey(at, what)
            return
        match what:
            case said.Withdraw():
                self.put, self.is_shown = said.PutTo(), False
            case said.ShowAnswer():
                self.put, self.is_shown = replace(self.put, answered=False, split=self.split()), True
            case said.CloseVote():
                self.put = replace(self.put, closed=True)
            case said.AskSure():
                self.put = replace(self.put, sure=True)
        self.obey(at, what)

    @precondition(lambda self: self.put.step)
    @rule(at=AT, seconds=st.sampled_from([0, 15, 30, 600]), closes=st.booleans())
    def count_down(self, at: int, seconds: int, closes: bool) -> None:
        """A countdown goes on for longer, by ten minutes at most; 0 only decides what happens at its end."""
        now, until = 1000 * self.now, self.put.until
        if seconds:
            until = now + min(max(until - now, 0.0) + 1000 * seconds, 600_000.0)
        self.put = replace(self.put, until=until, closes=closes)
        self.obey(at, said.CountDown(seconds=seconds, closes=closes))

    @rule(at=AT, data=st.binary(max_size=5), late=LATE)
    def show_motion(self, at: int, data: bytes, late: float) -> None:
        """The picture reaches all; a clock that is far off the server's is not believed."""
        picture = said.SentPicture(sheet="s", data=data)
        self.wait_for(self.registries[at].show(self.rooms[at], picture))
        self.obey(at, said.RunClock(t=2.0, rate=1.0, end=20.0, at=1000 * self.now + late))
        whole = self.rooms[1 - at].whole()
        assert whole.picture == picture and whole.clock
        assert whole.clock.at - 1000 * self.now == min(max(late, -5000.0), 200.0)

    @rule(at=AT, text=st.sampled_from(["Energy!", "a b c", "=1+1"]), shows=st.booleans(), given=GIVEN)
    def moderate(self, at: int, text: str, shows: bool, given: Any) -> None:
        self.ask(at, asked_in("why/why/"), self.put.vote if self.put.step == "why" else 1, False, given)
        if name_of(self.put) != self.moderated:  # another vote starts hidden
            self.moderated, self.words = name_of(self.put), {}
        self.words[text.casefold().strip("!")] = shows
        self.obey(at, said.Moderate(text=text, shows=shows))
        self.tell()
        if given:  # sometimes the class votes again
            self.wait_for(self.check_tally())
            self.ask(1 - at, None, min(self.put.vote + 1, 9), False, given)

    @rule(deed=st.sampled_from(["next", "back"]))
    def press(self, deed: str) -> None:
        """A remote control sends an order, which only the instructor's page gets."""
        self.tell(deed)
        self.wait_for(self.store.publish(self.code, {"deed": f'"{deed}"'.encode()}))
        self.wait_for(self.settle())
        assert self.leader.news[-1].deed == deed

    # the phones

    @rule(at=AT, phone=PHONE)
    def come(self, at: int, phone: int) -> None:
        """A phone asks for news, for the first time or again."""
        if phone >= len(self.tokens):
            self.tokens.append(self.registries[at].token(self.rooms[at]))
        token = self.tokens[min(phone, len(self.tokens) - 1)]
        room = self.wait_for(self.registries[at].followed(self.code, token))
        room.polled(token, leads=False)
        self.seen[room.voter(token), at] = self.now

    @rule(seconds=st.sampled_from([1.0, 4.5, 6.0, 20.0, 31.0, 400.0]))
    def wait(self, seconds: float) -> None:
        self.now += seconds

    @rule(given=GIVEN)
    def answer(self, given: list[tuple[int, int, int, int, int]]) -> None:
        """An answer to the open vote counts, in place of the phone's earlier one; others are refused."""
        for phone, at, one, sure, off in given:
            registry, room, put = self.registries[at], self.rooms[at], self.put
            voter = room.voter(self.tokens[phone % len(self.tokens)])
            recent = self.now - self.seen.get((voter, at), 0.0) < 2 * SILENCE
            assert self.wait_for(registry.follows(room, voter)) == recent
            asked = asked_in(name_of(put)) if put.step else QUESTIONS[0]
            answer = asked.answers[one % len(asked.answers)]
            named = {"walk": asked.walk, "step": asked.step, "vote": put.vote + off, "sure": sure}
            if not put.step or put.closed or self.is_shown or off:
                with pytest.raises(ValueError, match=r"^This question is closed\.$"):
                    self.wait_for(registry.vote(room, voter, Given(**named, **answer.fields)))
                continue
            for unfit in asked.unfit:
                with pytest.raises(ValueError):
                    self.wait_for(registry.vote(room, voter, Given(**named, **unfit)))
            self.wait_for(registry.vote(room, voter, Given(**named, **answer.fields)))
            self.wait_for(self.settle())
            self.votes.setdefault(name_of(put), {})[voter] = answer, sure, round(self.now)
            self.tell()
            assert self.leader.news[-1].answers

    # the server

    @rule(at=AT)
    def lose_and_restore(self, at: int) -> None:
        """A store that was restarted empty gets the class from the copies on the instructor's page."""
        put, was_shown = self.put, self.is_shown
        self.put, self.is_shown, self.moderated = said.PutTo(), False, ""
        self.wait_for(self.restore(self.registries[at]))
        if put.step:
            self.ask(at, asked_in(name_of(put)), put.vote, was_shown or put.answered, [])

    async def restore(self, registry: Registry) -> None:
        copies = [await registry.copied(registry.rooms[self.code], name) for name in self.votes]
        await self.store.end(self.code)
        await self.settle()
        assert self.leader.ended and self.follower.ended
        again = await asyncio.gather(*(one.reopen(self.code, self.key) for one in self.registries))
        assert again[0].parts["key"] == again[1].parts["key"]
        await self.enter()
        for copy in 2 * copies:  # nothing is restored twice
            await registry.obey(registry.rooms[self.code], said.RestoreAnswers(answers=copy))
            self.tell()
        await self.settle()
        assert [await registry.copied(registry.rooms[self.code], name) for name in self.votes] == copies

    def teardown(self) -> None:
        try:
            self.wait_for(self.end())
        finally:
            for task in self.tasks:
                task.cancel()
            self.loop.run_until_complete(asyncio.gather(*self.tasks, return_exceptions=True))
            self.loop.run_until_complete(self.opened.aclose())
            self.loop.run_until_complete(self.loop.shutdown_default_executor())
            self.loop.close()
            self.patch.undo()

    async def end(self) -> None:
        """At the end, nothing of the class is left, and nobody comes in again."""
        (registry, second), room = self.registries, self.rooms[0]
        await registry.obey(room, said.EndRoom())
        await self.settle()
        assert self.leader.ended and self.follower.ended and self.follower.news[-1].ended
        assert await contents(self.store, self.code) == [{}, []]
        assert not any([await self.store.votes(self.code, name) for name in self.votes])
        followed = [second.followed(self.code, token) for token in self.tokens]
        for work in (registry.obey(room, said.Withdraw()), second.reopen(self.code, self.key), *followed):
            with pytest.raises(ClosedError, match=r"class is over\.$"):
                await work

    # what holds at any time

    @invariant()
    def the_question_is_the_same_for_all(self) -> None:
        for room in self.rooms:
            assert replace(room.question, card=None, place="", lesson=None) == self.put
            assert (room.question.lesson is not None) == self.is_shown
            assert (room.question.card is not None) == bool(self.put.step)

    @invariant()
    def a_late_phone_gets_what_the_others_have_heard(self) -> None:
        known = dict[str, Any]()
        for news in self.follower.news:
            assert not (news.answers or news.deed or news.remotes)
            known |= {"answered": 0} if news.question else {}  # until they are counted
            known |= {name: value for name in NEWS if (value := getattr(news, name)) is not None}
        assert {name: getattr(self.rooms[1].whole(), name) for name in known} == known

    @invariant()
    def those_are_here_who_asked_just_now(self) -> None:
        for at, room in enumerate(self.rooms):
            ago = {name: self.now - time for (name, where), time in self.seen.items() if where == at}
            assert room.followers == at + sum(time < ASKED for time in ago.values())
            assert room.names == {name for name, time in ago.items() if time < 2 * SILENCE}
            assert room.is_led == (at == 0) and room.used

    @invariant()
    def an_instructor_who_asks_gets_each_deed_once_and_none_of_long_ago(self) -> None:
        news = self.rooms[0].news_after(self.known)
        late = [deed for at, deed in self.deeds if not deed or self.now - at < OBEYED]
        assert [one.deed for one in news] == late and all(one.answers == (not one.deed) for one in news)

    @invariant()
    def all_answers_are_counted(self) -> None:
        self.wait_for(self.check_tally())

    def split(self, name: str = "") -> said.Split:
        """The answers to a vote in numbers, as phones get them."""
        asked, vote = asked_in(name or name_of(self.put)), self.votes.get(name or name_of(self.put), {})
        given = Counter(str(one.counted) for one, _, _ in vote.values())
        options = tuple(given[str(one.counted)] for one in asked.answers if asked.counts == "options")
        having = (0, 0, 0, 0, given["100"]) if asked.counts == "sketches" and vote else ()
        right, judges = sum(one.right == "yes" for one, _, _ in vote.values()), bool(asked.answers[0].right)
        return said.Split(answered=len(vote), right=right, judges=judges, options=options, having=having)

    async def check_tally(self) -> None:
        for registry, room in zip(self.registries, self.rooms, strict=True):
            tally = await registry.tally(room)
            await registry.count(room)
            if not self.put.step:
                assert tally is None and room.answered == 0
                continue
            asked, vote, split = asked_in(name_of(self.put)), self.votes.get(name_of(self.put), {}), self.split()
            assert tally and (tally.walk, tally.step, tally.vote) == (asked.walk, asked.step, self.put.vote)
            now, given = tally.now, [one.counted for one, _, _ in vote.values()]
            assert (now.answered, tally.right) == (len(vote), split.right)
            assert (now.options, now.having) == (split.options, split.having)
            assert room.answered == now.answered and len(tally.features) == 5 * (asked.counts == "sketches")
            assert sorted(now.numbers) == (sorted(given) if asked.counts == "numbers" else [])
            sketches = sorted(one.curves["Xp1"][0] for one in now.sketches)
            assert sketches == (sorted(given) if asked.counts == "sketches" else [])
            shown = self.words if self.moderated == name_of(self.put) else {}
            words = Counter(given) if asked.counts == "words" else {}
            groups = {(word, times, word in shown) for word, times in words.items() if shown.get(word, True)}
            assert {(one.text.casefold().strip(" ."), one.count, one.shown) for one in now.words} == groups
            sure = [(level, one.right == "yes") for one, level, _ in vote.values() if level]
            levels = tuple((sum(level == n for level, _ in sure), sure.count((n, True))) for n in (1, 2, 3))
            assert now.sure == (levels if sure else ())
            first = self.split(f"{asked.walk}/{asked.step}/1") if self.put.vote > 1 else None
            before = tally.before and (tally.before.answered, tally.before.options)
            assert before == (first and (first.answered, first.options))

    @invariant()
    def the_table_and_the_summary_have_them(self) -> None:
        self.wait_for(self.check_table())

    async def check_table(self) -> None:
        registry, room = self.registries[0], self.rooms[0]
        rows = list(csv.DictReader(io.StringIO("".join(await votes_csv(registry, room)))))
        found, expected = defaultdict[str, list[Any]](list), defaultdict[str, list[Any]](list)
        for row in rows:
            name, text = f"{row['walk']}/{row['step']}/{row['vote']}", row["answer"].partition(";")[0]
            found[row["phone"]].append((name, text, row["unit"], row["right"], row["sure"], row["time"]))
        for name, vote in self.votes.items():
            for voter, (one, sure, at) in vote.items():
                time = datetime.fromtimestamp(at, UTC).strftime("%Y-%m-%dT%H:%M:%SZ")
                expected[voter].append((name, one.text, one.unit, one.right, LEVELS[sure], time))
        assert sorted(map(sorted, found.values())) == sorted(map(sorted, expected.values()))
        assert set(found) == {f"{n + 1}" for n in range(len(expected))}  # numbers that identify nobody
        questions = {name.rpartition("/")[0] for name in self.votes}
        assert await stored(registry, room) == said.Stored(answers=len(rows), questions=len(questions))
        # A question with right and wrong answers has its votes, and the mistake that is made most in the last one.
        summed = await summary(self.registries[0], self.rooms[0])
        judged = dict.fromkeys(name.rpartition("/")[0] for name in self.votes if asked_in(name).answers[0].right)
        assert [f"{one.walk}/{one.step}" for one in summed] == list(judged)
        for one in summed:
            name = f"{one.walk}/{one.step}/"
            splits = {n: self.split(f"{name}{n}") for n in range(1, 10) if f"{name}{n}" in self.votes}
            counts = [(n, split.answered, split.right) for n, split in splits.items()]
            assert [(vote.vote, vote.answered, vote.right) for vote in one.votes] == counts
            given = [answer for answer, _, _ in self.votes[f"{name}{max(splits)}"].values()]
            wrong = Counter(
                f"{each.text} {each.unit}".strip() for each in given if each.right == "no" and each.unit != "SI"
            )
            assert one.place == asked_in(name).place
            assert one.mistaken == max(wrong.values(), default=0) == wrong[one.mistake]


def test_any_course_of_a_class(url: str) -> None:
    # To shrink a failure takes minutes.
    given = settings(max_examples=60 if WHOLE else 10, stateful_step_count=30, deadline=None, phases=[Phase.generate])
    run_machine(lambda: AnyClass(url), settings=given)
