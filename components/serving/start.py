"""The start page, which needs no session: all scenes as small pictures, the walks, and the code of a live class."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property

from jinja2 import Template

from components.scene import Scene
from components.scene.thing import HIGH, WIDE, Thing
from components.serving.handlers import templates
from components.serving.shell import navigation, version
from components.state.link import PAGE_KEYS, read_query

LOOKS = frozenset({"theme", "projector"})
"""Keys of a link that only change the look of a page. They open no scene."""


@cache
def start_template() -> Template:
    """The template of the start page."""
    return templates().get_template("start.html")


@dataclass(frozen=True)
class StartPage:
    """Return the start page, for a link without a scene or with an unknown one."""

    scenes: Mapping[str, type[Scene]]
    walks: Sequence[Mapping[str, str]]
    things: Mapping[str, Thing]

    def asked(self, query: Mapping[str, Sequence[bytes]]) -> str | None:
        """Return the start page if the link names no scene, or an unknown one, which a sentence says; else None."""
        if query.keys() <= LOOKS:
            return self._plain
        if "scene" in query and not query.keys() & (PAGE_KEYS - LOOKS):
            problems = read_query({"scene": query["scene"]}, self.scenes).problems
            return self._page(problems[0]) if problems else None
        return None

    @cached_property
    def _plain(self) -> str:
        return self._page()

    @cached_property
    def _pictures(self) -> dict[str, str]:
        return {slug: thing() for slug, thing in self.things.items()}

    def _page(self, problem: str = "") -> str:
        return start_template().render(
            version=version(),
            first=next(iter(self.scenes)),
            navigation=navigation(self.scenes),
            pictures=self._pictures,
            walks=self.walks,
            wide=WIDE,
            high=HIGH,
            problem=problem,
        )
