"""One visitor's page: a scene, what it is told, and what it answers. It knows neither Panel nor sockets."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from concurrent.futures import Future
from typing import Protocol

from msgspec.structs import replace

from components.about import About, about_numbers
from components.carrying import Shared, brought, taken_along
from components.choices import stated
from components.comparison import told_beside
from components.controls import preset_name, settings
from components.covers import NEXT, checked_covers
from components.deeds import Deed, Errors, apply, sentence
from components.description import column_axes, sheet_address, usual
from components.frames import checked
from components.numbers import excerpt
from components.page.messages import (
    AskAbout,
    AskCsv,
    GiveAnswer,
    Given,
    Lead,
    Open,
    RunWalk,
    Said,
    SetValues,
    Shown,
    Taught,
    Walking,
)
from components.page.picture import Held, View
from components.page.state import Frame, State
from components.parameters import Quantity, Values
from components.predicting import asked_in, asked_of, covers_after, put_last, standing, told_of, waiting
from components.refusals import SORRY, report
from components.running import Later
from components.scene import Picture, Scene, frame_of
from components.sent import view_of
from components.states import before_in, held_in, state_of, stated_own, values_in
from components.take import as_file
from components.url import step_query, write_query
from components.walks import Walks
from components.walks.apart import Apart, Errand, Here, Reading, Replied, Teaching
from components.walks.judging import taught
from components.walks.walk import Step
from components.wire import Packet, decoded, packed

MOST_MESSAGES = 2**53
"""Messages are numbered below this; beyond it a browser counts no further."""

MOST_OWN = 5
TOO_MANY = (
    f"A page keeps {MOST_OWN} walks from files, and this would be one more: "
    "give it the name of one that it may replace, or open another tab."
)
ONE_AT_A_TIME = "A walk from a file is being read or answered. Try again in a moment."

Send = Callable[[Packet], None]
Problems = tuple[str, ...]


class Publish(Protocol):
    """Takes what makes a picture ready for a class, when it is needed, until it is ended."""

    def __call__(self, make: Callable[[], Packet], /) -> None: ...

    def end(self) -> None: ...


class Session:
    """Holds the scene that a visitor sees; `send` takes what the browser is told, packed; `scenes` are those that the
    session can be put into.

    `later` runs a function under the page's own lock: for what comes from another thread.
    """

    def __init__(
        self,
        scene: Scene,
        problems: tuple[str, ...] = (),
        *,
        scenes: Mapping[str, type[Scene]] | None = None,
        covered: tuple[str, ...] = (),
        walks: Walks | None = None,
        step: str = "",
    ) -> None:
        self.scene = scene
        self.scenes = scenes or {}
        self.walks: Walks = walks or {}
        self._own: Walks = {}
        """Walks from the visitor's files."""
        self.apart: Apart | None = None
        """Who reads walks from files; without anybody it is done here."""
        self._apart: tuple[int | None, Future[Replied]] | None = None
        """What was asked there last, and the number of the message that it answers."""
        self.send: Send = lambda packet: None
        self.first: Packet | None = None
        """What the page opens with, made ready while it was seen whether it can be."""
        self._errors: Errors = {}
        self._problems = problems
        self._answering = False
        self._last: int | None = None
        self._shared: Shared = {}
        self._kept = State(scene=scene.slug, covered=covered, step=step)
        self.asked: Scene | None = None
        """The scene from before the change that is to be predicted, which is told in place of the one that stands."""
        self.later: Later = lambda act: act()
        self.network = ""
        """Where the visitor comes from, if that is known: a network has one measurement waiting, and one walk."""
        self.lead: Callable[[str, str], Publish | None] = lambda code, key: None
        self._publish: Publish | None = None
        self._take_up(scene)

    def close(self) -> None:
        """The visitor has left."""
        if self._apart:
            self._apart[1].cancel()
        self._end_work()
        self._end_publishing()

    def _end_work(self) -> None:
        if self.scene.running:
            self.scene.running.close()

    def _end_publishing(self) -> None:
        if self._publish:
            self._publish.end()

    def opening(self) -> Packet:
        """The page as it is shown first, with what was refused of its link."""
        return self._packed(problems=self._problems)

    def hear(self, data: object) -> None:
        """Do what the visitor asks and answer, whatever happens: the browser waits for it. What comes need not be what
        our page sends; its number goes back only where it is one."""
        number = data.get("number") if isinstance(data, dict) else None
        answer = number if isinstance(number, int) and 0 <= number < MOST_MESSAGES else None
        scene, kept, asked, back, shown = self.scene, self._kept, self.asked, self.scene.way_back(), self.scene.shown
        try:
            reply = self._heard(data, answer)
        except Exception as error:
            report(error)
            self.scene, self._kept, self.asked = scene, kept, asked
            back()
            self._errors = {}
            reply = self._packed(answer, (SORRY,))
        if reply:
            self.send(reply)
        if self.scene.shown is not shown or self._kept is not kept:
            self._tell_class()

    def _heard(self, data: object, answer: int | None) -> Packet | None:
        try:
            said = decoded(data)
        except ValueError as refusal:
            self._errors = {"message": excerpt(str(refusal), 200)}
            return self._packed(answer)
        return self._reply(said, answer)

    def _reply(self, said: Said, answer: int | None) -> Packet | None:
        """What a message asks for, done and told, or None where that comes later; one that comes again is told only:
        its first answer was lost."""
        match said:
            case AskCsv(page=page):
                return packed(as_file(self.asked or self.scene, self.picture, page, answer))
            case AskAbout():
                return packed(about_numbers(self._about, answer))
            case GiveAnswer(answer=given) if step := self._own_step(given):
                return self._ask_apart(Teaching(given, step), answer)
            case GiveAnswer(answer=given):
                return packed(replace(taught(given, self.walks, self.scenes), answer=answer))
            case Lead(code=code, key=key):
                self._end_publishing()
                self._publish = self.lead(code, key) if code else None
                self._tell_class()
            case RunWalk():
                return self._ask_apart(Reading(said.name, said.text), answer)
        if isinstance(said, Lead) or (answer is not None and answer == self._last):
            return self._packed(answer)
        self._last = answer
        self._answering = True
        try:
            self._errors = self._turned(said) if isinstance(said, Open) else self._applied(said)
        finally:
            self._answering = False
        return self._packed(answer)

    def _applied(self, deed: Deed) -> Errors:
        """What a deed does; when a hand lets go, the frame grows where it must, and what is hardly used of it is fitted
        anew, but in a step of a walk and while something waits to be predicted."""
        scene, held = self.scene, self.scene.in_hand
        before = self.asked or waiting(scene, self._kept.covered)
        holding = deed.holding if isinstance(deed, SetValues) else None
        scene.in_hand = held or bool(holding)  # a flick is the last that a hand does
        errors = apply(scene, deed)
        scene.in_hand = bool(holding)
        self._predict(before, begins=self.asked is None)
        if held and not holding:
            scene.redraw()
        if holding is False and not (self._kept.step or self._kept.covered):
            scene.let_go()
        return errors

    def _predict(self, before: Scene | None, begins: bool) -> None:
        """What has changed since is covered, where that is to be predicted."""
        covered = self._kept.covered
        self.asked = asked_of(self.scene, before, begins) if NEXT in covered else None
        if self.asked:
            covered = covers_after(self.scene, self.asked, put_last(covered) if begins else covered)
            self._kept = replace(self._kept, covered=covered)

    def _own_step(self, given: Given) -> Step | None:
        """The step that is answered, where it is of a walk from the visitor's own files."""
        steps = self._own[given.walk].steps if given.walk in self._own else ()
        return next((step for step in steps if step.id == given.step), None)

    def _ask_apart(self, asked: Errand, answer: int | None) -> Packet | None:
        """What a stranger's file asks for is done elsewhere, one thing at a time, and told when it comes."""
        if self._apart and not self._apart[1].done():
            return None if self._apart[0] == answer else self._told_apart(asked, Replied(refused=ONE_AT_A_TIME), answer)
        future = (self.apart or Here(self.walks, self.scenes)).ask(asked, self.network)
        self._apart = answer, future

        def tell(done: Future[Replied]) -> None:
            if not done.cancelled():
                self.later(lambda: self.send(self._told_apart(asked, done.result(), answer)))

        future.add_done_callback(tell)
        return None

    def _told_apart(self, asked: Errand, replied: Replied, answer: int | None) -> Packet:
        if isinstance(asked, Teaching):
            given = asked.given
            nothing = Taught(walk=given.walk, step=given.step, lesson=None, refused=replied.refused)
            return packed(replace(replied.taught or nothing, answer=answer))
        own = {**self._own, **({replied.walk.name: replied.walk} if replied.walk else {})}
        if len(own) > MOST_OWN:
            return packed(Walking(answer=answer, sheet=None, refused=TOO_MANY))
        self._own = own
        return packed(Walking(answer=answer, sheet=replied.sheet, refused=replied.refused))

    def _about(self) -> About | None:
        if self._kept.covered:
            raise ValueError("they would give away what is covered")
        return self.scene.about()

    def _turned(self, said: Open) -> Errors:
        """A scene that is gone to without parameters opens as a page of it does; what goes along is left behind where
        the scene cannot be shown with it."""
        self._shared = taken_along(self.scene, self._shared)
        state = said.state
        if said.carried and state.scene in self.scenes:
            scene = self.scenes[state.scene]
            if not state.parameters:
                state = replace(state, parameters={name: stated(value) for name, value in scene.opens.items()})
            values = brought(scene, self._shared) if state.scene != self.scene.slug else {}
            given = {name: stated(value) for name, value in values.items()}
            if given and not self._open(replace(state, parameters={**given, **state.parameters})):
                return {}
        return self._open(state, said.keeps)

    def _open(self, state: State, keeps: bool = False) -> Errors:
        """Put the session into a state, in one batch, whole or not at all."""
        if state.scene not in self.scenes:
            return {"state": f"“{excerpt(state.scene)}” is not a scene. Still drawn as before."}
        scene = self.scene if state.scene == self.scene.slug else self.scenes[state.scene]()
        try:
            values, frame = values_in(type(scene), state), state.frame and checked(state.frame)
            held, before = held_in(type(scene), state), before_in(type(scene), state)
        except ValueError as refusal:
            return {"state": f"{refusal} Still drawn as before."}
        frame = self._standing(scene, values) if keeps and not frame else frame
        back, old = scene.way_back(), self.asked if scene is self.scene else None
        try:
            asked = self._before(scene, before, frame)
            scene.open(values, standing(old if before is None else asked, frame), held)
            covered = checked_covers(type(scene), scene.shown, state.covered)
        except ValueError as error:
            back()
            return {"state": f"{sentence(error)} Still drawn as before."}
        self._kept = State(scene=state.scene, covered=covered, step=state.step)
        if scene is not self.scene:
            self._change_to(scene)
        self._predict(asked, begins=state.before is None)
        return {}

    def _standing(self, scene: Scene, values: Values) -> Frame | None:
        """The frame that stands, for other quantities; another scene, window or way of showing is fitted anew."""
        moved = [name for name, value in values.items() if value != scene.values[name] and name != "hidden"]
        alike = all(isinstance(scene.param[name], Quantity) and name != "window" for name in moved)
        return frame_of(scene.shown) if alike and scene is self.scene else None

    def _before(self, scene: Scene, before: Values | None, frame: Frame | None) -> Scene | None:
        """The scene from before a change that is, or may be, to be predicted: of a state, or the one that stands."""
        asked = self.asked if scene is self.scene else None
        if before is None:
            return waiting(scene, self._kept.covered) if scene is self.scene and not asked else None
        if asked and stated_own(asked) == before and asked.frame == frame:
            return asked
        return asked_in(scene, before, frame)

    @property
    def _query(self) -> str:
        """The link of the state."""
        kept = self._kept
        return step_query(kept.step) if kept.step else write_query(self.scene, kept.covered, self.asked)

    @property
    def state(self) -> State:
        """What the page stands for: the scene, and what the session keeps beside it."""
        state = replace(state_of(self.scene), covered=self._kept.covered, step=self._kept.step)
        return replace(state, frame=self.asked.frame, before=stated_own(self.asked)) if self.asked else state

    @property
    def picture(self) -> Picture:
        """What is told: without what is covered."""
        return told_of(self.scene, self.asked, self._kept.covered)[0]

    def _change_to(self, scene: Scene) -> None:
        self._end_work()
        self._take_up(scene)

    def _take_up(self, scene: Scene) -> None:
        self.scene = scene
        scene.keep_frame()
        scene.on_picture(self._tell)
        if scene.running:
            scene.running.later = lambda act: self.later(act)
            scene.running.network = lambda: self.network

    def _tell(self, picture: Picture) -> None:
        """A change that no message of this page has asked for is sent at once; the others are with the answer, and a
        scene that the visitor has left says nothing."""
        if not self._answering and picture is self.scene.shown:
            self.send(self._packed())
            self._tell_class()

    def _tell_class(self) -> None:
        """The followers' picture: the same, without what was refused."""
        if self._publish:
            self._publish(lambda: self._packed(errors={}))

    def _packed(self, answer: int | None = None, problems: Problems = (), errors: Errors | None = None) -> Packet:
        scene, covered = type(self.scene), self._kept.covered
        shown, left_out = told_of(self.scene, self.asked, covered)
        view, numbers = view_of(shown, column_axes(scene), left_out)
        held, more = told_beside(self.scene, shown, covered, self.asked)
        told = replace(self.shown(view, held, answer, problems), errors=self._errors if errors is None else errors)
        return packed(told, [*numbers, *more], sheet=told.sheet, usual=usual(scene))

    def shown(self, view: View, held: Held | None, answer: int | None, problems: tuple[str, ...]) -> Shown:
        """All that the browser needs to show the scene as it now is."""
        scene, told = self.scene, self.asked or self.scene
        return Shown(
            answer=answer,
            scene=scene.slug,
            sheet=sheet_address(type(scene)),
            view=view,
            held=held,
            settings=settings(scene.param.objects("existing"), scene.values, scene.units(), told.shown.spans),
            state=self.state,
            preset=preset_name(label) if (label := scene.preset()) else None,
            here=tuple(told.here()),
            errors=self._errors,
            problems=problems,
            query=self._query,
            progress=scene.running.progress if scene.running else None,
        )
