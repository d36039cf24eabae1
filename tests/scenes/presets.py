"""Scenes after a preset was chosen, and their readouts by name."""

from __future__ import annotations

from typing import Any

from components.scene import Scene
from components.scenes import SCENES


def taken(slug: str, label: str) -> Any:
    scene: Scene = SCENES[slug]()
    scene.set({name: scene.preset_value(label, name) for name in scene.preset_names()})
    return scene


def readout(scene: Scene, name: str) -> float:
    return next(one.value for one in scene.readouts() if one.name == name)
