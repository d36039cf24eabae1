"""The file of a walk: a valid one is read; what is wrong, doubtful or gives an answer away is named with its place."""

import math
import re
from pathlib import Path

import pytest
from msgspec import to_builtins

from app import visited
from components.language.messages import Given
from components.live_class.question_bank import QuestionBank
from components.quantities.formatting import three
from components.scenes import SCENES
from components.walks.cards import parted, walk_sheet
from components.walks.checking import problems, shortcomings
from components.walks.giveaways import giveaways
from components.walks.judging import reply_to
from components.walks.loading import LARGEST, WalkError, load_walks, read_walk, steps_of
from components.walks.questions.number import NumberStep, NumericStep
from components.walks.registry import all_walks, asked_step
from components.walks.subject import Subject
from components.walks.variants import STRIDES, VARIANTS, numbers_drawn, varied
from components.walks.walk import Walk
from physics.oscillator import Oscillator
from tests.page.headless_page import unpacked
from tools.walk import main

OWN = load_walks(())
KNOWN = steps_of(OWN.values())
GOOD = """
title = "A walk of one's own"

[[step]]
id = "first"
kind = "choice"
title = "Stiffer is faster"
state = "?scene=coupled&k2=3"
question = "One spring gets stiffer. Do both frequencies rise?"
cover = ["value:omega_minus"]
controls = ["k2"]
explain = "Both do: {omega_minus} rad/s. And $\\\\omega_-^2 = \\\\val{omega_minus}$."
options = [{ text = "Both", right = true }, { text = "One", reply = "It is right for a **single** mass." }]
"""
ENERGY = """title = "t"
[[step]]
id = "first"
kind = "number"
title = "t"
question = "How long?"
explain = "e"
state = "?scene=energy"
cover = ["value:tau", "value:omega"]
answer = { of = "tau", unit = "s", tol = 0.1 }
misses = [{ is = "2 * tau", idea = "i", reply = "r" }]
"""
TYPED = ENERGY.partition("cover")[0] + 'answer = { is = ["1/4", 2.5, "2000 ms"], unit = "s", tol = "0,1" }\n'
TRIAL = '[[trial]]\nscene = "modes"\ntitle = "Find them"\ntext = "Drag the *ring*."\n\n'
MARK = '[[step]]\nid = "first"\nfrom = "d34-08"\n'
SKETCH = '[[step]]\nid = "first"\nfrom = "d31-09"\nwrong = []\n'
WRONG = 'wrong = [{ draws = "d", has = [], fails = ["period"], idea = "i", reply = "r" }]'
FEATURE = 'must = [{ f = "value", on = "V", at = 0.0, is = "OF", tol = 0.1 }]\nwrong'
PLACE = f'{MARK}reveal = "?scene=modes&view=hunt&m1=1&m2=1&k1=1&k2=1&x1_0=1&x2_0=1.618"\nexplain = "e"'
POLL = """[[step]]
id = "first"
poll = true
question = "How fast is this?"
options = [{ text = "Too fast" }, { text = "Right" }, { text = "Too slow" }]
"""
SWING = """
title = "Mine"
[[step]]
id = "swing"
kind = "number"
title = "More mass, more time"
state = "?scene=oscillator&view=motion&x_0=0.1"
reveal = "?scene=oscillator&view=motion&x_0=0.1&m=4"
vary = { k = [20, 80] }
cover = ["value:tau"]
question = "One swing takes {tau} s at {k} N/m. How long with 4 kg?"
explain = "It takes {tau} s."
answer = { of = "tau", unit = "s", tol = 0.05 }
misses = [{ is = "2 * tau", idea = "-", reply = "No." }]
"""
POLLS = f'[[step]]\nid = "one"\nfrom = "d34-04"\n{POLL}[[step]]\nid = "two"\nfrom = "d34-07"\n'
TITLE = 'title = "t"\n'
STEP = "[[step]]"
LISTED = GOOD.replace('k2=3"', 'view=energy&energy=modes"\nshow = ["plot:mode_energy"]')
META = r"\\text{<meta http-equiv=refresh content='0;//a.example'>}"
OF_TAU = 'of = "tau"'
MANY = str(["one"] * 6)
RING = '[{ f = "least", on = "V", is = 0.0, tol = 0.1 }]'


def read(text: str) -> Walk:
    return read_walk(text if "title" in text.partition(STEP)[0] else TITLE + text, "mine", KNOWN)


def told(text: str) -> list[str]:
    """The complaints about a file, or if there are none the doubts."""
    try:
        walk = read(text)
    except WalkError as error:
        return [str(error)]
    return [*problems(walk, SCENES)] or [*shortcomings(walk, SCENES)]


COMPLAINTS: list[tuple[str, str, str, str]] = [
    (GOOD, 'id = "first"', "id = 3", "mine, step 1, id: expected `str`, got `int`."),
    (GOOD, 'kind = "choice"', 'kind = "guess"', "mine, step 1 (first), kind: invalid value 'guess'."),
    (GOOD, 'explain = "Both', 'explian = "Both', "mine, step 1 (first), its fields: object"),
    (GOOD, '"k2"]', '"a", "b", "c", "k2"]', "controls: expected `array` of length <= 3."),
    (GOOD, "[[step]]", "[[stepp]]", "mine: “stepp” is no field of a walk; title, end, trial and step are."),
    (GOOD, 'title = "A walk of one\'s own"', "# title", "mine: the title is missing"),
    (GOOD, 'id = "first"', 'from = "d31-99"', "mine, step 1, from: “d31-99” is no step that is known."),
    (GOOD, '"first"', '"First!"', "id: small letters, digits and hyphens, as first-step."),
    (GOOD, STEP, GOOD[GOOD.index(STEP) :] + STEP, "mine, step 2: the id “first” was given"),
    (GOOD, STEP, "#" * LARGEST + "\n" + STEP, f"at most {LARGEST} are allowed"),
    (GOOD, "k2=3", "k2=-3", "state: k2: "),
    (GOOD, "scene=coupled", "scene=moon", "state: scene: “moon” is not a scene"),
    (GOOD, "?scene=coupled&", "?", "state: a link names its scene"),
    (GOOD, "value:omega_minus", "plot:x9", "cover: “plot:x9” is not possible: choose from band:"),
    (GOOD, 'controls = ["k2"]', 'controls = ["k9"]', "controls: “k9” is not possible: choose from "),
    (GOOD, "k2=3", "k2=3&cover=plot:x2", "state: cover: list hidden parts in the field cover"),
    (GOOD, "k2=3", "k2=3&before.k2=2", "state: before: a step cannot begin with an open prediction."),
    (GOOD, "{omega_minus}", "{omega_9}", "explain: “omega_9” is not possible: choose from "),
    (GOOD, "right = true", "right = false", "options: exactly one must be right."),
    (GOOD, "options = [", "poll = true\noptions = [", "options: none is right in a poll."),
    (GOOD, ', reply = "It is right for a **single** mass."', "", "options[1].reply: a wrong answer needs a reply"),
    (GOOD, "rise?", "rise, $\\\\left($?", "question: “\\left(” cannot be set as a formula."),
    (GOOD, "Stiffer is", "{tau} is", "title: live numbers are allowed in explain only."),
    (GOOD, 'explain = "B', 'derive = true\nexplain = "B', "derive: there are no formulas in follows to show."),
    (LISTED, '["k2"]', '["k2", "energy"]', "controls: with “energy” at parts, plot:mode_energy of show is not shown"),
    (GOOD, STEP, TRIAL.replace("modes", "mode") + STEP, "mine, trial: “mode” is not a"),
    (GOOD, STEP, TRIAL * 4 + STEP, "at most 3 scenes to try"),
    *((ENERGY, TITLE, f"{TITLE}end = {end}\n", "mine: end has at most 5 sentences") for end in ('"a"', MANY)),
    (ENERGY, TITLE, f'{TITLE}end = ["So $\\\\left($."]\n', "mine, end[0]: “\\left(” cannot be set as a formula."),
    (TYPED, "1/4", "1 kg", "answer: “1 kg” is in kg"),
    (ENERGY, f'{OF_TAU}, unit = "s", tol = 0.1', "tol = 1", "neither of nor is"),
    (ENERGY, OF_TAU, 'of = "period"', "answer.of: “period” has a name that the scene does not have, period; it has: "),
    (ENERGY, OF_TAU, 'of = "tau / (m - m)"', "answer.of: “tau / (m - m)” has no value here."),
    (ENERGY, OF_TAU, 'of = "9^9^9"', "answer.of: “9^9^9” has no value here."),
    (ENERGY, OF_TAU, 'of = "tau", is = 7.5', "answer.is: 7.5 is not what the scene has, 1.00 s."),
    (ENERGY, OF_TAU, "is = 7.5", "answer: 7.5 is no number of this scene: name the quantity that it is, of = ..."),
    (ENERGY, "2 * tau", "tau + 0.01", "misses[0].is: 1.01099 is within the tolerance of the right answer."),
    (ENERGY, '["value:tau", "value:omega"]', "[]", "cover: nothing is hidden, so students can read the answer."),
    (ENERGY, '"e"', f'"{"word " * 61}"', "explain: it has 61 words, at most 60 are allowed."),
    (ENERGY, '"e"', '"*τ* = 2.5 s"', "explain: “τ = 2.5” is not what is shown with the answer, 1.00: see"),
    (ENERGY, "answer", f'follows = "{"x" * 2001}"\nanswer', "follows: "),
    (ENERGY, "How long?", "Tell.", "question: no sentence ends with a question mark, or begins with Sketch or Mark."),
    (ENERGY, "answer", 'still = ["value:m"]\nanswer', "still: “value:m” is not in cover."),
    (ENERGY, "answer", 'still = ["value:tau", "value:omega"]\nanswer', "still: the answer shows nothing that"),
    (PLACE, "1.618", "0.5", "reveal: there x2_0 is 0.5; the answer is 1.62 m or −0.618 m."),
    (MARK, "d34-08", 'd34-08"\nsets = "x9_0', "sets: “x9_0” is not a parameter."),
    (SKETCH, "wrong = []", WRONG.replace("[]", RING.replace("V", "W")), "wrong[0].has: “W” is not drawn."),
    (SKETCH, "wrong", FEATURE.replace("OF", "2 * E_total"), "must[0]: the scene's own curve does not have"),
    (SKETCH, "wrong", FEATURE.replace("OF", "E_totl"), "does not have, E_totl; it has"),
    (SWING, "{ k =", "{ kk =", "vary: “kk” is no quantity of this scene."),
    (SWING, "[20, 80]", "[80, 20]", "vary: k goes from 80 to 20: give two numbers, the smaller one first."),
    (SWING, "[20, 80]", "[nan, 80]", "vary: k goes from nan to 80: give two numbers"),
    (SWING, "[20, 80]", "[-20, 80]", "vary: with k = -18: state: k: "),
    (SWING, "{ k = [20, 80]", "{ x_0 = [0, 1], k = [0, 80]", "vary: with x_0 = 0, k = 0: "),
    (SWING, "2 * tau", "63.5 / k", "vary: with k = 25: misses[0].is: 2.54 is within the tolerance of the right"),
    (SWING, "{tau} s at", "{taw} s at", "question: “taw” has a name that the scene does not have, taw; it has"),
    (SWING, "reply", 'reply = "No." }, { is = "200 / k", idea = "-", reply', "vary: with k = 6"),
    *((text, "", "", "") for text in (ENERGY, SKETCH, PLACE, SWING, POLLS, LISTED)),
    (ENERGY, '"e"', '"*τ* = 1.00 s, *x*_0 = 0.2 m"', ""),
    *((ENERGY, '"e"', f'"{text}"', "") for text in (f"A *$* sign, {META}$ and $.", "$\\\\hspace{-900em} x$")),
    (ENERGY, '"e"', '"$\\\\href{https://a.example}{x}$"', "explain: “\\href{https://a.example}{x}”: “href” is"),
    (ENERGY, "How long?", f"Given $a. Is {META}$ so?", "question: “a. Is \\text{<meta http-equiv=refresh co…”: “<math"),
    (ENERGY, "answer", f'follows = "b = d \\\\quad {META}"\nanswer', "follows, line 1: “\\text{<meta http-equiv="),
    *((SKETCH, "wrong = []", wrong, "") for wrong in (WRONG, WRONG.replace("[]", RING))),
    (SKETCH, "wrong", FEATURE.replace("OF", "E_total"), ""),
    (GOOD, STEP, TRIAL + STEP, ""),
    (POLL, "poll =", 'state = "?scene=coupled"\npoll =', ""),
    *((text, "", "", says) for text, says in (
        ("[[step]]\nfrom = []", "mine, step 1, from: “[]” is no step"),
        ('[["a". b . c.d.e.f.g.h.i]]', "is no field of a walk: its name has too many dots"),
        ("title = '\ud800'\n", "mine: a walk has 1 to 60 steps"),
    )),
]  # fmt: skip
"""A file, a change of it, and what is said about it: "" for nothing."""


@pytest.mark.parametrize(("text", "old", "new", "says"), COMPLAINTS)
def test_a_complaint_names_file_step_and_field(text: str, old: str, new: str, says: str) -> None:
    assert old in text
    found = told(text.replace(old, new, 1))
    assert any(says in one and one.startswith("mine") for one in found) if says else found == [], found


def test_what_a_file_says_is_read() -> None:
    (again,) = read('[[step]]\nid = "again"\nfrom = "d31-03"\nquestion = "How long?"').steps
    assert (again.id, again.question, again.title) == ("again", "How long?", "Twice as far takes just as long")
    (step,) = read(TYPED).steps
    assert isinstance(step, NumberStep) and (step.answer.numbers, step.answer.tolerance) == ((0.25, 2.5, 2.0), 0.1)
    assert read(ENERGY.replace(TITLE, f'{TITLE}end = ["So it is."]\n', 1)).end == ("So it is.",)
    assert walk_sheet(read(GOOD.replace(STEP, TRIAL + STEP)), SCENES).trials[0].scene == "modes"
    (step,) = read(ENERGY.replace('unit = "s", tol = 0.1', 'unit = "ms", tol = 1')).steps
    assert isinstance(step, NumberStep)
    assert step.right(Subject("mine", step, SCENES)) == pytest.approx([1000 * 2 * math.pi / math.sqrt(39.4)])
    before, poll, _ = read(POLLS).steps
    assert (poll.state, poll.cover, poll.show) == (before.shown, before.still, before.show)
    assert not poll.judges and poll.title == poll.question


def test_all_problems_are_reported_at_once_in_the_order_of_the_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = GOOD.replace('["k2"]', '["k9", "🙂"]').replace("{omega_minus} rad", "{omega_9} rad")
    other = GOOD[GOOD.index(STEP) :].replace('"choice"', '"dance"').replace('"first"', '"second"')
    path = tmp_path / "mine.toml"
    path.write_text(wrong + other, encoding="utf-8")
    assert main([str(path)]) == 1
    *found, last = capsys.readouterr().out.splitlines()
    places = ["mine, step 1 (first), controls", "mine, step 1 (first), explain", "mine, step 2 (second), kind"]
    assert [one.partition(": ")[0] for one in found] == places and last == "mine: 3 to mend."


def test_a_folder_brings_walks_and_is_checked(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(GOOD, encoding="utf-8-sig")  # as Notepad may save it
    assert list(all_walks([tmp_path], SCENES)) == [*OWN, "mine"]
    path.write_text(GOOD.replace("k2=3", "k2=-3"), encoding="utf-8")
    for folder, says in ((tmp_path, r"mine, step 1 \(first\), state"), (tmp_path / "no", "no folder of walks")):
        with pytest.raises(WalkError, match=says):
            all_walks([folder], SCENES)
    for name, says in (("d31", "there is a walk “d31” already"), ("Mine", "small letters")):
        path = path.rename(tmp_path / f"{name}.toml")
        with pytest.raises(WalkError, match=says):
            all_walks([tmp_path], SCENES)


def test_a_link_names_a_step_by_id_or_number() -> None:
    assert asked_step({"scene": [b"coupled"]}, OWN) is None
    found = [asked_step({"walk": [b"d34"], **more}, OWN) for more in ({}, {"step": [b"7"]})]
    assert [one and one.step.id for one in found] == ["d34-01", "d34-07"]
    for walk, says in ((b"d99", "walk: “d99” is not a walk"), (b"d34", "no step “99”; it has ")):
        with pytest.raises(ValueError, match=says):
            asked_step({"walk": [walk], "step": [b"99"]}, OWN)


def test_what_is_asked_is_told_from_what_is_given() -> None:
    assert parted("It is 4 N/m. Both rest. Force on mass 1?") == ("It is 4 N/m. Both rest.", "Force on mass 1?")
    assert parted("Look. Sketch it. It reaches 1 m.") == ("Look.", "Sketch it. It reaches 1 m.")
    assert parted("No question at all.") == ("", "No question at all.")
    assert parted("Given: $a. Is b$ so. Is it?") == ("Given: $a. Is b$ so.", "Is it?")


def test_the_walks_in_the_docs_are_right() -> None:
    """The examples of docs/writing-a-walk.md, unchanged: the first is a walk of three steps."""
    docs = (Path(__file__).parents[2] / "docs" / "writing-a-walk.md").read_text(encoding="utf-8")
    examples = [one.partition("```")[0] for one in docs.split("```toml\n")[1:] if one.startswith("title")]
    first, *others = (read_walk(one, "docs") for one in examples)
    assert [*shortcomings(first, SCENES), *(one for walk in (first, *others) for one in problems(walk, SCENES))] == []
    assert [step.kind for step in first.steps] == ["number", "choice", "choice"]


def test_a_walk_has_so_many_links() -> None:
    steps = [f'[[step]]\nid = "s{i}"\nfrom = "d31-03"\nstate = "?scene=energy&m={1 + i}"\n' for i in range(31)]
    linked = [f'{step}reveal = "?scene=energy&k={1 + i}"\n' for i, step in enumerate(steps)]
    read("".join(linked[:30]))
    with pytest.raises(WalkError, match="mine: a walk has at most 60 different links"):
        read("".join(linked))


# Numbers that differ for each student


def test_every_seed_has_its_numbers_question_and_answer() -> None:
    (card,) = walk_sheet(read(SWING), SCENES).steps
    (step,) = read(SWING).steps
    assert "variants" in to_builtins(card) and len(card.variants) == VARIANTS
    assert card.opens.parameters == {"view": "motion", "x_0": 0.1} and card.opens.step == "mine/swing"
    for seed, one in enumerate(card.variants, 1):
        k = one.opens.parameters["k"]
        assert isinstance(k, float) and 20 <= k <= 80
        assert one.opens.step == one.reveals.step == f"mine/swing/{seed}" and not one.variants
        assert one.reveals.parameters == {"view": "motion", "x_0": 0.1, "m": 4.0, "k": k}, "the answer sets m alone"
        assert f"takes {three(Oscillator(m=1, k=k).period)}\xa0s at {k:g}\xa0N/m." in one.given + one.question
        true = Oscillator(m=4, k=k).period
        for text, right in ((f"{true:.3f} s", True), (f"{2 * true:.3f}", False)):
            lesson = reply_to(Given(walk="mine", step="swing", seed=seed, text=text), step, SCENES).lesson
            assert lesson and lesson.right is right and lesson.places == pytest.approx([true])
            assert right or lesson.reply == "No."
    assert len({one.given for one in card.variants}) == VARIANTS


def test_a_link_has_the_seed_and_a_class_the_numbers_of_the_file() -> None:
    now = visited({"walk": [b"d31"], "step": [b"2"], "seed": [b"5"]}, OWN).now
    assert now.state.step == "d31/d31-02/5" and now.query == "walk=d31&step=d31-02&seed=5"
    assert now.scene.values["k"] == numbers_drawn(OWN["d31"].steps[1], 5)["k"] != 39.4
    assert visited({"walk": [b"d31"], "step": [b"2"]}, OWN).now.scene.values["k"] == 39.4
    card = QuestionBank(OWN, SCENES).put("d31", "d31-02", 1).card
    assert card and not card.variants and "k" not in card.opens.parameters and "1.00\xa0s" in card.given


def test_numbers_are_round_and_fill_the_range() -> None:
    (step,) = read(SWING.replace("{ k =", "{ m = [0.5, 2], x_0 = [-0.3, 0.1], v_0 = [1, 1e300], k =")).steps
    drawn = [numbers_drawn(step, seed) for seed in range(1, VARIANTS + 1)]
    assert len(STRIDES) == 4 and [drawn[-1][name] for name in step.vary] == [0.5, -0.3, 1, 20]
    for name, (low, high) in step.vary.items():
        values = [one[name] for one in drawn]
        assert min(values) == low and max(values) == high and all(low <= value <= high for value in values)
    assert all(round(one["m"], 2) == one["m"] and one["k"] == round(one["k"]) for one in drawn)
    assert len({(one["m"], one["k"]) for one in drawn}) == VARIANTS


@pytest.mark.parametrize("step", [s for walk in OWN.values() for s in walk.steps if s.vary], ids=lambda s: s.id)
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
    session = visited({"walk": [b"d31"], "step": [step.encode()], "seed": [seed.encode()]}, OWN)
    assert session.now.state.step == "" and says in str(unpacked(session.opening())["problems"])
    if seed.isdigit():
        (found,) = (one for one in OWN["d31"].steps if one.id == step)
        told = reply_to(Given(walk="d31", step=step, seed=int(seed)), found, SCENES)
        assert (told.lesson, told.refused) == (None, says)


# Numbers that give an answer away

BOTH = '["value:tau", "value:omega"]'
DELTA = '["value:delta"]'
EARLY = '["value:tau", "value:C"]'


def period(
    state: str, cover: str = '["value:tau"]', of: str = "tau", unit: str = "s", question: str = "How long is it?",
    id: str = "one",
) -> str:  # fmt: skip
    head = f'[[step]]\nid = "{id}"\nkind = "number"\ntitle = "t"\nquestion = "{question}"\nexplain = "e"\n'
    answer = f'answer = {{ of = "{of}", unit = "{unit}", tol = 0.01 }}\n'
    return f'{head}state = "?scene={state}"\ncover = {cover}\n{answer}'


@pytest.mark.parametrize(
    ("steps", "says"),
    [
        # The formula x = C sin(6.25 t) is shown in the view Formulas.
        ([period("oscillator&m=2.5")], r"omega” is visible.*2π over it is the answer"),
        ([period("oscillator&m=2.5", BOTH)], ""),
        ([period("energy&view=motion", DELTA, "delta_st", "m", "How far does it hang?")], r"0\.249.*it is the answer"),
        # The controls show it.
        ([period("absorber", '["value:now_X1"]', "m2/m1", "", "How heavy is mass 2 against mass 1?")], r"0\.160"),
        # Numbers that the question states, or that the scene is set to, give nothing away.
        ([period("energy&view=motion&x_0=0.1", DELTA, "x_0", "m", "Where does it start?")], ""),
        ([period("oscillator&m=2.5", question="ωₙ is 3.97 rad/s. How long is one swing?")], ""),
        # An earlier step of the same chain gives it away, and one of another chain with the same period does not.
        ([period("oscillator&m=2", EARLY, id="zero"), period("oscillator&m=2", BOTH)], "the answer of zero"),
        ([period("oscillator&m=4&k=100", BOTH, id="zero"), period("oscillator&m=2&k=50", BOTH)], ""),
    ],
)
def test_a_number_that_gives_the_answer_away_is_named(steps: list[str], says: str) -> None:
    mine = read_walk(TITLE + "".join(steps), "mine")
    found = list(giveaways(mine, SCENES))
    assert set(found) <= set(shortcomings(mine, SCENES)), "make walk says so"
    assert any(re.search(says, one) for one in found) if says else found == []
