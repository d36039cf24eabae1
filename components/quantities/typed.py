"""Parses the text that a visitor types into a field: a number or an expression such as 1/3, 2π or sqrt(2), and a unit.

An expression has + - * / ^, brackets, pi and sqrt. Python's parser reads it, and only nodes of these few kinds are
accepted. It is computed with 80 digits and rounded once. No code from the text is run.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable
from contextlib import suppress
from decimal import Decimal, Overflow

from components.quantities.formatting import (
    LONGEST_INPUT,
    NoNumberError,
    excerpt,
    in_doubles,
    parse_number,
    plain_number,
)
from components.quantities.measures import Measure, measure
from physics.precision.exact import PI, precise

LARGEST_POWER = 1000

_HALF_WIDTH = {code: code - 0xFEE0 for code in range(0xFF01, 0xFF5F)} | {ord("。"): ".", ord("｡"): "."}

_NUMBER_PART = re.compile(r"(?:pi(?![a-z])|sqrt|(?<=[0-9.])e(?=[-+−]?[0-9])|[-−+*/^()·×⋅√π0-9.,\s⁰¹²³⁴-⁹⁺⁻])*", re.I)
_TOKENS = re.compile(r"(?:[0-9]+\.?[0-9]*(?:e[+-]?[0-9]+)?|\.[0-9]+(?:e[+-]?[0-9]+)?|pi|sqrt|\*\*|[-+*/()])+")
_PRODUCT = re.compile(r"(?<=[0-9.)])(?=pi|sqrt|\()|(?<=pi)(?=sqrt|\()")
_OPERATIONS: dict[type[ast.operator], Callable[[Decimal, Decimal], Decimal]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


def typed_number(text: str, unit: str) -> float:
    """Return the number in a text typed into a field with this unit: 1/3, 2.5 N/m, 36 km/h, 3·10⁴, 1,5, １／３, 1。5.

    Raises ValueError, with a reason, for any other text, for a unit of another dimension, and for numbers outside the
    range of doubles.
    """
    if len(text) > LONGEST_INPUT:
        raise NoNumberError(text)
    number, given = _parts(text.translate(_HALF_WIDTH))
    if given in ("", unit):
        with suppress(NoNumberError):
            return parse_number(number)
    with precise():
        value = _worked_out(number, text) * (_ratio(given, unit, text) if given not in ("", unit) else 1)
        return in_doubles(float(value), not value, text)


def _parts(text: str) -> tuple[str, str]:
    """Return a number and the unit after it. A division before a unit belongs to the unit: 3 1/s, 3 /s."""
    found = _NUMBER_PART.match(text)
    end = found.end() if found else 0
    number, unit = text[:end].strip(), text[end:].strip()
    if not number and unit:
        raise NoNumberError(text)
    if unit and (over := re.search(r"(?:\s1\s*)?/$", number)):
        return number[: over.start()].strip(), f"1/{unit}"
    return number.rstrip("·×⋅* ") if unit else number, unit


def _worked_out(number: str, text: str) -> Decimal:
    plain = re.sub(r"[·×⋅]", "*", plain_number(number)).replace("π", "pi").replace("√", "sqrt").replace("^", "**")
    plain = re.sub(r"sqrt([0-9.]+|pi)", r"sqrt(\1)", plain)
    plain = re.sub(r"(?<![0-9.])0+(?=[0-9])", "", plain)
    if not _TOKENS.fullmatch(plain):
        raise NoNumberError(text)
    if re.search(r"/|\*\*", plain[: max((m.start() for m in _PRODUCT.finditer(plain)), default=0)]):
        raise ValueError(f"“{excerpt(text)}” has two meanings: write every multiplication sign ·, and use brackets.")
    expression = _PRODUCT.sub("*", plain)
    try:
        return _value(ast.parse(expression, mode="eval").body, expression)
    except SyntaxError:
        raise NoNumberError(text) from None
    except ZeroDivisionError:
        raise ValueError(f"“{excerpt(text)}” divides by zero.") from None
    except Overflow:
        raise ValueError(f"“{excerpt(text)}” takes more digits than a field has room for.") from None
    except ArithmeticError:
        raise ValueError(f"“{excerpt(text)}” is not a real number.") from None


def _value(node: ast.expr, expression: str) -> Decimal:
    match node:
        case ast.Constant():
            return Decimal(expression[node.col_offset : node.end_col_offset])
        case ast.Name(id="pi"):
            return PI
        case ast.UnaryOp(op=ast.UAdd() | ast.USub() as sign, operand=operand):
            value = _value(operand, expression)
            return -value if isinstance(sign, ast.USub) else value
        case ast.BinOp(left=left, op=ast.Pow(), right=right):
            return _power(_value(left, expression), _value(right, expression))
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATIONS:
            return _OPERATIONS[type(op)](_value(left, expression), _value(right, expression))
        case ast.Call(func=ast.Name(id="sqrt"), args=[one]):
            return _value(one, expression).sqrt()
    raise SyntaxError(expression)


def _power(base: Decimal, exponent: Decimal) -> Decimal:
    if abs(exponent) > LARGEST_POWER:
        raise Overflow
    return base**exponent


def _ratio(given: str, unit: str, text: str) -> Decimal:
    """Return the size of the typed unit, in the unit of the field."""
    wanted = f"type a number in {unit}" if unit else "type a number without a unit"
    try:
        found = measure(given)
    except ValueError:
        raise ValueError(f"“{excerpt(given)}” is not a unit known here: {wanted}.") from None
    own = _own(unit)
    if own is None or not found.is_kind_of(own):
        here = f"this is in {unit}" if unit else "this has no unit"
        raise ValueError(f"“{excerpt(text)}” is in {excerpt(given)}, and {here}: {wanted}.")
    return found.size / own.size


def unit_size(unit: str) -> float:
    """Return the size of a unit in SI; 1 for a scene's own unit, and for degrees, which scenes use for their angles."""
    own = _own(unit)
    return float(own.size) if own and unit not in ("", "°") else 1.0


def _own(unit: str) -> Measure | None:
    """Return the measure of a unit; None for a scene's own unit, such as v₀."""
    try:
        return measure(unit)
    except ValueError:
        return None
