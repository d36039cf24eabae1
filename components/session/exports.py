"""Files with the numbers of a page, and reports of their errors, computed in the worker process. They may take longer
than a picture, because a file has each point of each curve, rounded once.
"""

from __future__ import annotations

from msgspec import Struct

from components.language.messages import File
from components.language.state import State
from components.quantities.refusals import in_words
from components.scene.about import About, about_numbers
from components.session.links import linked, page_state_of
from components.state.commands import sentence
from components.state.csv_export import as_file, as_table
from components.state.page_state import page_state_in
from components.state.wire import Packet, packed
from components.walks import Query, Walks
from components.walks.links import Scenes


class PageExport(Struct, frozen=True, tag=True):
    """The job to make the file of a page in `state`. `page` is its address, `answer` the number of the request."""

    state: State
    page: str
    answer: int | None


class LinkExport(Struct, frozen=True, tag=True):
    """The job to make one table of the page that a link opens. `page` is the address before the link's query."""

    query: dict[str, list[bytes]]
    page: str


class AboutExport(Struct, frozen=True, tag=True):
    """The job to compute "About these numbers" for a page in `state`. `answer` is the number of the request."""

    state: State
    answer: int | None


def page_file(asked: PageExport, scenes: Scenes) -> Packet:
    """Return the file as a message. Raises ValueError, with a reason, if a number cannot be computed."""
    now = page_state_in(scenes[asked.state.scene], asked.state)
    try:
        with in_words():
            return packed(as_file(now.asked, now.to_send[0], asked.page, asked.answer))
    except ValueError as reason:
        raise ValueError(f"These numbers cannot be saved: {str(reason).rstrip('.')}.") from reason


def link_file(query: Query, page: str, scenes: Scenes, walks: Walks) -> File:
    """Return the first table of a link's page without its covered parts, or the one that `table` names.

    Raises ValueError, with a reason, for anything in the link that is not possible.
    """
    (*_, table) = ("", *(name.decode("utf-8", "replace") for name in query.get("table", ())))
    link, step = linked({key: given for key, given in query.items() if key != "table"}, scenes, walks)
    now, refused = page_state_of(scenes[link.slug], link, step)
    if problems := [*link.problems, *refused]:
        raise ValueError(" ".join(problems))
    try:
        with in_words():
            return as_table(now.asked, now.to_send[0], page, table)
    except ValueError as reason:
        raise ValueError(sentence(reason)) from reason


def about_page(asked: AboutExport, scenes: Scenes) -> Packet:
    """Return "About these numbers" as a message; if the numbers cannot be recomputed, a sentence says why."""
    now = page_state_in(scenes[asked.state.scene], asked.state)

    def ask() -> About | None:
        if now.covered:
            raise ValueError("they would reveal hidden parts")
        return now.scene.about(now.shown)

    return packed(about_numbers(ask, asked.answer))
