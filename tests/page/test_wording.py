"""Words that readers stumbled over do not come back: in scenes, walks, refusals, scripts and pages."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

import pytest

from tests.serving.server import ROOT

GONE = (
    "All that the next change changes", "Cover something, and say", "window and speed anew", "the scene chooses",
    "Keep this picture under", "Hidden until Show", "a guess counts", "What the walk has shown",
    "Ask about what is shown", "Walk from a file", "plays x", "plays m", "as does", "left alone",
    "mass 1 wants", "mass 2 wants", "As mass",
    "At full swing it needs", "nothing to add", "asks where", "sum stands still", "It tempts", "It is right for a",
    "helped from", "helped nowhere", "Lightest that met", "swings all the same", "never dies", "what a tuned absorber",
    "by unit of it", "flies over its back", "the top itself left out", "Across ", "Where the two part",
    "a row with its reason", "how long one run may take", "is the error that is good enough", "Keys of a single letter",
    "digit of the doubles", "How late: ", "which part of the motion dies", "while the other is held", "held ones cross",
    "Ask again", "Middle half", "outlined before the talk", "Let this phone in", "The claim, shown with",
    "What it means", "What is said of it", "Off by at most", "More that is covered", "not in a class of this code",
    "slide 8)", "Slide 4", "Slide 8",
)  # fmt: skip
"""Each as it once stood on the screen."""
UNSPOKEN = re.compile(r"/\*.*?\*/|<!--.*?-->|(?<!:)//[^\n]*", re.DOTALL)
"""Comments of scripts and pages."""


def python_texts(source: str) -> Iterator[str]:
    """The strings of a module, without those that only its readers see."""
    tree = ast.parse(source)
    silent = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in silent:
            yield node.value


def texts() -> Iterator[tuple[str, str]]:
    """All that a visitor can be told, by the file that it stands in."""
    for folder in ("components", "physics", "static"):
        for path in sorted((ROOT / folder).rglob("*.*")):
            if path.suffix in (".js", ".html", ".toml"):
                yield path.name, UNSPOKEN.sub("", path.read_text(encoding="utf-8"))
            elif path.suffix == ".py":
                yield path.name, "\n".join(python_texts(path.read_text(encoding="utf-8")))


@pytest.fixture(scope="module")
def said() -> list[tuple[str, str]]:
    return [(name, " ".join(text.split())) for name, text in texts()]


@pytest.mark.parametrize("words", GONE)
def test_what_was_not_understood_does_not_come_back(words: str, said: list[tuple[str, str]]) -> None:
    whole = re.compile(rf"\b{re.escape(words.strip())}" + (r"\b" if words[-1].isalpha() else ""))
    assert [
        (name, text[max(0, m.start() - 60) : m.end() + 60]) for name, text in said for m in whole.finditer(text)
    ] == []


def test_strings_are_read_and_comments_are_not() -> None:
    assert list(python_texts('"""A docstring."""\nx = f"one {2} three"  # four')) == ["one ", " three"]
    assert UNSPOKEN.sub("", 'a("one") // two\n/* three\n*/ b("http://four")') == 'a("one") \n b("http://four")'
