"""The state of a page, which the browser keeps: one message puts a session into it."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from msgspec import Meta, Struct

Value: TypeAlias = float | str | list[str] | None
"""A quantity in SI (None: the scene's own choice), the word of a choice, or a list of words."""


class Frame(Struct, frozen=True, kw_only=True):
    """A frame for a picture: the ranges of its axes by name, its time window in s, the scale of its stage, and its
    speed, simulated over real seconds. One that came with a link is `given`: no hand that lets go fits it anew."""

    ranges: Annotated[dict[str, tuple[float, float]], Meta(max_length=50)] = {}
    window: float | None = None
    scale: float | None = None
    speed: float | None = None
    given: bool = False


class State(Struct, frozen=True, kw_only=True):
    """All that a page stands for: a scene, its parameters that are not at their defaults, its frame where it is not the
    fitted one, the parameters held for comparison, the plots and values covered, the parameters from before the change
    to be predicted, the hidden curves where they are not the scene's own, the step of a walk: "d34/d34-07", and
    "d34/d34-07/5" where its numbers have a seed, and the parts to show in place of those of its view."""

    scene: str
    parameters: dict[str, Value] = {}
    frame: Frame | None = None
    held: dict[str, Value] | None = None
    covered: tuple[str, ...] = ()
    before: dict[str, Value] | None = None
    hidden: tuple[str, ...] | None = None
    step: str = ""
    show: Annotated[tuple[str, ...], Meta(max_length=50)] = ()
