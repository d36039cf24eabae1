"""A sentence for each preset on what to watch."""

WATCH = {
    "Light": "Four drops, four lengths, one factor: × 0.532. It stays below 1 % of its start only after 7.13 s.",
    "Car": "ζ 0.306: it overshoots by 36.4 %, and stays below 5 % of its start after 0.976 s.",
    "Worn": "A fifth of the car's damping: each swing keeps 68 %; below 5 % of its start after 5.84 s.",
    "Door closer": "ζ 1.5: it shuts without a slam, and is 8 mm from shut after 8.31 s.",
    "Critical": "It falls to 1 % of its start in 1.06 s; ζ 3 takes 4.30 s; ζ 0.83, which goes 1 % past 0, 0.674 s.",
    "Thrown": "It passes 0 once at 0.0506 s and turns at −0.0525 m; 98.8 % is heat after 0.2 s.",
    "No dashpot": "Envelope and staircase are gone, and the roots sit on the axis: nothing is lost.",
}
