"""The scripts that every page needs are sent as one file, as they were written but for what binds them."""

from __future__ import annotations

import re
from pathlib import PurePosixPath
from posixpath import normpath

import pytest

from components.serving.assets import STATIC, assets, static_files
from components.serving.scripts import FIRST, IMPORT, joined, later
from components.serving.shell import version

MODULES = {path.stem: path.read_text(encoding="utf-8") for path in STATIC.glob("*.js")}


def test_every_line_of_every_module_is_sent_but_for_its_imports() -> None:
    sent = joined(MODULES).splitlines()
    for module in MODULES.values():
        lines = IMPORT.sub("", module).splitlines()
        assert {line.removeprefix("export ") for line in lines} <= set(sent)
    assert len(MODULES) > 30


def test_every_import_of_a_script_that_is_sent_is_sent() -> None:
    scripts = {name: text.decode() for name, text in static_files().items() if name.endswith(".js")}
    asked = {
        normpath(f"{PurePosixPath(name).parent}/{imported}")
        for name, text in scripts.items()
        for imported in re.findall(r'(?:^import .* from |=> import\()"(.*)"', text, re.M)
    }
    assert len(asked) > 15
    assert asked <= scripts.keys()
    assert {f"{version()}/{name}" for name in scripts} <= assets().keys()


def test_a_module_comes_after_what_it_needs_and_says_what_others_may_use() -> None:
    modules = {
        FIRST: 'import {twice as double} from "./sum.js"\n\ndouble(1)\n',
        "sum": 'import {one} from "./one.js"\n\nexport const twice = n => n + n + one - one\n',
        "one": "export const one = 1\n",
    }
    assert joined(modules) == (
        "const $one = (() => {\nconst one = 1\nreturn {one}\n})()\n"
        "const $sum = (() => {\nconst {one} = $one\n\nconst twice = n => n + n + one - one\nreturn {twice}\n})()\n"
        "const $start = (() => {\nconst {twice: double} = $sum\n\ndouble(1)\nreturn {}\n})()\n"
        "export const {one} = $one\nexport const {twice} = $sum\n"
    )
    assert later('import {one} from "../one.js"\nimport {x} from "./x.js"\n') == (
        'import {one} from "../start.js"\nimport {x} from "./x.js"\n'
    )


@pytest.mark.parametrize(
    ("modules", "refused"),
    [
        ({FIRST: 'import {a} from "./a.js"\n', "a": 'import {b} from "./start.js"\n'}, "in a circle: start, a, start"),
        ({FIRST: 'import * as a from "./a.js"\n'}, "cannot be joined"),
        (
            {FIRST: 'import {a} from "./a.js"\nexport const a = 1\n', "a": "export const a = 1\n"},
            "Two scripts export a",
        ),
    ],
)
def test_what_cannot_be_joined_is_refused(modules: dict[str, str], refused: str) -> None:
    with pytest.raises(ValueError, match=refused):
        joined(modules)
