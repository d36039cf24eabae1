"""The fields common to all steps of a walk's TOML file, and the types of their texts and links."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, TypeAlias

from msgspec import Meta, Struct

Slug: TypeAlias = Annotated[str, Meta(pattern=r"^[a-z0-9][a-z0-9-]*$", max_length=40)]
Sentence: TypeAlias = Annotated[str, Meta(min_length=1, max_length=600)]
Address: TypeAlias = Annotated[str, Meta(max_length=8000)]
"""A link, with the maximum length that a server accepts (components/serving/pages.py)."""
Slide: TypeAlias = Annotated[str, Meta(pattern=r"^[A-Z0-9]+-N?\d+$")]
Span: TypeAlias = tuple[float, float]
"""The range of a quantity in SI units."""
Above0: TypeAlias = Annotated[float, Meta(gt=0)]


class Entry(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A table of a walk's file. Unknown fields are errors."""


class Reply(Entry, frozen=True, kw_only=True):
    """The reply to an answer, the misconception behind the answer, and `where`, a link to a case that the reply
    mentions."""

    idea: str = ""
    reply: str = ""
    where: Address = ""


class BaseStep(Entry, frozen=True, kw_only=True, tag_field="kind"):
    """One idea: a question, its state, the parts hidden until it is answered, and the explanation.

    `state` is the link to the picture of the question, `reveal` the link to the picture of the answer, if that differs.
    `still`
    lists covers that stay after the answer, because a later step asks for them. `show` are the visible parts of the
    scene, by default those of its view. `vary` has ranges by quantity, from which each student gets different numbers:
    components/walks/variants.py. `controls` are the parameters that can be changed after the answer; `next` suggests
    what to try with the first one. The `core` steps of a walk make a shorter one. If `closes`, the end of a countdown
    closes the vote. With `derive` a clicker also shows the formulas in `follows`. `notes` are for the instructor's
    remote control.
    """

    id: Slug
    title: Sentence
    question: Sentence
    state: Address
    explain: Sentence
    vary: Annotated[dict[str, Span], Meta(max_length=4)] = {}
    follows: Annotated[str, Meta(max_length=2000)] = ""
    next: str = ""
    slides: tuple[Slide, ...] = ()
    reveal: Address = ""
    cover: tuple[str, ...] = ()
    still: tuple[str, ...] = ()
    show: tuple[str, ...] = ()
    controls: Annotated[tuple[str, ...], Meta(max_length=3)] = ()
    minutes: float | None = None
    core: bool = False
    derive: bool = False
    closes: bool = False
    notes: Annotated[str, Meta(max_length=2000)] = ""

    @property
    def shown(self) -> str:
        """The link to the picture of the answer."""
        return self.reveal or self.state

    def links(self) -> Iterator[str]:
        """Every link."""
        yield from (self.state, self.shown)

    @property
    def equations(self) -> tuple[str, ...]:
        """The lines of `follows`, each a formula."""
        return lines(self.follows)

    @property
    def noted(self) -> tuple[str, ...]:
        """The lines of `notes`."""
        return lines(self.notes)

    def sentences(self) -> Iterator[tuple[str, str]]:
        """All texts of the step by the names of their fields."""
        for name in ("title", "question", "explain", "next"):
            yield name, getattr(self, name)
        yield from (("notes", line) for line in self.noted)


def lines(text: str) -> tuple[str, ...]:
    """The lines of a text that are not empty."""
    return tuple(line for line in map(str.strip, text.splitlines()) if line)
