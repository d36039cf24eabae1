"""A scene made of a case and its paper.

A case is a class whose fields are the parameters of the scene. A paper builds the sheet from placeholders for the
attributes of the case. The scene names both; a picture has the attributes that the paper uses.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from typing import Any, ClassVar

import numpy as np

from components.language.blocks import Block
from components.language.expressions import check_free
from components.language.picture import Onward, Pace
from components.language.state import Frame
from components.layout.views import check_views
from components.paper.deferred import attributes, book_of, fields, names
from components.paper.plots import settled
from components.quantities.parameters import Values
from components.quantities.readouts import Readout, SceneNumber, scene_number
from components.scene.about import About
from components.scene.case_curves import BandColumns
from components.scene.case_picture import CasePaper, CasePicture
from components.scene.frames import FITTED
from components.scene.picture import Asked, Picture
from components.scene.scene import Scene
from components.scene.traces import Floats, samples
from physics.sampling import highest_at

MOST_CASES = 8
"""Number of cached cases. Needed because a picture that does not fit its frame is drawn again with the same case."""


class Case(ABC):
    """The parameters of a scene (the fields), and values that depend on them and on the time window of a frame."""

    window: float | None

    def __init__(self, values: Values, frame: Frame = FITTED) -> None:
        vars(self).update({name: values[name] for name in fields(type(self)) if name in values})
        self.frame = frame

    @property
    @abstractmethod
    def lasting(self) -> float:
        """The time window in s that suits the motion."""

    @property
    @abstractmethod
    def highest(self) -> float:
        """The highest frequency or rate in rad/s that the curves must resolve."""

    @property
    def resolved(self) -> float:
        """The highest frequency in rad/s that files resolve."""
        return self.highest

    @cached_property
    def own_end(self) -> float:
        """The end of the time window in s that the scene chooses without a frame."""
        return self.window or self.lasting

    @property
    def end(self) -> float:
        """The end of the time window in s."""
        return self.frame.window or self.own_end

    @cached_property
    def instants(self) -> int:
        """The number of drawn points of a curve."""
        return samples(self.end, self.highest)

    @cached_property
    def times(self) -> Floats:
        """The times of the drawn points (n,) in s."""
        return np.linspace(0.0, self.end, self.instants)

    @cached_property
    def highest_line(self) -> float:
        """The highest frequency in rad/s that curves with these times can show as a line."""
        return highest_at(self.end / (self.instants - 1))

    def is_line(self, omega: float) -> bool:
        """Return True if a motion of this frequency in rad/s is slow enough for a line."""
        return abs(omega) <= self.highest_line

    @property
    def intervals(self) -> dict[str, tuple[float, int]]:
        """Intervals other than the time window, by source: the end in s and the number of points."""
        return {}

    @property
    def fits(self) -> float | None:
        """The scale of the stage that suits the motion; None if the stage has no scale."""
        return None

    @property
    def scale(self) -> float | None:
        """The scale of the stage."""
        return self.frame.scale or self.fits

    @property
    def pace(self) -> Pace:
        """The speeds of the clock."""
        return Pace()

    @property
    def spans(self) -> dict[str, tuple[float, float]]:
        """The ends of the sliders that depend on the case, by parameter."""
        return {}

    @property
    def bands(self) -> Mapping[str, BandColumns] | None:
        """The bands of the motions that are drawn as bands; None to choose these motions by their frequencies."""
        return None

    def notes(self) -> tuple[str, ...]:
        """Return sentences that tell the visitor how this picture differs from the exact motion."""
        return ()

    def to_scale(self) -> str:
        """Return the sentence on the scale of the stage; "" if the scale is 1 or there is none."""
        return ""

    def onward(self) -> tuple[Onward, ...]:
        """Return the links to scenes that show the same system for these values."""
        return ()

    def about(self, shown: Picture) -> About | None:
        """Return the content of 'About these numbers', or None."""
        return None


@dataclass(frozen=True)
class Example:
    """A preset with its values and the sentence on what to watch."""

    label: str
    watch: str
    values: Values


def example(label: str, watch: str, given: Values | None = None, /, **values: Any) -> Example:
    return Example(label, watch, {**(given or {}), **values})


@dataclass(frozen=True)
class ComparedNumber:
    """A number of the case that is listed in a comparison with another picture; left out if it is None or a text.

    `name` is its live number; `of` is the attribute, if that has another name. An `angle` is compared by difference,
    other numbers by ratio.
    """

    name: str
    symbol: str
    unit: str = ""
    tint: str = "ink"
    angle: bool = False
    of: str = ""

    def readout(self, case: Case) -> Readout | None:
        value = getattr(case, self.of or self.name)
        if value is None or isinstance(value, str):
            return None
        return Readout(self.name, self.symbol, float(value), self.unit, self.tint, self.angle)


@lru_cache(MOST_CASES)
def _case(asked: Asked[CaseScene]) -> Case:
    return asked.scene.case(asked.scene.values, asked.frame)


class CaseScene(Scene):
    """A scene made of a case and its paper."""

    case: ClassVar[type[Case]]
    paper: ClassVar[Callable[[], Block]]
    compared: ClassVar[tuple[ComparedNumber, ...]] = ()
    examples: ClassVar[tuple[Example, ...]] = ()

    def __init_subclass__(cls, **rest: Any) -> None:
        super().__init_subclass__(**rest)
        if "case" in vars(cls):
            check_free(cls.case.__name__, names(cls.case))
            if both := {one.name for one in attributes(cls.case)}.intersection(fields(cls.case)):
                raise TypeError(
                    f"{cls.case.__name__}: {', '.join(both)} is a parameter: give the attribute another name"
                )
        cls.presets = {one.label: one.values for one in cls.examples}
        cls.watch = {one.label: one.watch for one in cls.examples}

    @classmethod
    @cache
    def written(cls) -> CasePaper:
        """Return the paper with everything that it uses; built once per process."""
        book = book_of(cls.case)
        block = settled(cls.paper(), book)
        check_views(block, cls.views)
        return CasePaper.of(block, book)

    @classmethod
    @cache
    def part(cls, names: frozenset[str]) -> CasePaper:
        """Return what the paper needs for a picture with only these names."""
        return cls.written().part(names)

    @classmethod
    def sheet(cls) -> Block:
        return cls.written().block

    def of(self, frame: Frame = FITTED) -> Case:
        """Return the case of the scene in a frame. Frames that differ only in the ranges of axes share one case."""
        return _case(Asked((self.key, frame.window, frame.scale), self, frame))

    def picture(self, frame: Frame = FITTED) -> Picture:
        return CasePicture(self.written(), self.of(frame), frame).picture

    def picture_of(self, names: frozenset[str], frame: Frame) -> Picture:
        return CasePicture(self.part(names), self.of(frame), frame).picture

    @property
    def numbers(self) -> dict[str, SceneNumber]:
        case = self.of()
        known = [one for one in attributes(self.case) if one.meaning]
        found = {one.called: scene_number(one.of(case), one.unit, one.meaning) for one in known}
        return {name: number for name, number in found.items() if number}

    def readouts(self) -> tuple[Readout, ...]:
        case = self.of()
        return tuple(found for one in self.compared if (found := one.readout(case)))

    @classmethod
    def is_checked(cls) -> bool:
        return cls.case.about is not Case.about

    def about(self, shown: Picture) -> About | None:
        return self.of().about(shown)
