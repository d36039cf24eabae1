"""The declaration of a scene: its names, groups, presets and links, the same for all visitors."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, ClassVar

import param

from components.language.picture import Onward
from components.layout.controls import Group
from components.layout.views import View
from components.quantities.declared import LiveNumber
from components.quantities.parameters import AnyParameter, Quantity, Values
from components.scene.running import Running


class SceneInfo(param.Parameterized):
    """The class attributes that each scene declares; see components.scene."""

    slug: ClassVar[str]
    title: ClassVar[str]
    lecture: ClassVar[str]
    points: ClassVar[str]
    """The points of the lecture that it shows."""
    headline: ClassVar[str]
    """The main statement of the scene, in a sentence."""
    equations: ClassVar[tuple[str, ...]]
    """The equations that the numbers obey, in ASCII with the names of the code, for the CSV export."""
    spoken: ClassVar[Mapping[str, str | LiveNumber[Any]]] = {}
    """The numbers that a screen reader announces when they change: the name of each, and its live numbers with unit."""
    views: ClassVar[tuple[View, ...]] = ()
    """The views of the scene; it opens with the first one. The parameter `view` is made from them. A scene without
    views shows all
    of the sheet."""
    old_view: ClassVar[str] = ""
    """The view for old links that have values but no view; "" for the first view."""
    old_views: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    """The views for old links that chose a display by another parameter: by its name and value."""
    groups: ClassVar[tuple[Group, ...]]
    presets: ClassVar[Mapping[str, Values]] = {}
    watch: ClassVar[Mapping[str, str]] = {}
    """A sentence for each preset on what to watch, shown when a visitor chooses it."""
    opens: ClassVar[Values] = {}
    """Values other than the defaults with which a link opens the scene if it has no parameters."""
    start: ClassVar[str] = "Start from"
    start_folded: ClassVar[bool] = False
    """True if the presets are folded under the title `start`."""
    physical: ClassVar[tuple[AnyParameter, ...]] = ()
    """The choices that change the physical system; other choices only change how it is shown."""
    covered_with: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    """For a plot, other plots that show the same curves: they are covered with it."""
    reached: ClassVar[tuple[AnyParameter, ...]] = ()
    """The parameters that record a visitor's progress. Links contain them; comparisons ignore them."""
    places: ClassVar[tuple[str, ...]] = ()
    """The actions that go to a certain setting, such as resonance: their buttons are marked while it is set."""
    steady: ClassVar[tuple[str, ...]] = ()
    """The axes that are not fitted again at the end of a drag, even if they are mostly empty."""
    work: ClassVar[type[Running] | None] = None
    """The background work of a scene that measures. The page shows its progress instead of the Play button."""
    onward: ClassVar[tuple[Onward, ...]] = ()
    """Links to other scenes, with values of this one."""
    shares: ClassVar[Mapping[str, str]] = {}
    """Parameters with a meaning that other scenes share, such as m1: a visitor keeps their values between scenes
    (components.state.shared_system)."""
    sharing: ClassVar[Values] = {}
    """Values that the scene must have so that its shared parameters are visible."""

    @classmethod
    @cache
    def linked(cls) -> dict[str, AnyParameter]:
        """The parameters in a link and a state: quantities, choices and lists, unless constant or private."""
        kinds = (Quantity, param.Selector, param.Boolean, param.List)
        return {
            name: parameter
            for name, parameter in cls.param.objects("existing").items()
            if isinstance(parameter, kinds) and not parameter.constant and not name.startswith("_")
        }

    @classmethod
    @cache
    def quantities(cls) -> frozenset[str]:
        """The names of the parameters that are quantities."""
        return frozenset(name for name, one in cls.param.objects("existing").items() if isinstance(one, Quantity))

    @classmethod
    @cache
    def preset_values(cls) -> list[tuple[str, list[Any]]]:
        """Return the values of `preset_names` in each preset, by label."""
        return [(label, list(cls.preset_all(label).values())) for label in cls.presets]

    @classmethod
    @cache
    def preset_names(cls) -> list[str]:
        """Return the parameters that at least one preset sets."""
        return sorted({name for values in cls.presets.values() for name in values})

    @classmethod
    def preset_all(cls, label: str) -> Values:
        """Return the values that a preset sets, one for each parameter that any preset names."""
        return {name: cls.preset_value(label, name) for name in cls.preset_names()}

    @classmethod
    def preset_value(cls, label: str, name: str) -> Any:
        """Return the value of a parameter in a preset; its default if the preset does not name it."""
        return cls.presets[label].get(name, cls.param[name].default)
