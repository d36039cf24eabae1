"""Questions of every kind, with answers, the form in which each is counted, and what is refused."""

from typing import Any, NamedTuple

CHOICE, NUMBER = {"walk": "d31", "step": "d31-03"}, {"walk": "d31", "step": "d31-02"}
SKETCH = {"walk": "d34", "step": "d34-14"}
OWN = {
    "mine": 'title = "Mine"\n[[step]]\nid = "one"\nfrom = "d31-03"\n',
    "why": """title = "Why"
[[step]]
id = "why"
kind = "words"
title = "Energy goes to and fro"
state = "?scene=oscillator"
question = "Why does it swing on?"
explain = "Energy goes to and fro."
[[step]]
id = "vote"
kind = "choice"
poll = true
fixed = true
title = "Vote"
state = "?scene=coupled&k2=3"
question = "What is your answer to the question just asked?"
options = [{ text = "A" }, { text = "B" }]
explain = "The question was asked aloud."
""",
}
"""Walks from the instructor's files."""


class Answer(NamedTuple):
    """An answer: the fields that a phone sends, its text, judgement and unit in the table, and how it is counted."""

    fields: dict[str, Any]
    text: str
    right: str
    counted: Any
    unit: str = ""


class Asked(NamedTuple):
    """A question: its place in its walk, the field of `Counted` that has the answers, answers, and what is none."""

    walk: str
    step: str
    place: int
    counts: str
    answers: tuple[Answer, ...]
    unfit: tuple[dict[str, Any], ...]


def drawn(value: int, points: int = 101) -> dict[str, Any]:
    return {"curves": {"Xp1": [value] * points}}


OPTIONS = (
    Answer({"option": 0}, "Just as long as it did before", "yes", 0),
    Answer({"option": 1}, "Longer: the distance is longer", "no", 1),
    Answer({"option": 2}, "Shorter: the spring pulls harder", "no", 2),
)
NO_OPTION = ({}, {"option": 3}, {"option": 0, "text": "=cmd"}, {"option": 0, "value": 0.5}, {"option": 0, **drawn(5)})
QUESTIONS = (
    Asked("d31", "d31-03", 3, "options", OPTIONS, NO_OPTION),
    Asked("mine", "one", 1, "options", OPTIONS, NO_OPTION),
    Asked(
        "d31", "d31-02", 2, "numbers",
        (
            Answer({"text": "2"}, "2", "yes", 2.0, "s"), Answer({"text": "−2"}, "-2", "no", -2.0, "s"),
            Answer({"text": "-1,5"}, "-1.5", "no", -1.5, "s"), Answer({"text": "+3"}, "3", "no", 3.0, "s"),
            Answer({"text": "-10^3"}, "-1000", "no", -1000.0, "s"),
        ),
        ({"text": "two"}, {"option": 0}, {"text": "2", "option": 0}),
    ),
    Asked(
        "d34", "d34-08", 8, "numbers",
        (Answer({"value": 1.5}, "1.5", "yes", 1.5, "m"), Answer({"value": 0.5}, "0.5", "no", 0.5, "m")),
        ({"option": 1}, {"value": 1.5, "text": "=cmd"}, {"value": 1.5, **drawn(5)}),
    ),
    Asked(
        "d34", "d34-14", 14, "sketches",
        (Answer(drawn(500), "Xp1: 0 2.5", "no", 500, "SI"), Answer(drawn(100), "Xp1: 0 0.5", "no", 100, "SI")),
        (drawn(5, 50), {"curves": {"Xp9": [5] * 101}}, {**drawn(5), "text": "=cmd"}),
    ),
    Asked(
        "why", "why", 1, "words",
        (
            Answer({"text": "Energy"}, "Energy", "", "energy"), Answer({"text": " energy. "}, "energy.", "", "energy"),
            Answer({"text": "=1+1"}, "'=1+1", "", "=1+1"), Answer({"text": "x" * 80}, "x" * 80, "", "x" * 80),
            Answer({"text": "a\u202eb\nc"}, "a b c", "", "a b c"),
            Answer({"text": "🙂👩\u200d🔬"}, "🙂👩\u200d🔬", "", "🙂👩\u200d🔬"),
        ),
        ({"text": ""}, {"text": " \u200b "}, {"option": 0}),
    ),
    Asked(
        "why", "vote", 2, "options",
        (Answer({"option": 0}, "A", "", 0), Answer({"option": 1}, "B", "", 1)),
        ({"option": 2}, {"text": "A"}),
    ),
)  # fmt: skip
