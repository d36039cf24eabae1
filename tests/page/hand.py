"""A hand on a page without a browser: the page's own scripts, on a layout made up in hand.js."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import replace

from components.language.blocks import PlotBlock, StageBlock
from components.language.picture import View
from components.language.shapes import AnyShape, Grab
from components.layout.sheet import blocks
from components.scene import Scene
from components.state.encoding import view_of
from components.state.standing import Standing, with_values
from tests.page.names import visible
from tests.page.scripts import call

Named = dict[str, float]
Point = tuple[float, float]


def grabs(scene: type[Scene], forms: dict[str, str] | None = None) -> Iterator[tuple[AnyShape, Grab]]:
    """Each shape of a scene's sheet that is grabbed; with the forms of a picture those in blocks that stand."""
    for block in blocks(scene.sheet()) if forms is None else visible(scene.sheet(), forms):
        for shape in block.shapes if isinstance(block, (StageBlock, PlotBlock)) else ():
            if shape.grab:
                yield shape, shape.grab


def sets(grab: Grab) -> list[str]:
    return [way.parameter for way in grab.ways if way.parameter]


class Hand:
    """Over a shape of a page, a wide one or a phone's, at an instant; the frame stands while it holds on."""

    def __init__(self, now: Standing, shape: AnyShape, *, wide: bool, t: float) -> None:
        self.now = now
        plots = [(plot.name, plot.x, plot.y) for plot in blocks(now.kind.sheet()) if isinstance(plot, PlotBlock)]
        call("tests/page/hand.open", plots, shape, wide, self._view, t)

    @property
    def scene(self) -> Scene:
        return self.now.scene

    @property
    def _view(self) -> View:
        return replace(view_of(self.now.shown, {})[0], signals=self.now.shown.signals)

    def set(self, values: Named) -> None:
        self.now = with_values(self.now, values, holding=True)
        call("tests/page/hand.show", self._view)

    def at(self, *, moved: bool = True) -> Point | None:
        """Where the grip is, with what the hand has moved or as the picture has it; None where it is not drawn."""
        found = call("tests/page/hand.at", moved)
        return found and (found[0], found[1])

    def take(self) -> Named:
        """The values that are set when the grip is taken."""
        return self._does("pointerdown", self.at() or (0.0, 0.0))

    def move(self, to: Point) -> Named:
        return self._does("pointermove", to)

    def _does(self, deed: str, place: Point) -> Named:
        return dict(call("tests/page/hand.does", deed, *place))
