"""A sentence for each preset on what to watch."""

WATCH = {
    "Pulled down": "T is largest where x passes 0, V where the mass turns; the sum stays constant.",
    "Pushed up": "As far up as it was pulled down: the same energy.",
    "Kicked at equilibrium": "It starts with its largest T; a quarter period later T is 0.",
    "Heavy": "Twice the mass hangs twice as deep, and swings more slowly with the same T at its largest.",
    "Soft": "On a softer spring it swings more slowly, and where there is gravity it hangs deeper.",
    "Hanging still": "At rest in equilibrium nothing swings: x and T stay 0.",
}
