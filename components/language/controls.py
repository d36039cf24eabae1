"""The control panel, and what its controls show."""

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
    """A slider with its field: `label` is what it is called but for its unit, `soft` what it spans; `says` continues
    the symbol to a sentence."""

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
    """Joined buttons, or small pictures: the shapes of a stage by value."""

    name: str
    label: str
    options: tuple[Option, ...]
    pictures: dict[str, tuple[AnyShape, ...]] = {}


ControlRow: TypeAlias = SliderRow | ChoiceRow


class ActionButton(Struct, frozen=True):
    """A button that has the server set several parameters; a place shows whether the scene is there."""

    name: str
    label: str
    place: bool


class GroupSection(Struct, frozen=True, kw_only=True):
    """Controls that belong together; without a title they go on with those before. `facts` are rows of cells.

    A folded one opens when asked for and when one of its values is not the default; it stands by the form `form`.
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
    """A preset by its name: what it is called, the parameters that it sets, its outline (SVG path data in a box of 128
    by 46, or none), and what to watch in it.

    It sets all that any preset of the scene speaks of; the others stay.
    """

    name: str
    label: str
    sets: dict[str, Value]
    outline: str = ""
    watch: str = ""


class Panel(Struct, frozen=True, kw_only=True):
    """All controls of a scene; `start` is the title over the presets, which a folded one hides until asked for."""

    start: str
    folded: bool
    presets: tuple[PresetButton, ...]
    groups: tuple[GroupSection, ...]


class Setting(Struct, frozen=True, kw_only=True):
    """The state of a parameter's control: its value (in its own unit) and the text of its field.

    `unit` is the one that is shown and typed, of which one is `size`; `changed` says that it is not the default.
    """

    value: float | str | None
    text: str
    unit: str | None = None
    size: float = 1.0
    soft: tuple[float, float] | None = None
    changed: bool = False
