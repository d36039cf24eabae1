"""Every message of the browser while a function fails that its handler calls: the visitor gets an error, and the page
is unchanged and continues.
"""

import sys
from types import CodeType, FrameType
from typing import Any, get_args

import pytest

from components.language.messages import BrowserMessage
from components.quantities.refusals import SORRY
from components.scenes import SCENES
from components.session import session
from components.state.commands import RefusalError
from components.state.wire import packed
from tests.grids import WHOLE
from tests.page.headless_page import Page, set_values

MESSAGES: dict[str, dict[str, Any]] = {
    "about": {},
    "act": {"name": ""},
    "choose": {"name": "view", "value": "roots"},
    "csv": {},
    "given": {"answer": {"walk": "", "step": ""}},
    "lead": {"code": "", "key": ""},
    "open": {"state": {"scene": "damped", "parameters": {"k": 50.0}}},
    "rows": {"piece": 0, "of": 1, "t": [], "columns": [[]]},
    "run": {"order": "cancel"},
    "set": {"values": {"k": 50.0}},
    "typed": {"name": "k", "text": "50"},
    "walk": {"name": "", "text": ""},
}
NOTHING_FAILS = {"cancel_fit"}
"""Its handler calls no function of another module but the one that packs the answer."""
ANSWERS = (RefusalError.__init__.__code__, packed.__code__)
"""The handler has done its work when these are called."""
BROKEN = 40 if WHOLE else 6
"""Functions that fail, of each kind of message."""


def handled(page: Page, kind: str, broken: CodeType | None = None) -> tuple[list[CodeType], dict[str, Any]]:
    """Return the functions that a handler calls until its answer is known, and the answer. The one `broken` fails."""
    called: dict[CodeType, None] = {}

    def watch(frame: FrameType, event: str, argument: object) -> None:
        code = frame.f_code
        if code in ANSWERS:
            sys.setprofile(None)
        elif event == "call" and "/components/" in code.co_filename and code.co_filename != session.__file__:
            called[code] = None
            if code is broken:
                raise RuntimeError(f"{code.co_name} is broken")

    sys.setprofile(watch)
    try:
        answer = page.send({"type": kind, **MESSAGES[kind], "number": 4})
    finally:
        sys.setprofile(None)
    return list(called), answer


def test_there_is_a_message_of_each_kind() -> None:
    kinds = {kind.__struct_config__.tag for kind in get_args(BrowserMessage)}
    assert kinds - NOTHING_FAILS == MESSAGES.keys()


@pytest.mark.parametrize("kind", MESSAGES)
def test_a_failing_handler_is_reported_and_the_page_continues(kind: str) -> None:
    handled(Page(SCENES["damped"]()), kind)  # fills the caches
    called, _ = handled(Page(SCENES["damped"]()), kind)
    for broken in called[:: max(1, len(called) // BROKEN)]:
        page = Page(SCENES["damped"]())
        before = page.now
        reached, answer = handled(page, kind, broken)
        assert broken in reached
        assert (answer["answer"], SORRY in str(answer)) == (4, True), (broken, answer)
        assert page.now == before, broken
        told = set_values(page, k=77.0)
        assert (told["answer"], told["settings"]["k"]["value"]) == (2, 77.0)
