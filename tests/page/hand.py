"""Pointer input on a page without a browser: the page's own scripts on the layout of hand.js."""

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
    """Return each draggable shape of a scene's sheet; with the forms of a picture, those of visible blocks."""
    for block in blocks(scene.sheet()) if forms is None else in_force(scene.sheet(), forms):
        for shape in block.shapes if isinstance(block, (StageBlock, PlotBlock)) else ():
            if shape.grab:
                yield shape, shape.grab


def sets(grab: Grab) -> list[str]:
    return [way.parameter for way in grab.ways if way.parameter]


def draw(scene: type[Scene], picture: Picture, shapes: Sequence[AnyShape]) -> None:
    """Draw shapes in all layouts at the start of a picture; an unknown name is an error."""
    layout = dict.fromkeys(("wide", "narrow", "stacked", "hall", "desk", "low"), 1)
    call("tests/page/hand.draw", _axes(scene), shapes, layout, _view(picture))


def _axes(scene: type[Scene]) -> list[tuple[str, str, str]]:
    return [(plot.name, plot.x, plot.y) for plot in plots(scene)]


def _view(picture: Picture) -> PagePicture:
    return replace(view_of(picture, {})[0], signals=picture.signals)


class Hand:
    """A pointer over a shape of a wide page or a phone at one instant; the frame stays fixed during a drag."""

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
        """Return the position of the grip with the dragged values or those of the picture; None if it is not drawn."""
        found = call("tests/page/hand.at", moved)
        return found and (found[0], found[1])

    def take(self) -> Named:
        """Return the values that are set when the grip is taken."""
        return self._does("pointerdown", self.at() or (0.0, 0.0))

    def move(self, to: Point) -> Named:
        return self._does("pointermove", to)

    def _does(self, deed: str, place: Point) -> Named:
        return dict(call("tests/page/hand.does", deed, *place))
