"""One page under any sequence of messages; its laws hold after each of them.

The link and a new session give the state back, undo gives the previous one back, a refused message changes nothing and
is worded, the picture is finite, hidden answers are in no message, and the work stays within its budget.
"""

import json
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import Phase, settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
    run_state_machine_as_test,
)
from msgspec.structs import replace

from app import visited
from components.language.state import State
from components.layout.choices import options, word
from components.layout.controls import Choice
from components.quantities.refusals import SORRY
from components.scene import Scene
from components.scenes import SCENES
from components.state.compared import HIDDEN
from components.state.covers import NEXT, VALUE
from components.state.page_state import PageState
from components.state.scene_sheet import scene_sheet
from components.walks.cards import walk_sheet
from components.walks.loading import load_walks
from tests.grids import tries
from tests.page.headless_page import PICTURE, Page, counted, unpacked
from tests.page.test_covers import drawn, is_sent
from tests.page.test_refusals import MALFORMED, WORDED
from tests.scenes.checks import as_arguments, check_picture, quantities
from tests.states import covers, number, value

WALKS = load_walks(())
CARDS = {card.opens.step: card for walk in WALKS.values() for card in walk_sheet(walk, SCENES).steps}
ODD = ("", " ", "many", "nan", "1e999", "-1", "0", "1e-300", "1/0", "3 kg", "1/3", "pi", "<b>", "\ud800", "x" * 99)
NOTHING = {"walk": {"name": "mine", "text": "="}, "given": {"answer": {"walk": "", "step": ""}}, "csv": {}, "about": {}}
"""Messages that set nothing."""
FOLLOWING = {"own"}
"""Choices that follow from the other values."""
STRANGE: tuple[dict[str, Any], ...] = (
    *({"type": "set", "values": {"nothing": 1.0}}, {"type": "choose", "name": "view", "value": "loud"}),
    *(message for _, message, _, _ in WORDED if message["type"] == "open"),
    *(message for message in MALFORMED if isinstance(message, dict) and type(message.get("type")) is str),
)
"""Messages that every scene refuses."""


def sizes(now: PageState) -> dict[str, float]:
    """The ends of all axes, and the other sizes of the frame."""
    frame = now.asked.drawn.frame
    ends = {f"{name}{i}": end for name, span in frame.ranges.items() for i, end in enumerate(span)}
    return {**ends, "window": frame.window or 0.0, "scale": frame.scale or 0.0, "speed": frame.speed or 0.0}


class Visit(RuleBasedStateMachine):
    """A visitor's page, without a browser."""

    slug = "coupled"

    @initialize()
    def opens(self) -> None:
        self.page = Page(SCENES[self.slug]())
        self.page.session.walks = WALKS
        self.number, self.past = 0, list[State]()
        self.last: dict[str, Any] = {"type": "set", "values": {}}
        self.told = self.page.opening()

    @property
    def scene(self) -> type[Scene]:
        return self.page.now.kind

    @property
    def state(self) -> State:
        return self.page.now.state

    def say(self, **message: Any) -> dict[str, Any]:
        """Send a message, after a hand has let go; a refusal changes nothing, any other answer shows the new state."""
        if message["type"] != "set" and self.page.now.in_hand:
            self.lets_go()
        before, self.number, self.last = self.page.now, self.number + 1, message
        told, calls = counted(lambda: self.page.send({**message, "number": self.number}))
        now = self.page.now
        pictures = sum(one is not None for one in (now, now.held, now.before))
        assert calls <= 2 * PICTURE * pictures, message
        assert told["answer"] == self.number and SORRY not in str(told.get("problems"))
        if told["type"] == "kept":
            assert now.sends_the_same_as(before) and not self.told["errors"]
            return told
        if told["errors"]:
            assert now is before
            assert all(one.endswith((".", "…")) and len(one) < 400 for one in told["errors"].values()), told["errors"]
        elif now.state != before.state and not before.in_hand:  # undo goes back over a whole drag
            self.past.append(before.state)
        self.told = told
        return told

    def open(self, state: State | None = None, **to: Any) -> dict[str, Any]:
        more = {name: to.pop(name) for name in ("carried", "keeps") if name in to}
        return self.say(type="open", state=msgspec.to_builtins(state or self.state) | to, **more)

    @rule(data=st.data(), holding=st.sampled_from([None, True, False]))
    def sets(self, data: st.DataObject, holding: bool | None) -> None:
        name = data.draw(st.sampled_from(sorted(quantities(self.scene))))
        to = data.draw(number(quantities(self.scene)[name], 2.0))
        along = data.draw(st.lists(st.sampled_from(sorted(self.page.shown.axes)), max_size=2))
        self.say(type="set", values={name: to}, holding=holding, along=along)

    @rule()
    def lets_go(self) -> None:
        """The answer is short if it would repeat the last one. A repeated message is answered in full."""
        last, told = self.told, self.say(type="set", values={}, holding=False)
        again = self.page.send({**self.last, "number": self.number})
        one, other = (json.dumps({**each, "answer": 0}, default=np.ndarray.tolist) for each in (last, again))
        is_same = one == other and not self.page.session.running
        assert again["type"] == "shown" and is_same is (told["type"] == "kept")

    @rule(data=st.data(), text=st.sampled_from(ODD) | st.text(max_size=9))
    def types_odd_text(self, data: st.DataObject, text: str) -> None:
        self.say(type="typed", name=data.draw(st.sampled_from([*quantities(self.scene), "nothing"])), text=text)

    @rule(data=st.data())
    def chooses(self, data: st.DataObject) -> None:
        choices = [(name, one) for name, one in self.scene.linked().items() if isinstance(one, Choice)]
        name, option = data.draw(st.sampled_from([(name, option) for name, one in choices for option in options(one)]))
        held = self.state.held
        assert not self.say(type="choose", name=name, value=word(option))["errors"]
        assert self.page.scene.values[name] == option or name in FOLLOWING
        assert (self.state.held is None) == (held is None)

    @rule(data=st.data())
    def switches_curves(self, data: st.DataObject) -> None:
        names = data.draw(value(self.scene, HIDDEN))
        assert not self.say(type="choose", name=HIDDEN, value=names)["errors"]
        assert self.page.scene.values[HIDDEN] == names
        if data.draw(st.booleans()):
            assert not self.open(hidden=None)["errors"]
            assert self.page.scene.values[HIDDEN] == self.scene.param[HIDDEN].default

    @rule(data=st.data())
    def presses_a_button(self, data: st.DataObject) -> None:
        actions = [name for group in self.scene.groups for name, _ in group.actions]
        self.say(type="act", name=data.draw(st.sampled_from([*actions, "nothing"])))

    @rule(data=st.data())
    def takes_a_preset(self, data: st.DataObject) -> None:
        button = data.draw(st.sampled_from(scene_sheet(self.scene).panel.presets))
        told = self.open(parameters={**self.state.parameters, **button.sets}, frame=None)
        assert not told["errors"] and self.page.scene.preset() == button.label

    @rule()
    def holds_or_releases(self) -> None:
        held = self.state.parameters if self.state.held is None else None
        assert not self.open(held=held)["errors"]

    @rule(data=st.data())
    def predicts_a_change(self, data: st.DataObject) -> None:
        """A new session hides the change too. When it is revealed, every axis has room for both."""
        assert not self.open(covered=[])["errors"]
        old = self.open(covered=[NEXT])["view"]
        assert old["left_out"] == [], "until something changes"
        self.sets(data, None)
        if self.state.before is None:
            return
        assert self.state.covered[0] == NEXT
        self.reconnects()
        shown = self.open(covered=[])
        assert (self.state.before, self.state.covered, shown["view"]["left_out"]) == (None, (), [])
        for name, axis in shown["view"]["axes"].items():
            both = ((one, 10.0 ** one["exponent"]) for one in (axis, old["axes"][name]))  # each in its own unit
            (low, high), (least, most) = (sorted((one["start"] * unit, one["end"] * unit)) for one, unit in both)
            rounding = 1e-9 * (most - least)
            assert low <= least + rounding and most - rounding <= high, name

    @rule(data=st.data())
    def covers(self, data: st.DataObject) -> None:
        self.open(covered=list(data.draw(covers(self.scene))))

    @rule(slug=st.sampled_from(list(SCENES)))
    def goes_to_a_scene(self, slug: str) -> None:
        assert not self.open(State(scene=slug), carried=True)["errors"]
        assert self.scene.slug == slug and self.state.covered == ()

    @rule(step=st.sampled_from(list(CARDS)))
    def goes_to_a_step(self, step: str) -> None:
        card = CARDS[step]
        for state in (card.opens, card.reveals):
            told = self.open(state, keeps=state is card.reveals)
            assert not told["errors"] and self.state.covered == state.covered
            assert not {one.removeprefix(VALUE) for one in state.covered} & told["view"]["values"].keys()

    @precondition(lambda self: self.past)
    @rule()
    def undoes(self) -> None:
        before = self.past[-1]
        assert not self.open(before)["errors"]
        assert self.state == before
        self.past = self.past[:-1] if self.past[-1] == before else self.past[:-2]

    @precondition(lambda self: self.page.now.number == self.number)
    @rule()
    def repeats_a_message(self) -> None:
        """Send the last message again, to the session that has handled it."""
        now = self.page.now
        self.page.session.handle({**self.last, "number": self.number})
        assert self.page.now is now

    @rule(message=st.sampled_from(STRANGE))
    def sends_something_strange(self, message: dict[str, Any]) -> None:
        assert self.say(**message)["errors"]

    @rule(kind=st.sampled_from(list(NOTHING)))
    def asks_for_something(self, kind: str) -> None:
        now = self.page.now
        assert self.page.send({"type": kind, **NOTHING[kind], "number": 7})["answer"] == 7
        assert self.page.now is now

    @rule()
    def reconnects(self) -> None:
        if self.page.now.in_hand:
            self.lets_go()
        state, told, own = self.state, self.told, self.page.now
        self.page = Page(SCENES["oscillator"]())
        self.page.session.walks = WALKS
        again = self.open(state)
        assert (again["errors"], self.state, again["query"]) == ({}, state, own.query)
        assert all(again["view"][part] == told["view"][part] for part in ("left_out", "scalars", "values"))

    @invariant()
    def the_link_restores_the_state(self) -> None:
        now = self.page.now
        session = visited(as_arguments(now.query), WALKS)
        assert unpacked(session.opening())["problems"] == []
        if now.step:
            assert session.now.step == now.step
            return
        if not now.in_hand:  # then an axis may be too short, and a link lets it grow
            assert sizes(session.now) == pytest.approx(sizes(now), rel=2e-3, abs=1e-12), "a link has four digits"
        assert replace(session.now.state, frame=None) == replace(now.state, frame=None)

    @invariant()
    def the_picture_is_finite(self) -> None:
        check_picture(self.page.now)

    @invariant()
    def hidden_parts_are_not_sent(self) -> None:
        told, now = self.page.opening(), self.page.now
        assert (told["held"] is None) == (now.held is None)
        if not now.before:
            covered = set(now.covered)
            (hidden, _), (others, _) = (drawn(now.kind, covered, is_hidden=has) for has in (True, False))
            assert not {VALUE + one for one in told["view"]["values"]} & covered
            for view in filter(None, (told["view"], told["held"])):
                assert not any(is_sent(view, *one) for one in hidden - others - {("time", "t")})


@pytest.mark.parametrize("slug", SCENES)
def test_the_laws_of_a_page_hold_after_any_messages(slug: str) -> None:
    machine = type(f"Visit{slug.title()}", (Visit,), {"slug": slug})
    # To shrink a failure takes minutes.
    given = settings(max_examples=tries(12), stateful_step_count=13, phases=[Phase.generate])
    run_state_machine_as_test(machine, settings=given)
