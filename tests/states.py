"""Any state of any scene, for property tests.

`links()` draws a `Link`, the parsed form of an address, which `opened(SCENES, link)` accepts. `state_of(link)` is the
page state of the link. Numbers span many decades around the sliders, with zeros, equal values, resonances and critical
damping in between.

    @given(links())
    def test_something(link: Link) -> None:
        now = state_of(link)  # skips a link that the scene refuses
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import Any

import param
from hypothesis import assume
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from components.chain.parameters import CHAIN
from components.language.state import Frame
from components.layout.choices import options
from components.quantities.axes import TIME_AXIS
from components.quantities.parameters import AnyParameter, Quantity
from components.scene import Scene
from components.scenes import SCENES
from components.session.links import page_state_of
from components.state.compared import HIDDEN, WINDOW, holdable
from components.state.covers import NEXT, coverable
from components.state.link import Link
from components.state.page_state import PageState
from components.state.scene_sheet import plots
from physics.coupled import TwoMassChain

DECADES = 6.0
"""Decades beyond the end of a slider, and below it, that numbers reach."""
STEPS = 1000
"""Steps of a slider."""
NEARLY = (1e-15, -1e-15, 1e-12, 1e-9, -1e-9, 1e-6, 1e-4, -1e-4, 1e-2, -1e-2)
"""Relative distances from an exact resonance, critical damping or equality."""
PAIRS = (("m1", "m2"), ("k1", "k2"), ("c1", "c2"), ("x1_0", "x2_0"), ("v1_0", "v2_0"))
Values = dict[str, Any]


def links(scene: type[Scene] | None = None, decades: float = DECADES) -> SearchStrategy[Link]:
    """States of one scene or of all: values, frame, hidden items, the compared state, and the state before a
    prediction.
    """
    if scene is None:
        return st.sampled_from(list(SCENES.values())).flatmap(lambda one: links(one, decades))
    known = holdable(scene).keys() - {WINDOW}
    others = st.none() | values(scene, decades).map(
        lambda given: {name: given[name] for name in given if name in known}
    )
    parts = {"frame": st.none() | frames(scene), "covered": covers(scene), "held": others}
    return st.builds(Link, st.just(scene.slug), values(scene, decades), **parts).flatmap(
        # There is a state before the change only on a page that hides the next change.
        lambda link: others.map(lambda before: replace(link, before=before if NEXT in link.covered else None))
    )


def state_of(link: Link) -> PageState:
    """The page state of a link. Skips the example if the scene refuses any part of the link."""
    now, refused = page_state_of(SCENES[link.slug], link)
    assume(not refused)
    return now


@st.composite
def values(draw: st.DrawFn, scene: type[Scene], decades: float = DECADES) -> Values:
    """Values of some parameters: a preset or none, other numbers and choices on top, and some special relations."""
    presets = [{}, *(dict(scene.preset_all(label)) for label in scene.presets)]
    each = {name: value(scene, name, decades) for name in scene.linked()}
    found: Values = {**draw(st.sampled_from(presets)), **draw(st.fixed_dictionaries({}, optional=each))}
    for _ in range(draw(st.integers(0, 3))):
        relations = list(special({**scene.parameters(), **found}))
        if relations:
            related, off = draw(st.sampled_from(relations)), draw(st.just(0.0) | st.sampled_from(NEARLY))
            near = {name: one * (1 + off) if isinstance(one, float) else one for name, one in related.items()}
            found |= {name: one for name, one in near.items() if _is_possible(scene.linked()[name], one)}
    return found


def value(scene: type[Scene], name: str, decades: float = DECADES) -> SearchStrategy[Any]:
    """Values of one parameter."""
    parameter = scene.linked()[name]
    if isinstance(parameter, Quantity):
        return number(parameter, decades)
    if name == HIDDEN:
        return st.lists(st.sampled_from(_groups(scene)), max_size=3, unique=True)
    if isinstance(parameter, param.List) and not isinstance(parameter, param.ListSelector):
        return st.lists(st.sampled_from(parameter.default or [""]), max_size=2, unique=True)
    return st.sampled_from(list(options(parameter).values()))


def number(quantity: Quantity, decades: float = DECADES) -> SearchStrategy[float | None]:
    """Values of a quantity: on its slider, log-uniform around it, 0, and None if the scene may choose the value."""
    low, high = quantity.softbounds
    if quantity.scale == "count":
        return st.integers(int(low), int(10 * high)).map(float)
    largest = max(abs(low), abs(high))
    most = min(largest * 10**decades, *(abs(end) for end in (quantity.bounds or ())[1:] if end is not None), math.inf)
    size = logarithmic(largest * 10**-decades, most)
    signed = size | size.map(lambda one: -one) if quantity.refusal(-0.5 * largest) is None else size
    slider = st.integers(0, STEPS).map(lambda step: low + (high - low) * step / STEPS)
    possible = (st.just(0.0) | signed | slider).filter(lambda one: quantity.refusal(one) is None)
    return st.none() | possible if quantity.allow_None else possible


def logarithmic(low: float, high: float) -> SearchStrategy[float]:
    """Numbers of four digits between two positive limits, log-uniform."""
    return st.floats(math.log10(low), math.log10(high)).map(lambda power: float(f"{10**power:.4g}"))


def special(own: Values) -> Iterator[Values]:
    """Yield values for which something is equal, opposite, resonant or critically damped."""
    for one, other in PAIRS:
        if {one, other} <= own.keys():
            yield {other: own[one]}
            if one[0] in "xv":
                yield {other: -own[one]}
    naturals = list(_natural(own))
    if "omega" in own:
        yield from ({"omega": omega} for omega in naturals)
    if "zeta" in own:
        yield {"zeta": 1.0, "keep": "zeta"}
    elif "damping" in own:
        yield {"c": 2 * math.sqrt(own["m2"]) * math.sqrt(own["k2"]), "damping": "added"}
    if "c1" in own:  # dashpots in proportion to the springs: one mode is critically damped
        for omega in filter(None, naturals):
            yield {"c1": 2 * own["k1"] / omega, "c2": 2 * own["k2"] / omega}


def _natural(own: Values) -> Iterator[float]:
    """Yield the natural frequencies in rad/s, and the frequency at which mass 1 of a chain is at rest."""
    if {"m", "k"} <= own.keys():
        yield math.sqrt(own["k"]) / math.sqrt(own["m"])
    if set(CHAIN) <= own.keys():
        yield from TwoMassChain(**{name: own[name] for name in CHAIN}).modes().omega.tolist()
        yield math.sqrt(own["k2"]) / math.sqrt(own["m2"])


def frames(scene: type[Scene]) -> SearchStrategy[Frame]:
    """Frames that a link asks for: other ranges of some axes, another window, scale and speed."""
    axes = {name: axis.chosen for name, axis in scene().shown.axes.items()}
    window = axes.pop(TIME_AXIS, (0.0, 1.0))[1]
    shift = st.floats(-2, 2)
    ranges = {name: st.tuples(shift, shift).map(lambda by, ends=ends: _moved(ends, by)) for name, ends in axes.items()}
    sizes = {
        "window": logarithmic(window / 1e3, window * 1e3),
        "scale": logarithmic(1e-3, 1e3),
        "speed": logarithmic(1e-3, 1e3),
    }
    some = st.fixed_dictionaries({}, optional=ranges).map(
        lambda found: {name: span for name, span in found.items() if span[0] != span[1]}
    )
    return st.builds(
        Frame, ranges=some, given=st.just(True), **{name: st.none() | size for name, size in sizes.items()}
    )


def _moved(ends: tuple[float, float], by: tuple[float, float]) -> tuple[float, float]:
    whole = ends[1] - ends[0]
    return ends[0] + by[0] * whole, ends[1] + by[1] * whole


def covers(scene: type[Scene]) -> SearchStrategy[tuple[str, ...]]:
    """Names of items that are hidden until a prediction is made; mostly none."""
    return st.just(()) | st.lists(st.sampled_from(_coverable(scene)), max_size=4, unique=True).map(tuple)


@cache
def _coverable(scene: type[Scene]) -> list[str]:
    return sorted(coverable(scene, scene().shown))


@cache
def _groups(scene: type[Scene]) -> list[str]:
    """Return the groups of curves that can be switched off."""
    found = {drawn.group for plot in plots(scene) for drawn in (*plot.curves, *plot.regions) if drawn.group}
    return sorted(found | set(scene.param[HIDDEN].default)) or [""]


def _is_possible(parameter: AnyParameter, one: Any) -> bool:
    return not isinstance(parameter, Quantity) or parameter.refusal(one) is None
