"""The page of a link: a session in the state of the link."""

from __future__ import annotations

from collections.abc import Mapping

from components.quantities.refusals import LINK_LOST, report
from components.scene import Scene
from components.session.links import page_state_of
from components.session.session import Session
from components.state.link import Link
from components.state.page_state import fitted
from components.walks import Walks


def opened(scenes: Mapping[str, type[Scene]], link: Link, walks: Walks | None = None, step: str = "") -> Session:
    """Return the page of a link; if its values are not possible, the scene with its defaults, and the reason."""
    kind, problems = scenes[link.slug], list(link.problems)
    try:
        now, refused = page_state_of(kind, link, step)
        session = Session(now, (*problems, *refused), scenes=scenes, walks=walks)
        session.first = session.opening()
    except Exception as error:
        report(error)
        return Session(fitted(kind.at()), (*problems, LINK_LOST), scenes=scenes, walks=walks)
    return session
