"""`python -m tools.protocol` writes docs/protocol.md and types/page.d.ts from the types of components/language."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from pathlib import Path

from tools.notation import limit, notation
from tools.page_types import Alias, Chapter, Field, Record, browser_only, chapters, from_browser

ROOT = Path(__file__).parents[1]
WRITTEN = "Written by `make protocol` from components/language. Edit the code, not this file."


def page() -> str:
    """docs/protocol.md: every type under its module, with its docstring and its fields."""
    parts = ["# Messages between Python and the browser", WRITTEN, _introduction()]
    for chapter in chapters():
        parts += [f"## {chapter.name}.py", chapter.doc]
        parts += [part for type in chapter.types for part in _described(type)]
    return "\n\n".join(parts) + "\n"


def _introduction() -> str:
    """Return the introduction of the page."""
    contents = " · ".join(f"[{chapter.name}](#{chapter.name}py)" for chapter in chapters())
    return f"""\
One visitor's page and its session on the server exchange JSON messages over one WebSocket.

The browser numbers its messages (`BrowserMessage`), sends one at a time and waits for the answer. The server answers
each, also when it rejects one, with a message of type `AnyServerMessage`. It also sends changes without a request, for
example while a measurement runs. The fixed parts of a scene are sent once, as its `SceneSheet`. The first picture is
in the page itself.

A message of the server is compressed with the sheet's `preset_dictionary`. It is a line of JSON. With a
`PagePicture`, the numbers of its columns and of the runs of its signals follow as scaled integers:
components/state/encoding.py.

Types are in TypeScript's notation; numbers are doubles. The column "left out" has the value of a field that is missing.

{contents}"""


def _described(type: Alias | Record) -> Iterable[str]:
    yield f"### {type.name}"
    if type.doc:
        yield type.doc
    if isinstance(type, Alias):
        allowed = limit(type.type)
        yield f"`{notation(type.type)}`" + (f", {allowed}" if allowed else "")
        return
    if type.array:
        yield "An array, in this order:"
    yield from _rest(type)


def _rest(record: Record) -> Iterable[str]:
    """Yield the table of the fields, and a link to the inherited ones."""
    rows = [f'| `{record.tag[0]}` | `"{record.tag[1]}"` | |'] if record.tag else []
    rows += [f"| `{field.name}` | {_cell(field)} |{_default(record, field)} |" for field in record.fields]
    if rows:
        yield "\n".join(["| field | type | left out |", "|---|---|---|", *rows])
    if record.base:
        yield f"And the fields of [{record.base}](#{record.base.lower()})."


def _cell(field: Field) -> str:
    allowed = limit(field.type)
    return f"`{notation(field.type)}`".replace("|", r"\|") + (f", {allowed}" if allowed else "")


def _default(record: Record, field: Field) -> str:
    return f" `{field.default}`" if field.default is not None and record.name in from_browser() else ""


def definitions() -> str:
    """types/page.d.ts: the same for TypeScript, which checks the browser's scripts by it."""
    body = "\n\n".join(_module(chapter) for chapter in chapters())
    return f"// {WRITTEN}\n\ndeclare namespace page {{\n{textwrap.indent(body, '  ')}\n}}\n"


def _module(chapter: Chapter) -> str:
    return "\n\n".join(_comment(type.doc) + _definition(type) for type in chapter.types)


def _definition(type: Alias | Record) -> str:
    if isinstance(type, Alias):
        return f"type {type.name} = {notation(type.type)}"
    if type.array:
        return f"type {type.name} = [{', '.join(f'{field.name}: {notation(field.type)}' for field in type.fields)}]"
    mark = "?" if type.name in browser_only() else ""
    lines = [f'{type.tag[0]}: "{type.tag[1]}"'] if type.tag else []
    lines += [f"{field.name}{mark if field.default else ''}: {notation(field.type)}" for field in type.fields]
    extends = f" extends {type.base}" if type.base else ""
    body = textwrap.indent("\n".join([*lines, ""]), "  ")
    return f"interface {type.name}{extends} {{\n{body}}}"


def _comment(doc: str) -> str:
    lines = [f" * {line}".rstrip() for line in doc.splitlines()]
    return f"/**{chr(10).join(lines)[2:]} */\n" if doc else ""


FILES = {ROOT / "docs" / "protocol.md": page, ROOT / "types" / "page.d.ts": definitions}

if __name__ == "__main__":
    for path, text in FILES.items():
        path.write_text(text(), encoding="utf-8", newline="\n")
