"""A picture of a scene, drawn in a frame: fitted, kept, or grown."""

from __future__ import annotations

from collections.abc import Collection, Hashable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import Generic, Literal, Protocol, TypeVar

import msgspec
from msgspec.structs import replace as changed

from components.language.picture import Digits, Onward, Pace
from components.language.signals import AnySignal
from components.language.state import Frame
from components.quantities.axes import TIME_AXIS, Axis
from components.quantities.refusals import check_sendable, in_words
from components.scene.file_table import FileTable
from components.scene.frames import FITTED, grown, loosened, paced, refitted, together
from components.scene.traces import Columns, Traces

D = TypeVar("D", bound="Drawable")
Framing = Literal["fitted", "kept", "grown"]
"""How the frame of a picture is chosen: fitted to the picture, kept, or kept and widened where something would leave
it."""
MOST_DRAWN = 64
"""Number of cached pictures, shared by all visitors. Compared, undone and popular pictures are needed again."""
ROUNDS = 3
"""Limit of attempts to draw; more than one are needed if growth along one axis requires growth along another."""


@dataclass(frozen=True, kw_only=True)
class Picture:
    """Everything a scene shows for one set of parameters; data only, in SI units.

    `columns`   numbers of curves that no signal describes, by source and column
    `axes`      range and labels of each axis, by name; TIME_AXIS is the time window of the clock
    `signals`   the moving numbers, by name: see components.quantities.motion
    `traces`    the signals that are drawn over time, by source
    `tables`    tables that replace some sources in a file, by name
    `pace`      the speeds of the clock
    `scalars`   numbers that the stage and the marks use
    `values`    the texts of the live numbers, by name
    `live`      the formats of numbers that change while playing, by signal
    `forms`     the current variant of a formula or sentence, by name; "" hides it
    `notes`     sentences on how the picture differs from the exact motion (slowed down, averaged)
    `to_scale`  the sentence on the scale of the stage, if that is not 1; it is sent only with a stage
    `onward`    links to scenes that show the same system for these values
    `scale`     the scale of the stage, if it has one; `fits` is the one that suits the drawing
    `spans`     the ends of sliders whose range depends on the other parameters, by parameter
    """

    columns: dict[str, Columns]
    axes: dict[str, Axis]
    signals: Mapping[str, AnySignal] = field(default_factory=dict)
    traces: Mapping[str, Traces] = field(default_factory=dict)
    tables: Mapping[str, FileTable] = field(default_factory=dict)
    pace: Pace = Pace()  # noqa: RUF009 (frozen)
    scalars: dict[str, float] = field(default_factory=dict)
    values: dict[str, str] = field(default_factory=dict)
    live: dict[str, Digits] = field(default_factory=dict)
    forms: dict[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    to_scale: str = ""
    onward: tuple[Onward, ...] = ()
    scale: float | None = None
    fits: float | None = None
    spans: dict[str, tuple[float, float]] = field(default_factory=dict)

    @cached_property
    def sources(self) -> dict[str, Columns]:
        """All numbers of the plots, by source and column. Curves over time have the exact numbers of the physics."""
        traced = {source: traces.columns for source, traces in self.traces.items()}
        return {name: {**traced.get(name, {}), **self.columns.get(name, {})} for name in {**traced, **self.columns}}

    @cached_property
    def ends(self) -> dict[str, float]:
        """The end of each trace in the unit of the time axis, by source. Raises OverflowError beyond the range of
        doubles: a period can be that much longer than the window.
        """
        return {source: self.axes[TIME_AXIS].place(one.end) for source, one in self.traces.items()}


def frame_of(picture: Picture) -> Frame:
    """Return the frame that a picture is drawn in."""
    ranges = {name: (axis.start, axis.end) for name, axis in picture.axes.items()}
    return _frame(ranges, picture.scale, picture.pace)


def fitted_to(picture: Picture) -> Frame:
    """Return the frame that the scene would choose for a picture, which may be drawn in another one."""
    return _frame({name: axis.chosen for name, axis in picture.axes.items()}, picture.fits, picture.pace)


def _frame(ranges: dict[str, tuple[float, float]], scale: float | None, pace: Pace) -> Frame:
    spans = {name: (float(start), float(end)) for name, (start, end) in ranges.items()}
    window = spans[TIME_AXIS][1] if TIME_AXIS in spans else None
    return Frame(ranges=spans, window=window, scale=scale, speed=float(pace.auto))


@dataclass(frozen=True)
class Framed:
    """A picture, its frame, and the frame that would fit it; `beside` is the compared picture, if there is one."""

    picture: Picture
    frame: Frame
    fitted: Frame
    beside: Picture | None = None

    def loosened(self, still: Collection[str] = ()) -> Frame:
        """Return the frame, fitted again along each axis that is mostly empty in both pictures, except in `still`."""
        return loosened(self.frame, self.fitted, [one.axes for one in (self.picture, self.beside) if one], still)


class Drawable(Protocol):
    """Anything that can be drawn. Two objects with equal keys have equal pictures."""

    @property
    def key(self) -> Hashable: ...
    def picture(self, frame: Frame) -> Picture: ...


@dataclass(frozen=True)
class Asked(Generic[D]):
    """A key of a cache: a scene and a frame."""

    key: Hashable
    scene: D = field(compare=False)
    frame: Frame = field(compare=False)


@lru_cache(MOST_DRAWN)
def _drawn(asked: Asked[Drawable]) -> Framed:
    """Return a picture with read-only columns, because many pages share it. Raises ArithmeticError for a number that
    cannot be sent."""
    picture, frame = asked.scene.picture(asked.frame), asked.frame
    pace = paced(frame, picture.pace)
    shown = picture if pace == picture.pace else replace(picture, pace=pace)
    _check(shown)
    for columns in shown.columns.values():
        for column in columns.values():
            column.setflags(write=False)
    return Framed(shown, changed(frame_of(shown), given=frame.given), fitted_to(picture))


def drawing(scene: Drawable, frame: Frame = FITTED) -> Framed:
    """Return the picture of a scene in a frame; missing parts of the frame are fitted. Cached for all visitors."""
    return _drawn(Asked((scene.key, msgspec.json.encode(frame)), scene, frame))


def draw(
    scene: Drawable,
    held: Drawable | None = None,
    framing: Framing = "fitted",
    frame: Frame = FITTED,
    before: Frame | None = None,
    along: Collection[str] = (),
) -> Framed:
    """Return the picture of a scene, with the compared picture in the same frame.

    If the given frame is not possible, the picture is fitted. `before` is the fitted frame before a change of display;
    axes whose fitted range changed are fitted again. During a drag `along` some axes, these keep their range and the
    other axes grow. Raises ValueError, with a reason, if there is no picture.
    """
    with in_words():
        drawn = drawing(scene) if framing == "fitted" else _in_frame(scene, framing, frame, before, along)
        return _with_held(drawn, scene, held) if held else drawn


def _in_frame(scene: Drawable, framing: Framing, frame: Frame, before: Frame | None, along: Collection[str]) -> Framed:
    try:
        drawn = drawing(scene, frame)
        if framing == "grown":
            return _grown(drawn, scene, before)
        return _grown(drawn, scene, None, along) if along else drawn
    except (ValueError, ArithmeticError):
        return drawing(scene)


def _grown(drawn: Framed, scene: Drawable, before: Frame | None, along: Collection[str] = ()) -> Framed:
    """Return the picture in a frame in which it fits. During a drag, the axes `along` it and the stage's scale stay."""
    if before is not None:
        drawn = drawing(scene, refitted(drawn.frame, before, drawn.fitted))
    for _ in range(ROUNDS):
        frame = grown(drawn.frame, drawn.picture.axes, None if along else drawn.picture.fits, along)
        if frame == drawn.frame:
            break
        drawn = drawing(scene, frame)
    return drawn


def _with_held(drawn: Framed, scene: Drawable, held: Drawable) -> Framed:
    """Return the picture with the compared one, in a frame in which both fit.

    If the compared scene cannot be drawn in that frame, it is left out.
    """
    try:
        beside = drawing(held, drawn.frame).picture
        wide = together(drawn.frame, beside.axes, beside.fits)
        if wide != drawn.frame:
            drawn = replace(drawing(scene, wide), fitted=drawn.fitted)
            beside = drawing(held, drawn.frame).picture
    except (ValueError, ArithmeticError):
        return drawn
    return replace(drawn, fitted=together(drawn.fitted, beside.axes, beside.fits), beside=beside)


def _check(picture: Picture) -> None:
    rulers = [axis.ruler for axis in picture.axes.values()]
    axes = [(ruler.start, ruler.end, ruler.ticks) for ruler in rulers]  # labels are texts
    numbers = [picture.columns, picture.pace, picture.signals, picture.scalars, picture.spans]
    check_sendable([*numbers, axes, picture.ends])
