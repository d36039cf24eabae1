"""Laws that every state of a scene obeys: it can be drawn or is refused in words, its texts say its numbers, and
in one frame a larger motion is drawn larger."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings

from components.quantities.instant import instant
from components.quantities.refusals import SORRY
from components.scenes import SCENES
from components.session.links import page_state_of
from components.state.csv_export import tables
from components.state.link import Link
from components.state.page_state import PageState, with_values
from tests.grids import tries
from tests.scenes.checks import check_picture
from tests.states import links, state_of, values

pytestmark = pytest.mark.timeout(600)
scenes = pytest.mark.parametrize("slug", SCENES)
ALL_DOUBLES = 60.0
"""Decades beyond the sliders: from nothing to far more than a square can hold."""


@pytest.mark.parametrize("decades", [6.0, ALL_DOUBLES])
@scenes
def test_a_picture_of_any_state_is_finite_or_refused_in_words(slug: str, decades: float) -> None:
    @settings(max_examples=tries(60))
    @given(links(SCENES[slug], decades))
    def holds(link: Link) -> None:
        now, refused = page_state_of(SCENES[slug], link)
        check_picture(now)
        for sentence in refused:
            assert sentence.endswith((".", "…")) and SORRY not in sentence, sentence

    holds()


CHAIN = "t x1 x1_slow x1_fast x2 x2_slow x2_fast"
COLUMNS: list[tuple[str, dict[str, Any], str]] = [
    ("oscillator", {}, "time: t x v a, loop: t x v a"),
    ("energy", {}, "time: t x T V total, well: x V"),
    ("analogues", {}, "time: t x q, excess: curve angle excess"),
    ("damped", {}, "time: t x upper lower V T E E_0 heat P, locus: re im"),
    ("damped", {"zeta": 1.5}, "time: t x slow fast V T E E_0 heat P, locus: re im"),
    ("damped", {"c": 0.0}, "time: t x V T E E_0"),
    ("damped", {"c": 1e-3, "window": 1e4},
     "band: t upper lower x_lo x_hi V_mean T_mean E_mean E_0_mean heat_mean P_mean"),
    ("driven", {}, "time: t x x_c x_p, below: omega M lag power, power: t P_in P_lost"),
    ("modes", {}, "path: t x1 x2"),
    ("coupled", {}, f"time: {CHAIN} T1 V1 V2 T2, modes: slow1 slow2 fast1 fast2"),
    ("coupled", {"energy": "modes"}, f"time: {CHAIN} E_slow E_fast E_total"),
    ("forced", {}, "time: t x1 x1_p x1_c x2 x2_p x2_c, energy: t gain work, response: omega Xp1 Xp2, "
     "nyquist: omega re1 re2 im1 im2"),
    ("absorber", {}, "rest: t x1 x1_p x1_c, sweep: w swing stroke alone, helped: w helped_lo helped_hi"),
]  # fmt: skip
"""Tables of files and the columns that they begin with: programs read them by these names."""


@pytest.mark.parametrize(("slug", "values", "text"), COLUMNS)
def test_a_file_keeps_its_columns(slug: str, values: dict[str, Any], text: str) -> None:
    scene = SCENES[slug](**values)
    found = {table.name: [name.split(" [")[0] for name in table.head] for table in tables(SCENES[slug], scene.shown)}
    for part in text.split(", "):
        name, _, columns = part.partition(": ")
        assert found[name][: len(columns.split())] == columns.split()


STARTS_OF_TWO = ("x1_0", "x2_0", "v1_0", "v2_0")
LINEAR = {
    "oscillator": (("x_0", "v_0"), {"x": 1, "v": 1, "a": 1}),
    "energy": (("x_0", "v_0"), {"x": 1, "T": 2}),
    "damped": (("x_0", "v_0"), {"x": 1, "E": 2, "T": 2, "V": 2, "P": 2}),
    "driven": (("x_0", "v_0", "F_0", "Y", "moment"), {"x": 1, "x_p": 1, "x_c": 1}),
    "coupled": (STARTS_OF_TWO, {"x1": 1, "x2_fast": 1, "T1": 2, "V2": 2}),
    "forced": ((*STARTS_OF_TWO, "F_0"), {"x1": 1, "x2": 1, "x2_p": 1}),
    "absorber": ((*STARTS_OF_TWO, "F_0"), {"x1": 1}),
}
"""Initial conditions and drives of a scene; and the power of all of them together that a motion is proportional to."""


@pytest.mark.parametrize("slug", LINEAR)
def test_in_one_frame_twice_the_motion_is_drawn_twice_as_large(slug: str) -> None:
    @settings(max_examples=tries(40))
    @given(links(SCENES[slug], 2.0))
    def holds(link: Link) -> None:
        now = state_of(link)
        scaled, powers = LINEAR[slug]
        twice = {name: 2 * now.scene.values[name] for name in scaled if name in now.scene.values}
        try:
            after = with_values(now, twice, holding=True)
        except ValueError:
            assume(False)
        assume(powers_of_ten(now) == powers_of_ten(after))  # a signal is in the unit of its axis, which may become kW
        for name, power in powers.items():
            one, two = drawn_heights(now, name), drawn_heights(after, name)
            if one.size and one.size == two.size:
                np.testing.assert_allclose(two, 2**power * one, rtol=1e-9, atol=1e-9 * np.abs(two).max())

    holds()


def powers_of_ten(now: PageState) -> dict[str, int]:
    """The power of ten in the unit of each axis."""
    return {name: axis.exponent for name, axis in now.shown.axes.items()}


def drawn_heights(now: PageState, name: str) -> np.ndarray:
    """A motion at seven instants of the window, as the browser draws it over time; empty if it is not."""
    shown = now.shown
    for trace in shown.traces.values():
        if name in trace.names:
            signal = dict(trace.signals).get(name, name)
            end = shown.axes["t"].place(trace.end)
            return np.array([instant(shown.signals, shown.scalars, end * i / 7)[signal] for i in range(7)])
    return np.array([])


@scenes
def test_a_text_of_a_number_is_that_number(slug: str) -> None:
    """The numbers are compared with another route in test_numbers; here they are read as the visitor reads them."""

    @settings(max_examples=tries(60))
    @given(values(SCENES[slug]))
    def holds(given: dict[str, Any]) -> None:
        try:
            scene = SCENES[slug](**given)
        except ValueError:
            assume(False)
        # Solve leaves the dashpots out, and has its frequencies under the names of those with dashpots.
        told = {} if scene.values["view"] == "solve" else scene.shown.values
        for name, number in scene.numbers.items():
            if number.unit in AS_SHOWN:
                check_text(told.get(name, ""), number.value)

    holds()


AS_SHOWN = ("", "rad/s", "1/s", "rad")
"""Units in which texts show a number unscaled; other units follow an axis."""


def check_text(text: str, exact: float) -> None:
    """A shown number differs from the exact one by at most half of its third digit or of its last place."""
    plain = text.replace("\N{MINUS SIGN}", "-").replace(" ", "")
    if re.fullmatch(r"[-+]?\d+(\.\d+)?", plain):
        places = [-len(plain.partition(".")[2]), *([math.floor(math.log10(abs(exact))) - 2] if exact else [])]
        assert abs(float(plain) - exact) <= 0.5001 * 10.0 ** max(places), (text, exact)
