"""The contract of every scene: any state can be drawn or is refused in words; one solve a change, presets, small
messages; its use as a library; the same picture, with the same digits in its texts, in other units; and about these
numbers, every point is within its bound, and true by formulas that the reference does not share.
"""

import copy
import dataclasses
import doctest
import pickle
import re
from collections.abc import Iterator
from decimal import Decimal
from functools import partial
from typing import Any
from unittest.mock import Mock

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from components.panel_face.face import PanelFace
from components.quantities.formatting import parse_number
from components.quantities.instant import instant
from components.quantities.parameters import Quantity
from components.quantities.refusals import SORRY
from components.scene import Picture, Scene
from components.scene.about import NO_BAND, About, Table, about_numbers, bounded, digits, drift
from components.scene.face import SceneFace
from components.scenes import SCENES
from components.session.links import page_state_of
from components.state.encoding import span
from components.state.link import Link, read_query
from components.state.scene_sheet import column_axes
from tests.grids import tries
from tests.page.headless_page import Page, set_values
from tests.page.scripts import played
from tests.scenes.checks import as_arguments, changes, check_picture, choices, in_any_state, power, scaled
from tests.states import links

ALL_DOUBLES = 60.0
"""Decades beyond the sliders: from nothing to far more than a square can hold."""
MOST_BYTES = {"phugoid": 5000}
"""Of a change, where 3000 are not enough."""
FRAMES = 340
"""Bytes of the frames that Bokeh sends with a change."""
pytestmark = pytest.mark.timeout(600)
scenes = pytest.mark.parametrize("scene_class", SCENES.values(), ids=SCENES.keys())
ODD: tuple[object, ...] = (None, "", "2", True, ["x"], [1], {"k": 1}, 3, 1j, float("nan"), -float("inf"), 10**400)
"""Values of all types, most of them wrong for any parameter."""
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
FAST: dict[str, dict[str, Any]] = {
    **{slug: {"window": 1e5} for slug in ("oscillator", "energy", "analogues", "phugoid", "coupled")},
    "damped": {"c": 1e-5, "window": 1e4},
    "driven": {"window": 1e4},
    "forced": {"k2": 1e12, "omega": 1e5},
}
UNREAD = re.compile(r"\$|\*\*|\bnan\b|\binf\b|None|Decimal|\de[-+]?\d", re.IGNORECASE)
checked = pytest.mark.parametrize("slug", [slug for slug, scene in SCENES.items() if scene.is_checked()])


@scenes
def test_a_picture_of_any_state_is_finite_or_refused_in_words(scene_class: type[Scene]) -> None:
    """The browser evaluates its signals as Python does, and its address brings the state back."""

    @settings(max_examples=tries(80))
    @given(links(scene_class) | links(scene_class, ALL_DOUBLES), st.sampled_from([0.0, 1e-3, 0.31, 0.77, 1.0]))
    def holds(link: Link, share: float) -> None:
        now, refused = page_state_of(scene_class, link)
        check_picture(now)
        for sentence in refused:
            assert sentence.endswith((".", "…")) and SORRY not in sentence, sentence
        read = read_query(as_arguments(now.query), SCENES)
        again, problems = page_state_of(now.kind, read)
        assert (read.problems, problems, again.query) == ([], [], now.query)
        assert replace(again.state, frame=None) == replace(now.state, frame=None)
        shown = now.shown
        t = share * shown.axes["t"].place(shown.axes["t"].end) if "t" in shown.axes else share
        wanted, beside = (instant(shown.signals, shown.scalars, one) for one in (t, t * (1 + 2.0**-50)))
        for name, value in played(shown, t).items():  # of a fast motion the phase has the rounding of its instant
            room = 1e-9 + 2 * abs(beside[name] - wanted[name])
            assert float(value) == pytest.approx(wanted[name], rel=1e-9, abs=room), name

    holds()


@scenes
def test_each_change_is_one_solve(scene_class: type[Scene]) -> None:
    scene, counted = scene_class(), list[Picture]()
    scene.on_picture(counted.append)
    presets = map(scene_class.preset_all, scene_class.presets)
    for values in (next(changes(scene_class)), *choices(scene_class), *presets):
        counted.clear()
        is_another = bool(scene.differing(values))
        scene.set(values)
        assert len(counted) == is_another, values
        check_picture(scene)


@scenes
def test_a_change_is_small(scene_class: type[Scene]) -> None:
    page = Page(scene_class())
    for values in changes(scene_class):
        set_values(page, **values)
        set_values(page, **{name: scene_class.param[name].default for name in values})
    assert max(len(packet["data"]) for packet in page.packets) + FRAMES <= MOST_BYTES.get(scene_class.slug, 3000)


@pytest.mark.parametrize(
    "documented",
    [Scene, Scene.frame, Scene.numbers, SceneFace, PanelFace, *SCENES.values()],
    ids=lambda one: getattr(one, "__name__", "numbers"),
)
def test_the_examples_of_docstrings_run(documented: Any) -> None:
    name = getattr(documented, "__name__", "numbers")
    examples = doctest.DocTestParser().get_doctest(documented.__doc__ or "", {}, name, None, 0)
    assert doctest.DocTestRunner().run(examples).failed == 0
    assert examples.examples


def test_a_wrong_name_or_word_is_refused_with_those_that_there_are() -> None:
    scene: Any = SCENES["coupled"]()
    with pytest.raises(AttributeError, match=r"k3 is not a parameter of Coupled: it has .*m1, m2, k1, k2"):
        scene.k3 = 2.0
    with pytest.raises(ValueError, match=r"^view = 'plan' is not possible: choose one of motion, energy, plane"):
        scene.view = "plan"


@scenes
def test_an_odd_value_is_taken_or_refused_in_words(scene_class: type[Scene]) -> None:
    scene: Any = scene_class()
    before, taken = scene.value, 0
    for name in scene_class.linked():
        for odd in ODD:
            try:
                setattr(scene, name, odd)
            except ValueError as error:
                assert re.match(r"[^'].* .*\w", str(error)), (name, odd, error)
                if not isinstance(odd, (int, float)):
                    assert str(error).startswith(f"{name} = "), (name, odd, error)
                    with pytest.raises(ValueError, match=re.escape(str(error))):
                        scene_class(**{name: odd})
            else:
                taken += 1
                assert type(scene.values[name]) in (type(odd), float) and scene.shown, (name, odd)
                scene.show(before)
            assert scene.value.key == before.key, (name, odd)
    assert taken


@scenes
def test_numbers_outlive_copies(scene_class: type[Scene]) -> None:
    scene = scene_class(window=12.5)
    for twin in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert twin.numbers == scene.numbers and twin.numbers is not scene.numbers
        twin.window = 20.0
        assert scene.window == 12.5


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


def told_by(scene: Scene) -> About:
    return scene.about(scene.shown) or pytest.fail("it has no numbers to check")


def beyond(tables: tuple[Table, ...]) -> list[tuple[str, str, float]]:
    return [(row.name, row.place, row.off) for each in tables for row in each.rows if not row.off <= each.limit]


@checked
def test_every_point_of_any_state_is_within_its_bound(slug: str) -> None:
    rare = [{}, {"c1": 0.1, "omega": 0.0}] if slug == "forced" else [{}]
    in_any_state(SCENES[slug], told_by, check_points, 28, 4.0, rare)


def check_points(scene: Scene, about: About) -> None:
    assert about.tables
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


@checked
def test_a_curve_that_is_off_is_found_out(slug: str) -> None:
    """Add a few ulp of its largest value to every column: each row that depends on it then exceeds its bound."""
    scene = SCENES[slug]()
    if slug == "modes":
        scene.set({"view": "sweep"})
    ulps = 4 * max(each.limit for each in told_by(scene).tables)
    columns = {
        source: {
            name: column + (0 if name in ("t", "omega", "w", "p") else ulps * np.spacing(np.max(np.abs(column))))
            for name, column in data.items()
        }
        for source, data in scene.shown.sources.items()
        if not source.startswith("band")
    }
    wrong = scene.about(dataclasses.replace(scene.shown, columns=columns, traces={}))
    assert wrong is not None
    of_curves = [each for each in wrong.tables if each.limit >= 1]
    assert of_curves and len(beyond(wrong.tables)) == sum(len(each.rows) for each in of_curves)


@checked
def test_what_is_drawn_as_an_envelope_is_said_and_has_no_points(slug: str) -> None:
    scene = SCENES[slug]()
    assert told_by(scene).envelope.startswith(NO_BAND)
    if slug not in FAST:
        return
    scene.set(FAST[slug])
    about = told_by(scene)
    bands = {name.removesuffix("_lo") for name in scene.shown.sources["band"] if name.endswith("_lo")}
    assert bands and not bands & set(scene.shown.sources["time"])
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
    told = about_numbers(Mock(side_effect=ValueError("the phase leaves the range of doubles")))
    assert (told.reading, told.tables) == ("", ())
    assert told.notes == ("These numbers cannot be recomputed: the phase leaves the range of doubles.",)
