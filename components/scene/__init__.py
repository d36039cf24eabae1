"""A scene: its parameters, the pure function that computes their picture, and the frame of the picture."""

from components.scene.picture import Picture
from components.scene.scene import Scene
