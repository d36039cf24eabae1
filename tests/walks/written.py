"""The file of a walk whose step has other numbers for each student."""

SWING = """
title = "Mine"
[[step]]
id = "swing"
kind = "number"
title = "More mass, more time"
state = "?scene=oscillator&view=motion&x_0=0.1"
reveal = "?scene=oscillator&view=motion&x_0=0.1&m=4"
vary = { k = [20, 80] }
cover = ["value:tau"]
question = "One swing takes {tau} s at {k} N/m. How long with 4 kg?"
explain = "It takes {tau} s."
answer = { of = "tau", unit = "s", tol = 0.05 }
misses = [{ is = "2 * tau", idea = "-", reply = "No." }]
"""
