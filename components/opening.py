"""The page of a link: a session that is where the link wants it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from components.covers import NEXT, coverable, refused_covers
from components.deeds import sentence
from components.page.state import State
from components.predicting import asked_in, asked_of, standing
from components.refusals import LINK_LOST, report
from components.scene import Scene
from components.session import Session
from components.states import put, state_in, strange_axes
from components.url import Link
from components.walks import Walks


def opened(scenes: Mapping[str, type[Scene]], link: Link, walks: Walks | None = None, step: str = "") -> Session:
    """The page of a link: where its values cannot be shown, the scene as it is without them, and why."""
    scene, problems = scenes[link.slug](), list(link.problems)
    back = scene.way_back()
    try:
        problems += _refused(scene, state_in(link, type(scene)))
        covered = [cover for cover in link.covered if cover in coverable(type(scene), scene.shown)]
        session = Session(scene, tuple(problems), scenes=scenes, covered=tuple(covered), walks=walks, step=step)
        if link.before is not None and NEXT in covered:
            before = asked_in(scene, link.before, link.frame)
            scene.open(link.values, standing(before, link.frame), link.held)
            session.asked = asked_of(scene, before)
        session.first = session.opening()
    except Exception as error:
        report(error)
        back()
        return Session(scene, (*problems, LINK_LOST), scenes=scenes, walks=walks)
    return session


def _refused(scene: Scene, state: State) -> Iterator[str]:
    """Puts the scene where the link wants it; what of that cannot be, in words."""
    try:
        put(scene, state)
    except ValueError as reason:
        yield f"{sentence(reason)} The link's parameters were not used."
    yield from strange_axes(scene, state)
    yield from refused_covers(type(scene), scene.shown, state.covered)
