"""`python -m tools.walk FILE ...` checks walks: every link, name, formula and answer, against the scenes, and that no
step shows what a later one asks for."""

from __future__ import annotations

import sys
from pathlib import Path

from components.scenes import SCENES
from components.walks.checking import coverable_names, problems, shortcomings
from components.walks.loading import WalkError, load_walk, load_walks, steps_of


def main(paths: list[str]) -> int:
    if not paths:
        print("Which file? make walk FILE=my-walk.toml")
        return 2
    known = steps_of(load_walks(()).values())
    wrong = 0
    for path in map(Path, paths):
        try:
            walk = load_walk(path, known)
        except WalkError as error:
            print(error)
            wrong += 1
            continue
        found = list(problems(walk, SCENES))
        for step in walk.steps:
            if any(f"({step.id}), cover: " in problem for problem in found):
                found.append(f"{step.id} can cover {', '.join(coverable_names(step, SCENES))}.")
        found = found or list(shortcomings(walk, SCENES))
        print(*found, f"{walk.name}: {len(walk.steps)} steps, {len(found) or 'nothing'} to mend.", sep="\n")
        wrong += len(found)
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
