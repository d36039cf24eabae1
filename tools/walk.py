"""`python -m tools.walk FILE ...` checks walks: every link, name, formula and answer, against the scenes, and that no
step shows what a later one asks for. It reports all problems, in the order of the file.

With `--look` it also measures each step in a browser: tools/look.py. With `--pictures` it takes a picture of each step,
and with `--serve` it serves them on a page with the problems next to the pictures: tools/preview.py.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from components.scenes import SCENES
from components.walks.checking import problems, problems_of, shortcomings
from components.walks.loading import KnownSteps, WalkError, load_walk, load_walks, steps_of
from components.walks.walk import Walk

LOOK, PICTURES, SERVE = OPTIONS = "--look", "--pictures", "--serve"
PLACE = re.compile(r", step (\d+)")


def main(arguments: list[str]) -> int:
    paths = [Path(one) for one in arguments if one not in OPTIONS]
    if not paths:
        print("Which file? make walk FILE=my-walk.toml")
        return 2
    known, wrong = steps_of(load_walks(()).values()), 0
    for path in paths:
        walk, found = _read(path, known)
        if walk and not found:
            found = _shortcomings(walk, path, LOOK in arguments)
        size = f"{len(walk.steps)} steps, " if walk else ""
        print(*found, f"{path.stem}: {size}{len(found) or 'nothing'} to mend.", sep="\n")
        wrong += len(found)
        if {PICTURES, SERVE} & {*arguments}:
            _preview(walk, path, found, SERVE in arguments)
    return int(wrong > 0)


def _read(path: Path, known: KnownSteps) -> tuple[Walk | None, list[str]]:
    """Read a walk; return it, unless a step cannot be read, and its problems."""
    try:
        walk = load_walk(path, known)
    except WalkError as error:
        if not error.by_step:
            return None, [str(error)]
        of_others = (problem for i, step in error.steps.items() for problem in problems_of(path.stem, i, step, SCENES))
        return None, _in_order([*error.by_step.values(), *of_others])
    return walk, _in_order([*problems(walk, SCENES)])


def _in_order(sentences: list[str]) -> list[str]:
    """Sort sentences by the step that they begin with; general ones come last."""

    def place(sentence: str) -> float:
        found = PLACE.search(sentence)
        return float(found[1]) if found else float("inf")

    return sorted(sentences, key=place)


def _shortcomings(walk: Walk, path: Path, is_looked_at: bool) -> list[str]:
    found = list(shortcomings(walk, SCENES))
    if is_looked_at:
        from tools.look import look  # the environment that runs the app has no browser

        found += look(walk, path)
    return _in_order(found)


def _preview(walk: Walk | None, path: Path, found: list[str], is_served: bool) -> None:
    from tools.preview import preview

    preview(walk, path, found, is_served)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
