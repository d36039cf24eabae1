"""The physics of the lecture: pure functions of numbers, without a trace of the page that shows them."""
