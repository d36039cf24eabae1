"""In other units of mass, length and time each scene shows the same picture, with the same digits in its texts."""

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from components.quantities.instant import instant
from components.quantities.parameters import Quantity
from components.scene import Scene
from components.scenes import SCENES
from components.state.encoding import span
from components.state.scene_sheet import column_axes
from tests.scenes.checks import choices, power, scaled

ONE, OTHER = (6, 18, -12), (9, 24, -15)
"""Two systems of units, as powers of ten: both so far from SI that each number is written with a power of ten."""
FIXED = {
    "oscillator": r"peak_[xva]|peak\d_seen",  # at 0 or a period later, by rounding
    "driven": r"width",  # 1.005 rounds to either side
    "energy": r"planet\d|here_\w+|has_planet\d|place|other",
    "absorber": r"swing",  # 0 by rounding
    "analogues": r"note|inertia|stiffness",  # of a pipe of one width with air of one density
    "forced": r"(time|energy)\..*|pole_..\d|above\d_\d|unit|turn",  # how many samples; a hand only in nearer units
    "modes": r"add\d_N|paths\.re[23]",  # of a swing of 1 m; paths meet near a double root
    "phugoid": r"(tau_)?(at_)?(model|glider|light|airliner)|v_here|tau_here|named|at_.*",
}
"""Names of what a scene states in SI, planets and aircraft, and of what rounding decides."""
NATURE = {"rocking", "floating", "string"}
"""Analogues with a constant of nature in their formulas."""


def growth(unit: str) -> int:
    """Return the power of ten by which the number of a quantity grows from one system to the other."""
    return power(unit, OTHER) - power(unit, ONE)


def states(kind: type[Scene]) -> Iterator[Any]:
    """Each preset and each word of each choice, where no axis is logarithmic and no formula has a constant.

    No machine is the one of the book, and no driven chain is at a resonance, where rounding decides.
    """
    for state in ({}, *map(kind.preset_all, kind.presets), *choices(kind)):
        scene = kind.at({**state, "own": True} if "own" in kind.linked() else state)
        if kind.slug == "forced":
            scene = kind.at({**state, "omega": 1.03 * scene.omega})
        if scene.values.get("system") not in NATURE and not any(axis.log for axis in scene.shown.axes.values()):
            yield scene


def texts(scene: Any) -> dict[str, str]:
    """All texts, with three digits of each number and without its power of ten."""
    shown = scene.shown
    named = {**shown.values, **{f"note {i}": note for i, note in enumerate(shown.notes)}}
    plain = {name: re.sub(r"(·| )?10[⁻⁰¹²³⁴-⁹]+|\s", "", text) for name, text in named.items()}
    digits = {
        name: re.sub(r"\d[\d.]*", lambda one: one[0].replace(".", "").strip("0")[:3], text)
        for name, text in plain.items()
    }
    return digits | {f"form {name}": text for name, text in shown.forms.items()}


def numbers(scene: Any) -> dict[str, np.ndarray]:
    """All numbers that are sent: scalars, columns where they are drawn, and signals at two instants."""
    shown, axes = scene.shown, column_axes(type(scene))
    found: dict[str, np.ndarray] = {name: np.array(one) for name, one in shown.scalars.items()}
    for source, columns in shown.sources.items():
        for name in columns.keys() & axes.get(source, {}).keys():
            axis = shown.axes[axes[source][name]]
            found[f"{source}.{name}"] = np.clip(axis.places(columns[name]), *span(axis.ruler))
    for share in (0.0, 0.3) if "t" in shown.axes else ():
        now = instant(shown.signals, shown.scalars, share * shown.axes["t"].ruler.end)
        found |= {f"{name} at {share}": np.array(one) for name, one in now.items() if name not in shown.scalars}
    return found


def differences(one: Any, other: Any) -> Iterator[str]:
    """Yield the names of all that differs by more than the units."""
    said, other_said = texts(one), texts(other)
    yield from (name for name in said.keys() | other_said.keys() if said.get(name) != other_said.get(name))
    units = [p.unit for p in one.linked().values() if isinstance(p, Quantity)]
    powers = {0, *map(growth, units), *(growth(number.unit) for number in one.numbers.values())}
    sent, other_sent = numbers(one), numbers(other)
    for name in sent.keys() ^ other_sent.keys() | one.numbers.keys() ^ other.numbers.keys():
        yield name
    for name in sent.keys() & other_sent.keys():
        if not any(is_same(sent[name] * 10.0**by, other_sent[name], 1e-9 * 10.0**by) for by in powers):
            yield name
    for name, ends in one.shown.spans.items():
        if not is_same(np.array(ends) * 10.0 ** growth(one.linked()[name].unit), np.array(other.shown.spans[name])):
            yield name
    for name in one.numbers.keys() & other.numbers.keys():
        value, by = one.numbers[name].value, growth(one.numbers[name].unit)
        if not is_same(np.array(value * 10.0**by), np.array(other.numbers[name].value), 0.0 if by else 1e-12):
            yield name


def is_same(x: np.ndarray, y: np.ndarray, least: float = 0.0) -> bool:
    """Compare all numbers but 2 %: by rounding, a sample at a jump is on either side of it."""
    if x.shape != y.shape:
        return False
    most = np.abs(y[np.isfinite(y)]).max(initial=0.0)
    near = np.isclose(x, y, rtol=1e-6, atol=max(1e-6 * most, least))
    return bool(np.mean(near) >= 0.98) if near.size else True


@pytest.mark.parametrize("slug", [slug for slug in SCENES if slug != "accuracy"])
def test_in_other_units_the_picture_is_the_same(slug: str) -> None:
    fixed = re.compile(rf"({FIXED.get(slug, 'none')})( at .*)?")
    for scene in states(SCENES[slug]):
        one, other = scaled(scene, ONE), scaled(scene, OTHER)
        assert not [name for name in differences(one, other) if not fixed.fullmatch(name)], dict(scene.off_default())
