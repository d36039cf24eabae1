"""Moderation: the instructor shows answers in words to the hall, and removes others."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct
from msgspec.structs import replace

from components.language.class_messages import Moderate, WordGroup
from components.walks.questions.words import normalized

MOST = 500
"""Maximum number of shown answers to one vote, and of removed ones."""


class Moderation(Struct, frozen=True, kw_only=True):
    """The shown and the removed answers to one vote, normalized."""

    question: str = ""
    shown: tuple[str, ...] = ()
    removed: tuple[str, ...] = ()

    def after(self, order: Moderate, question: str) -> Moderation:
        """Return the moderation after an order; a new vote starts with no shown or removed answers. Raises ValueError
        for too many answers."""
        before = self if self.question == question else Moderation(question=question)
        text = normalized(order.text)
        shown = tuple(one for one in before.shown if one != text)
        removed = tuple(one for one in before.removed if one != text)
        if max(len(shown), len(removed)) >= MOST:
            raise ValueError(f"At most {MOST} answers to one vote can be shown or removed.")
        added = {"shown": (*shown, text)} if order.shows else {"removed": (*removed, text)}
        return replace(before, **{"shown": shown, "removed": removed, **added})

    def moderated(self, words: Iterable[WordGroup], question: str) -> tuple[WordGroup, ...]:
        """Return the groups without the removed ones, each marked if it is shown."""
        if self.question != question:
            return tuple(words)
        shown, removed = set(self.shown), set(self.removed)
        pairs = ((one, normalized(one.text)) for one in words)
        return tuple(replace(one, shown=text in shown) for one, text in pairs if text not in removed)
