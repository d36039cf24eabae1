"""Messages between browser and server. Each message of the browser is answered under its number."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from msgspec import Meta, Struct

from components.language.blocks import Block
from components.language.controls import Panel, Setting
from components.language.picture import Held, PagePicture, Progress
from components.language.state import State
from components.language.text import Html
from components.language.walk import Lesson, WalkSheet

SaidName: TypeAlias = Annotated[str, Meta(max_length=100)]
Text: TypeAlias = Annotated[str, Meta(max_length=1000)]
HEIGHTS = 101
"""Of a sketch, evenly from the left end of its frame to the right."""

Height: TypeAlias = Annotated[int, Meta(ge=-100, le=1100)]
"""In thousandths of the frame, from its foot."""
Sketched: TypeAlias = Annotated[list[Height | None], Meta(max_length=101)]
"""A sketched curve: its heights, null where there is a gap."""


class Given(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """An answer to a step of a walk: an option by its place, the text of a number, a place on the axis, or curves by
    name.

    `seed` is that of the step's numbers, 0 for those of its file; `vote` counts how often the question has been put to
    a class, from 1 on; `sure` is how sure of it somebody is: 1 for a guess, 2 for fairly, 3 for certain, 0 if not said.
    """

    walk: SaidName
    step: SaidName
    seed: Annotated[int, Meta(ge=0, le=1000)] = 0
    vote: Annotated[int, Meta(ge=1, le=9)] = 1
    option: Annotated[int, Meta(ge=0, le=9)] | None = None
    text: Annotated[str, Meta(max_length=60)] = ""
    value: float | None = None
    curves: Annotated[dict[SaidName, Sketched], Meta(max_length=2)] = {}
    sure: Annotated[int, Meta(ge=0, le=3)] = 0


class FromBrowser(Struct, frozen=True, kw_only=True, tag_field="type", forbid_unknown_fields=True):
    """Anything that the browser says."""

    number: int = 0


class SetValues(FromBrowser, frozen=True, kw_only=True, tag="set"):
    """Sets quantities by name, in SI: from sliders and handles.

    While a hand is `holding` on to what is drawn, the axes that it moves `along` and the scale of the stage stay; the
    others grow. When it has let go, or a slider or key has, an axis that is hardly used is fitted again, but none that
    the hand moved `along`. Without `holding` a value is on its way.
    """

    values: Annotated[dict[SaidName, float | None], Meta(max_length=50)]
    holding: bool | None = None
    along: Annotated[tuple[SaidName, ...], Meta(max_length=8)] = ()


class Typed(FromBrowser, frozen=True, kw_only=True, tag="typed"):
    """Sets a quantity by the text of its field, in the unit that it shows."""

    name: SaidName
    text: Text


class Act(FromBrowser, frozen=True, kw_only=True, tag="act"):
    """Presses a button, which does its action."""

    name: SaidName


class Choose(FromBrowser, frozen=True, kw_only=True, tag="choose"):
    """Sets a choice by its word, or a list by its words."""

    name: SaidName
    value: Text | Annotated[list[SaidName], Meta(max_length=50)]


class RunOrder(FromBrowser, frozen=True, kw_only=True, tag="run"):
    """Starts or ends the measurement of a scene that measures."""

    order: Literal["start", "cancel", "skip"]


class Open(FromBrowser, frozen=True, kw_only=True, tag="open"):
    """Puts the session into a state; another scene then has what it shares with those before, where that is asked to be
    `carried`. In a picture that is to be compared with the one that stands, other quantities of one scene, the frame
    that stands `keeps` its place."""

    state: State
    carried: bool = False
    keeps: bool = False


class GiveAnswer(FromBrowser, frozen=True, kw_only=True, tag="given"):
    """Gives an answer to a step of a walk."""

    answer: Given


class RunWalk(FromBrowser, frozen=True, kw_only=True, tag="walk"):
    """Has this session alone run a walk from the text of its file."""

    name: SaidName
    text: Annotated[str, Meta(max_length=48_000)]


class Lead(FromBrowser, frozen=True, kw_only=True, tag="lead"):
    """Sends all that is shown from now on to those who follow the class of this code; the room knows the key."""

    code: Annotated[str, Meta(max_length=8)]
    key: SaidName


class AskCsv(FromBrowser, frozen=True, kw_only=True, tag="csv"):
    """Asks for the numbers of all plots as CSV; `page` is the address that their link begins with."""

    page: Text = ""


class AskAbout(FromBrowser, frozen=True, kw_only=True, tag="about"):
    """Asks for the known errors of the numbers that are drawn."""


Said: TypeAlias = SetValues | Typed | Act | Choose | RunOrder | Open | GiveAnswer | RunWalk | Lead | AskCsv | AskAbout


class Told(Struct, frozen=True, kw_only=True, tag_field="type"):
    """Anything that the browser is told; `answer` is the number of the message that it answers."""

    answer: int | None = None


class Shown(Told, frozen=True, kw_only=True, tag="shown"):
    """The page as it now is.

    `sheet` is the address of the scene's sheet, `held` the picture held beside it, `settings` what the controls show by
    parameter, `preset` names the one in force, `here` the places where the scene is, `errors` what was refused of the
    last message by parameter, `problems` what was refused of a link, `query` the link of this state.
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


class Kept(Told, frozen=True, kw_only=True, tag="kept"):
    """The answer to letting go if the page does not change."""


class File(Told, frozen=True, kw_only=True, tag="file"):
    """A file to keep, and its media type."""

    name: str
    kind: str
    content: bytes


class AboutPoint(Struct, frozen=True, kw_only=True):
    """One number in twenty digits: as drawn, as it truly is, and how far off in ulp."""

    name: Html
    place: Html
    drawn: str
    true: str
    off: str


class AboutTable(Struct, frozen=True):
    """Points under the sentence that bounds their errors."""

    bound: Html
    rows: tuple[AboutPoint, ...]


class AboutNumbers(Told, frozen=True, kw_only=True, tag="about"):
    """The known errors of the numbers that are drawn."""

    reading: Html
    tables: tuple[AboutTable, ...]
    notes: tuple[Html, ...]


class Taught(Told, frozen=True, kw_only=True, tag="taught"):
    """The lesson of a step, in answer to what was given; `refused` says why there is none, `is_busy` that others come
    first: it may be asked again."""

    walk: str
    step: str
    lesson: Lesson | None
    refused: str = ""
    is_busy: bool = False


class Walking(Told, frozen=True, kw_only=True, tag="walking"):
    """A walk that this session runs; `refused` says what is wrong with its file, `is_busy` that others come first."""

    sheet: WalkSheet | None
    refused: str = ""
    is_busy: bool = False


ToldAny: TypeAlias = Shown | Kept | File | AboutNumbers | Taught | Walking


class Onward(Struct, frozen=True, kw_only=True):
    """A link to another scene: what is `given`, and the parameters of this scene that are taken along."""

    label: str
    scene: str
    given: dict[str, str]
    taken: tuple[str, ...]


class ViewTab(Struct, frozen=True, kw_only=True):
    """A view of a scene: its name in links, the name on its tab, its task, and the parameters whose controls are the
    first of the panel."""

    word: str
    name: str
    task: Html
    keys: tuple[str, ...]


class SceneSheet(Struct, frozen=True, kw_only=True):
    """All that the browser must know of a scene once, the same for every visitor: an immutable file.

    Messages about the scene are deflated with `usual` before them, which they refer to. `hidden` are the curves that it
    opens without, `spoken` the numbers that are read aloud after a change: by what they are called, texts with {live
    numbers}. A scene without `views` always shows its whole paper; the parameter `view` says which one is shown.
    """

    slug: str
    title: str
    headline: str
    hidden: tuple[str, ...]
    runs: bool
    about: bool
    onward: tuple[Onward, ...]
    usual: str
    spoken: dict[str, str]
    views: tuple[ViewTab, ...]
    paper: Block
    panel: Panel
