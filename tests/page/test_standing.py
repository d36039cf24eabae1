"""The page state is a value: refused or failing messages do not change it."""

from __future__ import annotations

from typing import Any

import pytest

from components.scenes import SCENES
from tests.page.headless_page import Page

HUGE = {"scene": "forced", "parameters": {"omega": 1e300}}
REFUSED: dict[str, tuple[str, dict[str, Any]]] = {
    "set, by its bounds": ("coupled", {"type": "set", "values": {"k2": -1.0}}),
    "set, by the physics": ("coupled", {"type": "set", "values": {"x1_0": 1e308, "k2": 1e308}}),
    "set in a hand": ("coupled", {"type": "set", "values": {"m1": 0.0}, "holding": True}),
    "set as a hand lets go": ("coupled", {"type": "set", "values": {"m1": 0.0}, "holding": False}),
    "typed": ("coupled", {"type": "typed", "name": "k2", "text": "many"}),
    "choose": ("coupled", {"type": "choose", "name": "view", "value": "loud"}),
    "act": ("coupled", {"type": "act", "name": "nothing"}),
    "open": ("coupled", {"type": "open", "state": HUGE}),
    "open, carried": ("coupled", {"type": "open", "state": HUGE, "carried": True}),
    "open, of another kind": ("coupled", {"type": "open", "state": {"scene": "nowhere"}}),
    "run": ("coupled", {"type": "run", "order": "start"}),
    "run, of a scene that can": ("accuracy", {"type": "run", "order": "skip it"}),
    "read": ("coupled", {"type": "walk", "name": "mine", "text": "="}),
    "given": ("coupled", {"type": "given", "walk": "no", "step": "no"}),
    "about": ("coupled", {"type": "about"}),
    "csv": ("coupled", {"type": "csv", "page": ""}),
    "no message": ("coupled", {"type": "set", "values": {"k2": "three"}}),
}


@pytest.mark.parametrize("said", REFUSED)
def test_after_a_refusal_the_page_state_is_the_same_object(said: str) -> None:
    slug, message = REFUSED[said]
    page = Page(SCENES[slug]())
    before = page.now
    told = page.send({**message, "number": 7})
    assert page.now is before
    assert said in ("about", "csv", "given", "read", "run, of a scene that can") or told["errors"]
