"""Reference solutions in arbitrary precision, independent of the rest, to measure it by."""
