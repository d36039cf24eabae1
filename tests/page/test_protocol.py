"""docs/protocol.md and the browser's types agree with the types of components/language."""

from __future__ import annotations

import ast
import pkgutil
import re
from pathlib import Path

import pytest

import components.language
from tools import page_types
from tools.notation import notation
from tools.protocol import FILES


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_what_is_written_is_current(path: Path) -> None:
    assert path.read_text(encoding="utf-8") == FILES[path](), "make protocol writes it anew"


def test_every_module_is_written_of() -> None:
    assert {module.name for module in pkgutil.iter_modules(components.language.__path__)} == set(page_types.MODULES)


def test_no_two_types_share_a_name() -> None:
    names = [type.name for chapter in page_types.chapters() for type in chapter.types]
    assert "Shown" in names
    assert len(names) == len(set(names))


def test_every_name_of_a_definition_is_defined() -> None:
    (definitions,) = (text() for path, text in FILES.items() if path.suffix == ".ts")
    code = re.sub(r'/\*\*.*?\*/|//[^\n]*|"[^"]*"', "", definitions, flags=re.S)
    defined = set(re.findall(r"(?:type|interface) (\w+)", code))
    assert set(re.findall(r"\b[A-Z]\w+", code)) - {"Record"} == defined


def test_a_type_without_notation_is_refused() -> None:
    with pytest.raises(ValueError, match="set"):
        notation(ast.parse("set[str]", mode="eval").body)
