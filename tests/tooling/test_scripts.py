"""Rules for scripts that the linters do not check."""

from __future__ import annotations

import json
import re
from collections import Counter
from pathlib import Path

from tests.serving.server import ROOT

SCRIPTS = sorted((ROOT / "static").rglob("*.js"))
LARGEST_CIRCLE = 3
IMPORTED = re.compile(r"""\b(?:from|import)\s*\(?\s*["'](\.{1,2}/[^"']+)["']""")
"""Static and dynamic imports, and those in JSDoc types."""


def reached(start: Path, imports: dict[Path, set[Path]]) -> set[Path]:
    found: set[Path] = set()
    waiting = set(imports[start])
    while waiting:
        found |= waiting
        waiting = {further for path in waiting for further in imports[path]} - found
    return found


def test_import_cycles_are_small() -> None:
    """A module that uses its container gets it as a host, whose members types/hosts.d.ts lists."""
    imports = {
        path: {(path.parent / name).resolve() for name in IMPORTED.findall(path.read_text(encoding="utf-8"))}
        for path in SCRIPTS
    }
    assert sum(map(len, imports.values())) > len(SCRIPTS)
    reach = {path: reached(path, imports) for path in SCRIPTS}
    circles = {frozenset(one.name for one in reach[path] if path in reach[one]) for path in SCRIPTS}
    assert {circle for circle in circles if len(circle) > LARGEST_CIRCLE} == set()


def test_no_two_types_share_a_name() -> None:
    """Classes of scripts, types of their comments and those of `types/`, without the page language's own."""
    texts = [path.read_text(encoding="utf-8") for path in [*SCRIPTS, *(ROOT / "types").glob("[!p]*.d.ts")]]
    named = re.compile(r"^(?:export )?(?:class|interface|type) (\w+)|@typedef \{(?:[^@]*)\} (\w+)", re.M)
    again = re.compile(r"@typedef \{import\([^@]*\)\.(\w+)\} \1$|@typedef \{import\([^@]*\)\.(\w+)\} \2 ", re.M)
    counted = Counter(name for text in texts for name in map("".join, named.findall(again.sub("", text))))
    assert len(counted) > 140
    assert {name for name, count in counted.items() if count > 1} == set()


def test_typescript_is_pinned_by_hash_and_no_host_is_named() -> None:
    text = (ROOT / "package-lock.json").read_text()
    packages = {name: package for name, package in json.loads(text)["packages"].items() if name}
    assert "node_modules/typescript" in packages
    assert all(package["integrity"].startswith("sha512-") for package in packages.values())
    assert "resolved" not in text
    assert "://" not in text
