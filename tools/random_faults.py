"""Random faults for `make mutants`: one small change of the syntax tree of a module.

Each fault has a kind: another comparison, another operator, another number, `return None`, or a call that is left out.
The same seed gives the same faults while the code is the same. Faults are spread evenly over the areas and kinds, so
that the many numbers of the scenes do not outweigh everything else.

Some numbers are choices, which a test should not repeat: places and sizes in drawings, limits and other constants of
modules and classes of `components`, and options such as `frozen=True` of a class or `strict=True` of `zip`. There are
no faults in these.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import NamedTuple

AREAS = ("physics", "components/scenes", "components/state", "components/walks", "components/live_class")
SKIPPED = ("physics/reference/", "__main__.py", "_worker.py")
"""Files without random faults: solutions that only tests use, and programs that run in separate processes."""
NOT_CODE = ("annotation", "returns", "decorator_list", "type_comment")
DRAWINGS = ("paper.py", "pictures.py", "places.py", "plots.py", "sheet.py", "stage.py")
"""Modules of scenes whose numbers are places and sizes."""
NEGATED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.GtE, ast.GtE: ast.Lt, ast.Gt: ast.LtE, ast.LtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
}  # fmt: skip
SWAPPED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
    ast.FloorDiv: ast.Mult, ast.Mod: ast.Mult,
}  # fmt: skip


class Site(NamedTuple):
    """A place in a file for a fault of a kind: the index of a node in the syntax tree."""

    file: str
    kind: str
    line: int
    node: int


class RandomFault(NamedTuple):
    """A site with the whole file before and after, as the syntax tree writes it, and the two pieces that differ."""

    site: Site
    text: str
    old: str
    new: str


def random_sites(root: Path, seed: int) -> Iterator[Site]:
    """Yield places of all areas and kinds in turn, until there is none left."""
    chance = Random(seed)
    turns = [(area, kind) for kind in KINDS for area in AREAS]
    pools: dict[tuple[str, str], list[Site]] = {turn: [] for turn in turns}
    for area in AREAS:
        for site in sites(root, area):
            pools[area, site.kind].append(site)
    for pool in pools.values():
        chance.shuffle(pool)
    while any(pools.values()):
        for turn in turns:
            if pools[turn]:
                yield pools[turn].pop()


def sites(root: Path, area: str) -> Iterator[Site]:
    """Return the places in an area where a fault is possible."""
    for path in sorted((root / area).rglob("*.py")):
        name = path.relative_to(root).as_posix()
        if not any(part in name for part in SKIPPED):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            chosen = set(_choices(name, tree))
            for number, node in enumerate(nodes(tree)):
                for kind, changed in KINDS.items():
                    if changed(node) is not None and node not in chosen:
                        yield Site(name, kind, getattr(node, "lineno", 0), number)


def _choices(file: str, tree: ast.Module) -> Iterator[ast.AST]:
    """Yield the numbers of a module that are choices."""
    yield from (one.value for one in ast.walk(tree) if isinstance(one, ast.keyword) and one.arg == "strict")
    if file.startswith("components"):
        bodies = [tree.body, *(one.body for one in ast.walk(tree) if isinstance(one, ast.ClassDef))]
        constants = [one for body in bodies for one in body if isinstance(one, ast.Assign | ast.AnnAssign)]
        for part in [tree] if file.endswith(DRAWINGS) else constants:
            yield from (node for node in ast.walk(part) if isinstance(node, ast.Constant))


def put(root: Path, site: Site) -> RandomFault:
    """Return a site's file with the fault in it."""
    tree = ast.parse((root / site.file).read_text(encoding="utf-8"))
    node = list(nodes(tree))[site.node]
    new = KINDS[site.kind](node)
    if new is None:
        raise ValueError(f"{site}: this file has changed.")
    old = ast.unparse(node)
    place = _Replace(node, new).visit(tree)
    return RandomFault(site, ast.unparse(ast.fix_missing_locations(place)), old, ast.unparse(new))


def nodes(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes that are executed, in the order of the text: without annotations, decorators, options of classes
    and f-strings."""
    for field, value in ast.iter_fields(tree):
        if field not in NOT_CODE and not (field == "keywords" and isinstance(tree, ast.ClassDef)):
            for node in value if isinstance(value, list) else [value]:
                if isinstance(node, ast.AST) and not isinstance(node, ast.JoinedStr):
                    yield node
                    yield from nodes(node)


class _Replace(ast.NodeTransformer):
    def __init__(self, old: ast.AST, new: ast.AST) -> None:
        self.old, self.new = old, new

    def visit(self, node: ast.AST) -> ast.AST:
        return self.new if node is self.old else super().generic_visit(node)


def _comparison(node: ast.AST) -> ast.AST | None:
    if not isinstance(node, ast.Compare) or type(node.ops[0]) not in NEGATED:
        return None
    return ast.Compare(node.left, [NEGATED[type(node.ops[0])](), *node.ops[1:]], node.comparators)


def _arithmetic(node: ast.AST) -> ast.AST | None:
    if not isinstance(node, ast.BinOp) or type(node.op) not in SWAPPED or _is_text(node.left) or _is_text(node.right):
        return None
    return ast.BinOp(node.left, SWAPPED[type(node.op)](), node.right)


def _number(node: ast.AST) -> ast.AST | None:
    if not isinstance(node, ast.Constant) or not isinstance(node.value, int | float):
        return None
    return ast.Constant(not node.value if isinstance(node.value, bool) else node.value + 1)


def _nothing(node: ast.AST) -> ast.AST | None:
    is_value = isinstance(node, ast.Return) and node.value and ast.unparse(node.value) not in ("None", "False")
    return ast.Return(ast.Constant(None)) if is_value else None


def _no_call(node: ast.AST) -> ast.AST | None:
    call = node.value if isinstance(node, ast.Expr) else None
    called = call.value if isinstance(call, ast.Await) else call
    return ast.Pass() if isinstance(called, ast.Call) else None


def _is_text(node: ast.AST) -> bool:
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


KINDS: dict[str, Callable[[ast.AST], ast.AST | None]] = {
    "comparison": _comparison,
    "arithmetic": _arithmetic,
    "number": _number,
    "return None": _nothing,
    "no call": _no_call,
}
