"""For each preset, a sentence that says what to watch."""

WATCH = {
    "Unequal masses": "Watch for the shapes on which both masses agree: there are just two.",
    "All equal": "Equal masses and springs: in one shape they swing the same way, in the other opposite ways.",
    "Beats": "A light mass tuned to a heavy one: the two frequencies are close.",
    "No wall": "Without spring 1 the slow frequency is 0: both masses drift together.",
    "Loose": "With a loose spring 2 each mass nearly has a frequency of its own.",
}
