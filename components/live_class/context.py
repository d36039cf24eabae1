"""The context of the live class's handlers: its rooms, and limits on the rate of requests."""

from __future__ import annotations

from dataclasses import dataclass, field

from components.live_class.registry import Registry
from components.live_class.slices import Turns
from components.serving.visitors import Arrivals, Rate

OF_A_CLASS = 1200
"""Messages a minute of one instructor, follower or remote control."""
OPENINGS = 60
"""Classes that one network may open in a minute."""


@dataclass(frozen=True)
class ClassContext:
    registry: Registry
    rate: Rate = field(default_factory=lambda: Rate(OF_A_CLASS))
    openings: Arrivals = field(default_factory=lambda: Arrivals(OPENINGS))
    turns: Turns = field(default_factory=Turns)
