"""The physics of the lecture: pure functions of numbers, independent of the page."""
