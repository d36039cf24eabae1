"""Random combinations of extreme values of all scenes and parameters; malformed links and messages."""

from __future__ import annotations

import sys
from typing import Any

import param
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from components.layout.choices import options, word
from components.quantities.formatting import shortest
from components.quantities.parameters import Quantity
from components.scene import Scene
from components.scenes import SCENES

TINY, HUGE = sys.float_info.min, sys.float_info.max
EXTREMES = (5e-324, TINY, 1e-300, 1e-160, 1e-80, 1e-9, 1.0, 1e9, 1e80, 1e160, 1e300, HUGE)
NAMES = ("x1", "x2", "x1_p", "work", "verlet", "closed", "2", "99", "nothing")
AXES = ("t", "x", "w", "omega", "X", "X1", "v", "E", "p", "f", "none")
MOST_ROWS = 1250
"""Most rows in a piece, as in components.language.messages."""
COVERS = ("plot:x1", "plot:x2", "plot:response", "value:tau", "value:omega", "value:D", "plot:none")
ExtremeValues = dict[str, Any]
Message = dict[str, Any]


def values(scene: type[Scene]) -> SearchStrategy[ExtremeValues]:
    """Values of some parameters of a scene. Each value alone is possible."""
    each = {name: value(parameter) for name, parameter in scene.linked().items()}
    return st.fixed_dictionaries({}, optional=each)


def value(parameter: param.Parameter) -> SearchStrategy[Any]:
    if isinstance(parameter, Quantity):
        return number(parameter)
    if isinstance(parameter, param.List) and not isinstance(parameter, param.ListSelector):
        return st.lists(st.sampled_from(NAMES), max_size=4)
    return st.sampled_from(list(options(parameter).values()))


def number(quantity: Quantity) -> SearchStrategy[float | None]:
    """Values of a quantity: extremes, any double, and values near its slider's range."""
    extremes = [sign * size for sign in (1.0, -1.0) for size in EXTREMES]
    whole = quantity.scale == "count"
    around = st.floats(*quantity.softbounds)
    anything = st.floats(-HUGE, HUGE)
    if whole:
        around, anything = around.map(round).map(float), st.integers(1, 10**300).map(float)
    numbers = st.one_of(st.sampled_from([0.0, -0.0, *extremes]), anything, around)
    possible = numbers.filter(lambda found: quantity.refusal(found) is None)
    return st.none() | possible if quantity.allow_None else possible


def messages(scene: type[Scene]) -> SearchStrategy[list[Message]]:
    """Messages that a visitor may send in sequence, without measurements. Some are malformed."""
    kinds = [
        values(scene).map(_set),
        st.sampled_from(sorted(scene.linked())).flatmap(lambda name: _about(scene, name)),
        st.sampled_from(
            [{"type": "csv"}, {"type": "about"}, {"type": "cancel_fit"}, {"type": "run", "order": "cancel"}]
        ),
        st.sampled_from([scene, *SCENES.values()]).flatmap(_open),
        _rows(),
        records(),
        malformed(scene),
    ]
    acts = [{"type": "act", "name": name} for group in scene.groups for name, _ in group.actions]
    kinds += [st.sampled_from(acts)] if acts else []
    return st.lists(st.one_of(*kinds), min_size=1, max_size=5)


def _rows() -> SearchStrategy[Message]:
    """A piece of a measured record: any index, out of order, too large, with any value as a number."""
    sizes = st.sampled_from([0.0, -0.0, *EXTREMES, float("nan"), float("inf")]) | st.floats(-10, 10)
    columns = st.lists(sizes, max_size=40) | st.lists(st.floats(-1, 1), min_size=8, max_size=8).map(sorted)
    places = st.integers(0, 2) | st.integers(-5, 10**20)
    columns |= st.just([0.0] * (MOST_ROWS + 1))
    several = st.lists(columns, max_size=3) | columns | st.text(max_size=3)
    parts = {"type": st.just("rows"), "piece": places, "of": places, "t": columns, "columns": several}
    return st.fixed_dictionaries(parts, optional={"size": places})


def records() -> SearchStrategy[Message]:
    """A complete measured record of arbitrary numbers, which the server fits."""
    numbers = st.floats(-1e9, 1e9) | st.sampled_from([0.0, -0.0, 5e-324, 1e-300, 1e9])

    def rows(n: int) -> SearchStrategy[Message]:
        column = st.lists(numbers, min_size=n, max_size=n)
        parts = {"t": column.map(sorted), "columns": st.lists(column, min_size=1, max_size=2)}
        fixed = {"type": st.just("rows"), "piece": st.just(0), "of": st.just(1), **parts}
        return st.fixed_dictionaries(fixed, optional={"size": st.integers(1, 10), "derivative": st.integers(0, 2)})

    return st.integers(0, 40).flatmap(rows)


def _open(scene: type[Scene]) -> SearchStrategy[Message]:
    """Open a state, also of another scene, in a frame of any size."""
    sizes = st.sampled_from([0.1, 5.0, *EXTREMES]) | st.floats(0.0, HUGE, exclude_min=True)
    ends = st.just(0.0) | sizes | sizes.map(lambda size: -size)
    ranges = st.dictionaries(st.sampled_from(AXES), st.tuples(ends, ends), max_size=3)
    frames = st.fixed_dictionaries({}, optional={"ranges": ranges, "window": sizes, "scale": sizes, "speed": sizes})
    more = {
        "frame": st.none() | frames,
        "covered": st.lists(st.sampled_from(COVERS), max_size=2),
        "hidden": st.lists(st.sampled_from(NAMES), max_size=2),
    }
    parts = st.fixed_dictionaries({"parameters": values(scene).map(_in_words)}, optional=more)
    return parts.map(lambda state: {"type": "open", "state": {"scene": scene.slug, **state}})


def _in_words(given: ExtremeValues) -> ExtremeValues:
    """Return values as a state has them: words for booleans; hidden curves are left out, they have their own field."""
    return {name: word(v) if isinstance(v, bool) else v for name, v in given.items() if name != "hidden"}


def _set(given: ExtremeValues) -> Message:
    return {"type": "set", "values": {name: v for name, v in given.items() if isinstance(v, float)}}


def _about(scene: type[Scene], name: str) -> SearchStrategy[Message]:
    """Type or choose one parameter."""
    parameter = scene.linked()[name]
    if isinstance(parameter, Quantity):
        return value(parameter).map(lambda v: {"type": "typed", "name": name, "text": "" if v is None else shortest(v)})
    return value(parameter).map(lambda v: {"type": "choose", "name": name, "value": v})


def malformed(scene: type[Scene]) -> SearchStrategy[Message]:
    """Messages in which any part may be anything."""
    names = st.sampled_from([*scene.linked(), "name", "_state", "param", "__class__"]) | st.text(max_size=20)
    scalars = st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=80)
    deeper = st.lists(scalars, max_size=3) | st.dictionaries(names, scalars, max_size=3)
    junk = scalars | deeper | st.dictionaries(names, deeper, max_size=2)
    fields = ("values", "name", "text", "value", "order", "state", "number")
    kind = st.sampled_from(["set", "typed", "choose", "act", "open", "csv", "about"]) | junk
    return st.fixed_dictionaries({"type": kind}, optional=dict.fromkeys(fields, names | junk))


def queries(scene: type[Scene]) -> SearchStrategy[dict[str, list[bytes]]]:
    """Malformed links, with any text as name or value of a parameter."""
    names = st.sampled_from([*scene.linked(), "scene", "theme", "bokeh-token"]) | st.text(max_size=20)
    texts = st.text(max_size=80).map(lambda text: text.encode("utf-8", "replace")) | st.binary(max_size=80)
    told = st.sampled_from([b"1e999", b"-0", b"nan", b"inf", b"auto", b"", b",,,", b"1e-400", b"0x10", "١".encode()])
    return st.dictionaries(names, st.lists(texts | told, min_size=1, max_size=2), max_size=6).map(
        lambda found: {"scene": [scene.slug.encode()], **found}
    )
