"""A sentence for each preset on what to watch."""

WATCH = {
    "All equal": "From ω₋ to its zero, 1 rad/s, mass 1 swings against the push in xₚ; past it with the push.",
    "At slow": "Pushed at the slow frequency it swings further and further: nothing damps it.",
    "At fast": "Pushed at the fast frequency it swings further and further, the masses opposite ways.",
    "Still mass 1": "At 1 rad/s mass 1 stands still under the push: spring 2 pulls it back just as hard.",
    "Light mass 2": "A light mass 2 splits one resonance into two, close to each other.",
    "Damped": "With dashpots the swing at the slow frequency has an end: the complementary part dies, xₚ remains.",
}
