"""The walks of a server by name, including a visitor's own, and the step of a link."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from components.quantities.formatting import excerpt
from components.walks import Query, Walks
from components.walks.checking import problems
from components.walks.links import Scenes, name_in_state
from components.walks.loading import WalkError, load_walks, read_walk, steps_of
from components.walks.variants import varied
from components.walks.walk import Step, Walk

MOST_PROBLEMS = 8
"""Number of problems in a visitor's file that are reported at once."""


def all_walks(folders: Iterable[Path], scenes: Scenes) -> dict[str, Walk]:
    """Return the built-in walks, which tests have checked, and the walks of folders, checked here. Raises WalkError for
    the first invalid one."""
    own = load_walks(())
    walks = load_walks(folders)
    for name, walk in walks.items():
        if name not in own:
            check(walk, scenes)
    return walks


def check(walk: Walk, scenes: Scenes) -> Walk:
    """Return the walk. Raises WalkError with its first fault."""
    for problem in problems(walk, scenes):
        raise WalkError(problem)
    return walk


def read_own(text: str, name: str, walks: Walks, scenes: Scenes) -> Walk:
    """Return a visitor's own walk from a file's text. Raises WalkError with its first few faults, or if the server has
    a walk with its name.
    """
    if name in walks:
        raise WalkError(f"there is a walk “{name}” here already: give the file another name.")
    walk = read_walk(text, name, steps_of(walks.values()))
    if found := list(islice(problems(walk, scenes), MOST_PROBLEMS)):
        raise WalkError(" ".join(found))
    return walk


class AskedStep(NamedTuple):
    """Return the step of a link, with the numbers of its seed, and its name in a state."""

    step: Step
    name: str


def asked_step(query: Query, walks: Walks) -> AskedStep | None:
    """Return the step that a link names, by default the first. Raises ValueError, with a reason, if there is none."""
    if "walk" not in query:
        return None
    name, step, seed = (query.get(key, [b""])[0].decode(errors="replace") for key in ("walk", "step", "seed"))
    if name not in walks:
        raise ValueError(f"walk: “{excerpt(name)}” is not a walk: choose one of {', '.join(walks)}.")
    walk = walks[name]
    place = walk.place(step) if step else 0
    if place is None:
        raise ValueError(f"step: the walk {name} has no step “{excerpt(step)}”; it has {len(walk.steps)}.")
    if seed and not (seed.isdecimal() and len(seed) < 5):
        raise ValueError(f"seed: “{excerpt(seed)}” is no seed of a step's numbers.")
    found = varied(walk.steps[place], int(seed or 0))
    return AskedStep(found, name_in_state(name, found, int(seed or 0)))
