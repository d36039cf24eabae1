"""A link carries the scene and what differs from its default: into and out of the query of an address."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any
from urllib.parse import urlencode

import param

from components.choices import chosen, word
from components.numbers import MINUS, exact, excerpt, parse_number
from components.parameters import Quantity

if TYPE_CHECKING:
    from components.scene import Scene

FOREIGN_KEYS = ("bokeh-", "panel-")
PAGE_KEYS = frozenset({"theme", "projector"})
MOST_PROBLEMS = 8
AUTOMATIC = "auto"
"""The word of a quantity that the scene chooses itself."""


@dataclass(frozen=True)
class Link:
    """What a query asks for: a scene, its values, and a sentence for each part that is refused."""

    slug: str
    values: dict[str, Any] = field(default_factory=dict)
    problems: list[str] = field(default_factory=list)


def read_query(args: Mapping[str, Sequence[bytes]], scenes: Mapping[str, type[Scene]]) -> Link:
    """Read a query key by key: what is good is kept, what is bad is named. Without a scene: the first one."""
    slug, problems = _read_slug(args.get("scene", ()), scenes)
    known = link_parameters(scenes[slug])
    values: dict[str, Any] = {}
    for key, given in args.items():
        if key == "scene" or key in PAGE_KEYS or key.startswith(FOREIGN_KEYS):
            continue
        try:
            values[key] = _read(known, key, given)
        except ValueError as error:
            problems.append(str(error))
    return Link(slug, values, _shortened(problems))


def write_query(scene: Scene) -> str:
    """The text after the question mark that brings `scene` back.

    Its slug comes first, then what differs from the default, in the order of the scene's parameters; numbers
    are the shortest text that reads back as the same double.
    """
    values = {name: getattr(scene, name) for name in link_parameters(type(scene))}
    changed = {name: value for name, value in values.items() if value != type(scene).param[name].default}
    return urlencode({"scene": scene.slug} | {name: _written(value) for name, value in changed.items()}, safe=",:")


def link_parameters(scene_class: type[Scene]) -> dict[str, param.Parameter]:
    """The parameters that a link may carry: quantities, choices and lists, unless constant or private."""
    kinds = (Quantity, param.Selector, param.Boolean, param.List)
    return {
        name: parameter
        for name, parameter in scene_class.param.objects("existing").items()
        if isinstance(parameter, kinds) and not parameter.constant and not name.startswith("_")
    }


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


def _read(known: Mapping[str, param.Parameter], key: str, given: Sequence[bytes]) -> object:
    """The value of one key; ValueError, naming the key, where it has none."""
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
        return exact(value)
    return ",".join(map(word, value)) if isinstance(value, list) else word(value)


def _shortened(problems: list[str]) -> list[str]:
    left_out = len(problems) - MOST_PROBLEMS
    if left_out <= 0:
        return problems
    return [*problems[:MOST_PROBLEMS], f"{left_out} more parts of this link are refused."]
