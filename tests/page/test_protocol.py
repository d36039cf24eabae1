"""docs/protocol.md and the browser's types agree with the types of components/language."""

from __future__ import annotations

import pkgutil
from pathlib import Path

import pytest

import components.language
from tools import page_types
from tools.protocol import FILES


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_what_is_written_is_current(path: Path) -> None:
    assert path.read_text(encoding="utf-8") == FILES[path](), "make protocol writes it anew"


def test_every_module_is_written_of() -> None:
    assert {module.name for module in pkgutil.iter_modules(components.language.__path__)} == set(page_types.MODULES)
