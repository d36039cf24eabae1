"""A sentence for each preset on what to watch."""

WATCH = {
    "Below": "Below the machine's own frequency: see how much vibration is left with a tuned absorber.",
    "Resonant": "At the machine's own frequency: without an absorber it would swing further and further.",
    "Above": "Above the machine's own frequency: watch between which resonances its speed lies.",
    "Own": "Your own machine: set it first, then its absorber.",
}
