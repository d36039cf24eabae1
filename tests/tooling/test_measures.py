"""House rules: sizes, names and docstrings, imports, hooks, and rules for scripts that no linter checks."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import yaml

from components.layout.views import View
from tests.serving.server import ROOT
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

LONG_FUNCTION = "def many():\n" + 40 * "    one()\n"
BROKEN = [
    (long_modules, "one.py", 501 * "one()\n", "has 501 lines. A module has at most 500"),
    (long_lines, "one.css", "\n" + 121 * "a", "one.css:2: has 121 characters"),
    (long_functions, "one.py", LONG_FUNCTION, "one.py:1: many has 41 lines. A function has at most 40"),
    (vague_docstrings, "one.py", 'def one():\n    """What it does."""\n', "one.py:2: begins with “What”"),
    (vague_docstrings, "one.js", "// Lines.\n\n/** The same lines. */\n", "one.js:3: begins with “The same”"),
]


@pytest.mark.parametrize(("rule", "name", "text", "message"), BROKEN)
def test_a_broken_rule_is_reported_with_its_place(
    rule: Callable[[Source], Iterator[str]], name: str, text: str, message: str
) -> None:
    (said,) = rule(Source(name, text))
    assert message in said


def test_shared_names_long_sentences_and_tasks_without_an_action_are_reported() -> None:
    one, other = Source("components/one.py", "class Case: ..."), Source("components/other.py", "\nclass Case: ...")
    assert list(shared_names([one])) == []
    (said,) = shared_names([one, other])
    assert "components/one.py:1 and components/other.py:2: two types are called Case" in said
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
    python = [source for source in code() if source.is_python]
    assert len(python) > 500
    assert [source.name for source in python if re.search("^if TYPE_CHECKING", source.text, re.M)] == []


def test_modules_are_in_subject_folders() -> None:
    """Each folder has one subject, and almost no file is outside a folder."""
    flat = [path.stem for path in (ROOT / "components").glob("*.py") if path.stem != "__init__"]
    assert flat == ["processes"]
    assert {path.stem for path in (ROOT / "static").glob("*.*")} == {"home", "later", "main", "start"}


# Hooks run tools of this environment.


def test_every_linter_of_make_lint_is_a_hook_and_no_hook_is_downloaded() -> None:
    config = ROOT / ".pre-commit-config.yaml"
    done = subprocess.run([sys.executable, "-m", "pre_commit", "validate-config", str(config)], check=False)
    assert done.returncode == 0
    repos = yaml.safe_load(config.read_text(encoding="utf-8"))["repos"]
    hooks = [hook for repo in repos for hook in repo["hooks"]]
    assert ([repo["repo"] for repo in repos], {hook["language"] for hook in hooks}) == (["local"], {"system"})
    assert all(hook["entry"].startswith(".venv/bin/") for hook in hooks)
    lint = re.findall(r"^lint:.*\n((?:\t.*\n)+)", (ROOT / "Makefile").read_text(encoding="utf-8"), re.M)[0]
    asked = {command.split()[0] for command in re.findall(r"\$\(BIN\)/(?!python -m tools)(.*)", lint)}
    assert len(asked) >= 4
    assert asked <= {hook["entry"].removeprefix(".venv/bin/").split()[0] for hook in hooks}


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
