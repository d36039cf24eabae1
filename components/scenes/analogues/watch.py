"""For each preset, a sentence that says what to watch."""

WATCH = {
    "10°": "From 10° the pendulum keeps step with the spring: each of its swings takes 0.2 % longer.",
    "60°": "From 60° the pendulum falls behind the spring: each of its swings takes longer.",
    "Clock": "From 3° pendulum and spring can hardly be told apart.",
    "Nearly over": "Close to the top it nearly stands still: so its period is long.",
    "Guitar": "The string swings as the mass on its spring does: only the names change.",
    "Radio": "The circuit swings as the mass on its spring does: only the names change.",
    "Swell": "On a standing wave 200 m long the crest rises and falls as the mass on its spring does.",
    "Cavendish": "A weak wire and a heavy rotor: a swing takes minutes.",
}
