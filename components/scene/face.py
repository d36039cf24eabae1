"""The mutable face of a scene, for notebooks, Panel and tests."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from copy import copy
from functools import cache, cached_property
from typing import Any, ClassVar

import param
from bokeh.models import ColumnDataSource
from param.parameterized import discard_events

from components.quantities.parameters import AnyParameter, Values
from components.scene.picture import Picture
from components.scene.scene import Scene


class SceneFace(param.Parameterized):
    """A scene whose parameters can be set: one by one, or several at once by `param.update` or `set`.

    It has all attributes of `value`, the current scene, which is immutable: `numbers`, `frame`, `presets` and so on. A
    notebook shows it as Panel widgets and figures.

    Parameters
    ----------
    **values
        Parameters by name, in SI units and rad. The docstring of each scene lists them with units, limits and defaults.

    Raises
    ------
    ValueError
        If a value is outside the limits of its parameter, or the physics refuses it. The face is then unchanged.
    AttributeError
        If a name that is set is not a parameter.

    Examples
    --------
    >>> from components.scenes import SCENES
    >>> scene = SCENES["damped"](m=1.0, k=16.0)
    >>> scene.c = 4.0
    >>> scene.numbers["zeta"].value
    0.5
    >>> scene.set({"k": 25.0, "c": 5.0})
    >>> scene
    SCENES["damped"](k=25.0, c=5.0)
    >>> scene.m = -1.0
    Traceback (most recent call last):
    ValueError: m = −1 kg is not possible: a mass is a finite number above 0.
    """

    scene_kind: ClassVar[type[Scene]]

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)  # type: ignore[no-untyped-call]  # param's own has no types
        self._listeners: list[Callable[[Picture], None]] = []
        self.show(self.scene_kind.at(values))
        self.param.watch(lambda *events: self._set(event.name for event in events), list(self.scene_kind.parameters()))

    @property
    def value(self) -> Scene:
        """The current scene, which is immutable."""
        scene: Scene = vars(self)["_scene"]
        return scene

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or "_scene" not in vars(self):
            raise AttributeError(f"{type(self).__name__} has no attribute {name}")
        return getattr(self.value, name)

    def __reduce__(self) -> Any:
        return self.scene_kind, (), dict(self.value.values)

    def __setstate__(self, values: Values) -> None:
        self.set(values)

    def __repr__(self) -> str:
        """A Python expression that makes this scene, with the values that are not at their defaults."""
        values = ", ".join(f"{name}={value!r}" for name, value in self.value.off_default().items())
        return f'SCENES["{self.scene_kind.slug}"]({values})'

    @cached_property
    def sources(self) -> dict[str, ColumnDataSource]:
        """The numbers of the current picture in SI units: a `ColumnDataSource` by name, updated after each change."""
        return {name: ColumnDataSource(data=data) for name, data in self.value.shown.sources.items()}

    def set(self, values: Values) -> None:
        """Set several parameters at once, by name, in SI units and rad.

        Raises ValueError if a value is not possible; the face is then unchanged.
        """
        if self.value.differing(values):
            self.show(self.value.changed(values))

    def panel(self) -> Any:
        """Return Panel widgets for the parameters and live Bokeh figures: a `components.panel_face.PanelFace`."""
        from components.panel_face.face import PanelFace  # imported here, because the server does not need it

        return PanelFace(self)

    __panel__ = panel

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Any:
        """The panel of the scene, which a notebook shows after `panel.extension()`."""
        return self.panel()._repr_mimebundle_(include, exclude)

    def on_picture(self, listener: Callable[[Picture], None]) -> None:
        """Call `listener` with the new picture after every change."""
        self._listeners.append(listener)

    def __setattr__(self, name: str, value: Any) -> None:
        if not (name.startswith("_") or hasattr(type(self), name)):
            known = ", ".join(self.scene_kind.linked())
            raise AttributeError(f"{name} is not a parameter of {self.scene_kind.__name__}: it has {known}")
        try:
            super().__setattr__(name, value)
        except Exception:
            # param stops a batch at the first bad value and keeps earlier ones, so restore all of them.
            self._restore()
            raise

    def _set(self, names: Iterable[str]) -> None:
        try:
            self.show(self.value.changed({name: getattr(self, name) for name in names}))
        except Exception:
            self._restore()
            raise

    def show(self, scene: Scene) -> None:
        """Show another `scene` of this kind."""
        picture = scene.shown
        known: Mapping[str, ColumnDataSource] = vars(self).get("sources", {})
        numbers = picture.sources if known else {}
        vars(self)["_scene"] = scene
        self._restore()
        for name in numbers.keys() | known.keys():
            self.sources.setdefault(name, ColumnDataSource()).data = numbers.get(name, {})
        for listener in self._listeners:
            listener(picture)

    def _restore(self) -> None:
        if "_scene" in vars(self):
            with discard_events(self):
                for name, value in self.value.values.items():
                    super().__setattr__(name, value)


@cache
def face_of(kind: type[Scene]) -> type[SceneFace]:
    """Return the class of the faces of a kind of scene, which has its parameters."""
    parameters = {name: _unbound(one) for name, one in kind.param.objects("existing").items() if name != "name"}
    return type(f"{kind.__name__}Face", (SceneFace,), {"scene_kind": kind, "__doc__": kind.__doc__, **parameters})


def _unbound(parameter: AnyParameter) -> AnyParameter:
    """Return a copy of a parameter that can be declared by another class."""
    twin = copy(parameter)
    for slot in ("name", "owner"):
        object.__setattr__(twin, slot, None)
    return twin
