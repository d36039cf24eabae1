"""Links of the address: each opens a scene with values, or a step of a walk."""

from __future__ import annotations

import dataclasses

from msgspec.structs import replace

from components.language.state import State
from components.scene import Scene
from components.state.commands import sentence
from components.state.covers import NEXT, refused_covers
from components.state.link import Link, read_query
from components.state.page_state import PageState, page_state_in
from components.state.states import state_in, strange_axes
from components.walks import Query, Walks
from components.walks.links import Scenes, read_link
from components.walks.registry import asked_step


def linked(query: Query, scenes: Scenes, walks: Walks) -> tuple[Link, str]:
    """Return the link of an address and the name of its walk step, or ""."""
    problems = []
    try:
        if asked := asked_step(query, walks):
            step, name = asked
            return dataclasses.replace(read_link(step.state, scenes), covered=step.cover, show=step.show), name
    except ValueError as reason:
        problems.append(str(reason))
    link = read_query(query, scenes).as_opened(scenes)
    return dataclasses.replace(link, problems=[*problems, *link.problems]), ""


def _drawn(kind: type[Scene], state: State, *, is_covered: bool) -> PageState:
    """Return the page state of a link, as a page may have shown it: other views may need numbers beyond doubles."""
    try:
        return page_state_in(kind, state)
    except ValueError as reason:
        if is_covered:
            raise
        try:
            return page_state_in(kind, state, in_view=True)
        except ValueError:
            raise reason from None


def page_state_of(kind: type[Scene], link: Link, step: str = "") -> tuple[PageState, list[str]]:
    """Return the page state of a link, and sentences on its impossible parts."""
    state, problems = replace(state_in(link), step=step), []
    known = replace(state, covered=tuple(cover for cover in state.covered if cover == NEXT))
    try:
        now = _drawn(kind, known, is_covered=bool(state.covered))
    except ValueError as reason:
        problems.append(f"{sentence(reason)} The link's parameters were not used.")
        known = State(scene=state.scene, step=state.step)
        now = page_state_in(kind, known)
    refused = refused_covers(kind, now.shown, state.covered)
    problems += [*strange_axes(now.shown, state), *refused.values()]
    covered = tuple(cover for cover in state.covered if cover not in refused)
    return now if covered == known.covered else page_state_in(kind, replace(known, covered=covered)), problems
