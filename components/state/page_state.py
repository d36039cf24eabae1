"""The page state: the complete state of a page as one frozen value, and the new value after a message."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import msgspec

from components.language.messages import Choose, Open, SetValues
from components.language.state import Frame, State
from components.layout.views import known_parts
from components.quantities.formatting import excerpt
from components.quantities.parameters import Values
from components.scene import Scene
from components.scene.frames import FITTED, checked, unfitted
from components.scene.picture import Framed, Framing, Picture, draw
from components.scene.scene import VIEW
from components.state.commands import Command, RefusalError, asked_values, refusal, sentence
from components.state.compared import HIDDEN, WINDOW, moved, own_values, shown_as
from components.state.covers import NEXT, checked_covers
from components.state.link import step_query, write_query
from components.state.predicting import covers_after, picture_to_send, put_last
from components.state.sent_parts import SceneInView
from components.state.shared_system import Shared, brought, taken_along
from components.state.states import other_in, scene_in, stated_all, stated_own

Scenes = Mapping[str, type[Scene]]


@dataclass(frozen=True, kw_only=True)
class PageState:
    """A scene, its picture, and everything else of a page that a message can change.

    `held`     the compared scene, drawn in the frame and view of the current one
    `before`   the page state before a change that is to be predicted; it is sent in place of this one
    `covered`  the plots, numbers and sentences that are not sent
    `step`     the current step of a walk, "d34/d34-07"; with a seed "d34/d34-07/5"
    `show`     the visible parts, if they are not those of the view
    `shared`   values of the physical system that other scenes take over
    `in_hand`  True during a drag; the axes along it then stay
    `in_view`  True if pictures may lack what the view doesn't show; in steps and covered pages they are whole
    `number`   the number of the last message, so that a repeated one is ignored
    `own`      walks from the visitor's files, by name
    """

    scene: Scene
    drawn: Framed
    held: Scene | None = None
    before: PageState | None = None
    covered: tuple[str, ...] = ()
    step: str = ""
    show: tuple[str, ...] = ()
    shared: Shared = field(default_factory=dict)
    in_hand: bool = False
    in_view: bool = False
    number: int | None = None
    own: Mapping[str, Any] = field(default_factory=dict)

    @property
    def kind(self) -> type[Scene]:
        return type(self.scene)

    @property
    def shown(self) -> Picture:
        """The current picture."""
        return self.drawn.picture

    @property
    def is_whole(self) -> bool:
        """True if the picture must have everything that any view shows."""
        return not self.in_view or bool(self.step or self.covered or self.show)

    @property
    def asked(self) -> PageState:
        """The page state whose picture is sent: the one before a change, while the change is being predicted."""
        return self.before or self

    @cached_property
    def frame(self) -> Frame | None:
        """The parts of the frame that differ from the fitted one; None if all are fitted."""
        return unfitted(self.drawn.frame, self.drawn.fitted)

    @property
    def seen_frame(self) -> Frame:
        """The frame as the visitor sees it: axes with hidden numbers are wider."""
        axes, frame = self.to_send[0].axes, self.drawn.frame
        wide = {name: (axes[name].start, axes[name].end) for name in frame.ranges if f"ticks:{name}" in self.covered}
        return msgspec.structs.replace(frame, ranges={**frame.ranges, **wide}) if wide else frame

    @property
    def to_send(self) -> tuple[Picture, tuple[str, ...]]:
        """The picture to send, and the names of the quantities that are left out of it."""
        return picture_to_send(self.kind, self.shown, self.before.shown if self.before else None, self.covered)

    @cached_property
    def state(self) -> State:
        """The part of the page state that links and messages contain."""
        own = self.scene.off_default()
        return State(
            scene=self.scene.slug,
            parameters=stated_all({name: value for name, value in own.items() if name != HIDDEN}),
            frame=self.asked.frame,
            held=None if self.held is None else stated_own(self.held),
            covered=self.covered,
            before=None if self.before is None else stated_own(self.before.scene),
            hidden=tuple(self.scene.values[HIDDEN]) if HIDDEN in own else None,
            step=self.step,
            show=self.show,
        )

    def sends_the_same_as(self, other: PageState) -> bool:
        """Return True if both states surely send the same to the browser. False can mean that they might differ."""
        pairs = zip(self._drawn_of, other._drawn_of, strict=True)
        return all(mine is its for mine, its in pairs) and self._marks == other._marks

    @property
    def _drawn_of(self) -> tuple[object, ...]:
        return self.scene, self.held, self.before, self.drawn.picture, self.drawn.beside

    @property
    def _marks(self) -> tuple[object, ...]:
        return self.drawn.frame, self.drawn.fitted, self.covered, self.step, self.show

    @property
    def query(self) -> str:
        """The query of the link to this state."""
        return step_query(self.step) if self.step else write_query(self.state, self.kind)


def fitted(scene: Scene) -> PageState:
    """Return the page state with a scene in its fitted frame, and defaults for everything else."""
    return PageState(scene=scene, drawn=draw(scene))


def changed(now: PageState, said: Command | Open, scenes: Scenes) -> PageState:
    """Return the page state after a message. Raises RefusalError, with a sentence for each reason."""
    return _turned(now, said, scenes) if isinstance(said, Open) else _done(now, said)


def with_values(
    now: PageState, values: Values, *, holding: bool = False, along: Collection[str] = (), released: bool = False
) -> PageState:
    """Return the page state with other values, in its frame, which grows if necessary.

    During a drag (`holding`), the axes `along` it do not grow. A new time window replaces the one of the frame. After
    a change of the display alone, the axes that it affects are fitted again. Raises ValueError, with a reason,
    for values that the scene cannot have.
    """
    scene = now.scene.changed(values, in_hand=now.in_hand or holding)
    if scene is now.scene and not released:
        return now
    ways = not now.kind.quantities() >= now.scene.differing(values)
    return _redrawn(now, scene, "kept" if holding else "grown", along, refits=ways)


def _draw(is_whole: bool, scene: Scene, held: Scene | None, *rest: Any) -> Framed:
    """Draw a scene with the compared one, whole or as far as the view shows them."""
    return draw(scene, held, *rest) if is_whole else draw(SceneInView(scene), held and SceneInView(held), *rest)


def _redrawn(
    now: PageState, scene: Scene, framing: Framing = "grown", along: Collection[str] = (), *, refits: bool
) -> PageState:
    """Return the page state with another scene of its class, in its frame. With `refits`, axes may be fitted again."""
    frame, held = now.drawn.frame, now.held and shown_as(now.held, scene)
    if scene.values[WINDOW] != now.scene.values[WINDOW]:
        frame = msgspec.structs.replace(frame, window=None)
    drawn = _draw(now.is_whole, scene, held, framing, frame, now.drawn.fitted if refits else None, along)
    return replace(now, scene=scene, held=held, drawn=drawn)


def _done(now: PageState, command: Command) -> PageState:
    """Return the page state after a command.

    The frame grows if necessary. At the end of a drag, mostly empty axes are fitted again, except the axes along the
    drag. They are not fitted in a step of a walk or while something is covered.
    """
    said, along = (command.holding, command.along) if isinstance(command, SetValues) else (None, ())
    values = asked_values(now.scene, command)
    try:
        after = with_values(now, values, holding=bool(said), along=along, released=now.in_hand and not said)
    except ValueError as error:
        raise refusal(now.scene, command, error) from error
    if said is False and not (now.step or now.covered):
        frame = after.drawn.loosened({*along, *now.kind.steady})
        if frame != after.drawn.frame:
            after = replace(after, drawn=_draw(after.is_whole, after.scene, after.held, "grown", frame))
    chooses_view = isinstance(command, Choose) and command.name == VIEW
    in_hand, show = bool(said), () if chooses_view else after.show
    if (in_hand, show) != (after.in_hand, after.show):
        after = replace(after, in_hand=in_hand, show=show)
    return _predicted(after, now.before or now, begins=now.before is None)


def _predicted(after: PageState, before: PageState | None, begins: bool) -> PageState:
    """Return the page state with covers for everything that has changed since `before`, if the visitor predicts.

    A prediction `begins` with the first change of a parameter that is not only a change of display.
    """
    if NEXT not in after.covered or before is None or (begins and not moved(after.scene, before.scene)):
        return replace(after, before=None) if after.before else after
    before = _shown_like(before, after)
    covered = put_last(after.covered) if begins else after.covered
    return replace(after, before=before, covered=covers_after(after.scene, after.shown, before.shown, covered))


def _shown_like(before: PageState, after: PageState) -> PageState:
    """Return an earlier page state with the display parameters and the compared scene of the current one."""
    scene = shown_as(before.scene, after.scene, HIDDEN)
    if scene is before.scene and _key(before.held) == _key(after.held):
        return before
    return _redrawn(replace(before, held=after.held), scene, refits=True)


def _key(scene: Scene | None) -> object:
    return scene and scene.key


def _turned(now: PageState, said: Open, scenes: Scenes) -> PageState:
    """Return the page state after a message that opens a state.

    A scene that is opened with `carried` takes over the values of the shared system, unless it cannot show them.
    """
    state = said.state
    if state.scene not in scenes:
        raise RefusalError({"state": f"“{excerpt(state.scene)}” is not a scene. Still drawn as before."})
    kind = scenes[state.scene]
    now = replace(now, shared=taken_along(now.scene, now.shared))
    if said.carried:
        if not state.parameters:
            state = msgspec.structs.replace(state, parameters=stated_all(kind.opens))
        given = stated_all(brought(kind, now.shared)) if kind is not now.kind else {}
        if given:
            with suppress(ValueError):
                return page_state_in(
                    kind, msgspec.structs.replace(state, parameters={**given, **state.parameters}), now
                )
    try:
        return page_state_in(kind, state, now, keeps=said.keeps)
    except ValueError as error:
        raise RefusalError({"state": f"{sentence(error)} Still drawn as before."}) from error


def page_state_in(
    kind: type[Scene], state: State, now: PageState | None = None, *, keeps: bool = False, in_view: bool = False
) -> PageState:
    """Return the page state for a state of a scene. Raises ValueError, with a reason, if it is not possible.

    Anything the state omits is taken from `now`. With `keeps`, the frame stays if only quantities change; for another
    scene, window or display it is fitted. With `in_view`, only what the view shows must be possible.
    """
    scene, held = scene_in(kind, state), other_in(kind, state.held)
    held = held and shown_as(held, scene)
    same = now if now and kind is now.kind else None
    frame = state.frame and checked(state.frame)
    if keeps and frame is None and same and _only_quantities(same.scene, scene):
        frame = same.seen_frame
    told = other_in(kind, state.before if NEXT in state.covered else None)
    before = _before(told, scene, held, frame, same)
    asked = before or (same and same.before)
    if asked and asked.frame == frame:
        frame = asked.drawn.frame  # not only the parts in the state, so that the answer is drawn in the same frame
    is_whole = not (in_view or (now and now.in_view)) or bool(state.step or state.covered or state.show)
    if same and (scene.key, _key(held), frame) == (same.scene.key, _key(same.held), same.frame):
        drawn = same.drawn if same.is_whole else _draw(is_whole, scene, held, "kept", same.drawn.frame)
    else:
        drawn = _draw(is_whole, scene, held, "grown" if frame else "fitted", frame or FITTED)
    after = replace(
        now or PageState(scene=scene, drawn=drawn),
        scene=scene,
        drawn=drawn,
        held=held,
        covered=checked_covers(kind, drawn.picture, state.covered),
        step=state.step,
        show=known_parts(kind.sheet(), state.show),
        in_hand=False,
    )
    begins = state.before is None
    if begins and same and same.before is None and NEXT in same.covered:
        before = same
    return _predicted(after, before, begins)


def _only_quantities(before: Scene, after: Scene) -> bool:
    """Return True if two scenes differ only in quantities, and not in their window."""
    return after.differing(before.values) - {HIDDEN} <= after.quantities() - {WINDOW}


def _before(
    scene: Scene | None, after: Scene, held: Scene | None, frame: Frame | None, same: PageState | None
) -> PageState | None:
    """Return the page state before a predicted change, from a state; the known page state if it is equal."""
    if scene is None:
        return None
    if same and same.before and own_values(same.before.scene) == own_values(scene) and same.before.frame == frame:
        return same.before
    scene = shown_as(scene, after, HIDDEN)
    return PageState(scene=scene, held=held, drawn=draw(scene, held, "grown" if frame else "fitted", frame or FITTED))
