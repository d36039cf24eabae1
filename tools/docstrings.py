"""Check that docstrings of physics explain each public name in the style of NumPy:

python -m tools.docstrings

- The docstring of a function begins with a verb or a noun phrase, not with a symbol or with True.
- A function has sections for its parameters and its result. With at most two parameters, prose that names them is
  enough: "Return a + b to about 104 bits." A property needs one line with its unit.
- One of several functions with the same signature may refer to the description of the others, with the words
  "Parameters and result as in" and a name.
- A record lists its fields.
- A function names the exceptions that it raises itself.
- A module names the source of its formulas.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
SOURCE = re.compile(r"\b(lecture|slides?|doi|chapter)\b|\b(1[6-9]|20)\d\d\b|https?:|see\s+physics", re.I)
NO_FORMULAS = (
    "physics/valid.py", "physics/integrators/accuracy.py", "physics/integrators/accuracy_worker.py",
    "physics/integrators/drift.py", "physics/integrators/price.py", "physics/integrators/race.py",
    "physics/integrators/stepping.py", "physics/motion.py",
)  # fmt: skip
"""Modules that check or combine numbers, or run and time methods: they have no source to name."""
NONE = "a docstring"
DATA = ("dataclass", "NamedTuple")
SHORT = 2
"""The most parameters that a docstring may explain in prose."""
FIRST = re.compile(r"(?!True\b)(An?|[A-Z][a-z]+)\b")
"""The first word of a function's docstring: a verb, or the beginning of a noun phrase; no symbol."""
AS_IN = re.compile(r"Parameters and result as in `\w+`")


class Gap(NamedTuple):
    """A public name of a module, and what its docstring lacks."""

    module: str
    name: str
    lacks: tuple[str, ...]


def gaps(folder: str = "physics") -> Iterator[Gap]:
    """Return the gaps of all modules of a folder."""
    for path in sorted((ROOT / folder).rglob("*.py")):
        yield from gaps_of(path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8"))


def gaps_of(module: str, code: str) -> Iterator[Gap]:
    """Return the gaps of a module, by its path and its code."""
    tree = ast.parse(code)
    sourced = module in NO_FORMULAS or module.endswith("__init__.py")
    if not sourced and not SOURCE.search(ast.get_docstring(tree) or ""):
        yield Gap(module, "", ("a source",))
    known = {name.rpartition(".")[2] for name, node in public(tree) if ast.get_docstring(node)}
    for name, node in public(tree):
        # A method may inherit its docstring from a base class.
        if (lacks := tuple(_lacking(node))) and not (lacks == (NONE,) and name.rpartition(".")[2] in known):
            yield Gap(module, name, lacks)


def public(tree: ast.Module) -> Iterator[tuple[str, ast.FunctionDef | ast.ClassDef]]:
    """Return the public functions, classes and methods of a module, by name."""
    for node in tree.body:
        if not isinstance(node, ast.FunctionDef | ast.ClassDef) or node.name.startswith("_"):
            continue
        yield node.name, node
        inside = node.body if isinstance(node, ast.ClassDef) else []
        methods = (one for one in inside if isinstance(one, ast.FunctionDef) and not one.name.startswith("_"))
        yield from ((f"{node.name}.{one.name}", one) for one in methods)


def _lacking(node: ast.FunctionDef | ast.ClassDef) -> Iterator[str]:
    text = ast.get_docstring(node)
    if not text:
        yield NONE
        return
    names = _named(node)
    if isinstance(node, ast.FunctionDef):
        if not _is_property(node) and not FIRST.match(text):
            yield "a first word"
        yield from (error for error in sorted(_raised(node)) if error not in text)
        if AS_IN.search(text):
            return
        if len(names) <= SHORT and not re.search(r"^(Parameters|Returns)$", text, re.M):
            yield from (name for name in names if not re.search(rf"\b{name}\b", text))
            return
    for name in names:
        if not re.search(rf"^(\w+, )*{name}(, \w+)*( : .+)?$", text, re.M):
            yield name
    if isinstance(node, ast.FunctionDef) and not _is_property(node) and _returns(node) and "\nReturns\n" not in text:
        yield "Returns"


def _raised(node: ast.FunctionDef) -> set[str]:
    """Return the names of the exceptions that the body of a function raises; an abstract method's do not count."""
    raised = (one.exc for one in ast.walk(node) if isinstance(one, ast.Raise))
    names = {one.func.id for one in raised if isinstance(one, ast.Call) and isinstance(one.func, ast.Name)}
    return {name for name in names if name.endswith("Error")}


def _named(node: ast.FunctionDef | ast.ClassDef) -> list[str]:
    """Return the names that a docstring has to explain: the parameters of a function, the fields of a record."""
    if isinstance(node, ast.FunctionDef):
        given = [*node.args.args, *node.args.kwonlyargs]
        return [one.arg for one in given if one.arg not in ("self", "cls", "_")]
    kinds = [ast.unparse(one) for one in (*node.decorator_list, *node.bases)]
    if not any(kind.startswith(DATA) for kind in kinds):
        return []
    return [one.target.id for one in node.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name)]


def _is_property(node: ast.FunctionDef) -> bool:
    return any("property" in ast.unparse(one) for one in node.decorator_list)


def _returns(node: ast.FunctionDef) -> bool:
    return node.returns is not None and ast.unparse(node.returns) != "None"


def main() -> None:
    found = list(gaps())
    for one in found:
        print(f"{one.module}: {one.name or 'the module'} lacks {', '.join(one.lacks)}")
    if found:
        sys.exit(f"{len(found)} names lack something")


if __name__ == "__main__":
    main()
