"""Each ValueError of the physics is a sentence for people: it says what was given and what is allowed, in symbols as
they stand on the screen."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import physics
from components.state.commands import sentence
from physics.valid import DOUBLES

ROOT = Path(physics.__file__).parent
GIVEN = re.compile(r"(The|An?)\b|[^:]*(=|“…”|…)")
"""The beginning of a reason: a noun, or a symbol and its value."""
ALLOWED = re.compile(
    r"allowed|needed|at least|the most|choose|range of doubles|finite number|must be|below|do(es)? not fit"
)
CODE = re.compile(
    r"\w_\w|\b(omega|theta|tau|delta|Xp\d?|sqrt|dtype|shape|None|assert|invalid|ndim)\b|[a-zA-Z]\d\b|\(\)|=="
)
NOT_MET = {
    ("valid", "finite_array"): "the times and frequencies of a picture are made by its scene, in one dimension",
}
"""Reasons that no visitor can cause, and why."""


def raised() -> Iterator[tuple[str, str, str]]:
    """Module, function and message, with … for each number, wherever a ValueError is made."""
    for path in sorted(ROOT.glob("*.py")):
        for function in ast.walk(ast.parse(path.read_text())):
            if isinstance(function, ast.FunctionDef):
                for call in ast.walk(function):
                    if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "ValueError":
                        yield path.stem, function.name, _message(call.args[0])


def _message(said: ast.expr) -> str:
    match said:
        case ast.Constant(value=str(text)):
            return text
        case ast.JoinedStr(values=parts):
            return "".join(map(_message, parts))
        case ast.FormattedValue(value=ast.Name(id="DOUBLES")):
            return DOUBLES
        case ast.FormattedValue():
            return "…"
    raise AssertionError(f"{ast.unparse(said)} is not written where it is raised")


def faults(message: str) -> list[str]:
    """The parts that a message lacks to be a sentence for people."""
    told = sentence(ValueError(message))
    missing = [name for name, rule in (("given", GIVEN.match), ("allowed", ALLOWED.search)) if not rule(told)]
    found = CODE.search(told)
    return missing + ([f"code: {found[0]}"] if found else []) + (["words"] if len(told.split()) < 6 else [])


def test_every_refusal_of_the_physics_says_what_was_given_and_what_is_allowed() -> None:
    sites = list(raised())
    assert len(sites) > 25
    wrong = {(*site, message): found for *site, message in sites if (found := faults(message))}
    assert not {place: found for place, found in wrong.items() if place[:2] not in NOT_MET}
    assert {place[:2] for place in wrong} == set(NOT_MET), "one that is exempt has words by now"


@pytest.mark.parametrize(
    ("said", "shown"),
    [
        ("the amplitude B = v_0/omega_n = -2.668e+331 leaves", "The amplitude B = v₀/ωₙ = −2.668e331 leaves."),
        ("x1_0 = nan: only finite numbers", "x₁(0) = nan: only finite numbers."),
        ("the amplitude Xp1 at omega = 3 rad/s", "The amplitude Xₚ₁ at ω = 3 rad/s."),
        ("above 2 sqrt(k1 m1), omega_+ and 9 m/s^2", "Above 2 √(k₁ m₁), ω₊ and 9 m/s²."),
        ("“plot:x2” and “x1” of D31 stay, as 1e5 does", "“plot:x2” and “x1” of D31 stay, as 1e5 does."),
    ],
)
def test_symbols_are_those_of_the_screen(said: str, shown: str) -> None:
    assert sentence(ValueError(said)) == shown
