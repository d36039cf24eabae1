"""The compared scene (the button Hold): another scene of the same class, drawn under the current one.

It keeps its quantities, and its choices that change the physical system (`Scene.physical`). Parameters that only
change the display come from the current scene, so that both are drawn in the same view and frame.
"""

from __future__ import annotations

from functools import cache
from typing import TypeVar

from components.quantities.parameters import AnyParameter, Quantity
from components.scene import Scene

WINDOW, HIDDEN = "window", "hidden"

AnyScene = TypeVar("AnyScene", bound=Scene)


@cache
def holdable(scene: type[Scene]) -> dict[str, AnyParameter]:
    """Return the parameters that a compared scene keeps; the others only set the display or record progress."""
    known = scene.linked().items()
    return {name: one for name, one in known if one not in scene.reached and not _is_view(scene, name, one)}


def _is_view(scene: type[Scene], name: str, parameter: AnyParameter) -> bool:
    return name == WINDOW or (not isinstance(parameter, Quantity) and parameter not in scene.physical)


def own_values(scene: Scene) -> dict[str, object]:
    """Return the parameters that are not at their defaults, without those that only change the display."""
    known = holdable(type(scene))
    return {name: value for name, value in scene.off_default().items() if name in known}


def shown_as(scene: AnyScene, other: Scene, *also: str) -> AnyScene:
    """Return a scene with the display parameters of another one of its class.

    Switched-off curves are only copied if `also` contains `HIDDEN`.
    """
    views = [name for name, one in scene.linked().items() if _is_view(type(scene), name, one)]
    return scene.changed({name: other.values[name] for name in views if name != HIDDEN or name in also})


def moved(scene: Scene, other: Scene) -> tuple[str, ...]:
    """Return the parameters, except for the display, in which two scenes of one kind differ."""
    return tuple(name for name in holdable(type(scene)) if scene.values[name] != other.values[name])
