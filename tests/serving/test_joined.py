"""The scripts that every page needs are sent as one file, unchanged except for imports and exports."""

from __future__ import annotations

import re
from pathlib import PurePosixPath
from posixpath import normpath

import pytest

from components.serving.assets import assets, static_files, written_files
from components.serving.scripts import FIRST, IMPORT, sent
from components.serving.shell import library, version

MODULES = {name: text.decode() for name, text in written_files().items() if name.endswith(".js")}


def test_every_line_of_every_module_is_sent_but_for_its_imports() -> None:
    scripts = sent(MODULES)
    first = scripts[FIRST].splitlines()
    joined = MODULES.keys() - scripts.keys()
    for name, module in MODULES.items():
        lines = IMPORT.sub("", module).splitlines()
        assert {line.removeprefix("export ") for line in lines if name in joined} <= set(first)
        assert set(lines) <= {*scripts.get(name, module).splitlines(), ""}
    assert len(joined) > 30


def test_every_import_of_a_script_that_is_sent_is_sent() -> None:
    scripts = {name: text.decode() for name, text in static_files().items() if name.endswith(".js")}
    asked = {
        normpath(f"{PurePosixPath(name).parent}/{imported}")
        for name, text in scripts.items()
        for imported in re.findall(r'(?:^import .* from |=> import\()"(.*)"', text, re.M)
    }
    assert len(asked) > 15 and asked <= scripts.keys()
    page = {f"{version()}/{name}" for name in (*scripts, "style.css")} | {library().removeprefix("assets/")}
    assert page <= assets().keys()


@pytest.mark.parametrize(
    ("modules", "refused"),
    [
        (
            {FIRST: 'import {a} from "./a.js"\n', "a.js": 'import {b} from "./start.js"\n'},
            "in a circle: start.js, a.js, start.js",
        ),
        ({FIRST: 'import * as a from "./a.js"\n'}, "cannot be joined"),
        (
            {FIRST: 'import {a} from "./a.js"\nexport const a = 1\n', "a.js": "export const a = 1\n"},
            "Two scripts export a",
        ),
    ],
)
def test_what_cannot_be_joined_is_refused(modules: dict[str, str], refused: str) -> None:
    with pytest.raises(ValueError, match=refused):
        sent(modules)
