"""'About these numbers' of the damped mass."""

from __future__ import annotations

from components.scene import Picture
from components.scene.about import About, bounded, drawn_as_bands, drift, few_of, reason_of, rows
from components.scene.traces import Columns
from components.scenes.damped.case import DampedCase
from components.scenes.damped.curves import Signals as S
from components.scenes.damped.curves import exact
from physics.reference_damped import damped_points


def damped_about(picture: Picture, case: DampedCase) -> About:
    columns, x = picture.sources["time"], {S.x: "$x$"}
    true = damped_points(case.oscillator, case.x_0, case.v_0, few_of(columns["t"]))
    energies = {S.V: "$V$", S.E: "$T + V$", S.P: "$P$"} if not picture.columns.get("time") else {}
    tables = (
        bounded("$x(t)$", 4, "both parts of $x$ together", rows(x, columns, true)),
        bounded("an energy or the power", 16, "what both parts could make it", rows(energies, columns, true)),
    )
    return About(tables, _balance(case, columns), drawn_as_bands(picture.sources, x))


def _balance(case: DampedCase, columns: Columns) -> str:
    """The sentence on how far T + V and the heat, each from its own formula, stray from what there was at the start."""
    try:
        lost = case.motion.lost(columns["t"])
        return drift(exact(case, columns["t"])[S.E] + lost, case.E_0, "$T + V$ + heat")
    except ValueError as reason:
        return f"The balance of the energies cannot be computed over the window: {reason_of(reason)}."
