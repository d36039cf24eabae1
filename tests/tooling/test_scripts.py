"""The scripts as text: what the tools that check them leave to be held."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.serving.server import ROOT

SCRIPTS = sorted((ROOT / "static").rglob("*.js"))
LONGEST_FILE, LONGEST_LINE = 500, 120


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.name)
def test_a_script_is_short(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= LONGEST_FILE
    assert [line for line in lines if len(line) > LONGEST_LINE] == []


def test_typescript_is_pinned_by_hash_and_no_host_is_named() -> None:
    text = (ROOT / "package-lock.json").read_text()
    packages = {name: package for name, package in json.loads(text)["packages"].items() if name}
    assert "node_modules/typescript" in packages
    assert all(package["integrity"].startswith("sha512-") for package in packages.values())
    assert "resolved" not in text
    assert "://" not in text
