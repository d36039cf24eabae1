"""The language of a live class: what the instructor's page asks of a room, what followers answer, what all are told."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import Meta, Struct

from components.language.messages import Given, SaidName, Sketched
from components.language.text import Html
from components.language.walk import Lesson, StepCard

YEAR_2100 = 4_102_444_800
"""In seconds since 1970."""
Deed: TypeAlias = Literal[
    "next",
    "back",
    "show",
    "votes",
    "derive",
    "again",
    "poll",
    "sure",
    "countdown",
    "closing",
    "blank",
    "close",
    "go",
    "end",
]
"""Buttons of a remote control."""


class Ordered(Struct, frozen=True, kw_only=True, tag_field="type", forbid_unknown_fields=True):
    """Anything that the instructor's page asks of the room."""


class RunClock(Ordered, frozen=True, kw_only=True, tag="clock"):
    """Sets the class's clock: the lecture's stood at `t` at the server's time `at`, in ms, and goes on by `rate` a
    second, up to `end`: in the unit of the time axis."""

    t: float
    rate: float
    end: float
    at: float


class PutQuestion(Ordered, frozen=True, kw_only=True, tag="put"):
    """Puts the question of a step to all; where `vote` is given, as that vote: one more than before, or the last one of
    a question that comes back. A vote that was `answered` takes no more answers: the class has seen the answer."""

    walk: SaidName
    step: SaidName
    vote: Annotated[int, Meta(ge=0, le=9)] = 0
    answered: bool = False


class HandWalk(Ordered, frozen=True, kw_only=True, tag="walk"):
    """Hands in a walk from the instructor's own file, whose questions can be put from now on."""

    name: SaidName
    text: Annotated[str, Meta(max_length=48_000)]


class ShowAnswer(Ordered, frozen=True, kw_only=True, tag="show"):
    """Shows all the lesson of the step; no answer is taken any more."""


class CloseVote(Ordered, frozen=True, kw_only=True, tag="close"):
    """Closes the vote: no answer is taken until the question is put as another vote. Nothing is shown."""


class AskSure(Ordered, frozen=True, kw_only=True, tag="sure"):
    """Asks of those who answer the question that is put how sure they are."""


class CountDown(Ordered, frozen=True, kw_only=True, tag="countdown"):
    """Counts down for the question that is put: so many seconds, or so many more where it counts already. At 0 the vote
    `closes`, or the count just ends."""

    seconds: Annotated[int, Meta(ge=0, le=600)] = 0
    closes: bool = False


class Withdraw(Ordered, frozen=True, kw_only=True, tag="withdraw"):
    """Withdraws the question: none is open."""


class Voted(Given, frozen=True, kw_only=True):
    """An answer as a class keeps it: when it was given, in seconds since 1970, and how many were here."""

    at: Annotated[float, Meta(ge=0, le=YEAR_2100)] = 0.0
    here: Annotated[int, Meta(ge=0, le=10_000_000)] = 0


class RestoreAnswers(Ordered, frozen=True, kw_only=True, tag="restore"):
    """Gives back answers that the server has lost, by the names in the tokens of those who gave them: the
    instructor's page keeps them. None takes the place of one that is there."""

    answers: dict[Annotated[str, Meta(pattern=r"^[0-9a-f]{11}[A-Za-z0-9_-]{8}$")], Voted]


class DescribeScreen(Ordered, frozen=True, kw_only=True, tag="screen"):
    """Describes the instructor's screen for a remote control: the words of the next press, the other buttons that do
    something now, and whether the screen is blank."""

    next: Annotated[str, Meta(max_length=60)] = ""
    blank: bool = False
    deeds: Annotated[tuple[Deed, ...], Meta(max_length=20)] = ()


class EndRoom(Ordered, frozen=True, kw_only=True, tag="end"):
    """Ends the class: the room and all that was answered are forgotten."""


Order: TypeAlias = (
    RunClock
    | HandWalk
    | PutQuestion
    | ShowAnswer
    | CloseVote
    | AskSure
    | CountDown
    | Withdraw
    | RestoreAnswers
    | DescribeScreen
    | EndRoom
)


class Split(Struct, frozen=True, kw_only=True):
    """The answers to a vote for those who gave them: how many, how many are right, how many chose each option or have
    each of the features asked for. It `judges` where answers are right or wrong."""

    answered: int
    right: int
    judges: bool
    options: tuple[int, ...] = ()
    having: tuple[int, ...] = ()


class PutTo(Struct, frozen=True, kw_only=True):
    """The question that is put: a step of a walk, its card, its place in the lecture, the vote from 1 on, and what it
    teaches once the answer is shown; a vote that is `closed` takes no answers; one that was `answered` had its answer
    shown, which is hidden again; `sure` asks how sure an answer is; a countdown ends at the
    server's time `until`, in ms, if it is not 0, and then the vote `closes` or does not; `split` comes with the answer.
    Without a step none is."""

    walk: str = ""
    step: str = ""
    card: StepCard | None = None
    place: str = ""
    vote: int = 1
    closed: bool = False
    answered: bool = False
    sure: bool = False
    until: float = 0.0
    closes: bool = False
    lesson: Lesson | None = None
    split: Split | None = None


class SentPicture(Struct, frozen=True, kw_only=True):
    """The picture of the instructor's page: a packed `Shown` and the sheet whose usual text it refers to."""

    sheet: str
    data: bytes


class News(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """The changes in a room since the last news; the first that a follower hears has all of it.

    `number` is this state's, `here` says how many follow, `answered` how many have answered the question, `lost` that
    the store which replicas share does not answer, `ended` that the class is over. The instructor's page alone hears of
    `answers` given, of the `deed` of a remote control, with the `step` that it is to go to, or that the lead was taken
    over, and of all `remotes` that wait to be let in, by the two digits that each shows.
    """

    number: str
    picture: SentPicture | None = None
    clock: RunClock | None = None
    question: PutTo | None = None
    here: int | None = None
    answered: int | None = None
    lost: bool | None = None
    ended: bool = False
    answers: bool = False
    deed: Deed | Literal["", "taken"] = ""
    step: str = ""
    remotes: tuple[str, ...] | None = None


class Opened(Struct, frozen=True, kw_only=True):
    """A room: its code, its key, which its instructor's browser keeps, and the address to join at, also as a QR code
    (SVG)."""

    code: str
    key: str
    address: str
    square: str


class Reopen(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Opens the room of a code anew, with its key, where a server has lost it: as often as it is asked for. `control`
    is what the page was told when it let a remote control in."""

    control: Annotated[str, Meta(pattern="^([0-9a-f]{64})?$")] = ""


class SketchOf(Struct, frozen=True, kw_only=True):
    """One sketch and which of the features asked for it has."""

    curves: dict[str, Sketched]
    has: tuple[bool, ...]


class Counted(Struct, frozen=True, kw_only=True):
    """The answers to one vote: how many, of each option, as numbers or places on the axis of a point, as sketches: some
    hundreds of them, and how many of all have each of the features asked for. `sure` has for each of the three levels
    how many are as sure, and how many of these are right; nothing where nobody has said it."""

    answered: int
    options: tuple[int, ...] = ()
    numbers: tuple[float, ...] = ()
    sketches: tuple[SketchOf, ...] = ()
    having: tuple[int, ...] = ()
    sure: tuple[tuple[int, int], ...] = ()


class Tally(Struct, frozen=True, kw_only=True):
    """The answers to the question that is put, for the instructor; `before` is the first vote where this is another,
    `features` what a right sketch has, by name, `right` how many answers are."""

    walk: str
    step: str
    vote: int
    now: Counted
    before: Counted | None
    features: tuple[Html, ...]
    right: int


class RemoteView(Struct, frozen=True, kw_only=True):
    """The contents of a remote control: the question that is put, how many are here, the count of its answers without
    single numbers and sketches, its lesson also before the answer is shown, whether its answers are right or wrong, the
    instructor's notes, and the instructor's screen. `number` is the room's state that it shows."""

    number: str
    question: PutTo
    here: int
    tally: Tally | None = None
    lesson: Lesson | None = None
    judges: bool = False
    notes: tuple[Html, ...] = ()
    screen: DescribeScreen | None = None


class VoteSummary(Struct, frozen=True, kw_only=True):
    """The answers to a vote by their number, and how many of them were right."""

    vote: int
    answered: int
    right: int


class Stored(Struct, frozen=True, kw_only=True):
    """The number of answers that a class stores, and of the questions that they answer."""

    answers: int
    questions: int


class StepSummary(Struct, frozen=True, kw_only=True):
    """A question that a class has answered, a step of a walk: its place there, from 1 on, its votes, and the wrong
    answer that was given most often in the last, by how many; "" where that cannot be said in a few words."""

    walk: str
    step: str
    place: int
    question: Html
    votes: tuple[VoteSummary, ...]
    mistake: str
    mistaken: int


class Entered(Struct, frozen=True, kw_only=True):
    """A follower's way in: the code as it is written, and the token under which answers are kept."""

    code: str
    token: str


class Ticket(Struct, frozen=True, kw_only=True):
    """A ticket for a remote control, good once: its address, also as a QR code (SVG); the phone sends the secret
    alone."""

    address: str
    square: str = ""


class Paired(Struct, frozen=True, kw_only=True):
    """A remote control that waits: the two digits that it shows, and the key that is good once it has been let in."""

    digits: str
    key: str


class HandOver(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Asks for a word with which another computer leads the class from now on, at the page of this link. `shown` has
    the vote after which the class saw the answer, by question."""

    query: Annotated[str, Meta(max_length=4000)]
    shown: Annotated[dict[Annotated[str, Meta(max_length=201)], int], Meta(max_length=100)] = {}


class TakeOver(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Takes the lead of a class with such a word, good once."""

    word: Annotated[str, Meta(max_length=20)]


class TakenOver(Opened, frozen=True, kw_only=True):
    """A room that another computer led, the link of the page that it showed, the answers that the class saw, the walks
    from its files, by name, and what was kept of its remote control."""

    query: str
    shown: dict[str, int]
    walks: dict[str, str]
    control: str


class Confirmed(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The digits that the instructor has seen on the phone."""

    digits: Annotated[str, Meta(max_length=2)]


class Done(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A press of a button on a remote control; `step` is the one to go to. `end` asks on the lecturer's screen
    whether to end the class, and ends it if that is asked already."""

    deed: Deed
    step: SaidName = ""


class Listed(Struct, frozen=True, kw_only=True):
    """A step in the contents of a remote control, by its title."""

    step: str
    title: Html
