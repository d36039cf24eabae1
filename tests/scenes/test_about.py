"""About these numbers: every point within its bound, and true by formulas that the reference does not share."""

import re
from dataclasses import replace
from decimal import Decimal
from functools import partial
from typing import Any

import msgspec
import numpy as np
import pytest

from components.quantities.formatting import parse_number
from components.scene import Scene
from components.scene.about import NO_BAND, About, Table, about_numbers, bounded, digits, drift
from components.scenes import SCENES
from tests.scenes.checks import in_any_state

SLUGS = [slug for slug, scene in SCENES.items() if scene.is_checked()]
FAST: dict[str, dict[str, Any]] = {
    **{slug: {"window": 1e5} for slug in ("oscillator", "energy", "analogues", "phugoid", "coupled")},
    "damped": {"c": 1e-5, "window": 1e4},
    "driven": {"window": 1e4},
    "forced": {"k2": 1e12, "omega": 1e5},
}
UNREAD = re.compile(r"\$|\*\*|\bnan\b|\binf\b|None|Decimal|\de[-+]?\d", re.IGNORECASE)
each_scene = pytest.mark.parametrize("slug", SLUGS)


def told_by(scene: Scene) -> About | None:
    return scene.about(scene.shown)


def beyond(tables: tuple[Table, ...]) -> list[tuple[str, str, float]]:
    return [(row.name, row.place, row.off) for each in tables for row in each.rows if not row.off <= each.limit]


@each_scene
def test_every_point_of_any_state_is_within_its_bound(slug: str) -> None:
    rare = [{}, {"c1": 0.1, "omega": 0.0}] if slug == "forced" else [{}]
    in_any_state(SCENES[slug], told_by, check_points, 28, 4.0, rare)


def check_points(scene: Scene, about: About | None) -> None:
    assert about is not None and about.tables
    assert not beyond(about.tables), dict(scene.values)
    drawn = {float(value) for data in scene.shown.sources.values() for column in data.values() for value in column}
    for each in about.tables:
        for row in each.rows:
            where = re.search(r"= (\S+) ", row.place)
            assert where is None or (parse_number(where[1]) in drawn and row.drawn in drawn), row.place
    wire = about_numbers(partial(scene.about, scene.shown))
    told = msgspec.json.encode(wire).decode()
    assert not UNREAD.search(re.sub(r"<[^>]*>", "", told))
    assert len(wire.tables) == sum(bool(each.rows) for each in about.tables)


@each_scene
def test_a_curve_that_is_off_is_found_out(slug: str) -> None:
    """Add a few ulp of its largest value to every column: each row that depends on it then exceeds its bound."""
    scene = SCENES[slug]()
    if slug == "modes":
        scene.set({"view": "sweep"})
    about = told_by(scene)
    assert about is not None
    ulps = 4 * max(each.limit for each in about.tables)
    columns = {
        source: {
            name: column + (0 if name in ("t", "omega", "w", "p") else ulps * np.spacing(np.max(np.abs(column))))
            for name, column in data.items()
        }
        for source, data in scene.shown.sources.items()
        if not source.startswith("band")
    }
    wrong = scene.about(replace(scene.shown, columns=columns, traces={}))
    assert wrong is not None
    of_curves = [each for each in wrong.tables if each.limit >= 1]
    assert of_curves and len(beyond(wrong.tables)) == sum(len(each.rows) for each in of_curves)


@each_scene
def test_what_is_drawn_as_an_envelope_is_said_and_has_no_points(slug: str) -> None:
    scene = SCENES[slug]()
    plain = told_by(scene)
    assert plain is not None and plain.envelope.startswith(NO_BAND)
    if slug not in FAST:
        return
    scene.set(FAST[slug])
    about = told_by(scene)
    bands = {name.removesuffix("_lo") for name in scene.shown.sources["band"] if name.endswith("_lo")}
    assert about is not None and bands and not bands & set(scene.shown.sources["time"])
    assert "**envelope**" in about.envelope and NO_BAND not in about.envelope
    assert not any(row.name in about.envelope and row.place.startswith("$t$") for t in about.tables for row in t.rows)
    assert all(sentence.rows for sentence in about_numbers(partial(scene.about, scene.shown)).tables)


def test_bounds_digits_and_drifts_as_they_are_said() -> None:
    for limit, said in ((4, "4 ulp"), (1511.2, "1520 ulp"), (123456, "1.24·10⁵ ulp")):  # not below the one that holds
        found = bounded("x", limit, "itself", ())
        assert f"at most {said} of itself" in found.bound and found.limit >= limit
    assert digits(Decimal.from_float(0.1)) == "0.10000000000000000555"
    assert digits(Decimal("-1.5e-200")) == "−1.5000000000000000000·10⁻²⁰⁰"
    assert digits(Decimal("0.99999999999999999999999")) == "1.0000000000000000000"
    assert drift(np.array([2.0, 2.0]), 2.0) == "$T + V$ = 2.00 J; over the window it keeps every digit."
    assert "it changes by at most 0.5 of this value" in drift(np.array([2.0, 3.0]), 2.0)
    assert drift(np.zeros(2), 0.0) == "$T + V$ is 0: nothing moves."


def test_a_scene_that_cannot_say_says_why() -> None:
    def refused() -> None:
        raise ValueError("the phase leaves the range of doubles")

    told = about_numbers(refused)
    assert (told.reading, told.tables) == ("", ())
    assert told.notes == ("These numbers cannot be recomputed: the phase leaves the range of doubles.",)
