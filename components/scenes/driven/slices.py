"""The push of the driven mass in slices, each of which acts like an impulse, and the sum of the responses."""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np

from components.quantities.axes import Axis, nice_axis
from components.scene.traces import Columns
from components.scenes.driven.pushes import PushedCase
from physics.convolution import SlicedPush, Tail, joined, outline, tails

MOST_TAILS, POINTS = 12, 700
"""Largest number of responses to slices that are drawn, and the number of their points."""
FOLLOWS = 0.05
"""The sum counts as following the motion if it differs by at most this share of it."""

SHORT = 0.1
"""A slice is short if its width is at most this share of a natural period."""


class SlicedCase(PushedCase):
    """A motion under a push, with the responses to slices of the push."""

    slices: float

    @property
    def in_slices(self) -> bool:
        """True if slices are drawn: the drive is a force, and the motion is slow enough for a line."""
        return self.kind == "force" and self.is_driven and self.is_line(self.highest)

    @cached_property
    def sliced(self) -> SlicedPush | None:
        """The push in slices, if it does not consist of impulses."""
        if self.is_impulsive or not self.in_slices:
            return None
        return SlicedPush(
            oscillator=self.one, force=self.moved.drive.at, end=self.end, count=int(self.slices),
            x_0=self.x_0, v_0=self.v_0,
        )  # fmt: skip

    @property
    def slice_share(self) -> float:
        """The width of a slice, as a share of a natural period."""
        return self.end / self.slices * self.one.omega_n / (2 * math.pi)

    @cached_property
    def compared(self) -> tuple[float, float] | None:
        """The largest difference between the sum and the motion in the window, and the largest |x| of the motion from
        rest, in m."""
        if not self.sliced:
            return None
        x = self.moved.from_rest(self.sliced.instants)
        return self.sliced.miss(x), float(np.abs(x).max())

    @cached_property
    def tails(self) -> list[Tail]:
        """The responses to some of the slices, and to the initial conditions."""
        if not self.in_slices:
            return []
        times, sizes = self.jolts, np.full_like(self.jolts, self.J)
        if self.sliced:
            times, sizes = self.sliced.times, self.sliced.sizes
        every = -(-len(times) // MOST_TAILS)
        found = tails(self.one, times[::every], sizes[::every], self.end, POINTS)
        start = [Tail(self.times, self.free.fadings[0].at(self.times))] if self.x_0 or self.v_0 else []
        return [*start, *found]

    def tail_words(self) -> str:
        """Return the name of the sentence on which responses are drawn."""
        count = len(self.jolts) if self.is_impulsive else self.slices
        return ("some" if count > MOST_TAILS else "each") + ("_jolt" if self.is_impulsive else "")

    @property
    def slice_axis(self) -> Axis:
        """The axis of the force, or of impulses."""
        alternates = self.shape in ("sine", "square", "triangle")
        size, unit = 1.3 * (self.amount or 1.0), "N s" if self.is_impulsive else "N"
        return nice_axis(-size if alternates else 0.0, size, unit, 2, exact=True)

    def tail_path(self) -> Columns | None:
        return dict(zip(("tail_t", "tail"), joined(self.tails), strict=True)) if self.tails else None

    def slice_path(self) -> Columns | None:
        """Return the outline of the slices; an impulse has no width."""
        if not self.in_slices:
            return None
        jolts, one = self.jolts, self.sliced
        found = outline(one.ends, one.forces) if one else outline(np.stack([jolts] * 2, 1), np.full_like(jolts, self.J))
        return {"slice_t": found[0], "slice": found[1], "zero": np.zeros_like(found[0])}

    def summed(self) -> str:
        """Return the name of the sentence that compares the sum of the responses with the motion."""
        if not self.is_driven or self.kind != "force":
            return "idle" if self.kind == "force" else "other"
        if not self.in_slices:
            return "fast"
        if not self.compared:
            return "impulses"
        miss, largest = self.compared
        return "follows" if miss <= FOLLOWS * largest else "coarse" if self.slice_share > SHORT else "changes"
