"""Every name that a sheet speaks of is in the picture, in every scene, preset and view: nothing is misspelt."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import param
import pytest

from components.scene import Scene
from components.scenes import SCENES
from components.scenes.accuracy.recorded import recorded
from components.state.scene_sheet import scene_sheet
from components.state.standing import fitted
from physics.accuracy import SYSTEMS
from tests.page.names import Names, missing, names

scenes = pytest.mark.parametrize("slug", SCENES)

MEASURED = {slug: (SYSTEMS[slug], 1.0, recorded(slug).runs.every, "done") for slug in ("near", "dashpot")}
"""An easy motion, and the one on which the implicit solvers are quick."""
# What else brings something to the picture: fast motions are drawn as bands, some marks need their case.
MORE: dict[str, list[dict[str, Any]]] = {
    "oscillator": [{"window": 1e4}],
    "energy": [
        {"window": 1e4},
        {"datum": "separate", "window": 1e4},
        {"g": 1.62},
        {"g": 24.8, "k": 150.0},
        {"k": 200.0, "g": 3.7},
    ],
    "analogues": [{"window": 1e4}, {"system": "spring", "window": 1e4}],
    "phugoid": [{"window": 1e6}, {"show": "lift", "window": 1e6}],
    "damped": [{"window": 1e4}, {"k": 0.0}, {"c": 40.0}],
    "driven": [{"window": 1e4}, {"F_0": 0.0}, {"c": 1e-3}],
    "coupled": [{"window": 1e4}],
    "modes": [
        {"task": "hunt", "answer": "shown"},
        {"task": "solve", "c1": 0.1, "c2": 0.2},
        {"task": "solve", "c1": 20.0, "c2": 20.0},
        *({"task": "sweep", "swept": name} for name in ("m1", "m2", "k1", "k2")),
    ],
    "absorber": [{"omega": 50.0001, "tuning": "free"}],
    "forced": [{"window": 1e4}, {"omega": 0.6180339887498949 + 2e-5, "window": 2e5}],
    "accuracy": [
        *({"view": "growth", "wanted": 1.0, "hidden": [], "system": slug} for slug in MEASURED),
        {"limit": 0.01},
        {"view": "growth", "equal": "cost"},
        *({"measured": runs, "system": slug} for slug, runs in MEASURED.items()),
    ],
}
# Which side of its point the name of a method stands on depends on what was measured; both are made from one list.
BY_MEASUREMENT = {"accuracy": ("_start", "_end")}


def cases(scene: type[Scene]) -> Iterator[Scene]:
    """The scene as it opens, each preset, each option of each choice, and what MORE names."""
    yield scene()
    for values in scene.presets.values():
        yield scene(**values)
    for name, parameter in scene.linked().items():
        if isinstance(parameter, param.Boolean):
            yield from (scene(**{name: value}) for value in (False, True))
        elif isinstance(parameter, param.Selector) and not isinstance(parameter, param.ListSelector):
            yield from (scene(**{name: value}) for value in parameter.get_range().values())
    yield from (scene(**values) for values in MORE.get(scene.slug, []))


@scenes
def test_what_is_spoken_of_is_there(slug: str) -> None:
    found = Names()
    for scene in cases(SCENES[slug]):
        assert missing(scene) == [], fitted(scene).state
        own = names(scene)
        found.spoken |= own.spoken
        found.given |= own.given
    never = {name for name in found.spoken - found.given if not name[1].endswith(BY_MEASUREMENT.get(slug, ()))}
    assert never == set()


@scenes
def test_what_is_read_aloud_is_there(slug: str) -> None:
    given = [scene.shown.values for scene in cases(SCENES[slug])]
    for text in scene_sheet(SCENES[slug]).spoken.values():
        wanted = set(re.findall(r"\{(\w+)\}", text))
        assert wanted and any(all(values.get(name) for name in wanted) for values in given), text


@pytest.mark.parametrize(("part", "name"), [("signals", "x1"), ("values", "tick"), ("scalars", "metre")])
def test_a_misspelt_name_is_found(part: str, name: str) -> None:
    scene = SCENES["coupled"]()
    whole = getattr(scene.shown, part)
    misspelt = {f"{key}_" if key == name else key: value for key, value in whole.items()}
    vars(scene)["_shown"] = replace(scene.shown, **{part: misspelt})
    with pytest.raises(AssertionError, match=rf"\W{name}\W"):
        assert missing(scene) == []
