"""The shared system: several scenes show the same physical system, so its values stay from scene to scene.

If a visitor has changed the system in one scene, every scene that shows it, or a part of it, takes over its values. A
scene that shows its default system drops the shared one.
"""

from __future__ import annotations

from collections.abc import Mapping

from components.quantities.parameters import Values
from components.scene import Scene

Shared = Mapping[str, object]
"""Values by their physical meaning."""


def taken_along(scene: Scene, before: Shared) -> Shared:
    """Return the shared values after a visit to a scene; `before` are the shared values from earlier scenes."""
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
