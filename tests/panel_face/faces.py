"""Faces that many tests use, each built once because that costs half a second, and the check of their figures."""

from functools import cache

import numpy as np

from components.panel_face.face import PanelFace
from components.panel_face.live_figure import LiveFigure
from components.scene.face import face_of
from components.scenes import SCENES


@cache
def _built(slug: str) -> PanelFace:
    return PanelFace(face_of(SCENES[slug])())


def first_face(slug: str) -> PanelFace:
    """Return the face of a scene with the values of a new scene, at t = 0."""
    face = _built(slug)
    face.scene.set(SCENES[slug].at().values)
    face.player.value = 0
    return face


def check_figures(face: PanelFace) -> None:
    """All figures draw the scene's numbers in the units of their axes."""
    picture, drawn = face.scene.shown, 0
    for figure in face.figures.values():
        block = figure.block
        if figure not in face.seen or not figure.has(picture):
            continue
        ruler = picture.axes[block.x].ruler
        rest = 1e-9 * (ruler.end - ruler.start)
        assert figure.model.x_range.start <= ruler.start + rest < ruler.end <= figure.model.x_range.end + rest
        for renderer, part in figure.parts.items():
            given = picture.sources.get(part.source, {}).get(part.x, ())
            if renderer.visible:
                assert np.array_equal(renderer.data_source.data[part.x], picture.axes[block.x].places(given))
                drawn += 1
        for item, renderers in figure.items.items():
            assert item.visible == any(renderer.visible for renderer in renderers), "the legend has what is drawn"
        drawn += figure.field is not None and len(figure.field.data["image"])
    assert drawn or not any(isinstance(one, LiveFigure) for one in face.seen)
