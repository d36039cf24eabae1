"""The declaration of a scene: its names, groups, presets and links, the same for all visitors."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, ClassVar

import param

from components.language.messages import Onward
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
    """The part of the lecture that it is about."""
    headline: ClassVar[str]
    """Its claim, in a sentence."""
    equations: ClassVar[tuple[str, ...]]
    """The equations that the numbers obey, in ASCII with the names of the code, for the CSV export."""
    spoken: ClassVar[Mapping[str, str | LiveNumber[Any]]] = {}
    """The numbers that are read aloud when a change moves them: what each is called, and its live numbers with unit."""
    views: ClassVar[tuple[View, ...]] = ()
    """Its views; the first one opens. The parameter `view` is made from them. A scene that has none shows all of the
    sheet."""
    old_view: ClassVar[str] = ""
    """The view of an old link that has values and names no view, if that is not the first."""
    old_views: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    """The views that old links name in another way: by the old parameter and its value."""
    groups: ClassVar[tuple[Group, ...]]
    presets: ClassVar[Mapping[str, Values]] = {}
    watch: ClassVar[Mapping[str, str]] = {}
    """A sentence for each preset on what to watch, said when it is taken."""
    opens: ClassVar[Values] = {}
    """The values that differ from the defaults where a page of it is opened without any parameter."""
    start: ClassVar[str] = "Start from"
    start_folded: ClassVar[bool] = False
    """The title over the presets, and whether they are folded under it."""
    physical: ClassVar[tuple[AnyParameter, ...]] = ()
    """The choices that make another system; the others only show it in another way."""
    reached: ClassVar[tuple[AnyParameter, ...]] = ()
    """The parameters that record what a visitor has reached: a link carries them, and nothing is compared with them."""
    places: ClassVar[tuple[str, ...]] = ()
    """The actions that are places rather than commands: their buttons show whether the scene is there."""
    steady: ClassVar[tuple[str, ...]] = ()
    """The axes that are not fitted again when a hand lets go, however little of them is used."""
    work: ClassVar[type[Running] | None] = None
    """The work of a scene that measures instead of playing: its progress replaces the transport."""
    onward: ClassVar[tuple[Onward, ...]] = ()
    """The links to other scenes that take values along."""
    shares: ClassVar[Mapping[str, str]] = {}
    """Its parameters by their meaning in other scenes too: components.state.shared_system takes them along."""
    sharing: ClassVar[Values] = {}
    """Additional values that it must have, so that the shared parameters are visible."""

    @classmethod
    @cache
    def linked(cls) -> dict[str, AnyParameter]:
        """The parameters that a link and a state carry: quantities, choices and lists, unless constant or private."""
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
        """The label of each preset, and the values of `preset_names` in it."""
        return [(label, list(cls.preset_all(label).values())) for label in cls.presets]

    @classmethod
    @cache
    def preset_names(cls) -> list[str]:
        """The parameters that presets speak about."""
        return sorted({name for values in cls.presets.values() for name in values})

    @classmethod
    def preset_all(cls, label: str) -> Values:
        """Return the values that a preset sets, one for each parameter that any preset names."""
        return {name: cls.preset_value(label, name) for name in cls.preset_names()}

    @classmethod
    def preset_value(cls, label: str, name: str) -> Any:
        """Return the value of a parameter in a preset; its default if the preset does not name it."""
        return cls.presets[label].get(name, cls.param[name].default)
