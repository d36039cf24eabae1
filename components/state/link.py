"""Links: the state of a page, written into and read from the query of an address.

A link has the scene, the parameters that differ from their defaults, the parts of the frame that are not fitted
(frame.x=-2,2 is a range, frame.window a time window), the curves switched off, the covers (cover=plot:x2,value:tau),
and the parameters of the compared scene: held.k=20, or held=default if all have their defaults. The parameters from
before a predicted change are written the same way: before.k=20. A list of parts, show=stage,plot:x, replaces the view.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN, Context
from functools import lru_cache
from urllib.parse import urlencode

from msgspec.structs import replace

from components.language.state import Frame, State
from components.layout.choices import chosen, word
from components.layout.views import parts
from components.quantities.axes import Range, ordered
from components.quantities.formatting import MINUS, excerpt, parse_number, shortest
from components.quantities.parameters import AnyParameter, Quantity, Values
from components.scene import Scene
from components.scene.frames import FITTED, SIZES, checked
from components.scene.scene import VIEW
from components.state.compared import HIDDEN, holdable

FOREIGN_KEYS = ("bokeh-", "panel-")
PAGE_KEYS = frozenset({"theme", "projector", "walk", "step", "seed"})
MOST_PROBLEMS = 8
MOST_NAMES = 200
COVER, SHOW = "cover", "show"
FRAME, GIVEN = "frame.", Frame(given=True)
HELD, BEFORE = "held", "before"
DEFAULT = "default"
DIGITS = 4
"""Digits of numbers of a frame in a link. Narrow ranges get more digits, so that their ends differ."""
MOST_RANGES = 1000
"""Number of ranges whose texts a process remembers."""
MOST_ROOM = 1.02
"""Factor by which a range may be widened so that it needs fewer digits."""
AUTOMATIC = "auto"
"""The word in a link for a quantity that the scene chooses itself."""


@dataclass(frozen=True)
class Link:
    """A parsed query: a scene, its values, the covers, and a sentence for each rejected part.

    `frame` has only some parts of the frame; the others are fitted. It is None if the link names no part.
    """

    slug: str
    values: Values = field(default_factory=dict)
    problems: list[str] = field(default_factory=list)
    frame: Frame | None = None
    covered: tuple[str, ...] = ()
    held: Values | None = None
    before: Values | None = None
    show: tuple[str, ...] = ()

    def as_opened(self, scenes: Mapping[str, type[Scene]]) -> Link:
        """Return the link of a state; missing parts have the value with which the scene opens."""
        bare = self == Link(self.slug)
        return Link(self.slug, scenes[self.slug].opens) if bare else self


def read_query(args: Mapping[str, Sequence[bytes]], scenes: Mapping[str, type[Scene]]) -> Link:
    """Parse a query. Valid keys are used, invalid ones are reported. The default scene is the first one."""
    slug, problems = _read_slug(args.get("scene", ()), scenes)
    kind, known = scenes[slug], scenes[slug].linked()
    values: dict[str, object] = {}
    show: tuple[str, ...] = ()
    others: dict[str, Values | None] = {HELD: None, BEFORE: None}
    frame: Frame | None = None
    covered: tuple[str, ...] = ()
    for key, given in args.items():
        if key == "scene" or key in PAGE_KEYS or key.startswith(FOREIGN_KEYS):
            continue
        try:
            if key == COVER:
                covered = _read_names(COVER, _only(key, given))
            elif view := _old_view(kind, key, given):
                values[VIEW] = view
            elif key == SHOW and key not in known:
                show = _read_parts(kind, _read_names(SHOW, _only(key, given)))
            elif key.startswith(FRAME):
                frame = _with_part(frame or GIVEN, key.removeprefix(FRAME), _only(key, given))
            elif (other := key.partition(".")[0]) in others:
                others[other] = {**(others[other] or {}), **_read_other(kind, key, given)}
            else:
                values[key] = _read(known, key, given)
        except ValueError as error:
            problems.append(str(error))
    if kind.old_view and VIEW not in values and (values or frame or covered or any(others.values())):
        values[VIEW] = kind.old_view
    return Link(slug, values, _shortened(problems), frame, covered, others[HELD], others[BEFORE], show)


def _old_view(scene: type[Scene], key: str, given: Sequence[bytes]) -> str:
    """Return the view that an old link chooses by another parameter, "" for none."""
    return scene.old_views.get(key, {}).get(_only(key, given), "") if key in scene.old_views else ""


def write_query(state: State, scene: type[Scene]) -> str:
    """Return the text after the question mark of a link to a state.

    The slug of the scene comes first, then the view and everything that differs from the default, then the frame.
    Numbers have as many digits as are needed to read back the same double.
    """
    view = {VIEW: scene.views[0].slug} if scene.views else {}
    own = view | state.parameters | ({} if state.hidden is None else {HIDDEN: list(state.hidden)})
    written = {"scene": scene.slug} | {name: _written(own[name]) for name in scene.linked() if name in own}
    written |= _frame_parts(state.frame or FITTED)
    for which, others in ((HELD, state.held), (BEFORE, state.before)):
        if others is not None:
            written |= {f"{which}.{name}": _written(value) for name, value in others.items()} or {which: DEFAULT}
    if len(written) == 1 and not state.covered:  # a link with only the scene opens it with `Scene.opens`
        written |= {name: _written(scene.param[name].default) for name in scene.opens}
    lists = {SHOW: state.show, COVER: state.covered}
    return urlencode(written | {key: ",".join(names) for key, names in lists.items() if names}, safe=",:")


def step_query(step: str) -> str:
    """Return the query that opens a step of a walk, "d34/d34-07", or "d34/d34-07/5" with the numbers of a seed."""
    return urlencode(dict(zip(("walk", "step", "seed"), step.split("/"), strict=False)))


def _frame_parts(frame: Frame) -> dict[str, str]:
    ranges = {FRAME + name: _range_text(span) for name, span in frame.ranges.items()}
    sizes = {name: getattr(frame, name) for name in SIZES}
    return ranges | {FRAME + name: shortest(_towards(size, ROUND_HALF_EVEN)) for name, size in sizes.items() if size}


@lru_cache(MOST_RANGES)
def _range_text(span: Range) -> str:
    """Return a range as text. Cached, because most changes keep the frame."""
    return ",".join(map(shortest, _brief(span)))


def _brief(span: Range) -> Range:
    """Return a range with few digits that contains the given one."""
    low, high = ordered(span)
    wide = _towards(low, ROUND_FLOOR), _towards(high, ROUND_CEILING)
    if wide[1] - wide[0] > MOST_ROOM * (high - low):
        return span
    return wide if span[0] < span[1] else wide[::-1]


def _towards(value: float, way: str) -> float:
    brief = float(Context(prec=DIGITS, rounding=way).create_decimal(shortest(value)))
    return brief if math.isfinite(brief) else value


def _read_other(scene: type[Scene], key: str, given: Sequence[bytes]) -> dict[str, object]:
    """Set the value of one key in the compared scene, or in the scene before a change."""
    which, dot, name = key.partition(".")
    if dot:
        return {name: _read(holdable(scene), name, given)}
    if _only(key, given) != DEFAULT:
        raise ValueError(f"{which}: write {which}={DEFAULT}, or {which}. before a parameter.")
    return {}


def _with_part(frame: Frame, name: str, text: str) -> Frame:
    """Return the frame with one more part, read from a link."""
    try:
        part = {name: parse_number(text)} if name in SIZES else {"ranges": {**frame.ranges, name: _range(text)}}
        return checked(replace(frame, **part))
    except ValueError as error:
        raise ValueError(f"{FRAME}{excerpt(name)}: {error}") from error


def _range(text: str) -> tuple[float, float]:
    ends = text.split(",")
    if len(ends) != 2:
        raise ValueError(f"“{excerpt(text)}” is not a range: give two numbers, such as -1,1.")
    return parse_number(ends[0]), parse_number(ends[1])


def _read_names(key: str, text: str) -> tuple[str, ...]:
    names = tuple(dict.fromkeys(name for name in text.split(",") if name))
    if len(names) > MOST_NAMES:
        raise ValueError(f"{key}: give at most {MOST_NAMES} names.")
    return names


def _read_parts(scene: type[Scene], names: tuple[str, ...]) -> tuple[str, ...]:
    known = parts(scene.sheet())
    if unknown := next((name for name in names if name not in known), None):
        raise ValueError(f"{SHOW}: “{excerpt(unknown)}” is not possible: choose from {', '.join(known)}.")
    return names


def _read_slug(given: Sequence[bytes], scenes: Mapping[str, type[Scene]]) -> tuple[str, list[str]]:
    first = next(iter(scenes))
    if not given:
        return first, []
    try:
        slug = _only("scene", given)
    except ValueError as error:
        return first, [str(error)]
    if slug in scenes:
        return slug, []
    return first, [f"scene: “{excerpt(slug)}” is not a scene: choose one of {', '.join(scenes)}."]


def _read(known: Mapping[str, AnyParameter], key: str, given: Sequence[bytes]) -> object:
    """Return the value of one key. Raises ValueError, with the key, if it is not possible."""
    if key not in known:
        raise ValueError(f"“{excerpt(key)}” is not a parameter of this scene.")
    parameter = known[key]
    text = _only(key, given)
    try:
        return _read_quantity(parameter, text) if isinstance(parameter, Quantity) else chosen(parameter, text)
    except ValueError as error:
        raise ValueError(f"{key}: {error}") from error


def _read_quantity(quantity: Quantity, text: str) -> float | None:
    if quantity.allow_None and text.strip() in ("", AUTOMATIC):
        return None
    value = parse_number(text)
    refusal = quantity.refusal(value, excerpt(text.strip()).replace("-", MINUS))
    if refusal:
        raise ValueError(refusal)
    return value


def _only(key: str, given: Sequence[bytes]) -> str:
    if len(given) != 1:
        raise ValueError(f"{key} is given {len(given)} times: give it once.")
    return given[0].decode("utf-8", errors="replace")


def _written(value: object) -> str:
    if value is None:
        return AUTOMATIC
    if isinstance(value, float):
        return shortest(value)
    return ",".join(map(word, value)) if isinstance(value, list) else word(value)


def _shortened(problems: list[str]) -> list[str]:
    left_out = len(problems) - MOST_PROBLEMS
    if left_out <= 0:
        return problems
    return [*problems[:MOST_PROBLEMS], f"{left_out} more parts of this link are refused."]
