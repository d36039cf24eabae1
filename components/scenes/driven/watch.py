"""A sentence for each preset on what to watch."""

WATCH = {
    "Below": "kX is 1.72 pushes, inertia takes 0.842 of it away; x lags 0.502 rad.",
    "Resonance": "A rectangle: kX and mω²X are 2.5 pushes each, cωX exactly one.",
    "Above": "Inertia is 1.29 pushes; x lags 2.88 rad, nearly against the push.",
    "Strong dashpot": "No peak: at r = 1 the swing is 0.625 of F₀/k.",
    "No dashpot": "Straight envelopes: the power put in grows, and none is lost.",
    "Beats": "X is 0.267 m, yet it reaches up to 0.505 m: beats of 10.0 s, for ever.",
    "Washboard": "0.704 of the base; with ζ = 1 it would be 0.942, with ζ = 0.05 0.646.",
    "Spin-dry": "1.62, towards 1 above; on the way up it passes 2.55 at r = 1.04.",
}
