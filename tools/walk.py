"""`python -m tools.walk FILE ...` checks walks: every link, name, formula and answer, against the scenes, and that no
step shows what a later one asks for. With `--look` each step is measured in a browser too: tools/look.py."""

from __future__ import annotations

import sys
from pathlib import Path

from components.scenes import SCENES
from components.walks.checking import coverable_names, problems, shortcomings
from components.walks.loading import WalkError, load_walk, load_walks, steps_of
from components.walks.walk import Walk

LOOK = "--look"


def main(arguments: list[str]) -> int:
    paths = [Path(one) for one in arguments if one != LOOK]
    if not paths:
        print("Which file? make walk FILE=my-walk.toml")
        return 2
    known, wrong = steps_of(load_walks(()).values()), 0
    for path in paths:
        try:
            walk = load_walk(path, known)
        except WalkError as error:
            print(error)
            wrong += 1
            continue
        found = _found(walk, path, LOOK in arguments)
        print(*found, f"{walk.name}: {len(walk.steps)} steps, {len(found) or 'nothing'} to mend.", sep="\n")
        wrong += len(found)
    return int(wrong > 0)


def _found(walk: Walk, path: Path, is_looked_at: bool) -> list[str]:
    """The problems of a walk; of one without any, its shortcomings."""
    found = list(problems(walk, SCENES))
    for step in walk.steps:
        if any(f"({step.id}), cover: " in problem for problem in found):
            found.append(f"{step.id} can cover {', '.join(coverable_names(step, SCENES))}.")
    if found:
        return found
    if not is_looked_at:
        return list(shortcomings(walk, SCENES))
    from tools.look import look  # the environment that runs the app has no browser

    return [*shortcomings(walk, SCENES), *look(walk, path)]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
