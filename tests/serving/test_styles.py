"""The style sheet: one on the wire, of several files by concern and those of single scenes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
import tinycss2
from tinycss2.ast import AtRule, Node, QualifiedRule

from components.serving.assets import SCENES, SHEETS, STYLES, in_text_sizes, static_files, style_sheet

PARTS = [*STYLES.glob("*.css"), *SCENES.glob("*/*.css")]
LONGEST_FILE, LONGEST_LINE = 300, 120


def rules(nodes: list[Node], where: str = "") -> Iterator[tuple[str, QualifiedRule]]:
    """Every rule under the condition that it stands in."""
    for node in nodes:
        if isinstance(node, AtRule) and node.content is not None:
            inner = tinycss2.parse_rule_list(node.content, skip_whitespace=True)
            yield from rules(inner, f"@{node.at_keyword}{tinycss2.serialize(node.prelude)}")
        elif isinstance(node, QualifiedRule):
            yield where, node


def all_rules() -> list[tuple[str, QualifiedRule]]:
    sheet = tinycss2.parse_stylesheet(style_sheet().decode(), skip_comments=True, skip_whitespace=True)
    assert not [node.message for node in sheet if node.type == "error"]
    return list(rules(sheet))


def test_every_part_is_on_the_wire_once_and_alone() -> None:
    assert {path.stem for path in STYLES.glob("*.css")} == set(SHEETS)
    assert len(SHEETS) == len(set(SHEETS))
    sheet = style_sheet()
    assert all(sheet.count(in_text_sizes(path.read_text("utf-8")).encode()) == 1 for path in PARTS)
    assert [name for name in static_files() if name.endswith(".css")] == ["style.css"]


def test_lengths_grow_with_the_text_and_lines_with_their_drawing() -> None:
    sheet = "@container screen (width < 1280px) { .a { margin: -4px 0.5px; --m1: #0a3f8a; stroke-width: 2px; } }"
    grown = (
        "@container screen (width < 80rem) { .a { margin: -0.25rem 0.03125rem; --m1: #0a3f8a; stroke-width: 2px; } }"
    )
    assert in_text_sizes(sheet) == grown


def test_no_rule_is_defined_twice() -> None:
    found = Counter((where, tinycss2.serialize(rule.prelude).strip()) for where, rule in all_rules())
    assert len(found) > 200
    assert [rule for rule, count in found.items() if count > 1] == []


def test_no_declaration_stands_twice_in_a_rule() -> None:
    for _, rule in all_rules():
        given = tinycss2.parse_blocks_contents(rule.content, skip_comments=True, skip_whitespace=True)
        names = [declaration.lower_name for declaration in given]
        assert names
        assert len(names) == len(set(names)), tinycss2.serialize(rule.prelude)


def test_what_is_important_says_why() -> None:
    lines = style_sheet().decode().splitlines()
    important = [i for i, line in enumerate(lines) if "!important" in line]
    assert all("/* Important: " in lines[i - 1] for i in important), [lines[i] for i in important]


@pytest.mark.parametrize("path", PARTS, ids=lambda path: path.name)
def test_a_part_is_short(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= LONGEST_FILE
    assert max(map(len, lines)) <= LONGEST_LINE


def test_the_rules_of_a_scene_lie_with_that_scene() -> None:
    assert {path.stem for path in SCENES.glob("*/*.css")} == {path.parent.name for path in SCENES.glob("*/*.css")}
