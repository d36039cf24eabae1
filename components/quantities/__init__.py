"""Numbers: parameters, axes, units, motions; how a number is formatted, parsed and rejected."""
