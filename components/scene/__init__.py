"""A scene: its parameters, one pure picture of them, the frame that it is drawn in."""

from components.scene.scene import Picture, Scene

__all__ = ["Picture", "Scene"]
