"""Joins the scripts that every page needs into one file, in the order of their imports.

Each module becomes a function. Its lines do not change, except for imports and exports:

    const $input_fitting = (() => {
    const {element} = $core_dom
    class Fit { ... }
    return {Fit}
    })()

The file exports the exports of all modules, for scripts that are fetched later. docs/decisions/no-bundler.md has the
reasons.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import chain
from posixpath import dirname, join, normpath, relpath

FIRST = "start.js"
"""The module that imports all others of a scene's first page, and the name of the joined file."""
ENTRIES = (FIRST, "home.js")
"""The modules that pages start with."""
IMPORT = re.compile(r'^import (\{[^}]*\}) from "(\.[^"]*)"$', re.M)
EXPORT = re.compile(r"^export (?=(?:async )?(?:function|class|const) (\w+))", re.M)


def sent(modules: Mapping[str, str]) -> dict[str, str]:
    """Return the scripts by path: for each module that a page starts with, one file with everything it imports, and
    each of the other modules.
    """
    needed = {entry: _in_order(entry, modules, ()) for entry in ENTRIES if entry in modules}
    first = needed[FIRST]
    return {path: _linked(path, module, first) for path, module in modules.items() if path not in first} | {
        entry: joined(modules, paths) for entry, paths in needed.items()
    }


def needed_later(path: str, modules: Mapping[str, str]) -> list[str]:
    """Return the module and all modules that it needs in addition to the first page's."""
    first = _in_order(FIRST, modules, ())
    return [name for name in _in_order(path, modules, ()) if name not in first]


def joined(modules: Mapping[str, str], paths: Sequence[str]) -> str:
    """Return one module as a function, after those that it imports."""
    parts = (_enclosed(path, modules[path]) for path in paths)
    exported = {path: EXPORT.findall(modules[path]) for path in paths}
    if twice := [name for name, count in Counter(chain(*exported.values())).items() if count > 1]:
        raise ValueError(f"Two scripts export {', '.join(twice)}.")
    exports = (f"export const {{{', '.join(found)}}} = {_name(path)}\n" for path, found in exported.items() if found)
    return "".join([*parts, *exports])


def _linked(path: str, module: str, first: Sequence[str]) -> str:
    """A module that is fetched later: it imports modules of the joined file from there."""
    start = relpath(FIRST, dirname(path))

    def taken(found: re.Match[str]) -> str:
        return f'import {found[1]} from "{start}"' if _found(path, found[2]) in first else found[0]

    return IMPORT.sub(taken, module)


def _found(path: str, imported: str) -> str:
    """Return the path of the script that a module imports."""
    return normpath(join(dirname(path), imported))


def _name(path: str) -> str:
    """Return the name of a module within the joined file."""
    return "$" + path.removesuffix(".js").replace("/", "_")


def _in_order(path: str, modules: Mapping[str, str], asking: tuple[str, ...]) -> list[str]:
    """Return the modules that one imports, then the module itself; each once."""
    if path in asking:
        raise ValueError(f"The scripts import each other in a circle: {', '.join([*asking, path])}.")
    needed: dict[str, None] = {}
    for _, imported in IMPORT.findall(modules[path]):
        needed |= dict.fromkeys(_in_order(_found(path, imported), modules, (*asking, path)))
    return [*needed, path]


def _enclosed(path: str, module: str) -> str:
    def taken(found: re.Match[str]) -> str:
        return f"const {found[1].replace(' as ', ': ')} = {_name(_found(path, found[2]))}"

    body = EXPORT.sub("", IMPORT.sub(taken, module))
    if left := re.findall(r"^(?:import|export)\b.*", body, re.M):
        raise ValueError(f"{path}: {left[0]} cannot be joined.")
    return f"const {_name(path)} = (() => {{\n{body}return {{{', '.join(EXPORT.findall(module))}}}\n}})()\n"
