"""Declarations of what a picture has: values follow from them, and mypy, which reads this file, finds a wrong name."""

from __future__ import annotations

import re
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest

from components.language.expressions import PAGE_NUMBERS, named, var
from components.layout.controls import Group
from components.layout.plots import curve, region
from components.layout.sheet import either, term
from components.layout.stage import ON_WIDE, PlotFrame, circle, shown_by
from components.layout.text import mathml, rich, runs
from components.quantities.axes import Axis
from components.quantities.declared import (
    AxisUnit,
    Column,
    Declared,
    DrawnAxis,
    Family,
    Form,
    LiveNumber,
    Scalar,
    Signal,
    Text,
    by_name,
)
from components.quantities.formatting import plus
from components.quantities.motion import derived, total
from components.quantities.readouts import Readout
from components.scene.about import rows

number = LiveNumber[complex]
STATIC = Path(__file__).parents[2] / "static"


class On(Declared[complex]):
    t, x = DrawnAxis.some(2)


class Shared(Declared[complex]):
    size = number(abs, "|z|", "m", "m1")
    unit = AxisUnit(On.x)


class Own(Shared):
    real = number(lambda z: z.real, form=plus)
    imaginary = number(lambda z: z.imag or None, "y", axis=Shared.unit)
    length = number(abs, unit="m", whole=True)
    height = number(lambda z: z.imag, axis=Shared.unit, whole=True)
    sign = number(lambda z: "none" if not z.real else z.real / abs(z), "s")
    first, second = number.both(lambda z: (Decimal(z.real), z.imag), plus, unit="m", whole=True)


class Drawn(Declared[complex]):
    """Declarations of the other kinds; a case without an imaginary part lacks some."""

    x = Signal[complex](lambda z, a: derived(On.x(a).place(z.real)), On.x, signed=True)
    y = Signal[complex](lambda z, a: total(Drawn.x, Drawn.x) if z.imag else None)
    at = Scalar[complex](lambda z, a: On.x(a).place(z.imag) if z.imag else None)
    seen = Scalar[complex](lambda z, a: z.imag > 0)
    side = Family((1, 2), lambda i: Scalar[complex](lambda z, a: i * z.real))
    part = Family(("slow", "fast"), lambda one: Scalar[complex](lambda z, a: float(len(one))))
    shape = Family([(1, "slow"), (2, "fast")], lambda one: Scalar[complex](lambda z, a: float(one[0])), "x{}_{}")
    re = Column[complex]("plane", lambda z: np.array([z.real]))
    im = Column[complex]("plane", lambda z: np.array([z.imag]) if z.imag else None)
    again = Column[complex]("other", lambda z: np.array([0.0]), called="re")
    kind = Form[complex](lambda z: "turned" if z.imag else "")
    stands = Form[complex](lambda z: z.real > 0)


AXES = {"x": Axis(0.0, 5e-3, "m")}


def test_texts_follow_in_the_order_of_declaration() -> None:
    texts = Own.texts(3e-3 + 4e-3j, AXES)
    assert list(texts) == ["size", "unit", "real", "imaginary", "length", "height", "sign", "first", "second"]
    assert texts["real"] == "+ 0.00300" and texts["unit"] == AXES["x"].full_unit
    assert texts["imaginary"] == AXES["x"].number(4e-3)
    assert (texts["first"], texts["second"]) == ("+ 0.00300 m", "+ 0.00400 m")
    assert (texts["length"], texts["height"]) == ("0.00500 m", f"{texts['imaginary']} {texts['unit']}")


def test_a_text_is_made_of_the_case_or_elsewhere() -> None:
    class Texts(Declared[complex]):
        here = Text[complex](lambda z, axes: f"{z.real} {axes['x'].unit}")
        one, two = Text[complex].some(2)

    assert Texts.texts(2j, AXES) | by_name({Texts.two: "elsewhere"}) == {"here": "0.0 m", "two": "elsewhere"}


def test_names_alone_come_some_at_a_time_or_by_key() -> None:
    class Names(Declared[complex]):
        one, two = Scalar[complex].some(2)
        x = Signal[complex].each((1, 2), "x_{}", on=On.x)

    assert (Names.one.name, Names.two.name, Names.x[2].name) == ("one", "two", "x_2")
    assert Names.scalars(1j, AXES) == {} and Names.live(AXES).keys() == {"x_1", "x_2"}


def test_an_axis_has_its_own_way_to_write_what_is_counted_on_it() -> None:
    whole = AxisUnit(On.x, write=lambda axis, value: f"{axis.place(value):.0f}")
    assert number(abs, axis=whole).text(3e-3 + 4e-3j, AXES) == f"{AXES['x'].place(5e-3):.0f}"


def test_what_has_a_symbol_and_a_value_is_compared() -> None:
    assert Own.readouts(3 + 4j) == (
        Readout("size", "|z|", 5.0, "m", "m1"), Readout("imaginary", "y", 4.0, ""), Readout("sign", "s", 0.6, ""),
    )  # fmt: skip
    assert [one.name for one in Own.readouts(2j)] == ["size", "imaginary"]
    assert Own.texts(2 + 0j, AXES)["imaginary"] == "" and Own.texts(2j, AXES)["sign"] == "none"


def test_a_picture_has_what_is_declared_and_lacks_what_a_case_has_not() -> None:
    one, other = 2e-3 + 1e-3j, -2e-3 + 0j
    assert Drawn.signals(one, AXES) == {"x": derived(AXES["x"].place(2e-3)), "y": total(Drawn.x, Drawn.x)}
    assert Drawn.signals(other, AXES).keys() == {"x"}
    assert Drawn.live(AXES) == {"x": AXES["x"].digits(signed=True)}
    assert Drawn.scalars(one, AXES) == {
        "at": AXES["x"].place(1e-3), "seen": 1.0, "side1": 2e-3, "side2": 4e-3, "part_slow": 4.0, "part_fast": 4.0,
        "x1_slow": 1.0, "x2_fast": 2.0,
    }  # fmt: skip
    assert "at" not in Drawn.scalars(other, AXES) and Drawn.scalars(other, AXES)["seen"] == 0.0
    assert {source: list(found) for source, found in Drawn.columns(one).items()} == {
        "plane": ["re", "im"], "other": ["re"],
    }  # fmt: skip
    assert list(Drawn.columns(other)["plane"]) == ["re"]
    assert Drawn.forms(one) == {"kind": "turned", "stands": "shown"} and Drawn.forms(other) == {
        "kind": "",
        "stands": "",
    }


def test_a_declaration_stands_for_its_name_in_all_that_is_built() -> None:
    assert var(Drawn.side[2]) == named("side2") and by_name({On.t: 1, Drawn.x: 2}) == {"t": 1, "x": 2}
    line = curve(Drawn.im, x=Drawn.re, signal=Drawn.y)
    assert (line.y, line.x, line.source, line.signal, line.group) == ("im", "re", "plane", "y", "im")
    assert (curve(Drawn.x).source, curve(Drawn.again).y, region(Drawn.x, Drawn.y, of=Drawn.x).of) == ("time", "re", "x")
    assert either(Drawn.kind, turned="").name == "kind" and term(Drawn.x, form=Drawn.kind, turned="x").form == "kind"
    inside = circle(0, 0, 1, show=(ON_WIDE, Drawn.seen), inside=PlotFrame("plane"))
    assert (inside.show, inside.inside) == (("wide", "seen"), "plane")
    assert shown_by(Drawn.part["slow"], inside)[0].show == ("part_slow", "wide", "seen")


def test_a_name_stands_alike_in_words_formulas_and_drawings() -> None:
    assert rich(f"{Own.size} m") == rich("{size} m")
    assert mathml(f"r = {Own.size}") == mathml(r"r = \val{size}")
    assert runs(f"*r* {Own.size}") == runs("*r* {size}")


def test_it_is_read_aloud_with_its_unit() -> None:
    assert (Own.size.aloud, Own.sign.aloud, Own.imaginary.aloud) == ("{size} m", "{sign}", "{imaginary} {unit}")
    assert Own.length.aloud == "{length}"


def test_the_live_numbers_of_the_page_are_its_own() -> None:
    told = {name for file in STATIC.rglob("*.js") for name in re.findall(r'live\.tell\("(\w+)"', file.read_text())}
    assert told == PAGE_NUMBERS
    with pytest.raises(ValueError, match="Fast: the page has a live number “speed” of its own"):

        class Fast(Declared[complex]):
            speed = number(abs)


def test_a_misspelt_name_is_an_error_of_types() -> None:
    with pytest.raises(AttributeError):
        Own.omga  # type: ignore[attr-defined]  # noqa: B018
    wrong = number(lambda z: z.rael)  # type: ignore[attr-defined]
    first, _ = number.both(lambda z: (z.rael, z.imag))  # type: ignore[attr-defined]
    for one in (wrong, first):
        with pytest.raises(AttributeError):
            one.text(1j, AXES)
    with pytest.raises(TypeError):
        number(symbol="x")  # type: ignore[call-arg]  # a number without a value
    with pytest.raises(AttributeError):
        Drawn.axis  # type: ignore[attr-defined]  # noqa: B018
    with pytest.raises(KeyError):
        Drawn.side[3]


def test_strings_are_no_names() -> None:
    """mypy, which asks for each of these remarks, finds them; where a name is read they are refused."""
    with pytest.raises(AttributeError):
        by_name({"x": 1.0})  # type: ignore[type-var]
    with pytest.raises(AttributeError):
        rows({"x": "$x$"}, {"t": np.zeros(1)}, {})  # type: ignore[type-var]
    with pytest.raises(AttributeError):
        _ = Group("Start", ("x_0",)).names  # type: ignore[arg-type]
