"""The shared system: several scenes show the same physical system, so its values are kept from scene to scene.

A system is kept whole, from a scene that has changed it, to every scene that shows it or a part of it. A scene that
shows its default system drops the shared one.
"""

from __future__ import annotations

from collections.abc import Mapping

from components.quantities.parameters import Values
from components.scene import Scene

Shared = Mapping[str, object]
"""Values by their physical meaning."""


def taken_along(scene: Scene, before: Shared) -> Shared:
    """The shared values that leave a scene, to which others have brought `before`."""
    if any(getattr(scene, name) != value for name, value in scene.sharing.items()):
        return before
    kind = type(scene)
    others = {meaning: value for meaning, value in before.items() if meaning not in kind.shares}
    if all(getattr(scene, name) == kind.param[name].default for name in kind.shares.values()):
        return others
    return others | {meaning: getattr(scene, name) for meaning, name in kind.shares.items()}


def brought(scene: type[Scene], shared: Shared) -> Values:
    """Return the values that a scene takes over from the shared system."""
    taken = {name: shared[meaning] for meaning, name in scene.shares.items() if meaning in shared}
    return {**scene.sharing, **taken} if taken else {}
