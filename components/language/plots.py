"""The contents of plots without their frames. Names of axes, scalars, forms and values refer to the picture."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from components.language.text import Html, Runs


class Room(Struct, frozen=True):
    """The margins of the frame of a plot, in pixels: for numbers at the left and below, labels at the right, flags
    above."""

    left: int = 40
    right: int = 56
    top: int = 4
    bottom: int = 2


class Curve(Struct, frozen=True, kw_only=True):
    """A line: column `y` of `source` over its column `x`, in the colour of the quantity `tint`.

    `signal` moves a dot along it (with `signal_x` as its abscissa if that is not time). `label` is at its right end and
    in the tooltip, `read` only in the tooltip. Curves of one `group` are switched on and off together. `marker` marks
    its points;
    with width "none" only the markers are drawn. In a group drawn as a band, its label is at the band's middle.
    """

    source: str
    x: str
    y: str
    group: str
    tint: str = "ink"
    width: Literal["sum", "line", "dash", "dots", "thin", "none"] = "line"
    label: Runs = ()
    read: str = ""
    signal: str = ""
    signal_x: str = ""
    marker: Literal["", "disc", "ring"] = ""


class Region(Struct, frozen=True, kw_only=True):
    """A filled band between the columns `low` and `high`: the envelope of the curve `of`, or a layer of a stack."""

    source: str
    x: str
    low: str
    high: str
    tint: str = "ink"
    alpha: float = 1.0
    group: str = ""
    of: str = ""
    label: Runs = ()
    read: str = ""


class Handle(Struct, frozen=True, kw_only=True):
    """A handle on an axis that sets a parameter, to at least `least`.

    It shows `symbol` and the parameter's number, or the value called `text`, then `unit`. `covering`: it hides the unit
    of the axis behind it. `bare`: it has no pill; a press on the plot moves it. It is visible while the picture has the
    form `form`. `whole`: it sets whole numbers.
    """

    parameter: str
    label: str
    symbol: str = ""
    tint: str = "ink"
    axis: Literal["x", "y"] = "x"
    least: float | None = None
    text: str = ""
    unit: str = ""
    covering: str = ""
    form: str = ""
    bare: bool = False
    whole: bool = False


class Mark(Struct, frozen=True, kw_only=True):
    """A line with a flag across the plot at the scalar `at`, a coordinate of the axis.

    The flag is a button. It does the action `act`, or sets the parameter `set` to the scalar `exactly` if given, else
    to the value at its position. `lift` is its height above the frame, `shift` its offset to the right, in pixels.
    """

    at: str
    tint: str = "ink"
    html: Html = ""
    label: str = ""
    set: str = ""
    exactly: str = ""
    act: str = ""
    axis: Literal["x", "y"] = "x"
    style: str = ""
    flag: str = ""
    lift: float | None = None
    shift: float = 0.0


class Term(Struct, frozen=True, kw_only=True):
    """One term of the heading: a formula or words by form, a sample of the line, and the switch of the group `curve`.

    `form` names the picture's form that chooses the variant; the default is the variant "formula".
    """

    variants: dict[str, Html]
    curve: str = ""
    form: str = ""
    key: Literal["sum", "line", "dash", "band", "none"] = "line"
    tint: str = "ink"
