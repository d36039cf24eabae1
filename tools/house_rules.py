"""`python -m tools.house_rules` checks the house rules that no linter knows, as `make lint` does.

It prints each place that breaks a rule, with the rule.
"""

from __future__ import annotations

import ast
import re
import sys
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from components.layout.views import View
from components.scenes import SCENES

ROOT = Path(__file__).resolve().parent.parent
SUFFIXES, VENDOR = (".py", ".js", ".css"), ROOT / "components" / "serving" / "vendor"
LONGEST_FUNCTION, LONGEST_MODULE, WIDEST_LINE = 40, 500, 120
SHORTEST_WATCH, LONGEST_WATCH, LONGEST_TASK = 21, 100, 105
TASKS_BEGIN = (
    "Pull", "Drag", "Turn", "Watch", "Choose", "Change", "Let", "Take", "Follow", "Compare", "Meet", "Add", "Make",
    "Start", "Drop",
)  # fmt: skip
VAGUE = re.compile(r"(The same|What|That|How|Those|This)\b")
"""First words of a docstring that name nothing."""
HEADERS = re.compile(r"(?:^//|^/\*|/\*\*)[\s*]+(.*)")
DECLARES = re.compile(r"(\w+\.)?(Declared|Named|dict|Has|\w*(Axes|Places|Signals))\b")
"""Bases of declarations: scenes may reuse the names of signals and numbers, because each has its own."""


LARGEST_CIRCLE = 3
IMPORTED = re.compile(r"""\b(?:from|import)\s*\(?\s*["'](\.{1,2}/[^"']+)["']""")
"""Static and dynamic imports of scripts, and those in JSDoc types."""
TYPED = re.compile(r"^(?:export )?(?:class|interface|type) (\w+)|@typedef \{(?:[^@]*)\} (\w+)", re.M)
TYPED_AGAIN = re.compile(r"@typedef \{import\([^@]*\)\.(\w+)\} (?:\1$|\1 )", re.M)


class Source(NamedTuple):
    """A file of code, by its path in the project."""

    name: str
    text: str

    @property
    def is_python(self) -> bool:
        return self.name.endswith(".py")

    @property
    def is_product(self) -> bool:
        return not self.name.startswith("tests/")

    @property
    def parsed(self) -> ast.Module:
        return ast.parse(self.text)


def code() -> list[Source]:
    """Return all Python, scripts and styles of the project."""
    paths = [ROOT / "app.py", ROOT / "reading.py"]
    for folder in ("components", "physics", "static", "tests", "tools"):
        found = (path for path in (ROOT / folder).rglob("*") if path.suffix in SUFFIXES)
        paths += sorted(path for path in found if path.parent != VENDOR)
    return [Source(path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")) for path in paths]


def long_modules(source: Source) -> Iterator[str]:
    if (length := len(source.text.splitlines())) > LONGEST_MODULE:
        yield f"{source.name}: has {length} lines. A module has at most {LONGEST_MODULE}: divide it by subject."


def long_lines(source: Source) -> Iterator[str]:
    for number, line in enumerate(source.text.splitlines(), start=1):
        if len(line) > WIDEST_LINE:
            yield f"{source.name}:{number}: has {len(line)} characters. A line has at most {WIDEST_LINE}."


def long_functions(source: Source) -> Iterator[str]:
    for node in ast.walk(source.parsed):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            length = (node.end_lineno or node.lineno) - node.lineno + 1
            if length > LONGEST_FUNCTION:
                yield (
                    f"{source.name}:{node.lineno}: {node.name} has {length} lines. A function has at most "
                    f"{LONGEST_FUNCTION}: make a function of a part of it."
                )


def vague_docstrings(source: Source) -> Iterator[str]:
    """Yield docstrings, and headers of scripts and styles, whose first words do not name the thing."""
    for number, text in docstrings(source):
        if found := VAGUE.match(text):
            yield (
                f"{source.name}:{number}: begins with “{found[1]}”. A docstring begins with a noun phrase that names "
                "the thing, or for a function with an imperative: “Return the ...”."
            )


def docstrings(source: Source) -> Iterator[tuple[int, str]]:
    """Yield the docstrings of a module, of its classes and functions, or the headers of a script, with their lines."""
    if not source.is_python:
        for header in HEADERS.finditer(source.text):
            yield source.text.count("\n", 0, header.start()) + 1, header[1]
        return
    for node in ast.walk(source.parsed):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            yield (node.body[0].lineno if node.body else 1), ast.get_docstring(node) or ""


def shared_names(sources: Iterable[Source]) -> Iterator[str]:
    """Yield the names that two types of the product have."""
    found: defaultdict[str, dict[str, str]] = defaultdict(dict)
    for source in sources:
        for name, number, kind in types_of(source):
            found[name].setdefault(kind, f"{source.name}:{number}")
    for name, places in found.items():
        if len(places) > 1:
            yield (
                f"{' and '.join(places.values())}: two types are called {name}. A name has one meaning in the whole "
                "code: put the word of your scene before it, as in DampedCase."
            )


def types_of(source: Source) -> Iterator[tuple[str, int, str]]:
    """Yield classes and type aliases at the top of a module, in CapWords: name, line, and a key of its meaning."""
    for node in source.parsed.body:
        match node:
            case ast.ClassDef(bases=[base, *_]) if DECLARES.match(ast.unparse(base)):
                pass
            case ast.ClassDef(name=found):
                yield found, node.lineno, source.name
            case ast.Assign(value=ast.Call(func=ast.Name(id="TypeVar"))):
                pass
            case (
                ast.Assign(targets=[ast.Name(id=found)], value=value)
                | ast.AnnAssign(target=ast.Name(id=found), value=ast.expr() as value)
            ):
                if found[:1].isupper() and not found.isupper():
                    yield found, node.lineno, ast.unparse(value)


def shared_script_names(texts: Iterable[str]) -> Iterator[str]:
    """Yield the names that two types of scripts have: classes, and types of comments and declarations."""
    counted = Counter(name for text in texts for name in map("".join, TYPED.findall(TYPED_AGAIN.sub("", text))))
    yield from (f"static: {count} types are called {name}." for name, count in counted.items() if count > 1)


def import_circles(scripts: Iterable[Path]) -> Iterator[str]:
    """Yield groups of more than LARGEST_CIRCLE scripts that import each other, directly or not.

    A script that uses its container gets it as a host, whose members types/hosts.d.ts lists.
    """
    imports = {
        path: {(path.parent / name).resolve() for name in IMPORTED.findall(path.read_text("utf-8"))} for path in scripts
    }
    reach = {path: _reached(path, imports) for path in imports}
    circles = {frozenset(one.name for one in reach[path] if path in reach[one]) for path in reach}
    for circle in sorted(sorted(circle) for circle in circles if len(circle) > LARGEST_CIRCLE):
        yield f"static: {', '.join(circle)} import each other. At most {LARGEST_CIRCLE} scripts do: give them a host."


def _reached(start: Path, imports: Mapping[Path, set[Path]]) -> set[Path]:
    found: set[Path] = set()
    waiting = set(imports[start])
    while waiting:
        found |= waiting
        waiting = {further for path in waiting for further in imports[path]} - found
    return found


def bad_sentences(slug: str, watch: Mapping[str, str]) -> Iterator[str]:
    """Yield the sentences on what to watch in the examples of a scene that are too short, too long or no sentence."""
    for label, said in watch.items():
        if not (SHORTEST_WATCH <= len(said) <= LONGEST_WATCH and said.endswith(".")):
            yield (
                f"components/scenes/{slug}: the example “{label}” has a sentence of {len(said)} characters. It has "
                f"{SHORTEST_WATCH} to {LONGEST_WATCH} characters and ends with a full stop."
            )


def bad_tasks(slug: str, views: Iterable[View]) -> Iterator[str]:
    """Yield the tasks of views that are too long, or do not begin with something to do."""
    for view in views:
        place = f"components/scenes/{slug}: the task of the view “{view.name}”"
        if len(view.task) > LONGEST_TASK:
            yield f"{place} has {len(view.task)} characters. A task has at most {LONGEST_TASK}."
        if not view.task.startswith(TASKS_BEGIN):
            yield f"{place} begins with “{view.task.split()[0]}”. A task begins with {', '.join(TASKS_BEGIN)}."


def broken() -> Iterator[str]:
    """Yield a line for each place that breaks a rule."""
    sources = code()
    for source in sources:
        yield from long_modules(source)
        yield from long_lines(source)
        yield from vague_docstrings(source)
        if source.is_python:
            yield from long_functions(source)
    yield from shared_names(source for source in sources if source.is_python and source.is_product)
    scripts = sorted((ROOT / "static").rglob("*.js"))
    yield from import_circles(scripts)
    # Without the types of the page language, which are made from it.
    declared = [*scripts, *sorted((ROOT / "types").glob("[!p]*.d.ts"))]
    yield from shared_script_names(path.read_text(encoding="utf-8") for path in declared)
    for slug, scene in SCENES.items():
        yield from bad_sentences(slug, scene.watch)
        yield from bad_tasks(slug, scene.views)


if __name__ == "__main__":
    found = list(broken())
    print(*found, sep="\n", end="\n" if found else "")
    sys.exit(bool(found))
