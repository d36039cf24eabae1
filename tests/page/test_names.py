"""Names in the sheet exist in every scene, preset and view: shapes are drawn, forms have texts, names are unique."""

import re
from functools import cache
from typing import Any

import pytest

from components.language.blocks import ChoiceBlock
from components.language.text import Forms
from components.layout.choices import stated
from components.layout.sheet import blocks, in_force
from components.scene import Scene
from components.scene.traces import BAND
from components.scenes import SCENES
from components.scenes.accuracy.recorded import recorded
from components.state.scene_sheet import plots, scene_sheet
from physics.integrators.accuracy import SYSTEMS
from tests.page.hand import draw, grabs, sets
from tests.scenes.checks import choices

scenes = pytest.mark.parametrize("slug", SCENES)

NEAR = {"measured": (SYSTEMS["near"], 1.0, recorded("near").runs.every, "done"), "system": "near"}
MORE: dict[str, list[dict[str, Any]]] = {
    "energy": [{"datum": "separate", "window": 1e4}],
    "phugoid": [{"view": "lift", "window": 1e6}],
    "damped": [{"k": 0.0}, {"c": 40.0}],
    "driven": [{"F_0": 0.0}, {"c": 1e-3}, {"omega": 0.2}],
    "modes": [{"view": "hunt", "answer": "shown"}, *({"view": "roots", "c1": c, "c2": c} for c in (0.1, 5.0, 20.0))],
    "absorber": [{"omega": 50.0001, "tuning": "free"}, {"view": "rest", "x1_0": 0.01}],
    "forced": [
        {"omega": 0.6180339887498949 + 2e-5, "window": 2e5},
        *({"view": view, "c1": 0.1, "c2": 0.1} for view in ("bode", "nyquist")),
    ],
    "accuracy": [
        {"view": "growth", "wanted": 1.0, "hidden": [], "system": "near"},
        *({"limit": 0.01}, {"view": "growth", "equal": "cost"}, NEAR),
    ],
}
"""Values that add items to a picture: fast motions are drawn as bands, and some marks need their case."""


@cache
def every(slug: str) -> list[Scene]:
    """The scene as it opens, with each preset, each option of each choice, bands, and the values of MORE."""
    scene = SCENES[slug]
    bands = [{"window": 1e4}] if "window" in scene.linked() else []
    return [scene.at(values) for values in ({}, *scene.presets.values(), *choices(scene), *bands, *MORE.get(slug, []))]


@scenes
def test_every_curve_has_its_numbers_and_every_block_is_visible(slug: str) -> None:
    """Each is drawn in some picture; a wrong source or form name never is. Bands appear for fast motions."""
    numbers = {
        (source, name)
        for scene in every(slug)
        for source, columns in scene.shown.sources.items()
        for name, column in columns.items()
        if len(column)
    }
    for plot in plots(SCENES[slug]):
        needed = {(one.source, name) for one in plot.curves for name in (one.x, one.y)}
        needed |= {(one.source, name) for one in plot.regions for name in (one.x, one.low, one.high)}
        assert {one for one in needed if one[0] != BAND} - numbers == set()
    standing = {name for scene in every(slug) for name, form in scene.shown.forms.items() if form}
    sheet = scene_sheet(SCENES[slug])
    assert {one.form for one in (*blocks(sheet.paper), *sheet.panel.groups) if one.form} <= standing


@scenes
def test_every_shape_is_drawn_and_each_form_has_its_words(slug: str) -> None:
    """The page's own scripts draw the shapes; a number missing from the picture is an error."""
    for scene in every(slug):
        sheet, shown = scene_sheet(type(scene)), scene.shown
        visible = list(in_force(sheet.paper, shown.forms))
        shapes = [shape for block in visible for shape in getattr(block, "shapes", ())]
        rows = [row for group in sheet.panel.groups for row in group.rows]
        shapes += [shape for row in rows for part in getattr(row, "pictures", {}).values() for shape in part]
        draw(type(scene), shown, shapes)
        for block in visible:
            cells = (cell for row in getattr(block, "rows", ()) for cell in row)
            for one in (*getattr(block, "items", ()), *cells, *getattr(block, "heading", ())):
                variant = shown.forms.get(one.name if isinstance(one, Forms) else one.form)
                assert not variant or variant in one.variants, (one, variant)


@scenes
def test_names_in_a_sheet_are_those_of_its_scene(slug: str) -> None:
    """Sliders, marks, buttons and drags set parameters; the term of a heading has the group of a curve that it
    switches; a preset has a sentence and sets all that presets set; what is read aloud is in some picture.
    """
    scene = SCENES[slug]
    named = [block.name for block in blocks(scene.sheet()) if isinstance(block, ChoiceBlock)]
    named += [name for _, grab in grabs(scene) for name in (*sets(grab), *(begin.parameter for begin in grab.start))]
    for plot in plots(scene):
        named += [handle.parameter for handle in plot.handles] + [mark.set for mark in plot.marks if mark.set]
        actions = {mark.act for mark in plot.marks if mark.act}
        assert actions <= {name for group in scene.groups for name, _ in group.actions}
        assert {term.curve for term in plot.heading} <= {"", *(one.group for one in (*plot.curves, *plot.regions))}
    assert set(named) <= scene.parameters().keys()
    assert list(scene.watch) == list(scene.presets)
    for button in scene_sheet(scene).panel.presets:
        assert button.sets == {name: stated(one) for name, one in scene.preset_all(button.label).items()}
    for values in scene.presets.values():
        one = scene(**values)
        assert {*one.shown.spans, *one.units()} <= scene.quantities()
        assert one.derived() <= scene.parameters().keys()
    for text in scene_sheet(scene).spoken.values():
        wanted = re.findall(r"\{(\w+)\}", text)
        assert wanted and any(all(one.shown.values.get(name) for name in wanted) for one in every(slug)), text
