"""The file of a walk: valid files are read; errors name the file, step and field."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from msgspec import to_builtins
from msgspec.structs import replace

from app import visited
from components.language.state import Frame
from components.scenes import SCENES
from components.session.session import Session
from components.state.page_state import fitted
from components.walks.cards import parted, walk_sheet
from components.walks.checking import problems, shortcomings
from components.walks.links import page_state_at
from components.walks.loading import LARGEST, WalkError, load_walks, read_walk, steps_of
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumberStep
from components.walks.registry import all_walks, asked_step
from components.walks.subject import Subject
from components.walks.walk import Walk
from tools.walk import main

OWN = load_walks(())
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


def changed(old: str, new: str) -> Walk:
    assert old in GOOD
    return read_walk(GOOD.replace(old, new), "mine")


def found(old: str, new: str) -> list[str]:
    return list(problems(changed(old, new), SCENES))


def test_a_good_walk_is_read_and_has_no_problems() -> None:
    walk = read_walk(GOOD, "mine")
    assert isinstance(walk.steps[0], ChoiceStep) and not list(problems(walk, SCENES))
    (card,) = walk_sheet(walk, SCENES).steps
    assert card.opens.parameters == {"k2": 3.0} and card.opens.covered == ("value:omega_minus",)
    assert card.opens.step == card.reveals.step == "mine/first" and card.reveals.covered == ()
    assert card.given == "One spring gets stiffer." and "Both" in card.options[0]


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('id = "first"', "id = 3", "mine, step 1, id: expected `str`, got `int`."),
        ('kind = "choice"', 'kind = "guess"', "mine, step 1 (first), kind: invalid value 'guess'."),
        ('explain = "Both', 'explian = "Both', "mine, step 1 (first), its fields: object"),
        ("right = true", "right = 1", "mine, step 1 (first), options[0].right: expected `bool`, got `int`."),
        ('"k2"]', '"a", "b", "c", "k2"]', "mine, step 1 (first), controls: expected `array` of length <= 3."),
        ("[[step]]", "[[stepp]]", "mine: “stepp” is no field of a walk; title, end, trial and step are."),
        ('title = "A walk of one\'s own"', "", "mine: the title is missing"),
        ("id =", "id ==", "mine: this is not TOML: "),
        ('id = "first"', 'from = "d31-99"', "mine, step 1, from: “d31-99” is no step that is known."),
    ],
)
def test_a_complaint_names_file_step_and_field(old: str, new: str, says: str) -> None:
    with pytest.raises(WalkError, match="mine") as caught:
        changed(old, new)
    assert str(caught.value).startswith(says)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("k2=3", "k2=-3", "state: k2: "),
        ("scene=coupled", "scene=moon", "state: scene: “moon” is not a scene"),
        ("?scene=coupled&", "?", "state: a link names its scene"),
        ("value:omega_minus", "plot:x9", "cover: “plot:x9” is not possible: choose from band:"),
        ('controls = ["k2"]', 'controls = ["k9"]', "controls: “k9” is not possible: choose from "),
        ("k2=3", "k2=", "state: k2: Nothing is typed here"),
        ("k2=3", "k2=3&frame.fruit=1,2", "state: frame.fruit: “fruit” is not an axis of this picture."),
        ("k2=3", "k2=3&frame.x=1", "state: frame.x: “1” is not a range"),
        ("k2=3", "k2=3&hidden=x1,fruit", "state: hidden: “fruit” is no curve of this scene."),
        ("k2=3", "k2=3&held.fruit=1", "state: “fruit” is not a parameter of this scene."),
        ("k2=3", "k2=3&cover=plot:x2", "state: cover: list hidden parts in the field cover"),
        ("k2=3", "k2=3&before.k2=2", "state: before: a step cannot begin with an open prediction."),
        ("{omega_minus}", "{omega_9}", "explain: “omega_9” is not possible: choose from "),
        ("right = true", "right = false", "options: exactly one must be right."),
        ("options = [", "poll = true\noptions = [", "options: none is right in a poll."),
        (', reply = "It is right for a **single** mass."', "", "options[1].reply: a wrong answer needs a reply"),
        ("rise?", "rise, $\\\\left($?", "question: “\\left(” cannot be set as a formula."),
        ("Stiffer is", "{tau} is", "title: live numbers are allowed in explain only."),
        ('explain = "Both', 'derive = true\nexplain = "Both', "derive: there are no formulas in follows to show."),
    ],
)
def test_a_check_names_the_field(old: str, new: str, says: str) -> None:
    assert any(problem.startswith(f"mine, step 1 (first), {says}") for problem in found(old, new)), found(old, new)


def test_a_step_holds_all_that_its_link_says() -> None:
    """One function makes the state: for the card, the checker, and the page that is opened at the step."""
    link = "?scene=coupled&k2=3&frame.x=-4,4&frame.window=50&held.k2=20&hidden=x1_slow"
    walk = changed("?scene=coupled&k2=3", link)
    assert not list(problems(walk, SCENES))
    (card,) = walk_sheet(walk, SCENES).steps
    for state in (card.opens, card.reveals):
        assert (state.parameters, state.held, state.hidden) == ({"k2": 3.0}, {"k2": 20.0}, ("x1_slow",))
        assert state.frame == Frame(ranges={"x": (-4.0, 4.0)}, window=50.0, given=True)
    at_address = visited({"walk": [b"mine"], "step": [b"1"]}, {"mine": walk}).now.state
    session = Session(fitted(SCENES["oscillator"]().value), scenes=SCENES)
    session.handle({"type": "open", "number": 1, "state": to_builtins(card.opens)})
    assert at_address == session.now.state == replace(card.opens, frame=session.now.state.frame)
    assert session.now.state.frame and session.now.state.frame.ranges["x"] == (-4.0, 4.0)
    page = page_state_at(link, SCENES)
    assert page.drawn.frame == session.now.drawn.frame
    assert page.drawn.beside and page.scene.hidden == ["x1_slow"]


def test_a_step_may_be_based_on_a_known_one() -> None:
    (step,) = read_walk(
        'title = "t"\n[[step]]\nid = "again"\nfrom = "d31-03"\nquestion = "How long?"', "mine", steps_of(OWN.values())
    ).steps
    assert (step.id, step.question, step.title) == ("again", "How long?", "Twice as far takes just as long")


def test_an_answer_may_be_written_as_it_is_typed_into_a_field() -> None:
    text = (
        'title = "t"\n[[step]]\nid = "one"\nkind = "number"\ntitle = "t"\nquestion = "q"\nexplain = "e"\n'
        'state = "?scene=energy"\nanswer = { is = ["1/4", 2.5, "2000 ms"], unit = "s", tol = "0,1" }\n'
    )
    (step,) = read_walk(text, "mine").steps
    assert isinstance(step, NumberStep) and (step.answer.numbers, step.answer.tolerance) == ((0.25, 2.5, 2.0), 0.1)
    for old, new, says in (
        ("1/4", "", "answer: nothing is typed here"),
        ("1/4", "1 kg", "answer: “1 kg” is in kg"),
        ('tol = "0,1"', "tolerance = 1", "answer: object contains unknown field"),
    ):
        with pytest.raises(WalkError, match=says):
            read_walk(text.replace(old, new), "mine")


ENERGY = """title = "t"
[[step]]
id = "one"
kind = "number"
title = "t"
question = "How long?"
explain = "e"
state = "?scene=energy"
cover = ["value:tau", "value:omega"]
answer = { of = "tau", unit = "s", tol = 0.1 }
misses = [{ is = "2 * tau", idea = "i", reply = "r" }]
"""


def told(text: str) -> list[str]:
    """The sentences of `make walk` on a step, without its name."""
    walk = read_walk(text, "mine")
    found = [*problems(walk, SCENES)] or [*shortcomings(walk, SCENES)]
    return [one.removeprefix("mine, step 1 (one), ") for one in found]


def test_an_answer_is_a_quantity_of_the_scene() -> None:
    assert told(ENERGY) == []
    (step,) = read_walk(ENERGY.replace('unit = "s", tol = 0.1', 'unit = "ms", tol = 1'), "mine").steps
    assert isinstance(step, NumberStep)
    subject = Subject("mine", step, SCENES)
    assert step.right(subject) == pytest.approx([1000 * 2 * math.pi / math.sqrt(39.4)])
    assert step.wrong(subject) == pytest.approx([2 * step.right(subject)[0]])
    for old, new, says in (
        (
            'of = "tau"',
            'of = "period"',
            "answer.of: “period” has a name that the scene does not have, period; it has: ",
        ),
        ('of = "tau"', 'of = "tau."', "answer.of: “tau.” is not an expression of the scene's numbers."),
        ('of = "tau"', 'of = "tau / (m - m)"', "answer.of: “tau / (m - m)” has no value here."),
        ('of = "tau"', 'of = "9^9^9"', "answer.of: “9^9^9” has no value here."),
        ('of = "tau"', 'of = "tau", is = 7.5', "answer.is: 7.5 is not what the scene has, 1.00 s."),
        ('of = "tau"', "is = 7.5", "answer: 7.5 is no number of this scene: name the quantity that it is, of = ..."),
        ("2 * tau", "tau + 0.01", "misses[0].is: 1.01099 is within the tolerance of the right answer."),
        ('["value:tau", "value:omega"]', "[]", "cover: nothing is hidden, so students can read the answer."),
        ('explain = "e"', f'explain = "{"word " * 61}"', "explain: it has 61 words, at most 60 are allowed."),
        (
            'explain = "e"',
            'explain = "*τ* = 2.5 s"',
            "explain: “τ = 2.5” is not what is shown with the answer, 1.00: see",
        ),
        ("How long?", "Tell.", "question: no sentence ends with a question mark, or begins with Sketch or Mark."),
    ):
        assert [one for one in told(ENERGY.replace(old, new)) if one.startswith(says)], told(ENERGY.replace(old, new))


def test_a_claim_is_true_of_what_is_shown() -> None:
    """The number that the texts give to a quantity, and the place that the answer plays."""
    assert told(ENERGY.replace('explain = "e"', 'explain = "*τ* = 1.00 s, *x*_0 = 0.2 m"')) == []
    place = '\n[[step]]\nid = "one"\nfrom = "d34-08"\nreveal = "?scene=modes&view=hunt&m1=1&m2=1&k1=1&k2=1&x1_0=1&x2_0='
    for value, says in (("1.618", []), ("0.5", ["reveal: there x2_0 is 0.5; the answer is 1.62 m or −0.618 m."])):
        walk = read_walk(f'title = "t"{place}{value}"\nexplain = "e"', "mine", steps_of(OWN.values()))
        assert [one.partition("(one), ")[2] for one in shortcomings(walk, SCENES)] == says


@pytest.mark.parametrize(("given", "says"), [('of = "tau", tol = 0', "above 0"), ("tol = 1", "neither of nor is")])
def test_an_answer_has_a_number_and_a_tolerance(given: str, says: str) -> None:
    with pytest.raises(WalkError, match=says):
        read_walk(ENERGY.replace('of = "tau", unit = "s", tol = 0.1', given), "mine")


def test_a_walk_ends_in_a_few_sentences() -> None:
    assert read_walk(f'end = ["So it is."]\n{ENERGY}', "mine").end == ("So it is.",)
    for end in ('"one"', "[1]", '["a", "b", "c", "d", "e", "f"]'):
        with pytest.raises(WalkError, match="mine: end has at most 5 sentences"):
            read_walk(f"end = {end}\n{ENERGY}", "mine")


def test_what_stays_covered_was_covered() -> None:
    text = ENERGY.replace('["value:tau", "value:omega"]', '["value:tau"]\nstill = ["value:omega"]')
    assert told(text) == ["still: “value:omega” is not in cover."]
    assert told(text.replace("omega", "tau")) == ["still: the answer shows nothing that was covered."]


def test_what_a_mark_sets_is_a_parameter() -> None:
    steps = steps_of(OWN.values())
    walk = read_walk('title = "t"\n[[step]]\nid = "one"\nfrom = "d34-08"\nsets = "x9_0"', "mine", steps)
    assert list(problems(walk, SCENES)) == ["mine, step 1 (one), sets: “x9_0” is not a parameter."]


@pytest.mark.parametrize(
    ("has", "says"),
    [
        ("", []),
        ('has = [{ f = "least", on = "V", is = 0.0, tol = 0.1 }], ', []),
        (
            'has = [{ f = "least", on = "W", is = 0.0, tol = 0.1 }], ',
            ["mine, step 1 (one), wrong[0].has: “W” is not drawn."],
        ),
    ],
)
def test_what_a_wrong_sketch_has_is_of_a_curve_that_is_drawn(has: str, says: list[str]) -> None:
    wrong = f'{{ draws = "d", {has}fails = ["period"], idea = "i", reply = "r" }}'
    text = f'title = "t"\n[[step]]\nid = "one"\nfrom = "d31-09"\nwrong = [{wrong}]'
    assert list(problems(read_walk(text, "mine", steps_of(OWN.values())), SCENES)) == says


@pytest.mark.parametrize(
    ("feature", "says"),
    [
        ('{ f = "value", on = "V", at = 0.0, is = "E_total", tol = 0.1 }', ""),
        ('{ f = "value", on = "V", at = 0.0, is = "2 * E_total", tol = 0.1 }', "the scene's own curve does not have"),
        ('{ f = "value", on = "V", at = 0.0, is = "E_totl", tol = 0.1 }', "does not have, E_totl; it has"),
    ],
)
def test_a_feature_given_by_the_scenes_numbers_is_checked(feature: str, says: str) -> None:
    text = f'title = "t"\n[[step]]\nid = "one"\nfrom = "d31-09"\nmust = [{feature}]\nwrong = []'
    found = list(problems(read_walk(text, "mine", steps_of(OWN.values())), SCENES))
    assert len(found) == bool(says) and all("must[0]" in one and says in one for one in found), found


def test_two_steps_of_one_id_and_too_large_a_file_are_refused() -> None:
    with pytest.raises(WalkError, match=r"mine, step 2: the id “first” was given"):
        read_walk(GOOD + GOOD[GOOD.index("[[step]]") :], "mine")
    with pytest.raises(WalkError, match=f"at most {LARGEST} are allowed"):
        read_walk(GOOD + "#" * LARGEST, "mine")
    with pytest.raises(WalkError, match="small letters"):
        read_walk(GOOD, "../mine")
    for old, new, says in (
        ('"first"', '"First!"', r"id: small letters, digits and hyphens, as first-step\."),
        ("\ncover", '\nslides = ["7"]\ncover', r"slides\[0\]: a lecture and one of its slides, as D34-7\."),
    ):
        with pytest.raises(WalkError, match=says):
            changed(old, new)


def test_a_walk_may_end_with_scenes_to_try() -> None:
    trial = '[[trial]]\nscene = "modes"\ntitle = "Find them"\ntext = "Drag the *ring*."\n\n'
    walk = changed("[[step]]", trial + "[[step]]")
    assert not list(problems(walk, SCENES))
    assert walk_sheet(walk, SCENES).trials[0].scene == "modes"
    assert found("[[step]]", trial.replace("modes", "mode") + "[[step]]")[0].startswith("mine, trial: “mode” is not a")
    with pytest.raises(WalkError, match="at most 3 scenes to try"):
        changed("[[step]]", trial * 4 + "[[step]]")
    with pytest.raises(WalkError, match="mine, trial: "):
        changed("[[step]]", trial.replace("scene", "sceen") + "[[step]]")


def test_a_folder_brings_walks_and_is_checked(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(GOOD, encoding="utf-8-sig")  # as Notepad may save it
    assert list(all_walks([tmp_path], SCENES)) == ["tour", "d31", "d32-33", "d34", "waves", "mine"]
    (tmp_path / "mine.toml").write_text(GOOD.replace("k2=3", "k2=-3"), encoding="utf-8")
    with pytest.raises(WalkError, match=r"mine, step 1 \(first\), state"):
        all_walks([tmp_path], SCENES)
    (tmp_path / "mine.toml").rename(tmp_path / "d31.toml")
    with pytest.raises(WalkError, match="there is a walk “d31” already"):
        all_walks([tmp_path], SCENES)
    with pytest.raises(WalkError, match="no folder of walks"):
        all_walks([tmp_path / "nowhere"], SCENES)


def test_a_link_names_a_step_by_id_or_number() -> None:
    assert asked_step({"scene": [b"coupled"]}, OWN) is None
    for query, step in (({"walk": [b"d34"]}, "d34-01"), ({"walk": [b"d34"], "step": [b"7"]}, "d34-07")):
        found = asked_step(query, OWN)
        assert found and found.step.id == step
    with pytest.raises(ValueError, match="walk: “d99” is not a walk"):
        asked_step({"walk": [b"d99"]}, OWN)
    with pytest.raises(ValueError, match="no step “22”; it has 21"):
        asked_step({"walk": [b"d34"], "step": [b"22"]}, OWN)


def test_what_is_asked_is_told_from_what_is_given() -> None:
    assert parted("It is 4 N/m. Both rest. Force on mass 1?") == ("It is 4 N/m. Both rest.", "Force on mass 1?")
    assert parted("Look. Sketch it. It reaches 1 m.") == ("Look.", "Sketch it. It reaches 1 m.")
    assert parted("No question at all.") == ("", "No question at all.")


def test_the_walks_in_the_docs_are_right() -> None:
    """The examples of docs/writing-a-walk.md, unchanged: the first is a walk of three steps."""
    docs = (Path(__file__).parents[2] / "docs" / "writing-a-walk.md").read_text(encoding="utf-8")
    examples = [one for one in docs.split("```toml\n")[1:] if one.startswith("title")]
    walks = [read_walk(one.split("```")[0], "docs") for one in examples]
    for walk in walks:
        assert list(problems(walk, SCENES)) == []
    assert list(shortcomings(walks[0], SCENES)) == []
    assert [(step.kind, step.judges) for step in walks[0].steps] == [
        ("number", True), ("choice", False), ("choice", True)
    ]  # fmt: skip


def test_all_problems_are_reported_at_once_in_the_order_of_the_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Each has all that is possible in its place; steps that cannot be read have theirs, too."""
    step = GOOD.partition("[[step]]")[2]
    wrong = [
        step.replace('controls = ["k2"]', 'controls = ["k9", "🙂"]').replace("{omega_minus} rad", "{omega_9} rad"),
        step.replace('"choice"', '"dance"').replace('"first"', '"second"'),
        step.replace("value:omega_minus", "<b>" + "x" * 10_000).replace('"first"', '"third"'),
    ]
    path = tmp_path / "mine.toml"
    path.write_text("[[step]]".join(['title = "T"\n', *wrong]), encoding="utf-8")
    assert main([str(path)]) == 1
    *found, last = capsys.readouterr().out.splitlines()
    assert [one.partition(": ")[0] for one in found] == [
        "mine, step 1 (first), controls", "mine, step 1 (first), explain", "mine, step 2 (second), kind",
        "mine, step 3 (third), cover",
    ]  # fmt: skip
    assert "“k9”, “🙂” are not possible: choose from" in found[0] and ", m1, m2, " in found[0]
    assert ", omega_minus, " in found[1] and ", value:omega_minus, " in found[3]
    assert len(found[3]) < 9_000 and last == "mine: 4 to mend."


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ('title = "t"\n[[step]]\nfrom = []', "mine, step 1, from: “[]” is no step"),
        ('title = "t"\nx = ' + "[" * 3000, "mine: this is not TOML"),
        ("a." * 20_000 + "a = 1", "mine: “a.a.a.a.a.a.a.a.” is no field of a walk"),
        ('[["a". b . c.d.e.f.g.h.i]]', "is no field of a walk: its name has too many dots"),
        ("title = '\ud800'", "mine: the title is missing|is not TOML|1 to 60 steps"),
    ],
)
def test_files_that_mean_harm_are_refused_in_a_sentence(text: str, says: str) -> None:
    with pytest.raises(WalkError, match=says.replace("[", r"\[").replace("]", r"\]")):
        read_walk(text, "mine")


def test_a_walk_has_so_many_links_and_so_much_that_follows() -> None:
    steps = [f'[[step]]\nid = "s{i}"\nfrom = "d31-03"\nstate = "?scene=energy&m={1 + i}"' for i in range(31)]
    known = steps_of(OWN.values())
    reveals = [f'\nreveal = "?scene=energy&k={1 + i}"' for i in range(31)]
    read_walk(
        "\n".join(['title = "t"', *(a + b for a, b in zip(steps[:30], reveals[:30], strict=True))]), "mine", known
    )
    with pytest.raises(WalkError, match="mine: a walk has at most 60 different links"):
        read_walk("\n".join(['title = "t"', *(a + b for a, b in zip(steps, reveals, strict=True))]), "mine", known)
    with pytest.raises(WalkError, match="follows: "):
        read_walk(f'title = "t"\n{steps[0]}\nfollows = "{"x" * 2001}"', "mine", known)


def test_a_control_that_takes_a_listed_part_away_is_named() -> None:
    """The choice of the energies shows one of two plots, of which the step lists one."""
    state = 'state = "?scene=coupled&view=energy&energy=modes"\nshow = ["plot:mode_energy"]'
    walk = changed('state = "?scene=coupled&k2=3"', state)
    assert not any("leave it out" in one for one in shortcomings(walk, SCENES))
    energy = read_walk(
        GOOD.replace('state = "?scene=coupled&k2=3"', state).replace('["k2"]', '["k2", "energy"]'), "mine"
    )
    (doubt,) = (one for one in shortcomings(energy, SCENES) if "leave it out" in one)
    assert "controls: with “energy” at parts, plot:mode_energy of show is not shown" in doubt
