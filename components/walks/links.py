"""The states of the links of a step."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from urllib.parse import parse_qs

from msgspec.structs import replace

from components.language.state import State
from components.scene import Scene
from components.state.link import Link, read_query
from components.state.page_state import PageState, page_state_in
from components.state.states import state_in, strange_axes, strange_curves
from components.walks.types import BaseStep

Scenes = Mapping[str, type[Scene]]


def read_link(link: str, scenes: Scenes) -> Link:
    """Return the parsed link of a step. Raises ValueError, with a reason, if it asks for something unknown."""
    query = parse_qs(link.removeprefix("?"), keep_blank_values=True)
    args = {key: [value.encode() for value in values] for key, values in query.items()}
    if "scene" not in args:
        raise ValueError("a link names its scene: ?scene=coupled&k2=3")
    found = read_query(args, scenes)
    if problems := [*found.problems, *_of_the_page(found)]:
        raise ValueError(" ".join(problems))
    return found


def _of_the_page(link: Link) -> Iterator[str]:
    """Return a sentence for each part of a link that is possible in the link of a page, but not in a walk."""
    if link.covered:
        yield "cover: list hidden parts in the field cover of the step."
    if link.before is not None:
        yield "before: a step cannot begin with an open prediction. Press Reveal, then copy the link."


def page_state_at(link: str, scenes: Scenes) -> PageState:
    """Return the page state of a page that opens a link."""
    state = state_of_link(link, scenes)
    kind = scenes[state.scene]
    found = page_state_in(kind, state)
    if strange := [*strange_axes(found.shown, state), *strange_curves(kind, state)]:
        raise ValueError(" ".join(strange))
    return found


def state_of_link(link: str, scenes: Scenes) -> State:
    """Return the state of a link, as a message contains it."""
    return state_in(read_link(link, scenes))


def name_in_state(walk: str, step: BaseStep, seed: int = 0) -> str:
    """Return the name of a step in a state, "d34/d34-07", or "d34/d34-07/5" with the numbers of a seed."""
    return "/".join((walk, step.id, *([str(seed)] if seed else [])))


def opening_state(name: str, step: BaseStep, scenes: Scenes) -> State:
    """Return the state for a step's question; `name` is the step's name in a state."""
    return replace(state_of_link(step.state, scenes), covered=step.cover, step=name, show=step.show)


def elsewhere(name: str, step: BaseStep, link: str, scenes: Scenes) -> State:
    """Return the state of another link of the step, with its answer shown."""
    state = state_of_link(link, scenes)
    is_same = state.scene == state_of_link(step.state, scenes).scene
    return replace(state, covered=step.still if is_same else (), step=name, show=step.show if is_same else ())
