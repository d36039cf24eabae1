"""A sentence for each preset on what to watch."""

WATCH = {
    "Ripple, 0.1": "After a small disturbance exact flight and linear theory differ by 5 % of the swing at most.",
    "Deep, 0.6": "The tops are sharper than the valleys, so the path is not a sine.",
    "Cusp, 0.732": "At the top the speed falls to 0: there the path has a cusp.",
    "Loop, 1": "It flies loops: the path crosses itself.",
}
