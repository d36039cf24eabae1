"""The docstring of a scene, generated from its declaration: parameters with units and limits, presets, numbers."""

from __future__ import annotations

from collections.abc import Iterator

import param

from components.quantities.parameters import AnyParameter, Quantity
from components.scene.scene_info import SceneInfo


def documented(kind: type[SceneInfo]) -> str:
    """Return the docstring of a scene, in the style of NumPy."""
    parameters = [line for name, one in kind.linked().items() for line in _parameter(name, one)]
    presets = ", ".join(f'"{label}"' for label in kind.presets)
    sections = {
        "Parameters": parameters,
        "Raises": RAISES,
        "Attributes": ATTRIBUTES,
        "Methods": METHODS,
        "Notes": [*kind.equations, "", f"Presets: {presets}."],
        "Examples": _example(kind),
    }
    lines = [f"{kind.headline}.", "", f"Source: {kind.lecture}, {kind.points}."]
    for title, text in sections.items():
        lines += ["", title, "-" * len(title), *text]
    return "\n".join(lines)


RAISES = ["ValueError", "    If a value is not possible. The scene is then unchanged."]
ATTRIBUTES = [
    "numbers : dict",
    "    The numbers that the scene shows, as floats in SI units: `.value`, `.unit`, `.description`.",
    "sources : dict",
    "    The numbers of the curves in SI units, a `ColumnDataSource` each.",
    "presets : dict",
    "    Values of parameters by label; `scene.param.update(**scene.presets[label])` sets them.",
]
METHODS = [
    "frame(source)",
    "    Return the numbers of a source or of a plot as columns with units, for `pandas.DataFrame`.",
    "set(values)",
    "    Set several parameters at once.",
    "panel()",
    "    Return Panel widgets for the parameters, and live Bokeh figures.",
]


def _example(kind: type[SceneInfo]) -> Iterator[str]:
    """The lines of a doctest that sets the scene's first quantity."""
    name, first = next((name, one) for name, one in kind.linked().items() if isinstance(one, Quantity) and one.default)
    yield ">>> from components.scenes import SCENES"
    yield f'>>> scene = SCENES["{kind.slug}"]({name}={first.default!r})'
    yield ">>> numbers, columns = scene.numbers, scene.frame()"


def _parameter(name: str, one: AnyParameter) -> Iterator[str]:
    """The lines on one parameter: its type, unit, limits and default."""
    label = one.label or name
    if isinstance(one, Quantity):
        yield f"{name} : float, {one.unit or 'a pure number'}" + (", or None" if one.allow_None else "")
        yield f"    {_sentence(label)} {_sentence(one.allowed)} The default is {one.default}."
    elif isinstance(one, param.Selector):
        words = ", ".join(repr(word) for word in one.objects)
        yield f"{name} : str"
        yield f"    {_sentence(label)} One of {words}. The default is {one.default!r}."
    else:
        yield f"{name} : {'bool' if isinstance(one, param.Boolean) else 'list of str'}"
        yield f"    {_sentence(one.doc or label)} The default is {one.default!r}."


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}".rstrip(".") + "."
