"""Messages between browser and server. The server answers each message of the browser by its number."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import Meta, Struct

from components.language.blocks import Block
from components.language.controls import Panel, Setting
from components.language.picture import Held, Onward, PagePicture, Progress
from components.language.state import State
from components.language.text import Html
from components.language.walk import Lesson, WalkSheet

SaidName: TypeAlias = Annotated[str, Meta(max_length=100)]
Text: TypeAlias = Annotated[str, Meta(max_length=1000)]
HEIGHTS = 101
"""Points of a sketch, evenly spaced from the left end of its frame to the right."""

Height: TypeAlias = Annotated[int, Meta(ge=-100, le=1100)]
"""A height in thousandths of the frame, from its lower edge."""
Sketched: TypeAlias = Annotated[list[Height | None], Meta(max_length=101)]
"""A sketched curve: its heights; null in gaps."""


RowNumbers: TypeAlias = Annotated[list[Annotated[float, Meta(ge=-1e9, le=1e9)]], Meta(max_length=1250)]
"""One column of a piece of a measured record."""


class Given(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """An answer to a step of a walk: the index of an option, a number or a few words as text, a place on the axis, or
    curves by name.

    `seed` chooses the step's numbers; 0 means the numbers of the file. `vote` counts how often the class has voted on
    the question, from 1 on. `sure` is the student's confidence: 1 for a guess, 2 for fairly, 3 for certain, 0 if not
    given.
    """

    walk: SaidName
    step: SaidName
    seed: Annotated[int, Meta(ge=0, le=1000)] = 0
    vote: Annotated[int, Meta(ge=1, le=9)] = 1
    option: Annotated[int, Meta(ge=0, le=9)] | None = None
    text: Annotated[str, Meta(max_length=80)] = ""
    value: float | None = None
    curves: Annotated[dict[SaidName, Sketched], Meta(max_length=2)] = {}
    sure: Annotated[int, Meta(ge=0, le=3)] = 0


class FromBrowser(Struct, frozen=True, kw_only=True, tag_field="type", forbid_unknown_fields=True):
    """Any message of the browser."""

    number: int = 0


class SetValues(FromBrowser, frozen=True, kw_only=True, tag="set"):
    """Sets quantities by name, in SI: from sliders and handles.

    While a hand is dragging (`holding` is true), neither the axes in `along` nor the scale of the stage change; other
    axes may grow. At the end of a drag or key press (false), a mostly empty axis is fitted again, unless the hand moved
    `along` it. If `holding` is None, the value may still change.
    """

    values: Annotated[dict[SaidName, float | None], Meta(max_length=50)]
    holding: bool | None = None
    along: Annotated[tuple[SaidName, ...], Meta(max_length=8)] = ()


class Typed(FromBrowser, frozen=True, kw_only=True, tag="typed"):
    """Sets a quantity by the text of its field, in the unit that it shows."""

    name: SaidName
    text: Text


class Act(FromBrowser, frozen=True, kw_only=True, tag="act"):
    """Presses a button."""

    name: SaidName


class Choose(FromBrowser, frozen=True, kw_only=True, tag="choose"):
    """Sets a choice by the word of its option, or a list by its words."""

    name: SaidName
    value: Text | Annotated[list[SaidName], Meta(max_length=50)]


class RunOrder(FromBrowser, frozen=True, kw_only=True, tag="run"):
    """Starts or ends a measurement."""

    order: Literal["start", "cancel", "skip"]


class Open(FromBrowser, frozen=True, kw_only=True, tag="open"):
    """Opens a state in this session. If `carried`, another scene takes over the parameters that it shares with earlier
    scenes. If `keeps`, the current frame stays, so that two pictures of one scene can be compared."""

    state: State
    carried: bool = False
    keeps: bool = False


class GiveAnswer(FromBrowser, frozen=True, kw_only=True, tag="given"):
    """Gives an answer to a step of a walk."""

    answer: Given


class RunWalk(FromBrowser, frozen=True, kw_only=True, tag="walk"):
    """Runs a walk from the text of its file, in this session only."""

    name: SaidName
    text: Annotated[str, Meta(max_length=48_000)]


class Lead(FromBrowser, frozen=True, kw_only=True, tag="lead"):
    """Sends the pictures of this page to the followers of a class from now on; `key` permits the page to lead."""

    code: Annotated[str, Meta(max_length=8)]
    key: SaidName


class AskCsv(FromBrowser, frozen=True, kw_only=True, tag="csv"):
    """Requests the numbers of all plots as CSV; `page` is the address that the link in the file begins with."""

    page: Text = ""


class AskAbout(FromBrowser, frozen=True, kw_only=True, tag="about"):
    """Requests the known errors of the displayed numbers."""


class SendRows(FromBrowser, frozen=True, kw_only=True, tag="rows"):
    """Sends a piece of a measured record: times in s that never decrease, and for each mass a column of displacements
    in m, or of their first or second derivative, as `derivative` says.

    The pieces have the numbers 0 to `of` - 1 and arrive in this order; after the last one the server fits a motion
    with as many frequencies as columns. Each row is the mean of `size` neighbouring rows of the file. A session keeps
    no rows after the fit.
    """

    piece: Annotated[int, Meta(ge=0, le=15)]
    of: Annotated[int, Meta(ge=1, le=16)]
    size: Annotated[int, Meta(ge=1, le=10)] = 1
    derivative: Annotated[int, Meta(ge=0, le=2)] = 0
    t: RowNumbers
    columns: Annotated[list[RowNumbers], Meta(min_length=1, max_length=2)]


class CancelFit(FromBrowser, frozen=True, kw_only=True, tag="cancel_fit"):
    """Cancels the fit that waits for its turn; the page no longer waits for its answer."""


BrowserMessage: TypeAlias = (
    SetValues
    | Typed
    | Act
    | Choose
    | RunOrder
    | Open
    | GiveAnswer
    | RunWalk
    | Lead
    | AskCsv
    | AskAbout
    | SendRows
    | CancelFit
)


class ServerMessage(Struct, frozen=True, kw_only=True, tag_field="type"):
    """Any message of the server; `answer` is the number of the message that it answers."""

    answer: int | None = None


class Shown(ServerMessage, frozen=True, kw_only=True, tag="shown"):
    """The current page.

    `sheet` is the address of the scene's sheet, `held` the compared picture, `settings` the values of the controls by
    parameter, `preset` the name of the current preset, `here` the buttons whose values the scene has now, `errors` the
    reasons for rejected values of the last message by parameter, `problems` the rejected parts of a link, `query` the
    link of this state.
    """

    scene: str
    sheet: str
    view: PagePicture
    held: Held | None = None
    settings: dict[str, Setting]
    state: State
    preset: str | None
    here: tuple[str, ...]
    errors: dict[str, str]
    problems: tuple[str, ...]
    query: str
    progress: Progress | None


class Kept(ServerMessage, frozen=True, kw_only=True, tag="kept"):
    """The answer to the end of a drag if the page does not change."""


class File(ServerMessage, frozen=True, kw_only=True, tag="file"):
    """A file to save, and its media type."""

    name: str
    kind: str
    content: bytes


class AboutPoint(Struct, frozen=True, kw_only=True):
    """One number in twenty digits: as drawn, the exact value, and the error in ulp."""

    name: Html
    place: Html
    drawn: str
    true: str
    off: str


class AboutTable(Struct, frozen=True):
    """Numbers with the sentence that bounds their errors."""

    bound: Html
    rows: tuple[AboutPoint, ...]


class AboutNumbers(ServerMessage, frozen=True, kw_only=True, tag="about"):
    """The known errors of the displayed numbers."""

    reading: Html
    tables: tuple[AboutTable, ...]
    notes: tuple[Html, ...]


class Taught(ServerMessage, frozen=True, kw_only=True, tag="taught"):
    """The lesson of a step, in answer to `GiveAnswer`. `refused` is the reason if there is none; if `is_busy`, the
    server has no time now and the page may ask again."""

    walk: str
    step: str
    lesson: Lesson | None
    refused: str = ""
    is_busy: bool = False


class Walking(ServerMessage, frozen=True, kw_only=True, tag="walking"):
    """A walk that this session runs. `refused` says what is wrong with its file; if `is_busy`, the server has no time
    now."""

    sheet: WalkSheet | None
    refused: str = ""
    is_busy: bool = False


class FittedNumber(Struct, frozen=True, kw_only=True):
    """A number of a fit and its standard error, as text; `error` is "" if it has none."""

    symbol: Html
    name: str
    value: str
    error: str
    unit: str


class FittedColumn(Struct, frozen=True, kw_only=True):
    """A fitted column, in SI units: the displacement is the sum over the frequencies of e^(-decay t) (C cos omega t +
    S sin omega t), with t counted from the first row. The rows are its derivative plus offset + drift t; `scatter` is
    the standard deviation of their residuals."""

    C: tuple[float, ...]
    S: tuple[float, ...]
    offset: float
    drift: float
    scatter: float


class FittedMotion(Struct, frozen=True, kw_only=True):
    """A fitted motion: the frequencies in rad/s and decays in 1/s that its columns share."""

    omega: tuple[float, ...]
    decay: tuple[float, ...]
    columns: tuple[FittedColumn, ...]


class FittedParameters(Struct, frozen=True, kw_only=True):
    """The parameters of a scene that follow from a fit: `values` as they are, and `per_mass` for each kg of the
    parameter `mass`, which the scene keeps."""

    mass: str
    values: dict[str, float | str]
    per_mass: dict[str, float]


class Fitted(ServerMessage, frozen=True, kw_only=True, tag="fitted"):
    """The answer to `SendRows`.

    `piece` is the number of the piece that the server needs next, 0 to begin again. The answer to the last piece has
    the fit, or in `refused` the reason why there is none; if `is_busy`, the server has no time now. `parameters` is
    None if the scene has no motion like the fitted one.
    """

    piece: int = 0
    motion: FittedMotion | None = None
    parameters: FittedParameters | None = None
    numbers: tuple[FittedNumber, ...] = ()
    sentences: tuple[str, ...] = ()
    refused: str = ""
    is_busy: bool = False


AnyServerMessage: TypeAlias = Shown | Kept | File | AboutNumbers | Taught | Walking | Fitted


class ViewTab(Struct, frozen=True, kw_only=True):
    """A view of a scene: its name in links, the name on its tab, its task, the parameters whose controls are the first
    of the panel, and the parts that its task is about."""

    word: str
    name: str
    task: Html
    keys: tuple[str, ...]
    names: tuple[str, ...]


class SceneSheet(Struct, frozen=True, kw_only=True):
    """Everything about a scene that is the same for every visitor: an immutable file.

    `preset_dictionary` compresses the messages about the scene. `hidden` are the curves that
    are switched off at first. `spoken` maps names to texts with {live numbers} that are read aloud after a change. A
    scene with `views` shows one at a time, chosen by the parameter `view`; other scenes always show the whole paper.
    """

    slug: str
    title: str
    headline: str
    hidden: tuple[str, ...]
    runs: bool
    about: bool
    onward: tuple[Onward, ...]
    preset_dictionary: str
    spoken: dict[str, str]
    views: tuple[ViewTab, ...]
    paper: Block
    panel: Panel
