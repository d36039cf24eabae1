"""House rules: each reports what breaks it, with its place. `make lint` holds the project to them."""

from __future__ import annotations

from pathlib import Path

from components.layout.views import View
from tools import house_rules
from tools.docstrings import gaps_of
from tools.house_rules import Source

UNEXPLAINED = 'def f(a, b):\n    """Return the sum."""\n    raise ValueError("no")'
WORDS = (
    "one.py: has 503 lines",
    "one.py:503: has 121 characters",
    "one.py:2: many has 501 lines",
    "one.py:1: begins with “The same”",
    "a.py:1 and b.py:1: two types are called Case",
    "static: 2 types are called One",
    "static: a.js, b.js, c.js, d.js import each other",
    "components/scenes/friction: the example “Heavy” has a sentence of 10 characters",
    "components/scenes/friction: the task of the view “A” begins with “Behold”",
)


def test_a_broken_rule_is_reported_with_its_place(tmp_path: Path) -> None:
    bad = Source("one.py", '"""The same."""\ndef many():\n' + 500 * "    one()\n" + 121 * "a")
    scripts = [tmp_path / name for name in ("a.js", "b.js", "c.js", "d.js")]
    for one, other in zip(scripts, [*scripts[1:], scripts[0]], strict=True):
        one.write_text(f"import('./{other.name}')")
    found = [
        *house_rules.long_modules(bad),
        *house_rules.long_lines(bad),
        *house_rules.long_functions(bad),
        *house_rules.vague_docstrings(bad),
        *house_rules.shared_names(Source(name, "class Case: ...") for name in ("a.py", "b.py")),
        *house_rules.shared_script_names(["class One {}", "/** @typedef {number} One */"]),
        *house_rules.import_circles(scripts),
        *house_rules.bad_sentences("friction", {"Heavy": "It creeps."}),
        *house_rules.bad_tasks("friction", [View("A", "Behold it.")]),
    ]
    assert [said[: len(words)] for said, words in zip(found, WORDS, strict=True)] == [*WORDS]
    (module, function) = gaps_of("physics/one.py", f'"""The sum."""\n{UNEXPLAINED}')
    assert (module.lacks, function.lacks) == (("a source",), ("ValueError", "a", "b"))
