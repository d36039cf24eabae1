"""The style sheet: one file for the browser, from several files by concern and those of single scenes."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

import tinycss2
from tinycss2.ast import AtRule, Declaration, Node, QualifiedRule

from components.serving.assets import SCENES, STYLES, in_text_sizes, static_files, style_sheet

PARTS = [path for path in (*STYLES.glob("*.css"), *SCENES.glob("*/*.css")) if path.name != "style.css"]
ORDER = tinycss2.parse_stylesheet((STYLES / "style.css").read_text("utf-8"), skip_comments=True, skip_whitespace=True)


def rules(nodes: list[Node], where: str = "") -> Iterator[tuple[str, list[str]]]:
    """Yield the declarations of each rule, with its layer, conditions and outer rules."""
    for node in nodes:
        if isinstance(node, AtRule | QualifiedRule) and node.content is not None:
            inside = f"{where} {getattr(node, 'at_keyword', '')} {tinycss2.serialize(node.prelude).strip()}"
            inner = tinycss2.parse_blocks_contents(node.content, skip_comments=True, skip_whitespace=True)
            if names := [part.lower_name for part in inner if isinstance(part, Declaration)]:
                yield inside, names
            yield from rules(inner, inside)


def all_rules() -> list[tuple[str, list[str]]]:
    sheet = tinycss2.parse_stylesheet(style_sheet().decode(), skip_comments=True, skip_whitespace=True)
    assert not [node.message for node in sheet if node.type == "error"]
    return list(rules(sheet))


MODE = re.compile(r"^ *\S.*? (screen|hall|panel|window) (\(.*\))$|^ +(screen|hall|panel|window) (\(.*\))$", re.M)
QUERY = re.compile(r"@(?:container (\w+)|media)([^{]*)\{")
EM = re.compile(r"([\d.]+)em\b")


def modes() -> set[tuple[str, str]]:
    """Return the container and condition of each layout mode that the head of the style sheet lists."""
    found = MODE.findall((STYLES / "style.css").read_text("utf-8"))
    return {(one or other, condition or alone) for one, condition, other, alone in found}


def sizes_asked() -> set[tuple[str, str]]:
    """Yield each container or window and each condition on its size in a part of the style sheet, in px."""
    asked = [query for path in PARTS for query in QUERY.findall(path.read_text("utf-8"))]
    plain = {
        (name or "window", EM.sub(lambda found: f"{16 * float(found[1]):g}px", text).strip()) for name, text in asked
    }
    return {(name, text) for name, text in plain if re.search("width|height", text)}


def test_each_layout_mode_is_named_once_and_no_query_asks_for_another() -> None:
    assert len(modes()) > 20
    assert sizes_asked() == modes()


def test_every_part_is_on_the_wire_once_and_alone() -> None:
    sheet = style_sheet()
    assert all(sheet.count(in_text_sizes(path.read_text("utf-8")).encode()) == 1 for path in PARTS)
    assert b"@import" not in sheet
    assert [name for name in static_files() if name.endswith(".css")] == ["style.css"]


def test_all_our_rules_are_in_a_named_layer() -> None:
    """A rule outside all layers would win against every rule inside one."""
    named, *parts = ORDER
    layers = [token.value for token in named.prelude if token.type == "ident"]
    sheet = tinycss2.parse_stylesheet(style_sheet().decode(), skip_comments=True, skip_whitespace=True)
    assert {node.lower_at_keyword for node in parts} == {"import"}
    assert all(node.type == "at-rule" and node.lower_at_keyword == "layer" for node in sheet)
    assert {tinycss2.serialize(node.prelude).strip() for node in sheet[1:]} == set(layers)


def test_lengths_grow_with_the_text_and_lines_with_their_drawing() -> None:
    sheet = "@container screen (width < 1280px) { .a { margin: -4px 0.5px; --m1: #0a3f8a; stroke-width: 2px; } }"
    grown = (
        "@container screen (width < 80rem) { .a { margin: -0.25rem 0.03125rem; --m1: #0a3f8a; stroke-width: 2px; } }"
    )
    assert in_text_sizes(sheet) == grown


def test_no_rule_is_defined_twice_and_no_declaration_occurs_twice_in_one() -> None:
    found = Counter(where for where, _ in all_rules())
    assert len(found) > 200
    assert [rule for rule, count in found.items() if count > 1] == []
    assert [where for where, names in all_rules() if len(names) != len(set(names))] == []


def test_what_is_not_selected_opens_no_menu_in_safari_either() -> None:
    """Safari needs the prefixed name, and a long press opens a menu there; no browser of the tests uses that rule."""
    found = [{*names} for _, names in all_rules() if "user-select" in names]
    assert found
    assert all({"-webkit-user-select", "-webkit-touch-callout"} <= names for names in found)
