"""What a scene shows: a picture, the frame that it is drawn in, and the one that would fit it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from msgspec.structs import replace as changed

from components.axes import TIME_AXIS, Axis
from components.frames import grown, loosened, paced, refitted, together
from components.page.picture import Digits, Pace
from components.page.signals import AnySignal
from components.page.state import Frame
from components.refusals import check_sendable
from components.traces import Columns

ROUNDS = 3
"""A frame that has grown along one axis may have to grow along another."""


@dataclass(frozen=True, kw_only=True)
class Picture:
    """Everything a scene shows for one set of parameters; data only, in SI units.

    `columns`   numbers of the plots, by source and column
    `axes`      range and labels of each axis, by name; TIME_AXIS is the time window, which the clock runs through
    `signals`   what moves, by name: see components.motion
    `pace`      the speeds of the clock
    `scalars`   numbers that the stage and the marks use
    `values`    the texts of the live numbers, by name
    `live`      how the numbers that change while playing are shown, by signal
    `forms`     which variant of a formula or sentence stands, by name; "" hides it
    `notes`     sentences about this picture that the visitor must know (slowed down, drawn to a scale)
    `scale`     the scale of the stage, where it has one, and `fits` the one that suits what is drawn
    `spans`     the ends of the sliders that follow the scene, by parameter
    """

    columns: dict[str, Columns]
    axes: dict[str, Axis]
    signals: Mapping[str, AnySignal] = field(default_factory=dict)
    pace: Pace = Pace()  # noqa: RUF009 (frozen)
    scalars: dict[str, float] = field(default_factory=dict)
    values: dict[str, str] = field(default_factory=dict)
    live: dict[str, Digits] = field(default_factory=dict)
    forms: dict[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    scale: float | None = None
    fits: float | None = None
    spans: dict[str, tuple[float, float]] = field(default_factory=dict)


def frame_of(picture: Picture) -> Frame:
    """The frame that a picture is drawn in."""
    ranges = {name: (axis.start, axis.end) for name, axis in picture.axes.items()}
    return _frame(ranges, picture.scale, picture.pace)


def fitted_to(picture: Picture) -> Frame:
    """The frame that the scene would choose for a picture, in whatever frame it is drawn."""
    return _frame({name: axis.chosen for name, axis in picture.axes.items()}, picture.fits, picture.pace)


def _frame(ranges: dict[str, tuple[float, float]], scale: float | None, pace: Pace) -> Frame:
    spans = {name: (float(start), float(end)) for name, (start, end) in ranges.items()}
    window = spans[TIME_AXIS][1] if TIME_AXIS in spans else None
    return Frame(ranges=spans, window=window, scale=scale, speed=float(pace.auto))


@dataclass(frozen=True)
class Framed:
    """A picture, its frame, and the frame that the scene would choose for it; `beside` is the one held."""

    picture: Picture
    frame: Frame
    fitted: Frame
    beside: Picture | None = None


def shared(drawn: Framed) -> Framed:
    """What many sessions hold: its columns refuse to be written."""
    for columns in drawn.picture.columns.values():
        for column in columns.values():
            column.setflags(write=False)
    return drawn


def drawn_in(picture_in: Callable[[Frame], Picture], frame: Frame) -> Framed:
    """The picture in a frame; what the frame leaves open is fitted."""
    picture = picture_in(frame)
    shown = replace(picture, pace=paced(frame, picture.pace))
    return Framed(shown, changed(frame_of(shown), given=frame.given), fitted_to(picture))


def kept(picture_in: Callable[[Frame], Picture], frame: Frame, before: Frame | None = None) -> Framed:
    """The picture in a frame that stands, grown where what is drawn would leave it.

    `before` is what fitted before another way of showing was chosen: what that changes is fitted anew.
    """
    drawn = drawn_in(picture_in, frame)
    if before is not None:
        drawn = drawn_in(picture_in, refitted(drawn.frame, before, drawn.fitted))
    for _ in range(ROUNDS):
        frame = grown(drawn.frame, drawn.picture.axes, drawn.picture.fits)
        if frame == drawn.frame:
            break
        drawn = drawn_in(picture_in, frame)
    return drawn


def let_go(drawn: Framed) -> Frame:
    """The frame of what is drawn once a hand has let go of it; what is held counts."""
    return loosened(drawn.frame, drawn.fitted, [one.axes for one in (drawn.picture, drawn.beside) if one])


def beside(drawn: Framed, picture_in: Callable[[Frame], Picture], held_in: Callable[[Frame], Picture]) -> Framed:
    """What is drawn, with the picture held in the same frame, which has room for both and is fitted to both.

    Where what is held cannot be drawn in that frame there is none of it.
    """
    try:
        held = held_in(drawn.frame)
        wide = together(drawn.frame, held.axes, held.fits)
        if wide != drawn.frame:
            drawn = replace(drawn_in(picture_in, wide), fitted=drawn.fitted)
            held = held_in(drawn.frame)
        _check(held)
    except (ValueError, ArithmeticError):
        return drawn
    return replace(drawn, fitted=together(drawn.fitted, held.axes, held.fits), beside=held)


def sendable(drawn: Framed) -> Framed:
    """What is drawn; ArithmeticError where a number of it leaves what can be sent."""
    _check(drawn.picture)
    return drawn


def _check(picture: Picture) -> None:
    rulers = [axis.ruler for axis in picture.axes.values()]
    axes = [(ruler.start, ruler.end, ruler.ticks) for ruler in rulers]  # their labels hold no numbers
    check_sendable([picture.columns, axes, picture.pace, picture.signals, picture.scalars, picture.spans])
