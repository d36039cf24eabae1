"""Different numbers for each student: a step with `vary` has one variant per seed, each with its right answer."""

from __future__ import annotations

import pytest
from msgspec import to_builtins

from app import visited
from components.language.messages import Given
from components.live_class.question_bank import QuestionBank
from components.quantities.formatting import three
from components.scenes import SCENES
from components.walks.cards import walk_sheet
from components.walks.judging import reply_to
from components.walks.loading import load_walks, read_walk
from components.walks.questions.number import NumericStep
from components.walks.subject import Subject
from components.walks.variants import STRIDES, VARIANTS, numbers_drawn, varied
from components.walks.walk import Walk
from physics.oscillator import Oscillator
from tests.page.headless_page import unpacked
from tests.walks.written import SWING

WALKS = load_walks(())


def mine(old: str = "", new: str = "") -> Walk:
    assert old in SWING
    return read_walk(SWING.replace(old, new), "mine")


def test_every_seed_has_its_numbers_question_and_answer() -> None:
    (card,) = walk_sheet(mine(), SCENES).steps
    (step,) = mine().steps
    assert "variants" in to_builtins(card) and len(card.variants) == VARIANTS
    assert card.opens.parameters == {"view": "motion", "x_0": 0.1} and card.opens.step == "mine/swing"
    for seed, one in enumerate(card.variants, 1):
        k = one.opens.parameters["k"]
        assert isinstance(k, float) and 20 <= k <= 80
        assert one.opens.step == one.reveals.step == f"mine/swing/{seed}" and not one.variants
        assert one.reveals.parameters == {"view": "motion", "x_0": 0.1, "m": 4.0, "k": k}, (
            "what the answer changes stands as it is"
        )
        assert f"takes {three(Oscillator(m=1, k=k).period)}\xa0s at {k:g}\xa0N/m." in one.given + one.question
        true = Oscillator(m=4, k=k).period
        for text, right in ((f"{true:.3f} s", True), (f"{2 * true:.3f}", False)):
            lesson = reply_to(Given(walk="mine", step="swing", seed=seed, text=text), step, SCENES).lesson
            assert lesson and lesson.right is right and lesson.places == pytest.approx([true])
            assert right or lesson.reply == "No."
    assert len({one.given for one in card.variants}) == VARIANTS


def test_a_link_has_the_seed_and_a_class_the_numbers_of_the_file() -> None:
    now = visited({"walk": [b"d31"], "step": [b"2"], "seed": [b"5"]}, WALKS).now
    assert now.state.step == "d31/d31-02/5" and now.query == "walk=d31&step=d31-02&seed=5"
    assert now.scene.values["k"] == numbers_drawn(WALKS["d31"].steps[1], 5)["k"] != 39.4
    assert visited({"walk": [b"d31"], "step": [b"2"]}, WALKS).now.scene.values["k"] == 39.4
    card = QuestionBank(WALKS, SCENES).put("d31", "d31-02", 1).card
    assert card and not card.variants and "k" not in card.opens.parameters and "1.00\xa0s" in card.given


def test_numbers_are_round_and_fill_the_range() -> None:
    (step,) = mine("k = [20, 80]", "m = [0.5, 2], k = [20, 80], x_0 = [-0.3, 0.1], v_0 = [1, 1e300]").steps
    drawn = [numbers_drawn(step, seed) for seed in range(1, VARIANTS + 1)]
    assert len(STRIDES) == 4 and [drawn[-1][name] for name in step.vary] == [0.5, 20, -0.3, 1]
    for name, (low, high) in step.vary.items():
        values = [one[name] for one in drawn]
        assert min(values) == low and max(values) == high and all(low <= value <= high for value in values)
    assert all(round(one["m"], 2) == one["m"] and one["k"] == round(one["k"]) for one in drawn)
    assert len({(one["m"], one["k"]) for one in drawn}) == VARIANTS


@pytest.mark.parametrize("step", [s for walk in WALKS.values() for s in walk.steps if s.vary], ids=lambda s: s.id)
def test_the_lecture_asks_for_another_number_of_each(step: NumericStep) -> None:
    right = {step.right(Subject("", varied(step, seed), SCENES)) for seed in range(1, VARIANTS + 1)}
    assert len(right) > VARIANTS / 3


@pytest.mark.parametrize(
    ("step", "seed", "says"),
    [
        ("d31-02", "38", "seed: 38 is none; they go from 1 to 37."),
        ("d31-02", "-1", "seed: “-1” is no seed of a step's numbers."),
        ("d31-01", "5", "seed: this step has the same numbers for all."),
    ],
)
def test_a_seed_that_is_none_is_refused(step: str, seed: str, says: str) -> None:
    session = visited({"walk": [b"d31"], "step": [step.encode()], "seed": [seed.encode()]}, WALKS)
    assert session.now.state.step == "" and says in str(unpacked(session.opening())["problems"])
    if seed.isdigit():
        (found,) = (one for one in WALKS["d31"].steps if one.id == step)
        told = reply_to(Given(walk="d31", step=step, seed=int(seed)), found, SCENES)
        assert (told.lesson, told.refused) == (None, says)
