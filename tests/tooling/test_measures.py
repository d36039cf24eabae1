"""The measures of CONTRIBUTING.md: functions of 40 lines, modules of 500, lines of 120 columns; no name for two
types."""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

from tests.serving.server import ROOT

LONGEST_FUNCTION, LONGEST_MODULE, WIDEST_LINE = 40, 500, 120


def sources(*endings: str) -> list[Path]:
    found = [ROOT / "app.py", ROOT / "reading.py"]
    for folder in ("components", "physics", "static", "tests", "tools"):
        found += [path for path in sorted((ROOT / folder).rglob("*")) if path.suffix in endings]
    return [path for path in found if path.suffix in endings]


def named(paths: list[Path]) -> dict[str, Path]:
    return {path.relative_to(ROOT).as_posix(): path for path in paths}


CODE = named(sources(".py", ".js", ".css"))
PYTHON = {name: path for name, path in CODE.items() if path.suffix == ".py"}
PRODUCT = {name: path for name, path in CODE.items() if not name.startswith("tests/")}


def lines(name: str) -> list[str]:
    return CODE[name].read_text(encoding="utf-8").splitlines()


def parsed(name: str) -> ast.Module:
    return ast.parse(PYTHON[name].read_text(encoding="utf-8"))


def functions(name: str) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    for node in ast.walk(parsed(name)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            yield node


def length(node: ast.stmt) -> int:
    return (node.end_lineno or node.lineno) - node.lineno + 1


def test_modules_are_short() -> None:
    lengths = {name: len(lines(name)) for name in CODE}
    assert {name: length for name, length in lengths.items() if length > LONGEST_MODULE} == {}


def test_lines_are_short() -> None:
    assert [(name, i) for name in CODE for i, line in enumerate(lines(name), start=1) if len(line) > WIDEST_LINE] == []


def test_functions_are_short() -> None:
    lengths = {(name, node.name): length(node) for name in PYTHON for node in functions(name)}
    assert len(lengths) > 1000
    assert {place: length for place, length in lengths.items() if length > LONGEST_FUNCTION} == {}


DECLARES = re.compile(r"(\w+\.)?(Declared|Named|dict|Has|\w*(Axes|Places|Signals))\b")


def types_of(name: str) -> Iterator[tuple[str, str]]:
    """Classes and aliases of types at the top of a module, names in CapWords, with what makes two of them different.

    But for declarations: each scene has its own signals and numbers, called like what they declare.
    """
    for node in parsed(name).body:
        match node:
            case ast.ClassDef(bases=[base, *_]) if DECLARES.match(ast.unparse(base)):
                pass
            case ast.ClassDef(name=found):
                yield found, name
            case ast.Assign(value=ast.Call(func=ast.Name(id="TypeVar"))):
                pass
            case (
                ast.Assign(targets=[ast.Name(id=found)], value=value)
                | ast.AnnAssign(target=ast.Name(id=found), value=ast.expr() as value)
            ):
                if found[:1].isupper() and not found.isupper():
                    yield found, ast.unparse(value)


def test_no_two_types_share_a_name() -> None:
    found: defaultdict[str, set[str]] = defaultdict(set)
    for module in PRODUCT.keys() & PYTHON:
        for name, kind in types_of(module):
            found[name].add(kind)
    assert len(found) > 100
    assert {name: kinds for name, kinds in found.items() if len(kinds) > 1} == {}


def test_no_import_is_for_types_alone() -> None:
    """One that cannot be made while the program runs says that two modules need each other."""
    assert [name for name in PYTHON if any(line.startswith("if TYPE_CHECKING") for line in lines(name))] == []


def docstrings(name: str) -> Iterator[tuple[str, str]]:
    """The docstrings of a module, of its classes and of its functions, each with its place."""
    for node in ast.walk(parsed(name)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            yield f"{name}:{node.body[0].lineno}", ast.get_docstring(node) or ""


def test_docstrings_and_headers_name_the_thing() -> None:
    """A stranger reads the first words without another file: a noun of the field, not what, how or the same."""
    said = [one for name in PYTHON for one in docstrings(name)]
    for name, path in CODE.items():
        if name not in PYTHON:
            said += [(name, text) for text in re.findall(r"(?:^//|^/\*|/\*\*)[\s*]+(.*)", path.read_text("utf-8"))]
    assert len(said) > 3000
    assert [place for place, text in said if re.match(r"(The same|What|That|How|Those|This)\b", text)] == []


def glossary() -> set[str]:
    terms = re.findall(r"\*\*(.+?)\*\*", (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8"))
    return {term.lower().removesuffix("s") for found in terms for term in found.split(", ")}


def names(name: str) -> Iterator[str]:
    """A module and its public classes, of a script those that it exports."""
    module = Path(name).with_suffix("").parts
    yield module[-2] if module[-1].startswith("__") else module[-1]
    if name in PYTHON:
        yield from (one.name for one in parsed(name).body if isinstance(one, ast.ClassDef) and one.name[0] != "_")
    elif name.endswith(".js"):
        yield from re.findall(r"^export class (\w+)", "\n".join(lines(name)), re.M)


def test_the_glossary_has_the_word_of_every_name() -> None:
    """The last word of a name, or the whole of it; words of a single scene stand in its own package."""
    known = glossary()
    rooms = [name for name in CODE if re.match(r"components/(?!scenes/).*py$|static/.*js$", name)]
    found = {one for name in rooms for one in names(name)}
    assert len(found) > 300
    words = {one: {one.lower(), re.findall("[A-Z]?[a-z]+|[A-Z]+", one)[-1].lower()} for one in found}
    assert {one for one in found if not {word.removesuffix("s") for word in words[one]} & known} == set()


def test_modules_stand_in_a_room() -> None:
    """A folder is a subject, and hardly a file stands beside them."""
    flat = [path.stem for path in (ROOT / "components").glob("*.py") if path.stem != "__init__"]
    assert flat == ["processes"]
    assert {path.stem for path in (ROOT / "static").glob("*.*")} == {"home", "later", "main", "start"}


def test_files_that_code_and_pages_name_are_there() -> None:
    texts = [
        *(ROOT / "docs").rglob("*.md"),
        *(ROOT / "types").glob("*.ts"),
        ROOT / "CONTRIBUTING.md",
        ROOT / "README.md",
    ]
    texts += [path for name, path in CODE.items() if not name.startswith("tests/")]
    named = re.compile(
        r"\b(?:components|docs|physics|static|tests|tools|types)/[\w/-]+\.(?:css|d\.ts|html|js|md|py|toml)\b"
    )
    found = [(path.name, one) for path in texts for one in named.findall(path.read_text(encoding="utf-8"))]
    assert len(found) > 100
    written = ("components/scenes/friction/", "tests/scenes/test_friction.py")  # by who follows docs/adding-a-scene.md
    assert [pair for pair in found if not ((ROOT / pair[1]).exists() or pair[1].startswith(written))] == []
