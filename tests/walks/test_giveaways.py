"""Live numbers that give an answer away: `make walk` finds them in formulas, labels and earlier steps."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from components.scenes import SCENES
from components.walks.checking import shortcomings
from components.walks.giveaways import giveaways
from components.walks.loading import read_walk
from tests.grids import tries

STEP = """
[[step]]
id = "{id}"
kind = "number"
title = "A period"
state = "{state}"
cover = {cover}
question = "{question}"
explain = "It is so."
answer = {{ of = "{of}", unit = "{unit}", tol = 0.01 }}
"""
QUESTION = "How long is one swing?"


def walk(*steps: str) -> list[str]:
    mine = read_walk('title = "Mine"' + "".join(steps), "mine")
    found = list(giveaways(mine, SCENES))
    assert set(found) <= set(shortcomings(mine, SCENES)), "make walk says so"
    return found


def step(state: str, cover: str, of: str = "tau", unit: str = "s", question: str = QUESTION, id: str = "one") -> str:
    return STEP.format(id=id, state=state, cover=cover, question=question, of=of, unit=unit)


@settings(max_examples=tries(80), deadline=None)
@given(st.floats(0.3, 9.0), st.floats(3.0, 90.0))
def test_a_period_is_given_away_by_the_frequency_in_a_formula(m: float, k: float) -> None:
    """The formula x = C sin(6.25 t) is shown in the view Formulas, but not in the view Motion."""
    state = f"?scene=oscillator&m={m:.3g}&k={k:.3g}"
    found = walk(step(state, '["value:tau"]'))
    assert any("omega” is visible" in one and "2π over it is the answer" in one for one in found), found
    covered = walk(step(state, '["value:tau", "value:omega"]'))
    assert not any("omega”" in one or "tau”" in one for one in covered)


def test_a_number_that_is_shown_under_another_name_is_found() -> None:
    """Numbers that the question states, or that the scene is set to, give nothing away."""
    shown = step("?scene=energy&view=motion", '["value:delta"]', "delta_st", "m", "How far does it hang down?")
    assert any("0.249" in one and "it is the answer" in one for one in walk(shown))
    assert walk(step("?scene=energy&view=motion&x_0=0.1", '["value:delta"]', "x_0", "m", "Where does it start?")) == []
    mass_ratio = step("?scene=absorber", '["value:now_X1"]', "m2/m1", "", "How heavy is mass 2 against mass 1?")
    assert any("0.160" in one for one in walk(mass_ratio)), "the controls show it"
    stated = step("?scene=oscillator", '["value:tau"]', question="ωₙ is 6.28 rad/s. How long is one swing?")
    assert not any("omega”" in one for one in walk(stated))


def test_an_earlier_step_of_the_same_chain_gives_it_away_too() -> None:
    early = step("?scene=oscillator&m=2", '["value:tau", "value:omega"]')
    other = early.replace('id = "one"', 'id = "zero"').replace('"value:omega"', '"value:C"')
    late = step("?scene=oscillator&m=2", '["value:tau", "value:omega"]', id="two")
    assert any("the answer of zero" in one for one in walk(other, late))
    assert walk(other.replace("m=2", "m=3").replace('"value:C"', '"value:omega"'), late) == []
