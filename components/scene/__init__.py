"""The framework of scenes: parameters, the pure function that computes their picture, and the frame of a picture."""

from components.scene.picture import Picture
from components.scene.scene import Scene
