"""The types of the page language in TypeScript's notation, from their annotations in Python."""

from __future__ import annotations

import ast

PLAIN = {"str": "string", "float": "number", "int": "number", "bool": "boolean", "Any": "unknown"}


def notation(type: ast.expr) -> str:
    """`tuple[Curve, ...]` as `Curve[]`, `dict[str, float | None]` as `Record<string, number | null>`."""
    match type:
        case ast.Constant(value=None):
            return "null"
        case ast.Name(id=name):
            return PLAIN.get(name, name)
        case ast.BinOp(left=left, op=ast.BitOr(), right=right):
            return f"{notation(left)} | {notation(right)}"
        case ast.Subscript(value=ast.Name(id=outer), slice=inner):
            return _generic(outer, inner.elts if isinstance(inner, ast.Tuple) else [inner])
    raise ValueError(f"{ast.unparse(type)} has no notation yet")


def _generic(outer: str, inner: list[ast.expr]) -> str:
    match outer, inner:
        case "Annotated", [type, _]:
            return notation(type)
        case "Literal", words:
            return " | ".join(f'"{ast.literal_eval(word)}"' for word in words)
        case "dict", [key, value]:
            return f"Record<{notation(key)}, {notation(value)}>"
        case ("list", [one]) | ("tuple", [one, ast.Constant()]):
            return _array(notation(one))
        case "tuple", several:
            return f"[{', '.join(map(notation, several))}]"
    raise ValueError(f"{outer} has no notation yet")


def _array(one: str) -> str:
    return f"({one})[]" if " | " in one else f"{one}[]"


def limit(type: ast.expr) -> str:
    """The limit that an annotation sets, in words."""
    match type:
        case ast.Subscript(value=ast.Name(id="Annotated"), slice=ast.Tuple(elts=[inner, ast.Call(keywords=[most])])):
            if most.arg == "pattern":
                return f"of the form `{ast.literal_eval(most.value)}`"
            unit = " characters" if notation(inner) == "string" else ""
            return f"at most {ast.unparse(most.value)}{unit}"
    return ""
