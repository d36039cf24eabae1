"""docs/accessibility.md: every criterion has its row, and every test that a row names exists."""

from __future__ import annotations

import re

from tests.serving.server import ROOT

PAGE = (ROOT / "docs" / "accessibility.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| (\d\.\d\.\d+) [^|]+ \| ([^|]+) \| ([^|]+) \|$", PAGE, re.M)
A = """1.1.1 1.2.1 1.2.2 1.2.3 1.3.1 1.3.2 1.3.3 1.4.1 1.4.2 2.1.1 2.1.2 2.1.4 2.2.1 2.2.2 2.3.1 2.4.1 2.4.2 2.4.3 2.4.4
2.5.1 2.5.2 2.5.3 2.5.4 3.1.1 3.2.1 3.2.2 3.2.6 3.3.1 3.3.2 3.3.7 4.1.2"""
AA = """1.2.4 1.2.5 1.3.4 1.3.5 1.4.3 1.4.4 1.4.5 1.4.10 1.4.11 1.4.12 1.4.13 2.4.5 2.4.6 2.4.7 2.4.11 2.5.7 2.5.8 3.1.2
3.2.3 3.2.4 3.3.3 3.3.4 3.3.8 4.1.3"""
TEST = re.compile(r"(tests/\S+\.py)::(test_\w+)")


def test_every_criterion_of_wcag_2_2_has_a_row() -> None:
    assert [number for number, *_ in ROWS] == [*A.split(), *AA.split()]


def test_supported_criteria_name_tests_that_exist() -> None:
    named = set()
    for number, conformance, remarks in ROWS:
        assert conformance in ("Supports", "Partially Supports", "Does Not Support", "Not Applicable"), number
        found = TEST.findall(remarks)
        assert found or conformance != "Supports", number
        assert remarks.strip(), number
        named.update(found)
    assert len(named) > 20
    for path, name in named:
        assert re.search(rf"^def {name}\(", (ROOT / path).read_text(encoding="utf-8"), re.M), f"{path}::{name}"
