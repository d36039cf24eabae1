"""The states that the links of a step stand for."""

from __future__ import annotations

from collections.abc import Mapping
from urllib.parse import parse_qs

from msgspec.structs import replace

from components.choices import stated
from components.page.state import State
from components.scene import Scene
from components.url import Link, read_query
from components.walks.types import BaseStep

Scenes = Mapping[str, type[Scene]]


def read_link(link: str, scenes: Scenes) -> Link:
    """What a step's link asks for; ValueError, in words, for one that asks for what is not there."""
    args = {key: [value.encode() for value in values] for key, values in parse_qs(link.removeprefix("?")).items()}
    if "scene" not in args:
        raise ValueError("a link names its scene: ?scene=coupled&k2=3")
    found = read_query(args, scenes)
    if found.problems:
        raise ValueError(" ".join(found.problems))
    return found


def scene_at(link: str, scenes: Scenes) -> Scene:
    """The scene of a link."""
    found = read_link(link, scenes)
    scene = scenes[found.slug]()
    scene.set(found.values)
    return scene


def state_of_link(link: str, scenes: Scenes) -> State:
    """The state of a link, as a message carries it."""
    found = read_link(link, scenes)
    return State(scene=found.slug, parameters={name: stated(value) for name, value in found.values.items()})


def opening_state(walk: str, step: BaseStep, scenes: Scenes) -> State:
    """The state that a step's question is asked of."""
    return replace(state_of_link(step.state, scenes), covered=step.cover, step=f"{walk}/{step.id}")


def answer_state(walk: str, step: BaseStep, scenes: Scenes) -> State:
    """The state that is shown with its answer."""
    return replace(state_of_link(step.shown, scenes), step=f"{walk}/{step.id}")
