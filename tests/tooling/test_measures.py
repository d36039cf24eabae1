"""House rules, each broken and kept; imports, hooks, and rules for scripts that no linter checks."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest
import yaml

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


PARAMETER, RETURNS = "    Parameters\n    ---\n    a : int\n", "    Returns\n    ---\n    int\n"
RAISES = "    Raises\n    ---\n    ValueError\n        Always.\n"
RULES: list[tuple[Check, tuple[str, ...], object]] = [
    (of(long_modules), ("one.py", 501 * "one()\n"), "has 501 lines. A module has at most 500"),
    (of(long_modules), ("one.py", 500 * "one()\n"), None),
    (of(long_lines), ("one.css", "\n" + 121 * "a"), "one.css:2: has 121 characters"),
    (of(long_lines), ("one.css", "\n" + 120 * "a"), None),
    (of(long_functions), ("one.py", "def many():\n" + 40 * "    one()\n"), "one.py:1: many has 41 lines"),
    (of(long_functions), ("one.py", "def many():\n" + 39 * "    one()\n"), None),
    (of(vague_docstrings), ("one.py", 'def one():\n    """What it does."""\n'), "one.py:2: begins with “What”"),
    (of(vague_docstrings), ("one.js", "// Lines.\n\n/** The same lines. */\n"), "one.js:3: begins with “The same”"),
    (of(vague_docstrings), ("one.js", "// Lines.\n\n/** A line. */\n"), None),
    (shared, ("class Case: ...", "\nclass Case: ..."), "components/0.py:1 and components/1.py:2: two types"),
    (shared, ("class Case: ...", "class Other: ..."), None),
    (bad_sentence, ("It creeps.",), "the example “Heavy” has a sentence of 10 characters"),
    (bad_sentence, ("Each swing is smaller than the one before.",), None),
    (tasks, ("Drag it" + 105 * ".",), "“A” has 112 characters"),
    (tasks, ("Behold it.",), "“A” begins with “Behold”. A task begins with Pull, Drag"),
    (tasks, ("Drag it.",), None),
    (lacks, ('def f():\n    """True if it swings."""',), ("a first word",)),
    (lacks, ('def f():\n    """A curve."""',), None),
    (lacks, ('class A:\n    """A."""\n    @property\n    def x(self) -> bool:\n        """True if so."""',), None),
    (lacks, ("def f(a):\n    pass",), ("a docstring",)),
    (lacks, ('def f(a, b):\n    """Return the sum."""',), ("a", "b")),
    (lacks, ('def f(a, b):\n    """Return a + b."""',), None),
    (lacks, ('def f(a, b, c):\n    """Return a + b + c."""',), ("a", "b", "c")),
    (lacks, ('def f(a, b, c):\n    """Springs. Parameters and result as in `Runner`."""',), None),
    (lacks, (f'def f(a) -> int:\n    """Double a.\n\n{PARAMETER}    """',), ("Returns",)),
    (lacks, (f'def f(a) -> int:\n    """Double it.\n\n{PARAMETER}\n{RETURNS}    """',), None),
    (lacks, ('def f():\n    """Fail."""\n    raise ValueError("no")',), ("ValueError",)),
    (lacks, (f'def f():\n    """Fail.\n\n{RAISES}    """\n    raise ValueError("no")',), None),
    (lacks, ('@dataclass\nclass A:\n    """A record."""\n    a: int',), ("a",)),
    (lacks, (f'@dataclass\nclass A:\n    """A record.\n\n{PARAMETER}    """\n    a: int',), None),
    (lacks, ("", "physics/one.py", "The motion at 1000 times."), ("a source",)),
    (lacks, ("", "physics/valid.py", "The motion at 1000 times."), None),
]  # fmt: skip


@pytest.mark.parametrize(("rule", "given", "message"), RULES)
def test_a_broken_rule_is_reported_with_its_place(rule: Check, given: tuple[str, ...], message: object) -> None:
    found = list(rule(*given))
    assert len(found) == (message is not None)
    assert not found or found == [message] or str(message) in str(found[0])


def test_no_import_is_for_types_alone() -> None:
    """An import that works only for types shows that two modules depend on each other."""
    python = [source for source in code() if source.is_python]
    assert len(python) > 500
    assert [source.name for source in python if re.search("^if TYPE_CHECKING", source.text, re.M)] == []


# Hooks run tools of this environment.


def test_every_linter_of_make_lint_is_a_hook_and_no_hook_is_downloaded() -> None:
    config = ROOT / ".pre-commit-config.yaml"
    done = subprocess.run([sys.executable, "-m", "pre_commit", "validate-config", str(config)], check=False)
    assert done.returncode == 0
    repos = yaml.safe_load(config.read_text(encoding="utf-8"))["repos"]
    hooks = [hook for repo in repos for hook in repo["hooks"]]
    assert ([repo["repo"] for repo in repos], {hook["language"] for hook in hooks}) == (["local"], {"system"})
    assert all(hook["entry"].startswith(".venv/bin/") for hook in hooks)
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    lint = "".join(re.findall(r"^(?:checks|python-types):.*\n((?:\t.*\n)+)", makefile, re.M))
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
