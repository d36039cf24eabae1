"""Moderation: the answers in words that the instructor shows the hall, and those that are removed."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct
from msgspec.structs import replace

from components.language.room import Moderate, WordGroup
from components.walks.questions.words import normalized

MOST = 500
"""Answers to one vote that can be shown, and as many that can be removed."""


class Moderation(Struct, frozen=True, kw_only=True):
    """The normalized answers to one vote that are shown, and those that are removed."""

    question: str = ""
    shown: tuple[str, ...] = ()
    removed: tuple[str, ...] = ()

    def after(self, order: Moderate, question: str) -> Moderation:
        """Return it after an order; ValueError, in words, where too many were moderated. Another vote begins anew."""
        before = self if self.question == question else Moderation(question=question)
        text = normalized(order.text)
        shown = tuple(one for one in before.shown if one != text)
        removed = tuple(one for one in before.removed if one != text)
        if max(len(shown), len(removed)) >= MOST:
            raise ValueError(f"At most {MOST} answers to one vote can be shown or removed.")
        added = {"shown": (*shown, text)} if order.shows else {"removed": (*removed, text)}
        return replace(before, **{"shown": shown, "removed": removed, **added})

    def moderated(self, words: Iterable[WordGroup], question: str) -> tuple[WordGroup, ...]:
        """Return the groups without those that are removed, and which of them are shown."""
        if self.question != question:
            return tuple(words)
        shown, removed = set(self.shown), set(self.removed)
        told = ((one, normalized(one.text)) for one in words)
        return tuple(replace(one, shown=text in shown) for one, text in told if text not in removed)
