"""The control panel and the values of its controls."""

from __future__ import annotations

from typing import Literal, TypeAlias

from msgspec import Struct

from components.language.blocks import Option
from components.language.shapes import AnyShape
from components.language.state import Value
from components.language.text import Html


class NamedValue(Struct, frozen=True):
    """A value with a name under its slider."""

    value: float
    text: str


class SliderRow(Struct, frozen=True, kw_only=True, tag_field="kind", tag="slider"):
    """A slider with its field: `label` is its name without the unit, `soft` its range; `says` is help text that
    continues the symbol: "m is the mass"."""

    name: str
    symbol: str
    label: str
    unit: str
    tint: str
    scale: Literal["linear", "log", "near0", "count"]
    soft: tuple[float, float]
    says: str
    marks: tuple[NamedValue, ...] = ()


class ChoiceRow(Struct, frozen=True, kw_only=True, tag_field="kind", tag="choice"):
    """A choice: joined buttons, or small pictures made of the shapes of a stage, by value."""

    name: str
    label: str
    options: tuple[Option, ...]
    pictures: dict[str, tuple[AnyShape, ...]] = {}


ControlRow: TypeAlias = SliderRow | ChoiceRow


class ActionButton(Struct, frozen=True):
    """A button that makes the server set several parameters; if `place`, it shows when the scene has these values."""

    name: str
    label: str
    place: bool


class GroupSection(Struct, frozen=True, kw_only=True):
    """Controls that belong together; a section without a title continues the one before. `facts` are rows of cells.

    A folded section opens on request, or if one of its values is not the default. It is visible while the picture has
    the form `form`.
    """

    title: str
    hint: str
    rows: tuple[ControlRow, ...]
    actions: tuple[ActionButton, ...]
    folded: bool
    form: str
    dense: bool
    facts: tuple[tuple[Html, ...], ...]


class PresetButton(Struct, frozen=True):
    """A preset: its label, the parameters that it sets, its outline (SVG path data in a box of 128 by 46, or none), and
    a sentence on what to watch.

    It sets every parameter that any preset of the scene sets; other parameters keep their values.
    """

    name: str
    label: str
    sets: dict[str, Value]
    outline: str = ""
    watch: str = ""


class Panel(Struct, frozen=True, kw_only=True):
    """All controls of a scene; `start` is the title above the presets. A folded list of presets opens on request."""

    start: str
    folded: bool
    presets: tuple[PresetButton, ...]
    groups: tuple[GroupSection, ...]


class Setting(Struct, frozen=True, kw_only=True):
    """The state of a parameter's control: its value (in its own unit) and the text of its field.

    `unit` is the unit of display and input, `size` its size in the parameter's own unit; `changed`: not the default.
    """

    value: float | str | None
    text: str
    unit: str | None = None
    size: float = 1.0
    soft: tuple[float, float] | None = None
    changed: bool = False
