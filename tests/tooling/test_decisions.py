"""docs/decisions: each record has a question, measured figures and a decision, and its command exists."""

from __future__ import annotations

import re

from tests.serving.server import ROOT
from tools.bench.decisions import QUESTIONS, modules

RECORDS = sorted((ROOT / "docs" / "decisions").glob("*.md"))


def test_a_record_has_its_parts_and_is_listed_in_the_architecture() -> None:
    architecture = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    assert len(RECORDS) >= 6
    for record in RECORDS:
        text = record.read_text(encoding="utf-8")
        assert [part for part in ("The question", "Measured", "Decided") if f"\n## {part}\n" not in text] == []
        assert f"(decisions/{record.name})" in architecture


def test_the_commands_of_the_records_exist() -> None:
    named = {
        name
        for record in RECORDS
        for name in re.findall(r"tools\.bench\.decisions (\w+)", record.read_text(encoding="utf-8"))
    }
    assert named == set(QUESTIONS)


def test_a_question_is_answered_by_figures() -> None:
    apart, together = modules()
    assert (
        float(re.findall(r"([\d.]+) kB with brotli", apart)[0])
        > float(re.findall(r"([\d.]+) kB with brotli", together)[0])
        > 10
    )
