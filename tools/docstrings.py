"""List the public names of physics whose docstrings lack a section in the style of NumPy, or whose module lacks a
source:

python -m tools.docstrings
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
SOURCE = re.compile(r"lecture|slide|notes|[12][09]\d\d|https?:|doi|, chapter|see physics", re.I)
NONE = "a docstring"
DATA = ("dataclass", "NamedTuple")


class Gap(NamedTuple):
    """A public name of a module, and what its docstring lacks."""

    module: str
    name: str
    lacks: tuple[str, ...]


def gaps(folder: str = "physics") -> Iterator[Gap]:
    """Return the gaps of all modules of a folder."""
    for path in sorted((ROOT / folder).rglob("*.py")):
        module, tree = path.relative_to(ROOT).as_posix(), ast.parse(path.read_text(encoding="utf-8"))
        if tree.body and not SOURCE.search(ast.get_docstring(tree) or ""):
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
    for name in _named(node):
        if not re.search(rf"^(\w+, )*{name}(, \w+)*( : .+)?$", text, re.M):
            yield name
    if isinstance(node, ast.FunctionDef) and not _is_property(node) and _returns(node) and "\nReturns\n" not in text:
        yield "Returns"


def _named(node: ast.FunctionDef | ast.ClassDef) -> list[str]:
    """Return the names that a docstring has to explain: the parameters of a function, the fields of a record."""
    if isinstance(node, ast.FunctionDef):
        given = [*node.args.args, *node.args.kwonlyargs]
        return [one.arg for one in given if one.arg not in ("self", "cls")]
    kinds = [ast.unparse(one) for one in (*node.decorator_list, *node.bases)]
    if not any(kind.startswith(DATA) for kind in kinds):
        return []
    return [one.target.id for one in node.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name)]


def _is_property(node: ast.FunctionDef) -> bool:
    return any("property" in ast.unparse(one) for one in node.decorator_list)


def _returns(node: ast.FunctionDef) -> bool:
    return node.returns is not None and ast.unparse(node.returns) != "None"


if __name__ == "__main__":
    found = list(gaps())
    for one in found:
        print(f"{one.module}: {one.name or 'the module'} lacks {', '.join(one.lacks)}")
    print(f"{len(found)} names lack something")
