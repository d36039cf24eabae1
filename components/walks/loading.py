"""Walks from their files: TOML, decoded by types. An error message names the file, the step and the field."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import msgspec

from components.language.walk import WalkTrial
from components.quantities.formatting import excerpt
from components.walks.walk import Step, Walk

OWN = Path(__file__).parent / "content"
"""The built-in walks."""
ORDER = ("tour", "d31", "d32-33", "d34", "waves")
LARGEST = 48_000
"""Maximum size of a file in bytes."""
MOST_STEPS = MOST_LINKS = 60
MOST_AT_END = 5
MOST_TRIALS = 3
PLACE = re.compile(r"^(?P<what>.*?) - at `\$\.?(?P<field>.*?)`$")
DEEP = re.compile(r"""^[ \t\[{]*(?:[\w"'-]+[ \t]*\.[ \t]*){8}""", re.MULTILINE)
"""Reading a dotted key takes time proportional to the square of its length."""
FORMS = {
    "id": "small letters, digits and hyphens, as first-step",
    "slides": "a lecture and one of its slides, as D34-7",
    "axis": "the name of a plot and x or y, as response.x",
}
"""The fields whose texts have a prescribed form, in words."""
NAME = re.compile(r"[a-z0-9][a-z0-9-]{0,39}")

KnownSteps = Mapping[str, Step]


class WalkError(ValueError):
    """Faults of a walk's file, one sentence each with its place.

    `by_step` has the fault of each unreadable step by its position, from 1 on; `steps` has the readable steps in the
    same way.
    """

    def __init__(self, *sentences: str, by_step: Mapping[int, str] = {}, steps: Mapping[int, Step] = {}) -> None:
        super().__init__(" ".join(sentences))
        self.by_step = by_step
        self.steps = steps


def read_walk(text: str, name: str, known: KnownSteps | None = None) -> Walk:
    """Return the walk of a file's text. Raises WalkError for an invalid one.

    A step with `from` takes the fields that it does not give itself from one of the `known` steps.
    """
    if not NAME.fullmatch(name):
        raise WalkError(f"{excerpt(name)}: a walk's name has small letters, digits and hyphens, at most 40.")
    size = len(text.encode(errors="replace"))
    if size > LARGEST:
        raise WalkError(f"{name}: the file has {size} bytes; at most {LARGEST} are allowed.")
    if deep := DEEP.search(text):
        raise WalkError(f"{name}: “{excerpt(deep[0].strip())}” is no field of a walk: its name has too many dots.")
    try:
        data = tomllib.loads(text.removeprefix("\ufeff"))  # some editors write a byte order mark at the beginning
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise WalkError(f"{name}: this is not TOML: {error}.") from error
    title, entries, end = data.pop("title", None), data.pop("step", None), data.pop("end", [])
    trials = _trials(data.pop("trial", []), name)
    if data:
        raise WalkError(f"{name}: “{excerpt(next(iter(data)))}” is no field of a walk; title, end, trial and step are.")
    if not isinstance(title, str) or not title:
        raise WalkError(f'{name}: the title is missing: title = "..." in the file\'s first line.')
    if not (isinstance(end, list) and len(end) <= MOST_AT_END and all(isinstance(one, str) for one in end)):
        raise WalkError(f"{name}: end has at most {MOST_AT_END} sentences.")
    if not isinstance(entries, list) or not 1 <= len(entries) <= MOST_STEPS:
        raise WalkError(f"{name}: a walk has 1 to {MOST_STEPS} steps, each under [[step]].")
    steps = _steps(entries, name, known or {})
    if len({link for step in steps for link in step.links()}) > MOST_LINKS:
        raise WalkError(f"{name}: a walk has at most {MOST_LINKS} different links.")
    return Walk(name=name, title=title, steps=tuple(steps), end=tuple(end), trials=trials)


def _trials(entries: Any, name: str) -> tuple[WalkTrial, ...]:
    try:
        trials = msgspec.convert(entries, tuple[WalkTrial, ...])
    except msgspec.ValidationError as error:
        raise WalkError(f"{name}, trial: {_told(str(error))}") from error
    if len(trials) > MOST_TRIALS:
        raise WalkError(f"{name}: a walk has at most {MOST_TRIALS} scenes to try, each under [[trial]].")
    return trials


def _steps(entries: list[Any], name: str, known: KnownSteps) -> list[Step]:
    """Read the steps. WalkError has the first fault of each unreadable one."""
    steps, faults, ids = dict[int, Step](), dict[int, str](), set[str]()
    for i, entry in enumerate(entries, 1):
        try:
            step = _step(entry, f"{name}, step {i}", known, steps.get(i - 1))
            if step.id in ids:
                raise WalkError(f"{name}, step {i}: the id “{step.id}” was given to a step before.")
        except WalkError as error:
            faults[i] = str(error)
        else:
            ids.add(step.id)
            steps[i] = step
    if faults:
        raise WalkError(*faults.values(), by_step=faults, steps=steps)
    return list(steps.values())


def _step(entry: Any, where: str, known: KnownSteps, last: Step | None) -> Step:
    if not isinstance(entry, dict):
        raise WalkError(f"{where}: a step begins with [[step]].")
    poll = _poll(entry, last) if entry.get("poll") is True else {}
    given = {**poll, **_base(entry, where, known), **{key: value for key, value in entry.items() if key != "from"}}
    if isinstance(entry.get("id"), str):
        where += f" ({excerpt(entry['id'])})"
    try:
        step: Step = msgspec.convert(given, Step)
    except msgspec.ValidationError as error:
        raise WalkError(f"{where}, {_told(str(error))}") from error
    return step


def _poll(entry: dict[str, Any], last: Step | None) -> dict[str, Any]:
    """Return the fields that a poll may omit, because it asks about the picture of the previous step."""
    fields = {"kind": "choice", "fixed": True, "title": entry.get("question"), "explain": "There is no right answer."}
    if last is None or "state" in entry:
        return fields
    return {**fields, "state": last.shown, "cover": last.still, "still": last.still, "show": last.show}


def _base(entry: dict[str, Any], where: str, known: KnownSteps) -> dict[str, Any]:
    origin = entry.get("from")
    if origin is None:
        return {}
    if not isinstance(origin, str) or origin not in known:
        raise WalkError(f"{where}, from: “{excerpt(str(origin))}” is no step that is known.")
    fields = msgspec.to_builtins(known[origin])
    return dict(fields)


def _told(problem: str) -> str:
    """Return an error message of msgspec, with the field first."""
    match = PLACE.match(problem)
    what, field = (match["what"], match["field"]) if match else (problem, "")
    if "matching regex" in what:
        what = FORMS.get(field.partition("[")[0], what)
    return f"{field or 'its fields'}: {what[:1].lower()}{what[1:].rstrip('.')}."


def load_walks(folders: Iterable[Path]) -> dict[str, Walk]:
    """Return the built-in walks, then the walks from the folders' files, by name."""
    paths = [OWN / f"{name}.toml" for name in ORDER]
    for folder in folders:
        if not folder.is_dir():
            raise WalkError(f"{folder}: this is no folder of walks.")
        paths += sorted(folder.glob("*.toml"))
    walks: dict[str, Walk] = {}
    for path in paths:
        if path.stem in walks:
            raise WalkError(f"{path.name}: there is a walk “{path.stem}” already.")
        walks[path.stem] = load_walk(path, steps_of(walks.values()))
    return walks


def load_walk(path: Path, known: KnownSteps) -> Walk:
    """Return the walk of a file."""
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise WalkError(f"{path.name}: the file cannot be read as UTF-8 text.") from error
    return read_walk(text, path.stem, known)


def steps_of(walks: Iterable[Walk]) -> dict[str, Step]:
    """Return all steps of walks, by id."""
    return {step.id: step for walk in walks for step in walk.steps}
