"""'About these numbers' of the driven mass."""

from __future__ import annotations

from components.scene import Picture
from components.scene.about import About, Place, bounded, drawn_as_bands, few_of, rows
from components.scene.traces import BAND
from components.scenes.driven.case import DrivenCase
from components.scenes.driven.curves import RINGING
from components.scenes.driven.curves import Resonance as R
from components.scenes.driven.curves import Signals as S
from physics.reference_damped import driven_points, response_points

DRIVE = Place(R.omega.name, r"$\omega$", "rad/s")


def driven_about(picture: Picture, case: DrivenCase) -> About:
    columns, sweep = picture.sources["time"], picture.sources[R.M.source]
    one, x, response = case.oscillator, {S.x: "$x$"}, {R.M: "$|X|$ over its unit", R.lag: r"$\phi$"}
    true = driven_points(one, case.omega, case.size, case.kind, case.x_0, case.v_0, few_of(columns["t"]))
    found = rows(response, sweep, response_points(one, case.kind, few_of(sweep["omega"])), DRIVE)
    tables = (
        bounded("$x(t)$", 4, "the sum of the sizes of its parts", rows(x, columns, true)),
        bounded("the response and the lag", 16, "itself, as far as rounding $r$ allows", found),
    )
    work = "The work put in and the work lost in a cycle are equal once the complementary part has died."
    bands = {BAND: picture.sources.get(BAND, {}) | picture.sources.get(RINGING, {})}
    return About(tables, work if one.c and case.pushed else "", drawn_as_bands(bands, x))
