"""The guess in the hand: the point of its frequency and shape, and the shape where the masses turn."""

from __future__ import annotations

from components import chain
from components.language.numbers import Number, var
from components.language.shapes import Along, Quotient
from components.layout.grabs import grab, on_plot
from components.layout.stage import Shape, W, box, circle, shown_by

METRE = 0.112
"""The share of the stage's width that an amplitude of 1 m takes."""
LEAST = 0.02
"""m; as small as a hand makes an amplitude: the other one is 1 m."""
UNIT = METRE * W


def guess_point(x: Number, y: Number) -> Shape:
    """The point in the plane of omega^2 and X2/X1."""
    ways = on_plot("shape", "x", "omega", "w", "w", least=0.0), on_plot("shape", "y", "ratio", "r", "r")
    held = grab("Guess: frequency and shape", *ways, inside="shape")
    return circle(x, y, 8, tint="F", show="guess_in", grab=held, held=True)


def full_swing(foot: Number) -> list[Shape]:
    """Both masses where they turn, in outline: the one that swings less is taken in hand, the other keeps its 1 m."""
    one, two = chain.rest(1), chain.rest(2)
    first = Quotient(parameter="ratio", moves="X1", across="x", zero=one, unit=UNIT, over="X2", least=LEAST, most=1.0)
    second = Along(parameter="ratio", moves="X2", across="x", zero=two, unit=UNIT, least=-1.0, most=1.0)
    shapes: list[Shape] = []
    for i, way in ((1, first), (2, second)):
        full = chain.rest(i) + UNIT * var(f"X{i}")
        held = grab(f"Shape: where mass {i} turns", way)
        shapes.append(box(full, foot, chain.side(i), "", tint=f"m{i}", style="ghost full"))
        shapes += shown_by(f"less{i}", circle(full, foot - 0.5 * chain.side(i), 0, grab=held))
    return shapes
