"""Expressions of a scene's numbers: the right answers in a walk, as formulas of quantities.

An expression has names of quantities and numbers, + - * / ^, brackets, pi, sqrt, exp and abs. Python's parser reads it,
and only these kinds of nodes are accepted. No code is ever run.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping

from components.quantities.formatting import excerpt
from components.scene import Scene

LONGEST, LARGEST_POWER = 200, 100
_OPERATIONS: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
_FUNCTIONS: dict[str, Callable[[float], float]] = {"sqrt": math.sqrt, "exp": math.exp, "abs": abs}


def numbers_of(scene: Scene) -> dict[str, float]:
    """Return the numbers of a scene by name, in SI and unrounded: its quantities and its readouts."""
    own = {name: value for name, value in scene.values.items() if isinstance(value, float)}
    return own | {name: float(one.value) for one in scene.readouts() for name in (*one.also, one.name)}


def worked_out(text: str, numbers: Mapping[str, float]) -> float:
    """Return the value of an expression. Raises ValueError, with a reason, for an invalid one."""
    if len(text) > LONGEST:
        raise ValueError(f"“{excerpt(text)}” is longer than {LONGEST} characters")
    try:
        found = _value(ast.parse(text.strip().replace("^", "**"), mode="eval").body, numbers)
    except (SyntaxError, RecursionError, ValueError) as error:
        known = f": {', '.join(sorted(numbers))}" if isinstance(error, UnknownNameError) else ""
        reason = str(error) if known else "is not an expression of the scene's numbers"
        raise ValueError(f"“{excerpt(text)}” {reason}{known}") from error
    except ArithmeticError as error:
        raise ValueError(f"“{excerpt(text)}” has no value here") from error
    if not math.isfinite(found):
        raise ValueError(f"“{excerpt(text)}” has no value here")
    return found


class UnknownNameError(ValueError):
    """An error: an expression contains a name that the scene does not have."""


def _value(node: ast.expr, numbers: Mapping[str, float]) -> float:
    match node:
        case ast.Constant(value=int() | float() as number):
            return float(number)
        case ast.Name(id="pi"):
            return math.pi
        case ast.Name(id=name):
            if name not in numbers:
                raise UnknownNameError(f"has a name that the scene does not have, {excerpt(name)}; it has")
            return numbers[name]
        case ast.UnaryOp(op=ast.UAdd() | ast.USub() as sign, operand=operand):
            value = _value(operand, numbers)
            return -value if isinstance(sign, ast.USub) else value
        case ast.BinOp(left=left, op=ast.Pow(), right=right):
            base, power = _value(left, numbers), _value(right, numbers)
            if abs(power) > LARGEST_POWER:
                raise OverflowError
            return math.pow(base, power)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATIONS:
            return _OPERATIONS[type(op)](_value(left, numbers), _value(right, numbers))
        case ast.Call(func=ast.Name(id=name), args=[one], keywords=[]) if name in _FUNCTIONS:
            return _FUNCTIONS[name](_value(one, numbers))
    raise SyntaxError
