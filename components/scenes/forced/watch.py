"""For each preset, a sentence that says what to watch."""

WATCH = {
    "All equal": "In xₚ mass 1 swings against the push from ω₋ to 1 rad/s, with it up to ω₊, then against it.",
    "At slow": "Pushed at the slow frequency it swings further and further: nothing damps it.",
    "At fast": "Pushed at the fast frequency it swings further and further, the masses opposite ways.",
    "Still mass 1": "At 1 rad/s mass 1 stands still under the push: spring 2 pulls it back just as hard.",
    "Light mass 2": "A light mass 2 splits one resonance into two, close to each other.",
    "Damped": "With dashpots the swing at the slow frequency has an end: the complementary part decays, xₚ remains.",
}
