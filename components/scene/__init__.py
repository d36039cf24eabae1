"""A scene: its parameters, one pure picture of them, the frame that it is drawn in."""

from components.scene.picture import Picture
from components.scene.scene import Scene
