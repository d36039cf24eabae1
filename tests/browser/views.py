"""Every scene in each option of each of its choices, for tests over a grid of screens."""

from __future__ import annotations

from collections.abc import Iterator

from components.scene import Scene
from components.scenes import SCENES
from components.state.page_state import fitted
from tests.grids import WHOLE
from tests.scenes.checks import choices

SAMPLE = ((1250, 590), (1024, 768), (844, 390), (360, 640))
GRID = (
    *SAMPLE,
    *((1280, 720), (1249, 1000), (1920, 1080), (2560, 1440), (3840, 2160), (1600, 480)),
    *((853, 480), (768, 1024), (640, 360), (600, 800), (390, 844), (320, 640), (320, 320)),
)
"""Sizes of windows, of which a sample is tested."""


def seen(scene: type[Scene]) -> Iterator[Scene]:
    """The scene as it opens, then with each other option of each choice."""
    yield (opens := scene.at())
    yield from (scene.at(choice) for choice in choices(scene) if opens.differing(choice))


LINKS = [fitted(view).query for scene in SCENES.values() for view in (seen(scene) if WHOLE else [scene.at()])]
"""All views; a sample has each scene as it opens."""

SCREENS = [(theme, width, height) for theme in ("light", "dark") for width, height in ((1280, 720), (390, 844))]


def screens(link: str) -> list[tuple[str, int, int]]:
    """Theme and size for a link; a sample takes one for each link, a different one for the next."""
    return SCREENS if WHOLE else [SCREENS[LINKS.index(link) % len(SCREENS)]]
