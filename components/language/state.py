"""The state of a page, which the browser keeps: one message puts a session into it."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from msgspec import Meta, Struct

Value: TypeAlias = float | str | list[str] | None
"""A value in a state: a quantity in SI (None if the scene chooses it), the word of a choice, or a list of words."""


class Frame(Struct, frozen=True, kw_only=True):
    """A frame for a picture: the ranges of its axes by name, its time window in s, the scale of its stage, and its
    speed in simulated seconds per second. `given`: it came with a link, so the end of a drag does not fit it again."""

    ranges: Annotated[dict[str, tuple[float, float]], Meta(max_length=50)] = {}
    window: float | None = None
    scale: float | None = None
    speed: float | None = None
    given: bool = False


class State(Struct, frozen=True, kw_only=True):
    """The state of a page.

    A scene, its parameters that are not at their defaults, its frame if it is not the fitted one, the parameters of the
    compared picture, the hidden plots and values, the parameters from before a change that is to be predicted, the
    switched-off curves if not the scene's default, the step of a walk ("d34/d34-07", or "d34/d34-07/5" with a seed for
    its numbers), and the parts to show in place of the parts of its view.
    """

    scene: str
    parameters: dict[str, Value] = {}
    frame: Frame | None = None
    held: dict[str, Value] | None = None
    covered: tuple[str, ...] = ()
    before: dict[str, Value] | None = None
    hidden: tuple[str, ...] | None = None
    step: str = ""
    show: Annotated[tuple[str, ...], Meta(max_length=50)] = ()
