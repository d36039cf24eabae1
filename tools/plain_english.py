"""`python -m tools.plain_english [FILE ...]` counts archaic or contorted turns of phrase.

It prints them per 1,000 words of documents, of docstrings and comments in Python, and of comments in scripts and
styles. If you name files, it prints each place in them. CONTRIBUTING.md has the rule.
"""

from __future__ import annotations

import ast
import io
import re
import sys
import tokenize
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
MOST = {"docs": 3.0, "Python": 5.0, "scripts": 2.5}
"""Allowed turns of phrase per 1,000 words. Lower a limit when you have rewritten texts: the aim is 5."""
WORDS = (
    r"stands?|stood", r"tells?|told", r"anew", r"besides?", r"(?:of|on) (?:its|one's|their|his) own", r"in force",
    r"in sight", r"apart", r"alike", r"whoever", r"those (?:that|who|of|in|which)", r"that of", r"as it (?:is|was)",
    r"(?:by|of) (?:itself|themselves)", r"what (?:it|was|they|comes|does|has|one|stands|follows)", r"hardly",
    r"(?:take|taken|takes|goes) along", r"(?:does|do) without", r"lies?", r"goes? on",
)  # fmt: skip
OPENINGS = (
    "Of", "What", "Who", "Whoever", "Whether", "Those", "Such", "Beside", "Where", "How", "From", "By", "Without",
    "Nothing", "None", "As", "To",
)  # fmt: skip
PATTERNS = (
    *(re.compile(rf"\b(?:{words})\b", re.IGNORECASE) for words in WORDS),
    re.compile(rf"(?:^|[.:;] |\n\n)(?:{'|'.join(OPENINGS)})\b(?! (?:run|see|read|use|set|choose|make|get|start)\b)"),
)
COMMENT = re.compile(r"/\*\*?(.*?)\*/|(?:^|\s)//(.*?)$", re.DOTALL | re.MULTILINE)
CODE = re.compile(r"```.*?```|`[^`]*`|\$[^$]*\$|https?://\S+|^\|[-| ]+\|$", re.DOTALL | re.MULTILINE)


class Prose(NamedTuple):
    """The prose of a part of a file, and the line that it begins on."""

    line: int
    text: str


def of_document(text: str) -> Iterator[Prose]:
    """Yield a document without its code."""
    yield Prose(1, CODE.sub(_blank, text))


def of_python(text: str) -> Iterator[Prose]:
    """Yield the docstrings and comments of a module."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            yield Prose(node.lineno, node.value.value)
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and not token.string.startswith(("#!", "# noqa", "# type:", "# fmt:")):
            yield Prose(token.start[0], token.string.lstrip("# "))


def of_script(text: str) -> Iterator[Prose]:
    """Yield the comments of a script or style sheet."""
    for match in COMMENT.finditer(text):
        yield Prose(text.count("\n", 0, match.start()) + 1, match[1] or match[2] or "")


KINDS: dict[str, tuple[Callable[[str], Iterator[Prose]], tuple[str, ...]]] = {
    "docs": (of_document, (".md",)),
    "Python": (of_python, (".py",)),
    "scripts": (of_script, (".js", ".css")),
}


def files(root: Path, *endings: str) -> list[Path]:
    """Return the files of a checkout with these endings, without the measured tables and the tests."""
    folders = (root / name for name in ("components", "physics", "static", "tools", "docs"))
    places = (*root.glob("*"), *(path for folder in folders for path in folder.rglob("*")))
    skipped = ("node_modules", "vendor", "error_vs_time.md", "CHANGELOG.md", "plain_english.py")
    return sorted(
        path for path in places if path.suffix in endings and not {*path.relative_to(root).parts} & {*skipped}
    )


def turns(prose: Prose) -> Iterator[tuple[int, str]]:
    """Yield each turn of phrase in a piece of prose, with its line."""
    for pattern in PATTERNS:
        for match in pattern.finditer(prose.text):
            yield prose.line + prose.text.count("\n", 0, match.start()), match[0].strip()


def rate(paths: list[Path], read: Callable[[str], Iterator[Prose]]) -> float:
    """Return the turns of phrase per 1,000 words of files."""
    words = found = 0
    for path in paths:
        for prose in read(path.read_text(encoding="utf-8")):
            words += len(re.findall(r"[A-Za-z][A-Za-z'-]*", prose.text))
            found += sum(1 for _ in turns(prose))
    return 1000 * found / max(words, 1)


def _blank(match: re.Match[str]) -> str:
    return "\n" * match[0].count("\n")


def main(arguments: list[str]) -> int:
    for name in arguments:
        path = Path(name)
        read = next((read for read, endings in KINDS.values() if path.suffix in endings), None)
        for prose in read(path.read_text(encoding="utf-8")) if read else ():
            for line, words in turns(prose):
                print(f"{name}:{line}: {words}")
    rates = {} if arguments else {name: rate(files(ROOT, *endings), read) for name, (read, endings) in KINDS.items()}
    for name, found in rates.items():
        print(f"{name}: {found:.1f} turns of phrase per 1,000 words; at most {MOST[name]:g} are allowed")
    return int(any(found > MOST[name] for name, found in rates.items()))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
