"""A hand on a page without a browser: the page's own scripts, on a layout made up in hand.js."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec.structs import replace

from components.language.blocks import PlotBlock, StageBlock
from components.language.picture import PagePicture
from components.language.shapes import AnyShape, Grab
from components.layout.sheet import blocks, in_force
from components.scene import Picture, Scene
from components.state.encoding import view_of
from components.state.page_state import PageState, with_values
from components.state.scene_sheet import plots
from tests.page.scripts import call

Named = dict[str, float]
Point = tuple[float, float]


def grabs(scene: type[Scene], forms: dict[str, str] | None = None) -> Iterator[tuple[AnyShape, Grab]]:
    """Each shape of a scene's sheet that is grabbed; with the forms of a picture those in blocks that stand."""
    for block in blocks(scene.sheet()) if forms is None else in_force(scene.sheet(), forms):
        for shape in block.shapes if isinstance(block, (StageBlock, PlotBlock)) else ():
            if shape.grab:
                yield shape, shape.grab


def sets(grab: Grab) -> list[str]:
    return [way.parameter for way in grab.ways if way.parameter]


def draw(scene: type[Scene], picture: Picture, shapes: Sequence[AnyShape]) -> None:
    """Draws shapes in all layouts at once, as a picture starts; a name that it has not is a fault."""
    layout = dict.fromkeys(("wide", "narrow", "stacked", "hall", "desk", "low"), 1)
    call("tests/page/hand.draw", _axes(scene), shapes, layout, _view(picture))


def _axes(scene: type[Scene]) -> list[tuple[str, str, str]]:
    return [(plot.name, plot.x, plot.y) for plot in plots(scene)]


def _view(picture: Picture) -> PagePicture:
    return replace(view_of(picture, {})[0], signals=picture.signals)


class Hand:
    """Over a shape of a page, a wide one or a phone's, at an instant; the frame stands while it holds on."""

    def __init__(self, now: PageState, shape: AnyShape, *, wide: bool, t: float) -> None:
        self.now = now
        layout = {"wide": wide, "narrow": not wide, "stacked": not wide, "hall": 0, "desk": 1, "low": 0}
        call("tests/page/hand.open", _axes(now.kind), [shape], layout, _view(now.shown), t)

    @property
    def scene(self) -> Scene:
        return self.now.scene

    def set(self, values: Named) -> None:
        self.now = with_values(self.now, values, holding=True)
        call("tests/page/hand.show", _view(self.now.shown))

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
