"""The style sheet: one file for the browser, from several files by concern and those of single scenes."""

from __future__ import annotations

import re

import tinycss2

from components.serving.assets import SCENES, STYLES, in_text_sizes, static_files, style_sheet

PARTS = [path for path in (*STYLES.glob("*.css"), *SCENES.glob("*/*.css")) if path.name != "style.css"]
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


def test_lengths_grow_with_the_text_and_lines_with_their_drawing() -> None:
    sheet = "@container screen (width < 1280px) { .a { margin: -4px 0.5px; --m1: #0a3f8a; stroke-width: 2px; } }"
    grown = (
        "@container screen (width < 80rem) { .a { margin: -0.25rem 0.03125rem; --m1: #0a3f8a; stroke-width: 2px; } }"
    )
    assert in_text_sizes(sheet) == grown


def test_the_sheet_can_be_read_and_what_is_not_selected_opens_no_menu_in_safari_either() -> None:
    """Safari needs the prefixed name, and a long press opens a menu there; no browser of the tests uses that rule."""
    text = style_sheet().decode()
    assert not [node for node in tinycss2.parse_stylesheet(text) if node.type == "error"]
    blocks = re.findall(r"\{([^{}]*[;\s{]user-select: none[^{}]*)\}", text)
    assert blocks and all("-webkit-user-select" in one and "-webkit-touch-callout" in one for one in blocks)
