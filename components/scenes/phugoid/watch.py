"""For each preset, a sentence that says what to watch."""

WATCH = {
    "Ripple, 0.1": "A small swing: in its first period the heights of both theories differ by about 5 % of it.",
    "Deep, 0.6": "The tops are sharper than the valleys, so the path is not a sine.",
    "Cusp, 0.732": "At the top the speed falls to 0: there the path has a cusp.",
    "Loop, 1": "It flies loops: the path crosses itself.",
}
