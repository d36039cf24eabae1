"""Faces that many tests use, each built once: building one costs half a second."""

from __future__ import annotations

from functools import cache

from components.panel_face.face import PanelFace
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
