"""A scene: parameters, one pure picture of them, and what follows from a change; a value, with a thin face to set."""

from __future__ import annotations

from abc import ABCMeta, abstractmethod
from collections.abc import Callable, Hashable, Iterable, Mapping
from functools import cache, cached_property
from typing import Any, Self

import param
from bokeh.models import ColumnDataSource
from param.parameterized import ParameterizedMetaclass, discard_events

from components.language.blocks import Block
from components.language.state import Frame
from components.layout.sheet import axes_of_columns
from components.quantities.parameters import Quantity, Values, one_of
from components.quantities.readouts import Readout
from components.quantities.refusals import in_words
from components.quantities.units import Unit
from components.scene.about import About
from components.scene.columns import with_units
from components.scene.frames import FITTED
from components.scene.picture import Picture, draw
from components.scene.scene_info import SceneInfo
from components.scene.traces import Columns

NONE: Values = {}
VIEW = "view"
"""The parameter of a scene that says which of its views is shown."""


class _SceneMeta(ParameterizedMetaclass, ABCMeta):
    """Gives a scene with views the parameter that chooses one."""

    def __new__(mcs, name: str, bases: tuple[type, ...], given: dict[str, Any], **rest: Any) -> Any:
        if views := given.get("views", ()):
            given["view"] = one_of(views[0].slug, {view.slug: view.name for view in views}, "View")
        return super().__new__(mcs, name, bases, given, **rest)


class Scene(SceneInfo, metaclass=_SceneMeta):
    """One idea of the lecture. Subclasses are final: they declare parameters, a sheet, and `picture`.

    `Scene.at(values)` is a value: nothing of it can be set, and `changed(values)` is another one. The page knows only
    these. A scene that is made as usual is their face for notebooks and tests: what is set, one parameter or a batch
    with `param.update`, makes it show another value, with one `picture`. A ValueError, from a parameter's own limits,
    from the physics or in place of an ArithmeticError, leaves it as it was; so does any other exception.
    """

    window = Quantity(
        default=None,
        allow_None=True,
        bounds=(0, None),
        inclusive_bounds=(False, False),
        softbounds=(1, 100),
        symbol="T",
        unit="s",
        says="the time window; empty for the scene's own choice.",
        allowed="a time window is a finite time above 0 s",
    )
    hidden = param.List(default=[], item_type=str, doc="The curves switched off, by group.")

    @classmethod
    @abstractmethod
    def sheet(cls) -> Block:
        """The arrangement of the paper: components.layout.sheet."""

    @abstractmethod
    def picture(self, frame: Frame = FITTED) -> Picture:
        """A pure function of the parameters and the frame, of which what it leaves open is chosen to fit. ValueError
        where doubles hold no answer."""

    @classmethod
    def drawings(cls) -> dict[str, str]:
        """A small picture for each preset that has one: SVG path data in a box of 128 by 46."""
        return {}

    def units(self) -> dict[str, Unit]:
        """The units in which quantities are now shown and typed, where they are not their own."""
        return {}

    def following(self, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Values:
        """The values of parameters that follow from those just changed, by a hand or not, in the scene `before`; from
        all that are given, where there is none before."""
        return {}

    def action(self, name: str) -> Values:
        """The values that a button of a group sets; ValueError, in words, where there are none."""
        raise NotImplementedError(name)

    def here(self) -> list[str]:
        """The names of `places` whose values are in force."""
        return [name for name in self.places if all(getattr(self, p) == v for p, v in self.action(name).items())]

    def about(self, shown: Picture) -> About | None:
        """The errors of all that is drawn, as far as they are known; None where there is nothing to say."""
        return None

    @classmethod
    def is_checked(cls) -> bool:
        """Return whether `about` compares what is drawn with exact numbers."""
        return cls.about is not Scene.about

    def readouts(self) -> tuple[Readout, ...]:
        """The numbers that are compared with those of another picture."""
        return ()

    def derived(self) -> frozenset[str]:
        """The parameters that follow from others as things stand, so that no link need tell them."""
        return frozenset()

    def off_default(self) -> Values:
        """The linked parameters that are not at their defaults, nor follow from others."""
        values, derived = self.values, self.derived()
        return {
            name: values[name]
            for name, one in self.linked().items()
            if values[name] != one.default and name not in derived
        }

    def preset(self) -> str | None:
        """The label of the preset in force, if any."""
        now = [self.values[name] for name in self.preset_names()]
        return next((label for label, values in self.preset_values() if values == now), None)

    # The value.

    @classmethod
    def at(cls, values: Values = NONE) -> Self:
        """The scene with these values, the others at their defaults, and what follows from them; ValueError for values
        that it cannot have."""
        cls._check_known(values)
        return cls._settled(values, frozenset(values), None, in_hand=False)

    def changed(self, values: Values, *, in_hand: bool = False) -> Self:
        """The scene with other values and what follows from their change; itself where they are its own."""
        value, defaults = self.value, self.parameters()
        changed = value.differing(values)
        if not changed:
            return value
        others = {name: own for name, own in value.values.items() if own is not defaults[name]}
        return self._settled({**others, **values}, changed, value, in_hand=in_hand)

    @classmethod
    def _settled(cls, values: Values, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Self:
        scene = cls.__new__(cls)
        param.Parameterized.__init__(scene, **values)  # type: ignore[no-untyped-call]  # param's own has no types
        with in_words():
            following = scene.following(changed, before, in_hand=in_hand)
        followed = {name: value for name, value in following.items() if getattr(scene, name) != value}
        for name, value in followed.items():
            setattr(scene, name, value)
        given = {name: getattr(scene, name) for name in (*values, *followed)}
        vars(scene)["values"] = {**cls.parameters(), **given}
        return scene

    @classmethod
    @cache
    def parameters(cls) -> dict[str, Any]:
        """All parameters, with their defaults."""
        return {name: one.default for name, one in cls.param.objects("existing").items() if name != "name"}

    @classmethod
    def _check_known(cls, values: Values) -> None:
        if unknown := values.keys() - cls.parameters().keys():
            raise ValueError(f"{', '.join(sorted(unknown))}: not a parameter of {cls.__name__}")

    def differing(self, values: Values) -> frozenset[str]:
        """The names of those values that are others than the scene's own; ValueError for a parameter that it lacks."""
        self._check_known(values)
        return frozenset(name for name, value in values.items() if self.values[name] != value)

    @property
    def values(self) -> Mapping[str, Any]:
        """The values of all parameters."""
        values: Values = vars(self.value)["values"]
        return values

    @cached_property
    def key(self) -> Hashable:
        """Equal for scenes that are the same to the last bit: -0.0 is not 0.0."""
        exact = (repr(value) if isinstance(value, (float, list)) else value for value in self.values.values())
        return type(self), tuple(exact)

    # The face.

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)  # type: ignore[no-untyped-call]  # param's own has no types
        self._listeners: list[Callable[[Picture], None]] = []
        self._show(type(self).at(values))
        self.param.watch(lambda *events: self._set(event.name for event in events), list(self.parameters()))

    @property
    def value(self) -> Self:
        """The value that a face shows; a value itself."""
        value: Self = vars(self).get("_value", self)
        return value

    @property
    def shown(self) -> Picture:
        """The picture in force."""
        picture: Picture | None = vars(self).get("_shown")
        return picture or draw(self).picture

    @cached_property
    def sources(self) -> dict[str, ColumnDataSource]:
        """The numbers of the picture in force, in SI units."""
        return {name: ColumnDataSource(data=data) for name, data in self.shown.sources.items()}

    def set(self, values: Values) -> None:
        """Set parameters in one batch, with one picture; a ValueError leaves the face as it was."""
        if self.differing(values):
            self._show(self.value.changed(values))

    def frame(self, source: str = "") -> Columns:
        """The numbers of a source in SI units under names such as "x1 [m]", for `pandas.DataFrame`: of the first that
        has any, where none is named. ValueError, with the names of those, for a source without numbers."""
        return with_units(self.shown, axes_of_columns(self.sheet()), source)

    def panel(self) -> Any:
        """Panel widgets for the parameters and live Bokeh figures of the plots: components.panel_face.PanelFace."""
        from components.panel_face.face import PanelFace  # the server and the physics do without

        return PanelFace(self)

    __panel__ = panel

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Any:
        """The scene in a notebook, once `panel.extension()` is loaded."""
        return self.panel()._repr_mimebundle_(include, exclude)

    def on_picture(self, listener: Callable[[Picture], None]) -> None:
        """Call `listener` after every change with the new picture."""
        self._listeners.append(listener)

    def __setattr__(self, name: str, value: Any) -> None:
        if "values" in vars(self):
            raise AttributeError(f"{name} cannot be set: changed({name}=...) is another scene")
        try:
            super().__setattr__(name, value)
        except Exception:
            # param stops a batch at the first bad value and keeps those already set: give all of them back.
            self._restore()
            raise

    def _set(self, names: Iterable[str]) -> None:
        try:
            self._show(self.value.changed({name: getattr(self, name) for name in names}))
        except Exception:
            self._restore()
            raise

    def _show(self, value: Self) -> None:
        picture = draw(value).picture
        known: Mapping[str, ColumnDataSource] = vars(self).get("sources", {})
        numbers = picture.sources if known else {}
        vars(self).update(_value=value, _shown=picture)
        self._restore()
        for name in numbers.keys() | known.keys():
            self.sources.setdefault(name, ColumnDataSource()).data = numbers.get(name, {})
        for listener in self._listeners:
            listener(picture)

    def _restore(self) -> None:
        if "_value" in vars(self):
            with discard_events(self):
                for name, value in self.value.values.items():
                    super().__setattr__(name, value)
