"""The page of a link: a session that is where the link wants it."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec.structs import replace

from components.language.state import State
from components.quantities.refusals import LINK_LOST, report
from components.scene import Scene
from components.session.session import Session
from components.state.commands import sentence
from components.state.covers import NEXT, refused_covers
from components.state.link import Link
from components.state.standing import Standing, fitted, standing_in
from components.state.states import state_in, strange_axes
from components.walks import Walks


def opened(scenes: Mapping[str, type[Scene]], link: Link, walks: Walks | None = None, step: str = "") -> Session:
    """The page of a link: where its values cannot be shown, the scene as it is without them, and why."""
    kind, problems = scenes[link.slug], list(link.problems)
    try:
        now, refused = standing_of(kind, link, step)
        session = Session(now, (*problems, *refused), scenes=scenes, walks=walks)
        session.first = session.opening()
    except Exception as error:
        report(error)
        return Session(fitted(kind.at()), (*problems, LINK_LOST), scenes=scenes, walks=walks)
    return session


def standing_of(kind: type[Scene], link: Link, step: str = "") -> tuple[Standing, list[str]]:
    """The standing that a link asks for; and what of that cannot be, in words."""
    state, problems = replace(state_in(link), step=step), []
    known = replace(state, covered=tuple(cover for cover in state.covered if cover == NEXT))
    try:
        now = standing_in(kind, known)
    except ValueError as reason:
        problems.append(f"{sentence(reason)} The link's parameters were not used.")
        known = State(scene=state.scene, step=state.step)
        now = standing_in(kind, known)
    refused = refused_covers(kind, now.shown, state.covered)
    problems += [*strange_axes(now.shown, state), *refused.values()]
    covered = tuple(cover for cover in state.covered if cover not in refused)
    return now if covered == known.covered else standing_in(kind, replace(known, covered=covered)), problems
