"""'About these numbers' of the driven mass."""

from __future__ import annotations

from components.scene import Picture
from components.scene.about import About, Place, bounded, drawn_as_bands, few, rows
from components.scenes.driven.case import DrivenCase
from physics.reference_damped import driven_points, response_points

DRIVE = Place("omega", r"$\omega$", "rad/s")


def driven_about(picture: Picture, case: DrivenCase) -> About:
    columns, sweep = picture.sources["time"], picture.sources["below"]
    at = few(columns["t"])
    one, drive = case.oscillator, (case.omega, case.size, case.kind)
    true = driven_points(one, *drive, case.x_0, case.v_0, columns["t"][at].tolist())
    places = few(sweep["omega"])
    swings = response_points(one, case.kind, sweep["omega"][places].tolist())
    tables = (
        bounded("$x(t)$", 4, "the sum of the sizes of its parts", rows({"x": "$x$"}, columns, true, at)),
        bounded(
            "the response and the lag", 16, "itself, as far as rounding $r$ allows",
            rows({"M": "$|X|$ over its unit", "lag": r"$\phi$"}, sweep, swings, places, DRIVE),
        ),
    )  # fmt: skip
    work = "The work put in and the work lost in a cycle are equal once the complementary part has died."
    return About(tables, work if one.c and case.pushed else "", drawn_as_bands(picture.sources, {"x": "$x$"}))
