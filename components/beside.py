"""Hold: another picture of the scene, drawn under the one that stands, in its frame and its view.

What is held are quantities, and choices that make another system (`Scene.physical`). How things are shown is that of
the scene that stands: so what is held survives every change of view.
"""

from __future__ import annotations

from typing import ClassVar, Generic, Protocol, TypeVar

from components.page.state import Frame
from components.parameters import AnyParameter, Quantity, Values
from components.picture import Framed, Picture, beside
from components.refusals import in_words

WINDOW, HIDDEN = "window", "hidden"


class Holding(Protocol):
    """What is asked of a scene here."""

    physical: ClassVar[tuple[str, ...]]

    @classmethod
    def linked(cls) -> dict[str, AnyParameter]: ...
    def set(self, values: Values) -> None: ...
    def picture(self, frame: Frame) -> Picture: ...


HeldScene = TypeVar("HeldScene", bound=Holding)


def holdable(scene: type[Holding]) -> dict[str, AnyParameter]:
    """The parameters that are held; the others say how a picture is shown."""
    return {name: parameter for name, parameter in scene.linked().items() if not _is_view(scene, name, parameter)}


def _is_view(scene: type[Holding], name: str, parameter: AnyParameter) -> bool:
    return name == WINDOW or (not isinstance(parameter, Quantity) and name not in scene.physical)


class Beside(Generic[HeldScene]):
    """A scene with the values held, shown as the scene that stands is."""

    def __init__(self, like: HeldScene, values: Values) -> None:
        """ValueError for values that the scene cannot have."""
        kind = type(like)
        self.scene = kind()
        self.scene.set({name: value for name, value in values.items() if name in holdable(kind)})
        self._drawn: tuple[Frame, Picture] | None = None

    @property
    def values(self) -> dict[str, object]:
        """What is held and not at its default."""
        return own_values(self.scene)

    def with_held(self, scene: HeldScene, drawn: Framed) -> Framed:
        """What is drawn of a scene, with what is held beside it."""
        if show_as(self.scene, scene):
            self._drawn = None
        return beside(drawn, scene.picture, self.picture)

    def picture(self, frame: Frame) -> Picture:
        """The picture held, in a frame; worked out once as long as that stands."""
        if self._drawn is None or self._drawn[0] != frame:
            with in_words():
                self._drawn = frame, self.scene.picture(frame)
        return self._drawn[1]


def own_values(scene: Holding) -> dict[str, object]:
    """What is not at its default, but for how it is shown."""
    known = holdable(type(scene))
    return {name: getattr(scene, name) for name in known if getattr(scene, name) != known[name].default}


def show_as(scene: HeldScene, other: HeldScene) -> bool:
    """Have a scene show its picture as another of its kind does; whether that is another way than before."""
    views = [name for name in other.linked() if name not in holdable(type(other)) and name != HIDDEN]
    others = {name: getattr(other, name) for name in views if getattr(other, name) != getattr(scene, name)}
    if others:
        scene.set(others)
    return bool(others)


def changed(scene: HeldScene, other: HeldScene) -> tuple[str, ...]:
    """The parameters in which two scenes of one kind differ, but for how they are shown."""
    return tuple(name for name in holdable(type(scene)) if getattr(scene, name) != getattr(other, name))
