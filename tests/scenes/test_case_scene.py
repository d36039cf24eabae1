"""A scene made of a case and its paper, tested with variants of the damped scene."""

from typing import Any

import pytest

from components.language.blocks import Block
from components.layout.sheet import column
from components.layout.stage import line
from components.paper.deferred import Attributes, deferred
from components.paper.plot_axes import TIME, axis
from components.paper.plots import Plot, curve, words
from components.scene.case import CaseScene
from components.scenes.damped import Damped
from components.scenes.damped.case import DampedCase, DampedShown

value = Attributes(DampedCase)
X = Plot("x", TIME, axis("m", lambda c: (-1.0, 1.0)))


def variant(shown: type[Any], *blocks: Block) -> type[CaseScene]:
    """The damped scene with another case, and these blocks as its paper."""

    class Variant(Damped):
        case, paper, views, groups = shown, staticmethod(lambda: column(*blocks)), (), ()

    return Variant


def test_a_number_that_is_none_must_be_optional() -> None:
    class Broken(DampedShown):
        lost = value(lambda c: None)

    with pytest.raises(TypeError, match="lost is None: make it an optional attribute"):
        variant(Broken, X.block(curve(deferred(Broken).lost), title="Nothing")).at().picture()


def test_an_attribute_has_a_name_that_the_page_and_its_parameters_have_not() -> None:
    quick = type("Quick", (DampedShown,), {"speed": value(lambda c: c.v_0)})
    with pytest.raises(ValueError, match="Quick: the page has a live number “speed” of its own: choose another name"):
        variant(quick)
    doubled = type("Doubled", (DampedCase,), {"m": value(lambda c: 2.0, "kg", "twice the mass")})
    with pytest.raises(TypeError, match="Doubled: m is a parameter: give the attribute another name"):
        variant(doubled)


@pytest.mark.parametrize("order", [(True, False), (False, True)])
def test_a_picture_does_not_depend_on_papers_built_before_it(order: tuple[bool, bool]) -> None:
    """Two papers share the time axis; one of them also shows its unit, and a length relative to its end."""
    shown = {uses: _timed(uses).at().shown for uses in order}
    assert (shown[True].scalars["t_share"], shown[True].values["t_unit"]) == (1 / shown[True].axes["t"].end, "s")
    assert not shown[False].scalars and not shown[False].values


def _timed(uses_time: bool) -> type[CaseScene]:
    class Timed(DampedShown):
        pass

    over = [line(0, 0, 90 * TIME.share, 0)] if uses_time else []
    text = [words(f"in {TIME.unit_text}")] if uses_time else []
    return variant(Timed, X.block(curve(deferred(Timed).x), title="x", over=over), *text)
