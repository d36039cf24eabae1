"""Live numbers that give an answer away: `make walk` finds them in formulas, labels and earlier steps."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.scenes import SCENES
from components.state.scene_sheet import plots
from components.walks.checking import shortcomings
from components.walks.giveaways import giveaways
from components.walks.links import page_state_at
from components.walks.loading import load_walks, read_walk
from components.walks.questions.point import PointStep
from components.walks.questions.sketch import SketchStep
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
    return list(giveaways(read_walk('title = "Mine"' + "".join(steps), "mine"), SCENES))


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
    stated = step("?scene=oscillator", '["value:tau"]', question="ωₙ is 6.28 rad/s. How long is one swing?")
    assert not any("omega”" in one for one in walk(stated))


def test_an_earlier_step_of_the_same_chain_gives_it_away_too() -> None:
    early = step("?scene=oscillator&m=2", '["value:tau", "value:omega"]')
    other = early.replace('id = "one"', 'id = "zero"').replace('"value:omega"', '"value:C"')
    late = step("?scene=oscillator&m=2", '["value:tau", "value:omega"]', id="two")
    assert any("the answer of zero" in one for one in walk(other, late))
    assert walk(other.replace("m=2", "m=3").replace('"value:C"', '"value:omega"'), late) == []


@pytest.mark.parametrize("name", load_walks(()))
def test_no_step_of_the_lecture_gives_its_answer_away(name: str) -> None:
    assert list(giveaways(load_walks(())[name], SCENES)) == []


@pytest.mark.parametrize("name", load_walks(()))
def test_no_step_draws_the_curve_that_a_later_one_asks_for(name: str) -> None:
    """Curves over time are left out: each step has its own motion."""
    steps = load_walks(())[name].steps
    scenes = [page_state_at(step.state, SCENES).kind for step in steps]
    for place, (step, scene) in enumerate(zip(steps, scenes, strict=True)):
        plot = (
            step.plot
            if isinstance(step, SketchStep)
            else step.axis.split(".")[0]
            if isinstance(step, PointStep)
            else ""
        )
        timed = {one.name for one in plots(scene) if one.time}
        earlier = (one for one, other in zip(steps[:place], scenes, strict=False) if other is scene)
        shown = [one.id for one in earlier if f"plot:{plot}" in set(one.show) - set(one.still)]
        assert plot in timed or not shown, f"{step.id} asks for the plot {plot} of {shown}"


def test_make_walk_says_so() -> None:
    mine = read_walk('title = "Mine"' + step("?scene=oscillator&k=30", '["value:tau"]'), "mine")
    assert any("“omega” is visible" in one for one in shortcomings(mine, SCENES))
