"""The messages of a live class: requests of the instructor's page, answers of followers, and what the server sends."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import Meta, Struct

from components.language.messages import Given, SaidName, Sketched
from components.language.text import Html
from components.language.walk import Lesson, StepCard

YEAR_2100 = 4_102_444_800
"""A time in seconds since 1970."""
Deed: TypeAlias = Literal[
    "next",
    "back",
    "show",
    "derive",
    "again",
    "poll",
    "sure",
    "countdown",
    "closing",
    "blank",
    "close",
    "go",
    "allow",
    "remove",
    "end",
]
"""Buttons of a remote control."""


class Ordered(Struct, frozen=True, kw_only=True, tag_field="type", forbid_unknown_fields=True):
    """Any request of the instructor's page to the room."""


class RunClock(Ordered, frozen=True, kw_only=True, tag="clock"):
    """Sets the class's clock: it showed `t` at the server's time `at`, in ms, and advances by `rate` per second, up to
    `end`; `t`, `rate` and `end` are in the unit of the time axis."""

    t: float
    rate: float
    end: float
    at: float


class PutQuestion(Ordered, frozen=True, kw_only=True, tag="put"):
    """Asks the class the question of a step. `vote` is the number of the vote: one more for a new vote, the same as
    last time if the instructor returns to the question. If `answered`,
    the class has seen the answer and the vote takes no more answers.
    """

    walk: SaidName
    step: SaidName
    vote: Annotated[int, Meta(ge=0, le=9)] = 0
    answered: bool = False


class HandWalk(Ordered, frozen=True, kw_only=True, tag="walk"):
    """Adds a walk from the instructor's own file, so that its questions can be asked."""

    name: SaidName
    text: Annotated[str, Meta(max_length=48_000)]


class ShowAnswer(Ordered, frozen=True, kw_only=True, tag="show"):
    """Shows the lesson of the step to all and ends the vote."""


class CloseVote(Ordered, frozen=True, kw_only=True, tag="close"):
    """Closes the vote without showing the answer: the question takes no more answers until the next vote on it."""


class AskSure(Ordered, frozen=True, kw_only=True, tag="sure"):
    """Asks the followers how sure they are of their answers to the current question."""


class CountDown(Ordered, frozen=True, kw_only=True, tag="countdown"):
    """Starts a countdown for the current question, or adds seconds to a running one. At its end the vote closes if
    `closes`."""

    seconds: Annotated[int, Meta(ge=0, le=600)] = 0
    closes: bool = False


class Moderate(Ordered, frozen=True, kw_only=True, tag="moderate"):
    """Shows the hall an answer in words, with all answers equal to it, or removes them."""

    text: Annotated[str, Meta(max_length=80)]
    shows: bool


class Withdraw(Ordered, frozen=True, kw_only=True, tag="withdraw"):
    """Withdraws the question, so that none is open."""


class Voted(Given, frozen=True, kw_only=True):
    """An answer as a class stores it, with its time in seconds since 1970 and the number of followers at that time."""

    at: Annotated[float, Meta(ge=0, le=YEAR_2100)] = 0.0
    here: Annotated[int, Meta(ge=0, le=10_000_000)] = 0


class RestoreAnswers(Ordered, frozen=True, kw_only=True, tag="restore"):
    """Restores answers that the server has lost, by the names in their followers' tokens; the instructor's page has
    copies. Existing answers are not replaced."""

    answers: dict[Annotated[str, Meta(pattern=r"^[0-9a-f]{11}[A-Za-z0-9_-]{8}$")], Voted]


class DescribeScreen(Ordered, frozen=True, kw_only=True, tag="screen"):
    """Describes the instructor's screen for a remote control: the label of the button Next, the other active buttons,
    and whether the screen is blank."""

    next: Annotated[str, Meta(max_length=60)] = ""
    blank: bool = False
    deeds: Annotated[tuple[Deed, ...], Meta(max_length=20)] = ()


class EndRoom(Ordered, frozen=True, kw_only=True, tag="end"):
    """Ends the class and deletes the room with all its answers."""


Order: TypeAlias = (
    RunClock
    | HandWalk
    | PutQuestion
    | ShowAnswer
    | CloseVote
    | AskSure
    | CountDown
    | Moderate
    | Withdraw
    | RestoreAnswers
    | DescribeScreen
    | EndRoom
)


class Split(Struct, frozen=True, kw_only=True):
    """The result of a vote for the followers: the number of answers, of right ones, and of answers with each option or
    feature. `judges`: answers can be right or wrong."""

    answered: int
    right: int
    judges: bool
    options: tuple[int, ...] = ()
    having: tuple[int, ...] = ()


class PutTo(Struct, frozen=True, kw_only=True):
    """The current question of the class: a step of a walk, its card, its position in the lecture, the number of the
    vote from 1 on, and its lesson once the answer is shown.

    `closed`: the vote takes no more answers. `answered`: its answer was shown before and is hidden again. `sure`:
    followers are asked how sure they are. `until` is the end of a countdown in ms of the server's time, 0 for none; if
    `closes`, the vote closes at that time. `split` comes with the answer. If `step` is empty, there is no question.
    """

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
    """The picture of the instructor's page: a packed `Shown`, and the sheet with the dictionary for its compression."""

    sheet: str
    data: bytes


class News(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """The changes in a room since the last news; a follower's first news has the complete state.

    `number` is the number of this state, `here` the number of followers, `answered` the number of answers to the
    question. `lost`: the store that replicas share does not answer. `ended`: the class is over. Only the instructor's
    page gets the `answers`, the `deed` of a remote control with its `step`, the notice that another computer leads now,
    and all waiting `remotes`, by the two digits on their screens.
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
    """Opens the room of a code again, with its key, after a server has lost it; it may be repeated. `control` is the
    proof that the page got when it admitted a remote control."""

    control: Annotated[str, Meta(pattern="^([0-9a-f]{64})?$")] = ""


class SketchOf(Struct, frozen=True, kw_only=True):
    """One sketch, and its features."""

    curves: dict[str, Sketched]
    has: tuple[bool, ...]


class WordGroup(Struct, frozen=True, kw_only=True):
    """Equal answers in words: the newest of them, how many there are, and whether the instructor shows them."""

    text: str
    count: int
    shown: bool = False


class Counted(Struct, frozen=True, kw_only=True):
    """The answers to one vote: their number, the number for each option, the numbers or places on the axis of a point,
    some hundreds of sketches, and the number of sketches with each feature. `sure` has for each of the three levels of
    confidence the number of answers and of right ones; it is empty if nobody gave a level. `words` are the newest
    groups of equal answers in words, without the removed ones."""

    answered: int
    options: tuple[int, ...] = ()
    numbers: tuple[float, ...] = ()
    sketches: tuple[SketchOf, ...] = ()
    having: tuple[int, ...] = ()
    sure: tuple[tuple[int, int], ...] = ()
    words: tuple[WordGroup, ...] = ()


class Tally(Struct, frozen=True, kw_only=True):
    """The answers to the current question, for the instructor. `before` is the first vote if there are two, `features`
    the features of a right sketch, by name, `right` the number of right answers."""

    walk: str
    step: str
    vote: int
    now: Counted
    before: Counted | None
    features: tuple[Html, ...]
    right: int


class RemoteView(Struct, frozen=True, kw_only=True):
    """The contents of a remote control: the current question, the number of followers, the counted answers without
    single numbers and sketches, the lesson (also before the answer is shown), if the answers can be right or wrong, the
    instructor's notes, and the instructor's screen. `number` is the number of the room's state."""

    number: str
    question: PutTo
    here: int
    tally: Tally | None = None
    lesson: Lesson | None = None
    judges: bool = False
    notes: tuple[Html, ...] = ()
    screen: DescribeScreen | None = None


class VoteSummary(Struct, frozen=True, kw_only=True):
    """The number of answers to a vote, and of right ones."""

    vote: int
    answered: int
    right: int


class Stored(Struct, frozen=True, kw_only=True):
    """The number of stored answers of a class, and of their questions."""

    answers: int
    questions: int


class StepSummary(Struct, frozen=True, kw_only=True):
    """A question that a class has answered: its position in the walk, from 1 on, its votes, and the most frequent wrong
    answer of the last vote with its count; "" if it does not fit into a few words."""

    walk: str
    step: str
    place: int
    question: Html
    votes: tuple[VoteSummary, ...]
    mistake: str
    mistaken: int


class Entered(Struct, frozen=True, kw_only=True):
    """The entry of a follower: the normalised code, and the token under which answers are kept."""

    code: str
    token: str


class Ticket(Struct, frozen=True, kw_only=True):
    """A ticket for one remote control: its address, also as a QR code (SVG). The phone sends only the secret."""

    address: str
    square: str = ""


class Paired(Struct, frozen=True, kw_only=True):
    """A waiting remote control: its two digits, and the key that is valid once the instructor has admitted it."""

    digits: str
    key: str


class HandOver(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Requests a word with which another computer can take over the class; it then opens the page of this link. `shown`
    has
    the number of the vote whose answer the class has seen, by question."""

    query: Annotated[str, Meta(max_length=4000)]
    shown: Annotated[dict[Annotated[str, Meta(max_length=201)], int], Meta(max_length=100)] = {}


class TakeOver(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Takes the lead of a class with such a word, which is valid once."""

    word: Annotated[str, Meta(max_length=20)]


class TakenOver(Opened, frozen=True, kw_only=True):
    """A room that another computer led: the link of its page, the answers that the class saw, the walks from files by
    their names, and the saved state of the remote control."""

    query: str
    shown: dict[str, int]
    walks: dict[str, str]
    control: str


class Confirmed(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Admits a remote control by the digits that the instructor has seen on the phone."""

    digits: Annotated[str, Meta(max_length=2)]


class Done(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A press of a button on a remote control; `step` is the step to open, `text` the answer to allow or remove. The
    first `end` asks the instructor to confirm, the second ends the class."""

    deed: Deed
    step: SaidName = ""
    text: Annotated[str, Meta(max_length=80)] = ""


class Listed(Struct, frozen=True, kw_only=True):
    """A step in the list of steps of a remote control."""

    step: str
    title: Html
