"""A sentence for each preset on what to watch."""

WATCH = {
    "Benign": "Follow one line down: each further digit costs a stepping method time, the formula none.",
    "Beats": "Frequencies close to each other are no harder to step: what counts is the fastest swing.",
    "Wide apart, 1e6": "2000 fast swings to each slow one: a stepping method must step through all of them.",
    "Wide apart, 1e10": "The fast mode stands still, yet explicit methods need its steps: they make no progress here.",
    "Light mass 2": "A millionth of the mass swings 1000 times as fast: its small steps set the cost for both.",
    "Stiff: a dashpot": "Nothing swings, but one rate is 10⁶ times the other: explicit methods make no progress.",
    "Near resonance": "Driven 10⁻⁸ from resonance the swing grows and grows, and the formula keeps its digits.",
    "At resonance": "At resonance the formula has a limit of its own: it keeps its digits there too.",
    "From a link": "The chain of the link, or of the scene you came from: Run measures each method on it.",
}
