"""Small moving pictures for the start page: SVG source with lists of positions, which the browser plays."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

WIDE, HIGH = 192, 116
"""Width and height of a picture."""
TEETH = 8
"""Turns of a spring."""
Places: TypeAlias = float | NDArray[np.float64]
Thing: TypeAlias = Callable[[], str]
"""A function that returns a picture; called when the start page is first requested."""


class Loop(NamedTuple):
    """A motion that repeats after `seconds`, in `frames` equal steps; `still` is the step for reduced motion."""

    seconds: float
    frames: int
    still: int = 0

    @property
    def share(self) -> NDArray[np.float64]:
        """Return the share of the loop that has passed at each step, from 0 to 1."""
        return np.linspace(0, 1, self.frames + 1)

    def phase(self, cycles: float = 1) -> NDArray[np.float64]:
        """Return the angle in rad at each step, for a motion with so many cycles in the loop."""
        return 2 * np.pi * cycles * self.share

    def translate(self, x: Places, y: Places, *parts: str) -> str:
        return self._transform("translate", (x, y), parts)

    def scale(self, x: Places, y: Places, *parts: str) -> str:
        return self._transform("scale", (x, y), parts)

    def rotate(self, degrees: Places, *parts: str) -> str:
        return self._transform("rotate", (degrees,), parts)

    def spring(self, x: Places, y: Places, length: Places, angle: int = 0) -> str:
        """Return a spring that starts at x, y and points to the right, or down for an angle of 90 degrees."""
        turned = f'<g transform="rotate({angle})">{self.scale(length, 1, ZIGZAG)}</g>' if angle else ""
        return self.translate(x, y, turned or self.scale(length, 1, ZIGZAG))

    def _transform(self, kind: str, columns: tuple[Places, ...], parts: tuple[str, ...]) -> str:
        table = np.broadcast_arrays(self.share, *columns)[1:]
        rows = [" ".join(map(short, row)) for row in zip(*table, strict=True)]
        if len(set(rows)) == 1:
            return f'<g transform="{kind}({rows[0]})">{"".join(parts)}</g>'
        moves = (
            f'<animateTransform attributeName="transform" type="{kind}" dur="{self.seconds}s" begin="indefinite" '
            f'repeatCount="indefinite" values="{";".join(rows)}"/>'
        )
        return f'<g transform="{kind}({rows[self.still]})">{moves}{"".join(parts)}</g>'


def short(value: float) -> str:
    """Return a number with at most two decimals."""
    return f"{value:.2f}".rstrip("0").rstrip(".") if abs(value) < 3 else f"{value:.1f}".removesuffix(".0")


def _zigzag() -> str:
    """Return a spring from 0 to 1, to be scaled to its length."""
    teeth = "".join(f"L{short(0.1 + 0.8 * (i + 0.5) / TEETH)} {5 - 10 * (i % 2)}" for i in range(TEETH))
    return f'<path class="spring scaled" d="M0 0L.1 0{teeth}L.9 0L1 0"/>'


ZIGZAG = _zigzag()


def drawn(*parts: str) -> Markup:
    """Return a picture of these parts, from back to front."""
    return Markup("".join(parts))


def mass(side: float, tint: str = "m1", high: float | None = None) -> str:
    """Return a block around the origin."""
    high = high or side
    size = f'x="{short(-side / 2)}" y="{short(-high / 2)}" width="{short(side)}" height="{short(high)}"'
    return f'<rect class="mass {tint}" {size} rx="2"/>'


def dot(tint: str, radius: float = 4) -> str:
    return f'<circle class="dot {tint}" r="{short(radius)}"/>'


def path(kind: str, d: str) -> str:
    return f'<path class="{kind}" d="{d}"/>'


def curve(kind: str, x: Places, y: Places) -> str:
    """Return a line through points."""
    points = zip(*np.broadcast_arrays(x, y), strict=True)
    return path(f"ln {kind}", "M" + "L".join(f"{short(px)} {short(py)}" for px, py in points))


def arrow(tint: str, length: float) -> str:
    """Return an arrow from the origin to the right."""
    tip = short(length)
    return path(f"ln {tint}", f"M0 0H{short(length - 5)}") + path(f"fill {tint}", f"M{tip} 0l-8 -4.500v9z")


def held(x: float, y: float, length: float, angle: int = 0) -> str:
    """Return a fixed surface with hatches: a floor at 0 degrees, a wall on the left at 90, a ceiling at 180."""
    half = length / 2
    hatches = "".join(f"M{short(at)} 0l-6 6" for at in np.arange(-half + 6, half + 1, 7))
    line = path("floor", f"M{short(-half)} 0H{short(half)}") + path("hatch", hatches)
    return f'<g transform="translate({short(x)} {short(y)}) rotate({angle})">{line}</g>'
