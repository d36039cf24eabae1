"""The rooms of one replica: their followers, their latest parts, and the instructor's orders."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from contextlib import suppress
from functools import partial
from secrets import token_hex
from time import monotonic, time
from typing import Any

import msgspec

from components.language.class_messages import (
    AskSure,
    CloseVote,
    CountDown,
    DescribeScreen,
    EndRoom,
    HandWalk,
    Moderate,
    Order,
    PutQuestion,
    PutTo,
    RestoreAnswers,
    RunClock,
    SentPicture,
    ShowAnswer,
    Split,
    Tally,
    Voted,
    Withdraw,
)
from components.language.messages import Given
from components.live_class.codes import Keys, digest, is_key, join_key
from components.live_class.moderation import Moderation
from components.live_class.question_bank import BusyError, QuestionBank
from components.live_class.remotes import CONTROL, decided
from components.live_class.room import NOTHING_PUT, ClassRoom
from components.live_class.slices import Slices
from components.live_class.store import LIFE, MOST_VOTES, OWNER, FullError, Parts, Store, UnreachableError
from components.walks.questions.question import Judged

LONGEST_COUNT = 600_000.0
"""The longest countdown of a vote, in milliseconds."""
MOST_AHEAD, MOST_BEHIND = 200.0, 5000.0
"""Milliseconds by which an instructor's clock may differ from the arrival of its message, ahead or behind."""
FIRST, LAST = 1, 9
"""The maximum number of votes on one question."""
SPARE = 50
"""Answers to a vote beyond two for each phone that has been in the class; some students change phones."""
MOST_OWN = 5
"""The maximum number of walks from files in a room."""
TRIES = 3
"""Attempts to find a code for a new room. With 500 rooms, one code in 1600 is taken."""
NOT_OF_IT = "This is not the key of a class with this code."
OVER = "The class is over."
NO_PLACE = "This server has no room for another class now. Try again later."


class ClosedError(ValueError):
    """A refusal, because there is no such room or no permission. Its message says which."""


class EndedError(ClosedError):
    """A refusal of a follower's request, because the class has ended for good."""


class Registry:
    """The rooms with at least one member at this replica."""

    def __init__(self, store: Store, bank: QuestionBank, keys: Keys | None = None) -> None:
        self.store = store
        self.bank = bank
        self._keys = keys or Keys()
        self.rooms: dict[str, ClassRoom] = {}
        self._coming: dict[str, list[ClassRoom]] = {}
        """Rooms that are being loaded from the store; they get the updates that arrive meanwhile."""
        self._name = token_hex(6).encode()
        self.slices = Slices()

    @property
    def followers(self) -> int:
        return sum(room.followers for room in self.rooms.values())

    @property
    def places(self) -> int:
        return sum(room.places for room in self.rooms.values())

    async def open(self, owner: str = "") -> tuple[str, str]:
        """Open a room and return its code and its key. `owner` is the network that opens it, or "" for somebody who
        knows the passphrase. Raises ClosedError if there is no place for a room.
        """
        for _ in range(TRIES):
            key = self._keys.new()
            code = await asyncio.to_thread(self._keys.code_of, key)
            if await self.store.open(code, _locks(key, owner)):
                return code, key
        raise ClosedError(NO_PLACE)

    def is_own(self, key: str) -> bool:
        """Return True if a server with this one's passphrase may have made the key."""
        return self._keys.is_own(key)

    async def reopen(self, code: str, key: str, control: str = "", owner: str = "") -> ClassRoom:
        """Return the room of a server's key; open it again if it is lost. `control` is the stored digest of its
        remote control's key, `owner` as in `open`. Raises ClosedError, or ValueError with a sentence."""
        if not self.is_own(key) or await asyncio.to_thread(self._keys.code_of, key) != code:
            raise ValueError(NOT_OF_IT)
        room = await self._found(code)
        if not room.parts:
            if await self.store.count(_ended(digest(key)), LIFE, 0):
                raise ClosedError(OVER)
            await self.store.open(code, {**_locks(key, owner), **({CONTROL: control.encode()} if control else {})})
            room = await self._found(code)
        if not room.parts:
            raise ClosedError(NO_PLACE)
        if not is_key(key, room.parts["key"]):
            raise ValueError("Another class has this code by now. Press T for a new one.")
        return self._asked(room)

    async def followed(self, code: str, token: str) -> ClassRoom | None:
        """Return the room of a follower's token, or None if there is none or the token belongs to another. Raises
        EndedError if the class has ended."""
        room = await self._found(code)
        if room.voter(token):
            return self._asked(room)
        with suppress(UnreachableError):  # the class may have ended, but the store cannot be asked now
            if not room.parts and await self.store.count(_ended(code.encode()), LIFE, 0):
                raise EndedError(OVER)
        return None

    async def room(self, code: str) -> ClassRoom:
        """Return the room of a code. Raises ClosedError if there is none."""
        room = await self._found(code)
        if not room.parts:
            raise ClosedError("No class has this code now. A code has four letters and digits.")
        return self._asked(room)

    async def led(self, code: str, key: str) -> ClassRoom:
        """Return the room of a key. Raises ClosedError for another key, also if there is no such room."""
        room = await self._found(code)
        if not is_key(key, room.parts.get("key", b"")):
            raise ClosedError("The class was lost. Press T: the phones come back.")
        return self._asked(room)

    async def _found(self, code: str) -> ClassRoom:
        """Return the room from here or from the store; it has no parts if there is none."""
        if code in self.rooms:
            return self.rooms[code]
        room, nobody = ClassRoom(code, {}), ClassRoom(code, {})
        self._coming.setdefault(code, []).append(room)
        try:
            parts = await self.store.parts(code) if code else {}
        finally:
            coming = self._coming.get(code, [])
            is_open = room in coming
            self._coming[code] = [one for one in coming if one is not room]
            if not self._coming[code]:
                del self._coming[code]
        room.parts = {**parts, **room.parts}
        return room if parts and is_open else nobody

    def _asked(self, room: ClassRoom) -> ClassRoom:
        """Note that a room is in use. Return the stored room with its code; if there is none, store this one."""
        there = self.rooms.setdefault(room.code, room)
        there.asked = monotonic()
        return there

    async def obey(self, room: ClassRoom, order: Order, network: str = "") -> None:
        """Execute an order of the instructor's page, from `network`. Raises ValueError, with a reason."""
        match order:
            case RunClock():
                now = 1000 * time()
                at = min(max(order.at, now - MOST_BEHIND), now + MOST_AHEAD)
                await self._keep(room, clock=msgspec.structs.replace(order, at=at))
            case HandWalk(name=name, text=text):
                await self._take(room, name, text, network)
            case PutQuestion():
                await self._put(room, order)
            case ShowAnswer() | CloseVote() | AskSure() | CountDown():
                await self._amend(room, order)
            case Moderate():
                moderation = room.part("moderation", Moderation) or Moderation()
                await self._keep(room, moderation=moderation.after(order, _question(room.question)))
                await self.store.publish(room.code, {"answers": b"true"})
            case Withdraw():
                await self._keep(room, question=NOTHING_PUT)
            case RestoreAnswers(answers=answers):
                await self._restore(room, answers)
            case DescribeScreen():
                await self._keep(room, screen=order)
            case EndRoom():
                with suppress(UnreachableError, FullError):  # end the class even if the store cannot count this
                    for ended in (room.parts["key"], room.code.encode()):
                        await self.store.count(_ended(ended), LIFE)
                await self.store.end(room.code)

    async def _put(self, room: ClassRoom, order: PutQuestion) -> None:
        """Ask the class a question. If it is the current one, it keeps its settings."""
        put, walk, step, asked = room.question, order.walk, order.step, order.vote
        same = (put.walk, put.step) == (walk, step)
        again = max(put.vote, min(asked, put.vote + 1, LAST))  # a repeated order has no effect
        vote = again if asked and same else put.vote if same and put.lesson is None else asked or FIRST
        is_same = same and vote == put.vote
        answered = order.answered or (is_same and (put.lesson is not None or put.answered))
        settings: dict[str, Any] = {
            "closed": answered or (is_same and put.closed),
            "answered": answered,
            "sure": same and put.sure,
        }
        if is_same:
            settings |= {"until": put.until, "closes": put.closes}
        asked_again = self.bank_of(room).put(walk, step, vote)
        await self._keep(room, question=msgspec.structs.replace(asked_again, **settings))

    async def _amend(self, room: ClassRoom, order: ShowAnswer | CloseVote | AskSure | CountDown) -> None:
        """Change the current question. Raises ValueError, with a reason, if there is none."""
        put, changed = room.question, dict[str, Any]()
        if not put.step:
            raise ValueError("No question is open now.")
        match order:
            case ShowAnswer():
                lesson = self.bank_of(room).lesson(Given(walk=put.walk, step=put.step))
                changed = {"lesson": lesson, "answered": False, "split": await self._split(room)}
            case CloseVote():
                changed = {"closed": True}
            case AskSure():
                changed = {"sure": True}
            case CountDown(seconds=seconds, closes=closes):
                now = 1000 * time()
                until = min(max(put.until, now) + 1000 * seconds, now + LONGEST_COUNT) if seconds else put.until
                changed = {"until": until, "closes": closes}
        await self._keep(room, question=msgspec.structs.replace(put, **changed))

    async def show(self, room: ClassRoom, picture: SentPicture) -> None:
        await self._keep(room, picture=picture)

    async def _take(self, room: ClassRoom, name: str, text: str, network: str) -> None:
        """Read a walk from the instructor's file, once. Raises ValueError, with a reason, if it is invalid."""
        own = {**room.own, name: text}
        if own == room.own:
            return
        if len(own) > MOST_OWN:
            raise ValueError(f"A class can keep {MOST_OWN} walks from files; this is one too many.")
        asked = name, text
        if not room.reading:
            room.reading = asked, asyncio.ensure_future(self.bank.try_own(name, text, network))
        elif room.reading[0] != asked:
            raise BusyError("Another walk is being read. Try again in a moment.")
        reading = room.reading[1]  # a repeated order waits for the first reading
        try:
            walk = await reading
        finally:
            if room.reading and room.reading[1] is reading:
                room.reading = None
        room.walks = {**room.walks, (name, text): walk}
        await self._keep(room, walks={**room.own, name: text})

    async def _restore(self, room: ClassRoom, answers: Mapping[str, Voted]) -> None:
        """Restore answers that a server has lost, without replacing newer ones. They are judged when they are read.

        Raises ValueError, with a reason, for an unknown question and for too many answers. If this server did not
        give the name of an answer, the answer counts towards the limit of the phones that are here.
        """
        bank, now = self.bank_of(room), round(time())
        for walk, step in {(given.walk, given.step) for given in answers.values()}:
            bank.step(walk, step)
        kept = await self.slices.map(lambda given: _unjudged(given, now), answers.values())
        left_out = 0
        for voter, given, answer in zip(answers, answers.values(), kept, strict=True):
            most = MOST_VOTES if self._keys.is_given(voter, room.parts["key"]) else self._most(room)
            left_out += not await self.store.vote(room.code, _question(given), voter, answer, most, replace=False)
        await self.store.publish(room.code, {"answers": b"true"})
        put = room.question
        if put.lesson:
            await self._keep(room, question=msgspec.structs.replace(put, split=await self._split(room)))
        if left_out:
            raise ValueError(f"{left_out} answers were not kept: more than the phones of this class can have given.")

    async def copied(self, room: ClassRoom, question: str) -> dict[str, Voted]:
        """Return the answers to a vote by voter, for the copies on the instructor's page."""
        votes = await self.store.votes(room.code, question)
        return dict(zip(votes, await self.slices.map(self.bank.voted, votes.values()), strict=True))

    def bank_of(self, room: ClassRoom) -> QuestionBank:
        """Return the questions of the server's walks and of the walks from the instructor's files."""
        own = room.parts.get("walks", b"")
        if not room.bank or room.bank[0] != own:
            room.walks = self.bank.read_own(room.own, room.walks)
            room.bank = own, self.bank.taking(room.walks) if own else self.bank
        return room.bank[1]

    async def _keep(self, room: ClassRoom, **parts: object) -> None:
        await self.publish(room, {name: msgspec.json.encode(part) for name, part in parts.items()})

    async def publish(self, room: ClassRoom, parts: Parts) -> None:
        """Send new parts to the followers of a room: here at once, at other replicas through the store."""
        room.deliver(parts)
        try:
            await self.write(room, parts)
        except UnreachableError:
            pass
        except ClosedError:  # the store has lost the room, or the class is over
            if self.rooms.get(room.code) is not room:
                raise

    async def decide(self, room: ClassRoom, digits: str, is_in: bool) -> None:
        """Accept or reject the remote control with these digits. Raises ValueError, with a reason, if none has."""
        await self.publish(room, decided(room.parts, digits, is_in))

    async def write(self, room: ClassRoom, parts: Parts) -> None:
        """Store parts that the followers here already have, and send them to the other replicas."""
        room.unsaved |= parts
        if not await self.store.keep(room.code, {**parts, "by": self._name}):
            raise ClosedError("This class is over.")
        room.unsaved = {name: part for name, part in room.unsaved.items() if parts.get(name) is not part}

    async def vote(self, room: ClassRoom, voter: str, vote: Given) -> None:
        """Store an answer. Raises ValueError, with a reason, if it is late or invalid.

        If there are more answers than phones can have given, the answer of the newest absent token is removed.
        """
        put = room.question
        if (put.walk, put.step, put.vote) != (vote.walk, vote.step, vote.vote) or put.lesson or put.closed:
            raise ValueError("This question is closed.")
        judged = msgspec.structs.replace(self.bank_of(room).judge(vote), at=round(time()), here=room.here)
        question, answer = _question(put), msgspec.json.encode(judged)
        room.peak = max(room.peak, room.followers)
        most = self._most(room)
        if not await self.store.vote(room.code, question, voter, answer, most):
            gone = set(await self.store.votes(room.code, question)) - room.names - await self.store.named(room.code)
            if not gone:
                raise ValueError("No more answers can be counted for this question.")
            await self.store.unvote(room.code, question, max(gone))
            await self.store.vote(room.code, question, voter, answer, most)
        await self.store.publish(room.code, {"answers": b"true"})

    @staticmethod
    def _most(room: ClassRoom) -> int:
        """Return the largest number of answers that the phones of this class can have given to a vote."""
        return min(MOST_VOTES, SPARE + 2 * room.peak)

    def token(self, room: ClassRoom) -> str:
        """Return a token for a new follower."""
        return self._keys.new_token(room.parts["key"])

    async def follows(self, room: ClassRoom, name: str) -> bool:
        """Return True if somebody with this name follows, here or at another replica."""
        return room.follows(name) or name in await self.store.named(room.code)

    async def given(self, room: ClassRoom, question: str) -> list[Judged]:
        """Return the answers to a vote, or the last known ones if the store is unavailable."""
        votes = await self.votes(room, question)
        return [one for one in await self.slices.map(self.bank_of(room).read, votes.values()) if one]

    async def votes(self, room: ClassRoom, question: str) -> Parts:
        """Return the stored answers to a vote by voter, or the last known ones if the store is unavailable."""
        try:
            room.votes[question] = await self.store.votes(room.code, question)
        except UnreachableError:
            if question not in room.votes:
                raise
        return room.votes[question]

    async def tally(self, room: ClassRoom) -> Tally | None:
        put = room.question
        if not put.step:
            return None
        bank, count = self.bank_of(room), partial(self.bank_of(room).counted, put.walk, put.step)
        votes = await self.given(room, _question(put))
        (now,) = await self.slices.map(count, [votes])
        if now.words and (moderation := room.part("moderation", Moderation)):
            now = msgspec.structs.replace(now, words=moderation.moderated(now.words, _question(put)))
        before = None
        if put.vote > FIRST:
            first = await self.given(room, _question(msgspec.structs.replace(put, vote=FIRST)))
            (before,) = await self.slices.map(count, [first])
        (features,) = await self.slices.map(partial(bank.features, put.walk), [put.step])
        right = sum(one.right for one in votes)
        return Tally(
            walk=put.walk, step=put.step, vote=put.vote, now=now, before=before, features=features, right=right
        )

    async def _split(self, room: ClassRoom) -> Split | None:
        """Return the counts of the current question for the phones, or None if the store is unavailable."""
        with suppress(UnreachableError):
            if tally := await self.tally(room):
                now, judges = tally.now, self.bank_of(room).judges(tally.walk, tally.step)
                return Split(
                    answered=now.answered, right=tally.right, judges=judges, options=now.options, having=now.having
                )
        return None

    async def count(self, room: ClassRoom) -> None:
        """Send the number of answers to the current question to everyone in the room."""
        room.recount = False
        answered = len(await self.votes(room, _question(room.question))) if room.question.step else 0
        if answered != room.answered:
            room.change(answered=answered)

    def leave(self, room: ClassRoom) -> None:
        """Forget a room that nobody at this replica uses any more."""
        if not room.used and self.rooms.get(room.code) is room:
            del self.rooms[room.code]

    def receive(self, code: str, parts: Parts) -> None:
        """Pass on an update from the store; one without parts means that the room has ended."""
        room = self.rooms.get(code)
        if not parts:
            self.rooms.pop(code, None)
            self._coming.pop(code, None)
            if room:
                room.end()
        elif parts.get("by") != self._name:
            for one in [*self._coming.get(code, []), *([room] if room else [])]:
                one.deliver(parts)


def _question(of: PutTo | Given) -> str:
    return f"{of.walk}/{of.step}/{of.vote}"


def _unjudged(given: Voted, now: float) -> bytes:
    """Return a restored answer in its stored form, dated no later than now."""
    fields = msgspec.structs.asdict(given) | {"at": min(given.at, now)}
    return msgspec.json.encode(Judged(**fields))


def _locks(key: str, owner: str) -> Parts:
    """Return the parts of a new room: the hashes of its key and of its QR code's key, and its owner."""
    return {"key": digest(key), "join": digest(join_key(key)), **({OWNER: owner.encode()} if owner else {})}


def _ended(name: bytes) -> str:
    """Return the name that counts the end of a room, by its code or by the digest of its key."""
    return f"ended {name.decode()}"
