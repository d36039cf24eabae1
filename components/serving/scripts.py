"""The scripts as they are sent: those that every page needs in one file, in the order in which they need each other.

Each module stands in a function of its own, line by line as it was written, but for its imports and exports:

    const $fit = (() => {
    const {element} = $dom
    class Fit { ... }
    return {Fit}
    })()

The file exports what each of them does, for those that are fetched later. docs/decisions/no-bundler.md says why.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from itertools import chain

FIRST = "start"
"""The module that needs all others, and the name of the file."""
IMPORT = re.compile(r'^import (\{[^}]*\}) from "\./([\w-]+)\.js"$', re.M)
EXPORT = re.compile(r"^export (?=(?:async )?(?:function|class|const) (\w+))", re.M)
FROM_LATER = re.compile(r'^(import .* from )"\.\./[\w-]+\.js"$', re.M)


def joined(modules: Mapping[str, str]) -> str:
    """One module of those by name, as far as the first needs them."""
    names = _in_order(FIRST, modules, ())
    parts = (_enclosed(name, modules[name]) for name in names)
    exported = {name: EXPORT.findall(modules[name]) for name in names}
    if twice := [name for name, count in Counter(chain(*exported.values())).items() if count > 1]:
        raise ValueError(f"Two scripts export {', '.join(twice)}.")
    exports = (f"export const {{{', '.join(found)}}} = ${name}\n" for name, found in exported.items() if found)
    return "".join([*parts, *exports])


def later(module: str) -> str:
    """A module that is fetched later: what it imports of the others is in the joined file."""
    return FROM_LATER.sub(rf'\1"../{FIRST}.js"', module)


def _in_order(name: str, modules: Mapping[str, str], asking: tuple[str, ...]) -> list[str]:
    """The modules that one needs, then itself; each once."""
    if name in asking:
        raise ValueError(f"The scripts import each other in a circle: {', '.join([*asking, name])}.")
    found: dict[str, None] = {}
    for _, needed in IMPORT.findall(modules[name]):
        found |= dict.fromkeys(_in_order(needed, modules, (*asking, name)))
    return [*found, name]


def _enclosed(name: str, module: str) -> str:
    body = IMPORT.sub(lambda found: f"const {found[1].replace(' as ', ': ')} = ${found[2]}", module)
    body = EXPORT.sub("", body)
    if left := re.findall(r"^(?:import|export)\b.*", body, re.M):
        raise ValueError(f"{name}.js: {left[0]} cannot be joined.")
    return f"const ${name} = (() => {{\n{body}return {{{', '.join(EXPORT.findall(module))}}}\n}})()\n"
