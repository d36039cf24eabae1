"""Polls in the file of a walk: they have no cover, explanation or right answer, and keep the previous picture."""

from __future__ import annotations

import pytest

from components.scenes import SCENES
from components.walks.checking import problems, shortcomings
from components.walks.loading import WalkError, load_walks, read_walk, steps_of
from components.walks.walk import Walk

POLL = """[[step]]
id = "speed"
poll = true
question = "How fast is this?"
options = [{ text = "Too fast" }, { text = "Right" }, { text = "Too slow" }]
"""
TITLE = 'title = "T"\n'
FIRST, SECOND = (f'[[step]]\nid = "{step}"\nfrom = "{step}"\n' for step in ("d34-04", "d34-07"))


def read(text: str) -> Walk:
    return read_walk(text, "mine", steps_of(load_walks(()).values()))


def test_it_is_between_two_steps_of_one_scene() -> None:
    walk = read(TITLE + FIRST + POLL + SECOND)
    assert list(problems(walk, SCENES)) == list(shortcomings(walk, SCENES)) == []
    before, poll, _ = walk.steps
    assert (poll.state, poll.cover, poll.show) == (before.shown, before.still, before.show)
    assert not poll.judges and poll.title == poll.question


def test_one_that_opens_a_walk_has_a_state_and_nothing_else_of_a_question() -> None:
    with pytest.raises(WalkError, match="missing required field `state`"):
        read(TITLE + POLL)
    walk = read(TITLE + POLL.replace("poll =", 'state = "?scene=coupled"\npoll ='))
    assert list(problems(walk, SCENES)) == list(shortcomings(walk, SCENES)) == []
