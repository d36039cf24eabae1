"""Every scene in each option of each of its choices, for tests over a grid of screens."""

from __future__ import annotations

from collections.abc import Iterator

from components.scene import Scene
from tests.scenes.checks import choices

GRID = (
    *((1250, 590), (1024, 768), (844, 390), (360, 640)),
    *((1280, 720), (1249, 1000), (1920, 1080), (2560, 1440), (3840, 2160), (1600, 480)),
    *((853, 480), (768, 1024), (640, 360), (600, 800), (390, 844), (320, 640), (320, 320)),
)
"""Sizes of windows."""


def seen(scene: type[Scene]) -> Iterator[Scene]:
    """The scene as it opens, then with each other option of each choice."""
    yield (opens := scene.at())
    yield from (scene.at(choice) for choice in choices(scene) if opens.differing(choice))
