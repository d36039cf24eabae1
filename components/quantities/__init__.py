"""Numbers: parameters, axes, units, motions; how a number is written, typed and refused."""
