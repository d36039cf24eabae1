"""The docstring of a scene, generated from its declaration: parameters with units and limits, presets, numbers."""

from __future__ import annotations

from collections.abc import Iterator

import param

from components.quantities.parameters import AnyParameter, Quantity
from components.scene.scene_info import SceneInfo


def documented(kind: type[SceneInfo]) -> str:
    """Return the docstring of a scene, in the style of NumPy."""
    lines = [f"{kind.headline}.", "", f"Source: {kind.lecture}, {kind.points}.", "", "Parameters", "----------"]
    for name, one in kind.linked().items():
        lines += _parameter(name, one)
    lines += ["", "Attributes", "----------"]
    for name, text in ATTRIBUTES.items():
        lines += [name, f"    {text}"]
    presets = ", ".join(f'"{label}"' for label in kind.presets)
    return "\n".join([*lines, "", "Notes", "-----", *kind.equations, "", f"Presets: {presets}."])


ATTRIBUTES = {
    "numbers : dict": "The numbers that the scene shows, as floats in SI units: `.value`, `.unit`, `.description`.",
    "sources : dict": "The numbers of the curves in SI units, a `ColumnDataSource` each.",
    "presets : dict": "Values of parameters by label; `scene.param.update(**scene.presets[label])` sets them.",
}


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
