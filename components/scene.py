"""What every scene is: parameters, one pure picture computed from them, and data sources that hold its numbers."""

from __future__ import annotations

from abc import ABCMeta, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import Any, ClassVar

import numpy as np
import param
from bokeh.models import ColumnDataSource
from numpy.typing import NDArray
from param.parameterized import ParameterizedMetaclass, discard_events

from components.about import About
from components.axes import Axis
from components.controls import Group, controls_spec
from components.numbers import excerpt
from components.parameters import Quantity
from components.sheet import Block
from components.units import Unit

Columns = dict[str, NDArray[np.float64]]


@dataclass(frozen=True, kw_only=True)
class Picture:
    """Everything a scene shows for one set of parameters; data only, in SI units.

    `columns`   numbers of the plots, by source and column
    `axes`      range and labels of each axis, by name; the axis "t" is the time window that the clock runs through
    `signals`   what moves, by name: see components.motion
    `scalars`   numbers the stage, the marks and the clock use; `pace` is the auto speed, `limit` the fastest allowed
    `values`    the texts of the live numbers, by name
    `live`      how the numbers that change while playing are shown, by signal: (decimals, always signed)
    `forms`     which variant of a formula or sentence stands, by name; "" hides it
    `notes`     sentences about this picture that the visitor must know (slowed down, drawn to a scale)
    """

    columns: dict[str, Columns]
    axes: dict[str, Axis]
    signals: dict[str, Any] = field(default_factory=dict)
    scalars: dict[str, float] = field(default_factory=dict)
    values: dict[str, str] = field(default_factory=dict)
    live: dict[str, tuple[int, bool]] = field(default_factory=dict)
    forms: dict[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


class _SceneMeta(ParameterizedMetaclass, ABCMeta):
    pass


class Scene(param.Parameterized, metaclass=_SceneMeta):
    """One idea of the lecture. Subclasses are final: they declare parameters, a sheet, and `picture`.

    `later` runs a function under the page's own lock: for what comes from another thread.

    Setting parameters (one, or a batch with `param.update`) leads to exactly one `picture`. A ValueError, from a
    parameter's own limits or from the physics, leaves every parameter and every source as it was.
    """

    slug: ClassVar[str]
    title: ClassVar[str]
    lecture: ClassVar[str]
    headline: ClassVar[str]
    groups: ClassVar[tuple[Group, ...]]
    presets: ClassVar[dict[str, dict[str, Any]]] = {}
    start: ClassVar[str] = "Start from"
    places: ClassVar[tuple[str, ...]] = ()
    """The actions that are places rather than deeds: their buttons show whether the scene is there."""
    runs: ClassVar[bool] = False
    """Whether the scene measures instead of playing: then its `progress` stands in the transport's place."""

    window = Quantity(
        default=None,
        allow_None=True,
        bounds=(0, None),
        inclusive_bounds=(False, False),
        softbounds=(1, 100),
        symbol="T",
        unit="s",
        says="the time window; empty for the scene's own choice.",
        allowed="a time window is more than 0 s",
    )
    hidden = param.List(default=[], item_type=str, doc="The curves switched off, by group.")

    def __init__(self, **values: Any) -> None:
        self._good: dict[str, Any] = {}
        super().__init__(**values)
        self._follow(frozenset(values))
        self._shown: Picture = self.picture()
        self._good = self._state()
        self._listeners: list[Callable[[Picture], None]] = []
        self.later: Callable[[Callable[[], None]], object] = lambda act: act()
        self.param.watch(self._solve, list(self._good))

    @classmethod
    @abstractmethod
    def sheet(cls) -> Block:
        """What stands where on the paper: components.sheet."""

    @abstractmethod
    def picture(self) -> Picture:
        """What is shown, as a pure function of the parameters. ValueError where doubles hold no answer."""

    @classmethod
    def drawings(cls) -> dict[str, str]:
        """A small picture for each preset that has one: SVG path data in a box of 128 by 46."""
        return {}

    def units(self) -> dict[str, Unit]:
        """The units in which quantities are now shown and typed, where they are not their own."""
        return {}

    def following(self, changed: frozenset[str]) -> dict[str, Any]:
        """The values of parameters that follow from those just changed; they are set before the picture is made."""
        return {}

    def action(self, name: str) -> dict[str, Any]:
        """The values that a button of a group sets; ValueError, in words, where there are none."""
        raise NotImplementedError(name)

    def here(self) -> list[str]:
        """Those of `places` whose values are in force."""
        return [name for name in self.places if all(getattr(self, p) == v for p, v in self.action(name).items())]

    @property
    def progress(self) -> dict[str, Any] | None:
        """Of a scene that `runs`: {"state", "done", "total", "text"}."""
        return None

    def run(self, order: str) -> None:
        """Of a scene that `runs`: start, cancel or skip. ValueError, in words, where that cannot be."""
        raise ValueError(f"“{excerpt(order)}” is not possible: there is nothing to run here.")

    def close(self) -> None:
        """The visitor has left."""

    def about(self) -> About | None:
        """What is known of the errors of what is drawn, worked out when asked; None where there is nothing to say."""
        return None

    @property
    def shown(self) -> Picture:
        """The picture in force."""
        return self._shown

    @cached_property
    def sources(self) -> dict[str, ColumnDataSource]:
        """The columns of the picture in force, in SI units; a visitor costs none of them until they are asked for."""
        return {name: ColumnDataSource(data=data) for name, data in self._shown.columns.items()}

    def set(self, values: dict[str, Any]) -> None:
        """Set parameters in one batch, with one solve; a ValueError leaves the scene as it was."""
        self.param.update(**values)

    def on_picture(self, listener: Callable[[Picture], None]) -> None:
        """Call `listener` after every change with the new picture."""
        self._listeners.append(listener)

    def preset(self) -> str | None:
        """The label of the preset in force, if any."""
        names = self.preset_names()
        now = [getattr(self, name) for name in names]
        return next((label for label in self.presets if now == [self.preset_value(label, n) for n in names]), None)

    @classmethod
    def preset_names(cls) -> list[str]:
        """The parameters that presets speak about."""
        return sorted({name for values in cls.presets.values() for name in values})

    @classmethod
    def preset_value(cls, label: str, name: str) -> Any:
        """The value a preset stands for: what it does not name is at its default."""
        return cls.presets[label].get(name, cls.param[name].default)

    def view(self) -> Any:
        """What the shell shows: this scene as a Panel component."""
        from components.view import SceneView

        return SceneView(scene=self)

    def __setattr__(self, name: str, value: Any) -> None:
        try:
            super().__setattr__(name, value)
        except ValueError:
            # param stops a batch at the first bad value and keeps those already set: give all of them back.
            self._restore()
            raise

    def _state(self) -> dict[str, Any]:
        return {name: value for name, value in self.param.values().items() if name != "name"}

    def _restore(self) -> None:
        good = getattr(self, "_good", None)
        if not good:
            return
        with discard_events(self):
            for name, value in good.items():
                super().__setattr__(name, value)

    def _follow(self, changed: frozenset[str]) -> None:
        with discard_events(self):
            for name, value in self.following(changed).items():
                super().__setattr__(name, value)

    def _solve(self, *events: param.parameterized.Event) -> None:
        try:
            self._follow(frozenset(event.name for event in events))
            picture = self.picture()
        except ValueError:
            self._restore()
            raise
        self._shown, self._good = picture, self._state()
        for name, source in vars(self).get("sources", {}).items():
            source.data = picture.columns[name]
        for listener in self._listeners:
            listener(picture)


@cache
def static_description(scene: type[Scene]) -> dict[str, Any]:
    """All that the browser must know of a scene once: sheet, controls, presets; the same for every visitor."""
    return {
        "slug": scene.slug,
        "headline": scene.headline,
        "runs": scene.runs,
        "about": scene.about is not Scene.about,
        "sheet": scene.sheet(),
        "controls": controls_spec(scene, scene.groups, scene.presets, scene.drawings()),
    }
