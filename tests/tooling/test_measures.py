"""The limits of CONTRIBUTING.md: functions of 40 lines, modules of 500, lines of 120 columns, unique type names."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import pytest

from components.layout.views import View
from tests.serving.server import ROOT
from tools.house_rules import (
    Source,
    bad_sentences,
    bad_tasks,
    broken,
    code,
    long_functions,
    long_lines,
    long_modules,
    shared_names,
    vague_docstrings,
)

CODE = {source.name: source for source in code()}
PYTHON = {name: source for name, source in CODE.items() if source.is_python}
LONG_FUNCTION = "def many():\n" + 40 * "    one()\n"
BROKEN = [
    (long_modules, "one.py", 501 * "one()\n", "has 501 lines. A module has at most 500"),
    (long_lines, "one.css", "\n" + 121 * "a", "one.css:2: has 121 characters"),
    (long_functions, "one.py", LONG_FUNCTION, "one.py:1: many has 41 lines. A function has at most 40"),
    (vague_docstrings, "one.py", 'def one():\n    """What it does."""\n', "one.py:2: begins with “What”"),
    (vague_docstrings, "one.js", "// Lines.\n\n/** The same lines. */\n", "one.js:3: begins with “The same”"),
]


def test_the_code_follows_the_house_rules() -> None:
    """Modules, lines and functions are short, type names are unique, docstrings name the object, tasks are short."""
    assert list(broken()) == []
    assert len(CODE) > 500


@pytest.mark.parametrize(("rule", "name", "text", "message"), BROKEN)
def test_a_broken_rule_is_reported_with_its_place(
    rule: Callable[[Source], Iterator[str]], name: str, text: str, message: str
) -> None:
    (said,) = rule(Source(name, text))
    assert message in said


def test_two_types_with_one_name_are_found_with_both_places() -> None:
    one, other = Source("components/one.py", "class Case: ..."), Source("components/other.py", "\nclass Case: ...")
    assert list(shared_names([one])) == []
    (said,) = shared_names([one, other])
    assert "components/one.py:1 and components/other.py:2: two types are called Case" in said


def test_sentences_and_tasks_of_a_scene_are_short_and_tasks_begin_with_an_action() -> None:
    (said,) = bad_sentences("friction", {"Light": "Each swing is smaller than the one before.", "Heavy": "It creeps."})
    assert "components/scenes/friction: the example “Heavy” has a sentence of 10 characters" in said
    good, long, odd = View("A", "Drag it."), View("B", "Drag it" + 105 * "."), View("C", "Behold it.")
    assert list(bad_tasks("friction", [good])) == []
    (said,) = bad_tasks("friction", [long])
    assert "“B” has 112 characters" in said
    (said,) = bad_tasks("friction", [odd])
    assert "“C” begins with “Behold”. A task begins with Pull, Drag" in said


def test_no_import_is_for_types_alone() -> None:
    """An import that works only for types shows that two modules depend on each other."""
    assert [name for name in PYTHON if re.search("^if TYPE_CHECKING", PYTHON[name].text, re.M)] == []


def test_the_glossary_is_short() -> None:
    """It has only terms that neither a physicist nor a web developer knows."""
    terms = re.findall(r"\*\*(.+?)\*\*", (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8"))
    assert 0 < len(terms) <= 120


def test_modules_are_in_subject_folders() -> None:
    """Each folder has one subject, and almost no file is outside a folder."""
    flat = [path.stem for path in (ROOT / "components").glob("*.py") if path.stem != "__init__"]
    assert flat == ["processes"]
    assert {path.stem for path in (ROOT / "static").glob("*.*")} == {"home", "later", "main", "start"}


def test_files_named_in_code_and_documents_exist() -> None:
    texts = [
        *(ROOT / "docs").rglob("*.md"),
        *(ROOT / "types").glob("*.ts"),
        ROOT / "CONTRIBUTING.md",
        ROOT / "README.md",
    ]
    texts += [ROOT / name for name, source in CODE.items() if source.is_product]
    named = re.compile(
        r"(?<![\w/])(?:components|docs|physics|static|tests|tools|types)/[\w/-]+\.(?:css|d\.ts|html|js|md|py|toml)\b"
    )
    found = [(path.name, one) for path in texts for one in named.findall(path.read_text(encoding="utf-8"))]
    assert len(found) > 100
    written = (
        "components/scenes/friction/",
        "tests/scenes/test_friction.py",
    )  # added by following docs/adding-a-scene.md
    assert [pair for pair in found if not ((ROOT / pair[1]).exists() or pair[1].startswith(written))] == []
