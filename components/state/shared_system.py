"""The shared system: several scenes speak of one, and it goes along from scene to scene by what its parameters mean.

A system goes along whole, from a scene that shows it and where it is not the scene's own, to every scene that shows it
or a part of it. A scene that shows its own gives up what was taken along before.
"""

from __future__ import annotations

from collections.abc import Mapping

from components.quantities.parameters import Values
from components.scene import Scene

Shared = Mapping[str, object]
"""Values by what they mean."""


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
    """The values that a scene takes of what goes along."""
    taken = {name: shared[meaning] for meaning, name in scene.shares.items() if meaning in shared}
    return {**scene.sharing, **taken} if taken else {}
