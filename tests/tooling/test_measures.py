"""House rules, each broken and kept; imports, hooks, and rules for scripts that no linter checks."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from components.layout.views import View
from tests.serving.server import ROOT
from tools.docstrings import gaps_of
from tools.house_rules import (
    Source,
    bad_sentences,
    bad_tasks,
    code,
    long_functions,
    long_lines,
    long_modules,
    shared_names,
    vague_docstrings,
)

Check = Callable[..., Iterable[object]]


def of(rule: Callable[[Source], Iterable[object]]) -> Check:
    """Return the rule as a function of the name and the text of a file."""
    return lambda name, text: rule(Source(name, text))


def shared(*texts: str) -> Iterable[str]:
    return shared_names(Source(f"components/{i}.py", text) for i, text in enumerate(texts))


def bad_sentence(said: str) -> Iterable[str]:
    return bad_sentences("friction", {"Heavy": said})


def tasks(task: str) -> Iterable[str]:
    return bad_tasks("friction", [View("A", task)])


def lacks(code: str, module: str = "physics/one.py", source: str = "Source: lecture D31, slide 4.") -> Iterable[object]:
    return (one.lacks for one in gaps_of(module, f'"""{source}"""\n{code}'))


RULES: list[tuple[Check, tuple[str, ...], object]] = [
    (of(long_modules), ("one.py", 501 * "one()\n"), "has 501 lines. A module has at most 500"),
    (of(long_lines), ("one.css", "\n" + 121 * "a"), "one.css:2: has 121 characters"),
    (of(long_functions), ("one.py", "def many():\n" + 40 * "    one()\n"), "one.py:1: many has 41 lines"),
    (of(vague_docstrings), ("one.js", "// Lines.\n\n/** The same lines. */\n"), "one.js:3: begins with “The same”"),
    (shared, ("class Case: ...", "\nclass Case: ..."), "components/0.py:1 and components/1.py:2: two types"),
    (bad_sentence, ("It creeps.",), "the example “Heavy” has a sentence of 10 characters"),
    (tasks, ("Behold it.",), "“A” begins with “Behold”. A task begins with Pull, Drag"),
    (lacks, ('def f(a, b):\n    """Return the sum."""',), ("a", "b")),
    (lacks, ('def f():\n    """Fail."""\n    raise ValueError("no")',), ("ValueError",)),
    (lacks, ("", "physics/one.py", "The motion at 1000 times."), ("a source",)),
]


@pytest.mark.parametrize(("rule", "given", "message"), RULES)
def test_a_broken_rule_is_reported_with_its_place(rule: Check, given: tuple[str, ...], message: object) -> None:
    (found,) = rule(*given)
    assert found == message or str(message) in str(found)


def test_no_import_is_for_types_alone() -> None:
    """An import that works only for types shows that two modules depend on each other."""
    python = [source for source in code() if source.is_python]
    assert len(python) > 500
    assert [source.name for source in python if re.search("^if TYPE_CHECKING", source.text, re.M)] == []


# Scripts

SCRIPTS = sorted((ROOT / "static").rglob("*.js"))
LARGEST_CIRCLE = 3
IMPORTED = re.compile(r"""\b(?:from|import)\s*\(?\s*["'](\.{1,2}/[^"']+)["']""")
"""Static and dynamic imports, and those in JSDoc types."""


def reached(start: Path, imports: dict[Path, set[Path]]) -> set[Path]:
    found: set[Path] = set()
    waiting = set(imports[start])
    while waiting:
        found |= waiting
        waiting = {further for path in waiting for further in imports[path]} - found
    return found


def test_import_cycles_are_small() -> None:
    """A module that uses its container gets it as a host, whose members types/hosts.d.ts lists."""
    imports = {
        path: {(path.parent / name).resolve() for name in IMPORTED.findall(path.read_text(encoding="utf-8"))}
        for path in SCRIPTS
    }
    assert sum(map(len, imports.values())) > len(SCRIPTS)
    reach = {path: reached(path, imports) for path in SCRIPTS}
    circles = {frozenset(one.name for one in reach[path] if path in reach[one]) for path in SCRIPTS}
    assert {circle for circle in circles if len(circle) > LARGEST_CIRCLE} == set()


def test_no_two_types_share_a_name() -> None:
    """Classes of scripts, types of their comments and those of `types/`, without the page language's own."""
    texts = [path.read_text(encoding="utf-8") for path in [*SCRIPTS, *(ROOT / "types").glob("[!p]*.d.ts")]]
    named = re.compile(r"^(?:export )?(?:class|interface|type) (\w+)|@typedef \{(?:[^@]*)\} (\w+)", re.M)
    again = re.compile(r"@typedef \{import\([^@]*\)\.(\w+)\} \1$|@typedef \{import\([^@]*\)\.(\w+)\} \2 ", re.M)
    counted = Counter(name for text in texts for name in map("".join, named.findall(again.sub("", text))))
    assert len(counted) > 140
    assert {name for name, count in counted.items() if count > 1} == set()


def test_typescript_is_pinned_by_hash_and_no_host_is_named() -> None:
    text = (ROOT / "package-lock.json").read_text()
    packages = {name: package for name, package in json.loads(text)["packages"].items() if name}
    assert "node_modules/typescript" in packages
    assert all(package["integrity"].startswith("sha512-") for package in packages.values())
    assert "resolved" not in text
    assert "://" not in text
