"""A sentence for each preset on what to watch."""

WATCH = {
    "Both": "Two modes at once: x₁ and x₂ are sums of the same two sines.",
    "Slow": "Released in the shape of the slow mode, both masses swing the same way, in one sine.",
    "Fast": "Released in the shape of the fast mode, the masses swing opposite ways, in one sine.",
    "Beats": "The energy wanders from mass 1 to mass 2 and back.",
    "All equal": "The ratio of 0.618 and 1.618 rad/s is irrational, so the motion never repeats.",
    "Drift": "Without spring 1 the pair moves off at constant speed, and swings about its centre of mass.",
    "Heavy, light": "The light mass shows both modes; the heavy one swings nearly as if it were alone.",
}
