"""Reads the types of components/language as data, for whatever is written from them."""

from __future__ import annotations

import ast
import importlib
import inspect
from dataclasses import dataclass
from functools import cache
from types import ModuleType
from typing import Any

import msgspec

PACKAGE = "components.language"
MODULES = (
    "messages",
    "state",
    "walk",
    "class_messages",
    "picture",
    "controls",
    "blocks",
    "plots",
    "shapes",
    "signals",
    "expressions",
    "text",
)
"""Order from the whole to its parts, so that you can read the page from the top."""


@dataclass(frozen=True, kw_only=True)
class Field:
    """One field; `default` is its JSON value if it may be left out."""

    name: str
    type: ast.expr
    default: str | None = None


@dataclass(frozen=True, kw_only=True)
class Alias:
    """A name for another type."""

    name: str
    doc: str
    type: ast.expr


@dataclass(frozen=True, kw_only=True)
class Record:
    """A struct: an object with `fields` and the inherited fields of `base`, or an array of them in order.

    The field `tag` (its name and its value) identifies it; a record that has none is identified by its position.
    """

    name: str
    doc: str
    base: str
    fields: tuple[Field, ...]
    tag: tuple[str, str] | None
    array: bool


@dataclass(frozen=True, kw_only=True)
class Chapter:
    """A module of the package."""

    name: str
    doc: str
    types: tuple[Alias | Record, ...]


@cache
def chapters() -> tuple[Chapter, ...]:
    return tuple(_chapter(importlib.import_module(f"{PACKAGE}.{name}")) for name in MODULES)


def records() -> dict[str, Record]:
    return {one.name: one for chapter in chapters() for one in chapter.types if isinstance(one, Record)}


def aliases() -> dict[str, Alias]:
    return {one.name: one for chapter in chapters() for one in chapter.types if isinstance(one, Alias)}


def from_browser() -> frozenset[str]:
    """Return the types of the browser's messages and of their parts; fields with defaults may be left out in these."""
    return _made_of("BrowserMessage")


def browser_only() -> frozenset[str]:
    """Return the types that the server never sends, with all their fields."""
    return from_browser() - _made_of("AnyServerMessage")


def _made_of(whole: str) -> frozenset[str]:
    known: set[str] = set()
    asked = {whole}
    while asked:
        name = asked.pop()
        known.add(name)
        asked |= _parts(name) - known
    return frozenset(known)


def _parts(name: str) -> set[str]:
    """Return the types of the package that a type refers to."""
    if name in aliases():
        types = [aliases()[name].type]
    else:
        types = [*(field.type for field in records()[name].fields), ast.Name(records()[name].base)]
    names = {node.id for type in types for node in ast.walk(type) if isinstance(node, ast.Name)}
    return {name for name in names if name in records() or name in aliases()}


def _chapter(module: ModuleType) -> Chapter:
    body = ast.parse(inspect.getsource(module)).body
    types: list[Alias | Record] = []
    for statement, following in zip(body, [*body[1:], None], strict=True):
        if isinstance(statement, ast.ClassDef):
            # Skip protocols, which are never sent.
            if issubclass(made := getattr(module, statement.name), msgspec.Struct):
                types.append(_record(made))
        elif isinstance(statement, ast.AnnAssign) and ast.unparse(statement.annotation) == "TypeAlias":
            assert isinstance(statement.target, ast.Name) and statement.value
            types.append(Alias(name=statement.target.id, doc=_text(following), type=statement.value))
    return Chapter(name=module.__name__.rpartition(".")[2], doc=inspect.getdoc(module) or "", types=tuple(types))


def _text(statement: ast.stmt | None) -> str:
    """The docstring that follows an alias."""
    if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant):
        return inspect.cleandoc(str(statement.value.value))
    return ""


def _record(struct: type[msgspec.Struct]) -> Record:
    config, base = struct.__struct_config__, struct.__bases__[0]
    tagged = config.tag_field and not struct.__subclasses__()
    return Record(
        name=struct.__name__,
        doc=inspect.getdoc(struct) or "",
        base="" if base is msgspec.Struct else base.__name__,
        fields=tuple(_field(field, struct) for field in msgspec.structs.fields(struct) if _is_own(field, struct)),
        tag=(str(config.tag_field), str(config.tag)) if tagged else None,
        array=config.array_like,
    )


def _is_own(field: msgspec.structs.FieldInfo, struct: type[msgspec.Struct]) -> bool:
    return field.name in struct.__annotations__


def _field(field: msgspec.structs.FieldInfo, struct: type[msgspec.Struct]) -> Field:
    default: Any = field.default if field.default_factory is msgspec.NODEFAULT else field.default_factory()
    return Field(
        name=field.encode_name,
        type=ast.parse(struct.__annotations__[field.name], mode="eval").body,
        default=None if default is msgspec.NODEFAULT else msgspec.json.encode(default).decode(),
    )
