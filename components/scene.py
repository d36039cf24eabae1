"""What every scene is: parameters, one pure picture computed from them, and data sources that hold its numbers."""

from __future__ import annotations

from abc import ABCMeta, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from functools import cache, cached_property
from typing import Any, Self

import param
from bokeh.models import ColumnDataSource
from msgspec.structs import replace
from param.parameterized import ParameterizedMetaclass, discard_events

from components.about import About
from components.beside import Beside
from components.facts import Facts
from components.figures import Figure
from components.frames import FITTED, unfitted
from components.page.blocks import Block
from components.page.state import Frame
from components.parameters import Quantity, Values
from components.picture import Framed, Picture, drawn_in, frame_of, kept, let_go, sendable, shared
from components.refusals import in_words
from components.units import Unit

__all__ = ["Picture", "Scene", "frame_of"]


class _SceneMeta(ParameterizedMetaclass, ABCMeta):
    pass


class Scene(Facts, metaclass=_SceneMeta):
    """One idea of the lecture. Subclasses are final: they declare parameters, a sheet, and `picture`.

    Setting parameters (one, or a batch with `param.update`) leads to exactly one `picture`. A ValueError, from a
    parameter's own limits, from the physics or in place of an ArithmeticError, leaves every parameter and every
    source as it was; so does any other exception.
    """

    window = Quantity(
        default=None,
        allow_None=True,
        bounds=(0, None),
        inclusive_bounds=(False, False),
        softbounds=(1, 100),
        symbol="T",
        unit="s",
        says="the time window; empty for the scene's own choice.",
        allowed="a time window is more than 0 s",
    )
    hidden = param.List(default=[], item_type=str, doc="The curves switched off, by group.")

    def __init__(self, **values: Any) -> None:
        self._good: dict[str, object] = {}
        self.in_hand = False
        """Whether a hand holds on to what is drawn: then its frame stands, though something leaves it."""
        self._keeps = self._given = False
        self._frame: Frame | None = None
        self.beside: Beside[Scene] | None = None
        self.running = self.work(self) if self.work else None
        super().__init__(**values)  # type: ignore[no-untyped-call]  # param's own has no types
        self._follow(frozenset(values))
        self._drawn: Framed = self._picture(frozenset()) if values or self.running else self._first()
        self._good = {name: value for name, value in self.param.values().items() if name != "name"}
        self._listeners: list[Callable[[Picture], None]] = []
        self.param.watch(lambda *events: self._solve(event.name for event in events), list(self._good))

    @classmethod
    @cache
    def _first(cls) -> Framed:
        """The picture of the defaults, which most visitors see first: worked out once, and written by nobody."""
        return shared(cls(window=None)._drawn)

    @classmethod
    @abstractmethod
    def sheet(cls) -> Block:
        """What stands where on the paper: components.sheet."""

    @abstractmethod
    def picture(self, frame: Frame = FITTED) -> Picture:
        """What is shown, as a pure function of the parameters and the frame; what the frame leaves open is chosen to
        fit. ValueError where doubles hold no answer."""

    def fit(self) -> Frame:
        """The frame that fits the parameters, as a pure function of them."""
        return frame_of(self.picture())

    def grow(self, frame: Frame) -> Frame:
        """The frame, grown so far that it holds what these parameters draw."""
        return kept(self.picture, frame).frame

    @classmethod
    def drawings(cls) -> dict[str, str]:
        """A small picture for each preset that has one: SVG path data in a box of 128 by 46."""
        return {}

    def units(self) -> dict[str, Unit]:
        """The units in which quantities are now shown and typed, where they are not their own."""
        return {}

    def following(self, changed: frozenset[str]) -> Values:
        """The values of parameters that follow from those just changed; they are set before the picture is made."""
        return {}

    def action(self, name: str) -> Values:
        """The values that a button of a group sets; ValueError, in words, where there are none."""
        raise NotImplementedError(name)

    def here(self) -> list[str]:
        """Those of `places` whose values are in force."""
        return [name for name in self.places if all(getattr(self, p) == v for p, v in self.action(name).items())]

    def about(self) -> About | None:
        """What is known of the errors of what is drawn, worked out when asked; None where there is nothing to say."""
        return None

    @property
    def shown(self) -> Picture:
        """The picture in force."""
        return self._drawn.picture

    @property
    def shown_beside(self) -> Picture | None:
        """The picture held, in the same frame."""
        return self._drawn.beside

    @cached_property
    def sources(self) -> dict[str, ColumnDataSource]:
        """The columns of the picture in force, in SI units; a visitor costs none of them until they are asked for."""
        return {name: ColumnDataSource(data=data) for name, data in self.shown.columns.items()}

    def set(self, values: Values) -> None:
        """Set parameters in one batch, with one solve; a ValueError leaves the scene as it was.

        As `param.update`, whose way through the watchers takes a tenth of what a change costs.
        """
        if unknown := values.keys() - self._good.keys():
            raise ValueError(f"{', '.join(sorted(unknown))}: not a parameter of {type(self).__name__}")
        with discard_events(self):
            for name, value in values.items():
                setattr(self, name, value)
        changed = [name for name in values if getattr(self, name) != self._good[name]]
        if changed:
            self._solve(changed)

    def open(self, values: Values, frame: Frame | None, held: Values | None = None) -> None:
        """The same, in a frame that grows where it must, or fitted without one; with what is held beside it."""
        before, standing, drawn, beside = self._frame, self.frame, self._drawn, self.beside
        self._frame, self._given = frame, True
        try:
            self.beside = None if held is None else beside if beside and beside.values == held else Beside(self, held)
            self.set(values)
            if self._drawn is drawn and frame == standing and self.beside is beside:
                self._frame = before
            elif self._drawn is drawn:
                self._solve(())
        except Exception:
            self._frame, self.beside = before, beside
            raise
        finally:
            self._given = False

    @property
    def values(self) -> Mapping[str, Any]:
        """The values of all parameters that the picture in force is of: before the change that is being made."""
        return self._good

    @property
    def opening(self) -> bool:
        """Whether the values that are being set are all that is known: of a state, or of a new scene."""
        return self._given or not self._good

    def redraw(self) -> None:
        """The picture once more, for the same parameters."""
        self._solve(())

    def let_go(self) -> None:
        """A hand has let go of what it set: an axis that is hardly used is fitted anew."""
        frame = let_go(self._drawn)
        if frame != self._drawn.frame:
            self._frame = frame
            self._solve(())

    def keep_frame(self) -> None:
        """From now on a change of values keeps the frame that stands: of a page, where changes are seen."""
        self._keeps = True
        self._frame = self._drawn.frame

    @property
    def frame(self) -> Frame | None:
        """What of the frame that stands is not as it would be fitted; None where all of it is."""
        return unfitted(self._frame, self._drawn.fitted) if self._frame else None

    def way_back(self) -> Callable[[], None]:
        """What makes the scene again what it is now."""
        good, drawn, frame, beside = self._good, self._drawn, self._frame, self.beside

        def go() -> None:
            self._good, self._drawn, self._frame, self.beside = good, drawn, frame, beside
            self._restore()
            self._fill_sources()

        return go

    def twin(self) -> Self:
        """The scene as it now is, for itself: what changes this one leaves it."""
        other = type(self)()
        other._good, other._drawn, other._frame = self._good, self._drawn, self._drawn.frame
        other._keeps, other.beside, other.running = True, self.beside, self.running
        other._restore()
        return other

    def figures(self) -> tuple[Figure, ...]:
        """The numbers that are compared with those of another picture."""
        return ()

    def on_picture(self, listener: Callable[[Picture], None]) -> None:
        """Call `listener` after every change with the new picture."""
        self._listeners.append(listener)

    def off_default(self) -> Values:
        """Those of the linked parameters that are not at their defaults."""
        linked = self.linked().items()
        return {name: self.values[name] for name, parameter in linked if self.values[name] != parameter.default}

    def preset(self) -> str | None:
        """The label of the preset in force, if any."""
        now = [self.values[name] for name in self.preset_names()]
        return next((label for label, values in self.preset_values() if values == now), None)

    def __setattr__(self, name: str, value: Any) -> None:
        try:
            super().__setattr__(name, value)
        except Exception:
            # param stops a batch at the first bad value and keeps those already set: give all of them back.
            self._restore()
            raise

    def _restore(self) -> None:
        if good := getattr(self, "_good", None):
            with discard_events(self):
                for name, value in good.items():
                    super().__setattr__(name, value)

    def _follow(self, changed: frozenset[str]) -> frozenset[str]:
        """What has changed, with what follows from it."""
        with discard_events(self), in_words():
            followed = self.following(changed)
            for name, value in followed.items():
                super().__setattr__(name, value)
        return changed | followed.keys()

    def _picture(self, changed: frozenset[str]) -> Framed:
        with in_words():
            drawn = self._in_frame(changed) if self._frame else sendable(drawn_in(self.picture, FITTED))
            return self.beside.with_held(self, drawn) if self.beside else drawn

    def _in_frame(self, changed: frozenset[str]) -> Framed:
        """The picture in the frame that stands; fitted where nothing can be drawn in that one.

        Another window is chosen by its field; another way of showing things fits anew what it changes. A frame that has
        been given with the values is taken as it is.
        """
        frame = self._frame or FITTED
        if "window" in changed and not self._given:
            frame = replace(frame, window=None)
        ways = [] if self._given else [name for name in changed if not isinstance(self.param[name], Quantity)]
        try:
            if self.in_hand:
                return sendable(drawn_in(self.picture, frame))
            return sendable(kept(self.picture, frame, self._drawn.fitted if ways else None))
        except (ValueError, ArithmeticError):
            return sendable(drawn_in(self.picture, FITTED))

    def _fill_sources(self) -> None:
        if "sources" not in vars(self):
            return
        columns = self.shown.columns
        for name in columns.keys() | self.sources.keys():
            self.sources.setdefault(name, ColumnDataSource()).data = columns.get(name, {})

    def _solve(self, names: Iterable[str]) -> None:
        """The picture after a change of these parameters."""
        changed = frozenset(names)
        try:
            followed = self._follow(changed)
            drawn = self._picture(changed)
        except Exception:
            self._restore()
            raise
        if self._keeps or self._frame:
            self._frame = drawn.frame
        self._drawn, self._good = drawn, {**self._good, **{name: getattr(self, name) for name in followed}}
        self._fill_sources()
        for listener in self._listeners:
            listener(drawn.picture)
