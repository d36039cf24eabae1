"""A sentence for each preset on what to watch."""

WATCH = {
    "Benign": "Follow one line down: each further digit costs a stepping method time, the formula none.",
    "Beats": "Frequencies close to each other are no harder to step: what counts is the fastest swing.",
    "Wide apart, 1e6": "Highly oscillatory: one mode swings 2000 times as fast; all steps but Gautschi's follow it.",
    "Wide apart, 1e10": "Stiff: the fast mode rests, yet explicit steps follow it; at 10⁻⁶ that is 1000 times Gauss 4.",
    "Light mass 2": "A millionth of the mass swings 1000 times as fast: its small steps set the cost for both.",
    "Stiff: a dashpot": "The velocity jumps at once: long steps of Newmark ring to the end, of Radau and BDF not.",
    "Near resonance": "Driven 10⁻⁸ from resonance the swing grows and grows, and the formula keeps its digits.",
    "At resonance": "At resonance the formula has a limit of its own: it keeps its digits there too.",
    "From a link": "The chain of the link, or of the scene you came from: Run measures each method on it, in Python.",
}
