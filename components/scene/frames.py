"""The frame of a picture: the ranges of its axes, its time window, scale and speed.

A scene's `picture(frame)` uses the ranges that the frame has and chooses the others; with an empty frame it chooses
all. A new picture can keep the frame of the one before. The frame grows if the drawing would leave it, in steps of
1, 2, 5. A mostly empty axis is fitted again at the end of a drag.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from msgspec.structs import replace

from components.language.picture import Pace
from components.language.state import Frame
from components.quantities.axes import TIME_AXIS, Axis, Range, log_axis, ordered, round_ticks, scale_by_ten, widest
from components.quantities.formatting import excerpt, power_unit
from components.quantities.motion import round_down, round_up

FITTED = Frame()
"""The empty frame: the scene chooses everything."""
SIZES = ("window", "scale", "speed")
"""The numbers of a frame in addition to the ranges of its axes."""
FEW = 0.3
"""Ticks that mark something are replaced by round numbers if they span less than this share of the frame."""
USED = 0.25
"""Used share of an axis below which it is fitted again at the end of a drag."""
ALIKE, NOISE = 5e-4, 1e-14
"""Differences relative to a range: below ALIKE they are invisible on a screen, below NOISE they are rounding errors."""
LARGEST = 1e307
"""Limit of growth by steps, near the largest double."""


@dataclass(frozen=True, kw_only=True)
class Windowed:
    """A motion over a time window in s: the window of the frame (`frame_window`), else the chosen one (`window`), else
    `lasting`."""

    window: float | None
    frame_window: float | None = None

    @cached_property
    def lasting(self) -> float:
        """The window that suits the motion. Raises ValueError if it is outside the range of doubles."""
        raise NotImplementedError

    @property
    def own_end(self) -> float:
        """The end of the time window in s that the picture chooses, for a frame without one."""
        return self.window or self.lasting

    @property
    def end(self) -> float:
        return self.frame_window or self.own_end


def checked(frame: Frame) -> Frame:
    """Return the frame. Raises ValueError, with a reason, if nothing can be drawn in it."""
    for name, (low, high) in frame.ranges.items():
        if not (math.isfinite(low) and math.isfinite(high) and low != high):
            raise ValueError(f"The range of “{excerpt(name)}” is from {low} to {high}: its ends must differ.")
    for name, value in (("window", frame.window), ("scale", frame.scale), ("speed", frame.speed)):
        if value is not None and not 0 < value < math.inf:
            raise ValueError(f"The {name} of a frame is {value}: it must be above 0.")
    return frame


def framed(frame: Frame, axes: Mapping[str, Axis]) -> dict[str, Axis]:
    """Return the axes, with the ranges that the frame has for them."""
    return {name: with_range(axis, _range_in(frame, name, axis)) for name, axis in axes.items()}


def _range_in(frame: Frame, name: str, axis: Axis) -> Range:
    if name == TIME_AXIS:
        return (0.0, frame.window) if frame.window else (axis.start, axis.end)
    return frame.ranges.get(name, (axis.start, axis.end))


def with_range(axis: Axis, span: Range) -> Axis:
    """Return the axis over another range in SI units.

    Round ticks are chosen again; ticks that mark something stay, unless they are crowded.
    """
    if span == (axis.start, axis.end):
        return axis
    wide = replace(axis, start=span[0], end=span[1], own=axis.chosen)
    if axis.log:
        return replace(wide, ticks=log_axis(*ordered(span), count=axis.count, factor=axis.factor).ticks)
    if axis.labels:
        low, high = ordered((wide.place(wide.start), wide.place(wide.end)))
        inside = [(tick, label) for tick, label in zip(axis.ticks, axis.labels, strict=True) if low <= tick <= high]
        ticks, labels = zip(*inside, strict=True) if inside else ((), ())
        if not ticks or max(ticks) - min(ticks) >= FEW * (high - low):
            return replace(wide, ticks=ticks, labels=labels)
        wide = replace(wide, labels=())
    return _rounded(wide, named=not axis.labels or any(axis.labels))


def _rounded(axis: Axis, named: bool) -> Axis:
    """Return the axis with round ticks, and with another power of ten if that suits the range better."""
    reach = max(abs(axis.start), abs(axis.end)) / axis.factor
    named_alike = axis.power == 1 and bool(axis.exponent) == bool(axis.suffix)
    if named_alike and not 1e-2 <= scale_by_ten(reach, -axis.exponent) < 1e5:
        exponent, suffix = power_unit(reach)
        axis = replace(axis, exponent=exponent, suffix=suffix)
    ticks = round_ticks(axis)
    return replace(axis, ticks=ticks, labels=() if named else ("",) * len(ticks))


def unfitted(frame: Frame, fitted: Frame) -> Frame | None:
    """Return a frame with only the parts that visibly differ from the fitted ones, or None if no part does."""
    known = {**fitted.ranges, **({TIME_AXIS: (0.0, frame.window)} if frame.window else {})}
    sizes = {name: getattr(frame, name) for name in SIZES}
    rest = Frame(
        ranges={name: span for name, span in frame.ranges.items() if not _alike(span, known.get(name, ()))},
        **{name: size for name, size in sizes.items() if size and not _alike((size,), (getattr(fitted, name) or 0.0,))},
    )
    return replace(rest, given=frame.given) if rest != FITTED else None


def _alike(span: Sequence[float], other: Sequence[float]) -> bool:
    """Return True if a screen shows no difference."""
    noise = NOISE * abs(span[0] - span[-1])
    pairs = zip(span, other, strict=False)
    return len(span) == len(other) and all(math.isclose(*ends, rel_tol=ALIKE, abs_tol=noise) for ends in pairs)


def paced(frame: Frame, pace: Pace) -> Pace:
    """Return the pace with the frame's speed; its limit does not change."""
    return pace if frame.speed is None else Pace(frame.speed, pace.limit)


def grown(frame: Frame, axes: Mapping[str, Axis], scale: float | None = None, still: Collection[str] = ()) -> Frame:
    """Return the frame, grown so that everything that must be visible on the axes fits.

    Window and speed stay. A range also stays if the drawing fits in it, or if its axis is in `still`; other ranges
    grow to round numbers. `scale` is the largest scale at which the drawing fits on the stage.
    """
    spans = {name: _range_in(frame, name, axis) for name, axis in axes.items()}
    stay = {TIME_AXIS, *still}
    ranges = {name: span if name in stay else _grown(span, axes[name]) for name, span in spans.items()}
    scales = [one for one in (frame.scale, scale) if one is not None]
    return replace(frame, ranges=ranges, scale=min(scales, default=None))


def loosened(frame: Frame, fitted: Frame, drawn: Sequence[Mapping[str, Axis]], still: Collection[str] = ()) -> Frame:
    """Return the frame, fitted again along each axis that is mostly empty: `drawn` uses less than a quarter of it.

    `drawn` has the axes of one picture, or of two that are compared. The time window and the axes in `still` do not
    change; curves always fill the window.
    """
    if frame.given:
        return frame
    names = frame.ranges.keys() - {TIME_AXIS, *still}
    hardly = {name for name in names if _is_hardly_used(frame, fitted, name, drawn)}
    ranges = {name: fitted.ranges[name] if name in hardly else span for name, span in frame.ranges.items()}
    tiny = frame.scale and fitted.scale and frame.scale < USED * fitted.scale
    return replace(frame, ranges=ranges, scale=fitted.scale if tiny else frame.scale)


def _is_hardly_used(frame: Frame, fitted: Frame, name: str, drawn: Sequence[Mapping[str, Axis]]) -> bool:
    axes = [one[name] for one in drawn if name in one]
    if name not in fitted.ranges or not axes:
        return False
    seen = widest(*(axis.seen for axis in axes))
    used, whole, wanted = (
        abs(axes[0].place(high) - axes[0].place(low)) for low, high in (seen, frame.ranges[name], fitted.ranges[name])
    )
    return used < USED * whole and wanted < whole


def together(frame: Frame, axes: Mapping[str, Axis], scale: float | None) -> Frame:
    """Return the frame, widened for another picture; the time window does not change."""
    others = {name: axis for name, axis in axes.items() if name in frame.ranges and name != TIME_AXIS}
    wide = grown(frame, others, scale)
    return replace(wide, ranges={**frame.ranges, **wide.ranges})


def _grown(span: Range, axis: Axis) -> Range:
    """Return the range, grown so that everything that must be visible fits; a reversed axis stays reversed."""
    (low, high), (least, most), (start, end) = ordered(span), axis.seen, ordered(axis.chosen)
    if most > high:
        high = _up(max(end, most))
    if least < low:
        low = -_up(-min(start, least))
    return (low, high) if span[0] < span[1] else (high, low)


def _up(value: float) -> float:
    """Return the next number 1, 2 or 5 times a power of ten above a value of either sign."""
    if not 0 < abs(value) < LARGEST:
        return value
    return round_up(value) if value > 0 else -round_down(-value)


def refitted(frame: Frame, before: Frame, fitted: Frame) -> Frame:
    """Refit only the axes whose fitted range visibly changed with the view."""
    if before.window != fitted.window:
        frame = replace(frame, window=fitted.window, speed=fitted.speed)
    ranges = {
        name: frame.ranges.get(name, span) if _alike(span, before.ranges.get(name, ())) else span
        for name, span in fitted.ranges.items()
    }
    scale = frame.scale if before.scale == fitted.scale else fitted.scale
    return replace(frame, ranges=ranges, scale=scale)
