"""Numbers as a person reads and types them, in fields and at axes; formulas and sentences."""

import math
import re
from decimal import Decimal
from html import unescape

import pytest
from fontTools.ttLib import TTFont
from hypothesis import given
from hypothesis import strategies as st

from components.layout.choices import word
from components.layout.controls import settings
from components.layout.text import SENTENCES, SHORT, kept, mathml, rich
from components.quantities.axes import Axis, log_axis
from components.quantities.formatting import at_tick, excerpt, parse_number, shortest, three, tidy, with_error
from components.quantities.parameters import Quantity
from components.quantities.typed import typed_number
from components.quantities.units import Unit
from components.scenes import SCENES
from components.state.commands import sentence
from components.state.scene_sheet import sheet_json
from tools.math_font import FONT

UNITS = sorted({q.unit for scene in SCENES.values() for q in scene.param.objects().values() if isinstance(q, Quantity)})
finite = st.floats(allow_nan=False, allow_infinity=False)


@given(finite)
def test_three_digits_are_within_half_a_unit_of_the_third(value: float) -> None:
    shown = three(value).replace("−", "-").replace("·10", "e").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    assert abs(Decimal(shown) - Decimal(value)) <= abs(Decimal(value)) * Decimal("0.005")
    if 1e-307 < abs(value) < 1e307:
        assert parse_number(three(value)) == pytest.approx(value, rel=5e-3), "it can be typed again"


@given(finite, st.sampled_from(UNITS))
def test_field_and_shortest_text_read_back_exactly_with_a_unit_and_without(value: float, unit: str) -> None:
    for text in (tidy(value), shortest(value), repr(value)):
        assert text.isascii() and float(text) == value
        assert parse_number(text) == typed_number(text, unit) == typed_number(f"{text} {unit}", unit) == value


@given(
    st.text(alphabet="0123456789.,+-−*/^()e πpisqrtNmkg°²⁻", max_size=70) | st.text(max_size=70), st.sampled_from(UNITS)
)
def test_whatever_is_typed_is_a_double_or_refused_in_words(text: str, unit: str) -> None:
    try:
        value = typed_number(text, unit)
    except ValueError as error:
        assert str(error).endswith(".")
    else:
        assert math.isfinite(value)


NUMBERS = {
    **{"1e-3": 1e-3, "2e3": 2e3, "1,5": 1.5, "−3": -3.0, "1.5·10^-3": 1.5e-3, "1.5 × 10^−3": 1.5e-3, "3·10⁴": 3e4},
    **{"1.23·10⁻⁷": 1.23e-7, "10⁻³": 1e-3, "-10^3": -1e3, "  2.5 ": 2.5, "12 000": 12e3, ".5": 0.5, "+5.": 5.0},
    **{"0e-999": 0.0, "１．５": 1.5, "－3": -3.0},
}
"""Numbers as people type them, in a field or a link."""
EXPRESSIONS = {
    **{"pi": math.pi, "2π": math.tau, "2 pi/3": 2.0943951023931957, "1/3": 1 / 3, "sqrt(2)": math.sqrt(2)},
    **{"√2": math.sqrt(2), "2 sqrt(3)/(1+1)": math.sqrt(3), "2^0.5": math.sqrt(2), "-2^2": -4.0, "1e400/1e399": 10.0},
    **{"007/2": 3.5, "１／３": 1 / 3, "２ｍ": 2.0, "−3 m": -3.0, "5 mm": 5e-3, "1。5": 1.5},
}
"""Expressions, and numbers with a unit, which only fields read; here in m."""
MEASURED = [
    *(("12 000 N", "N", 12e3), ("2.5N/m", "N/m", 2.5), ("2.5 N/m", "kN/m", 2.5e-3), ("36 km/h", "m/s", 10.0)),
    *(("150 ft/s", "m/s", 45.72), ("5 µF", "F", 5e-6), ("1/2 g", "kg", 5e-4), ("7 g/cm³", "kg/m³", 7e3)),
    *(("9.81 m/s^2", "m/s²", 9.81), ("9.81 m s⁻²", "m/s²", 9.81), ("9.81 m/s/s", "m/s²", 9.81)),
    *(("3 N·s/m", "N s/m", 3.0), ("100 kg m/s²", "N", 100.0), ("30°", "rad", 0.5235987755982989)),
    *(("pi/6 rad", "°", 30.0), ("2 Hz", "rad/s", 4 * math.pi), ("3 1/s", "rad/s", 3.0), ("3 /s", "rad/s", 3.0)),
    *(("2 N m", "N m/rad", 2.0), ("0.5 v₀", "v₀", 0.5)),
]


@pytest.mark.parametrize(
    ("text", "unit", "value"), [*((text, "m", value) for text, value in (NUMBERS | EXPRESSIONS).items()), *MEASURED]
)
def test_a_number_as_people_type_it(text: str, unit: str, value: float) -> None:
    assert typed_number(text, unit) == value
    if text in NUMBERS:
        assert parse_number(text) == value


NO_NUMBERS = (
    *("abc", "nan", "inf", "1 2", "1.2.3", "٣", "()", "1+", "pi pi", "sqrt()", "sqrt(1)(2", "pi(2)("),
    *("__import__('os')", "1" * 61, "1e", "0x10", "1_0", "1.5·105", "3 N/m"),
)
"""Texts that are refused with an example of a number; in a field, the last five for another reason."""


@pytest.mark.parametrize("text", NO_NUMBERS)
def test_what_is_no_number_is_refused_with_an_example(text: str) -> None:
    for read in (parse_number, *([lambda text: typed_number(text, "m")] if text in NO_NUMBERS[:-5] else [])):
        with pytest.raises(ValueError, match=r"is not a number: type one such as 2\.5 or 1e-3"):
            read(text)


@pytest.mark.parametrize(
    ("text", "unit", "reason"),
    [
        ("3 kg", "N/m", "“3 kg” is in kg, and this is in N/m: type a number in N/m."),
        ("3 m", "", "“3 m” is in m, and this has no unit: type a number without a unit."),
        ("3 m", "v₀", "“3 m” is in m, and this is in v₀: type a number in v₀."),
        ("3 foo", "m", "“foo” is not a unit known here: type a number in m."),
        ("1e", "m", "“e” is not a unit known here: type a number in m."),
        ("3 m/", "m", "“m/” is not a unit known here: type a number in m."),
        *((text, "m", f"“{text}” divides by zero.") for text in ("1/0", "1/0 km")),
        ("sqrt(-1)", "m", "“sqrt(-1)” is not a real number."),
        ("9^9^9", "m", "“9^9^9” takes more digits than a field has room for."),
        ("1e999 km", "m", "1e999 km is too large: the largest number that can be held is about 1.8e308."),
        ("-1e999", "m", "-1e999 is too large: the largest number that can be held is about 1.8e308."),
        ("10^-400", "m", "10^-400 is too small: the smallest number that can be held is about 5e-324."),
        ("1/2π", "m", "“1/2π” has two meanings: write every multiplication sign ·, and use brackets."),
        *((text, "m", "Nothing is typed here: type a number such as 2.5 or 1e-3.") for text in ("", " ")),
    ],
)
def test_what_is_refused_says_why(text: str, unit: str, reason: str) -> None:
    with pytest.raises(ValueError) as refused:
        typed_number(text, unit)
    assert str(refused.value) == reason
    if unit == "m" and not reason.startswith("“") and "km" not in text:
        with pytest.raises(ValueError, match=reason.partition(":")[0].replace("^", r"\^")):
            parse_number(text)


@pytest.mark.parametrize(
    ("value", "error", "texts"),
    [
        *((6.30171, 0.00083, ("6.3017", "0.0008")), (0.017673, 0.00012, ("0.01767", "0.00012"))),
        *((-0.1049, 0.0031, ("−0.105", "0.003")), (13.899, 1.4, ("13.9", "1.4")), (0.0, 0.02, ("0.00", "0.02"))),
        *((13450.0, 21.0, ("1.345·10⁴", "0.002·10⁴")), (2.3456e-7, 3e-9, ("2.35·10⁻⁷", "0.03·10⁻⁷"))),
        *((2.5, 0.0, ("2.50", "")), (2.5, math.inf, ("2.50", ""))),
    ],
)
def test_a_number_ends_at_the_place_of_its_error(value: float, error: float, texts: tuple[str, str]) -> None:
    assert with_error(value, error) == texts


def test_ticks_foreign_texts_and_moving_numbers_have_the_signs_that_they_take() -> None:
    ticks = {0.0: "0", -2.5: "−2.5", 1252.5: "1252.5", 0.00125: "0.00125", 4e6: "4·10⁶", -1e305: "−1·10³⁰⁵"}
    assert {value: at_tick(value) for value in ticks} == ticks
    texts = {"a\nb\u202ec": "a\ufffdb\ufffdc", "x" * 41: "x" * 39 + "…", "x" * 40: "x" * 40}
    assert {text: excerpt(text) for text in texts} == texts
    places = {(0.0, 0): 12, (5e-324, 3): 12, (2.5e-3, -3): 2, (1.0, 0): 2, (40.0, 3): 4, (1e300, 0): 0}
    axes = {size: Axis(0.0, 1.0, "J", size[1], own=(0.0, size[0])) for size in places}
    assert {size: axis.digits().decimals for size, axis in axes.items()} == places


@given(st.floats(-300, 300), st.floats(0.05, 20), st.integers(3, 6))
def test_a_log_axis_has_two_numbers_at_least_each_where_it_says(power: float, span: float, count: int) -> None:
    axis = log_axis(10.0**power, 10.0 ** min(power + span, 307), "s", count)
    labels = [label.removesuffix(" s") for label in axis.ruler.labels]
    assert len(set(labels)) == len(axis.ticks) >= 2
    for label, tick in zip(labels, axis.ticks, strict=True):
        assert math.log10(parse_number(label)) == pytest.approx(tick, abs=0.003)


@pytest.mark.parametrize("slug", SCENES)
def test_a_field_has_the_value_of_its_quantity_and_says_whether_it_has_changed(slug: str) -> None:
    for values in SCENES[slug].presets.values():
        scene = SCENES[slug].at(values)
        spans = scene.shown.spans
        for name, setting in settings(scene.param.objects("existing"), scene.values, scene.units(), spans).items():
            parameter, value = SCENES[slug].param[name], scene.values.get(name)
            assert setting.changed == (value != parameter.default)
            if isinstance(parameter, Quantity) and value is not None:
                typed = typed_number(setting.text, setting.unit or parameter.unit) * (setting.size or 1.0)
                assert typed == pytest.approx(value, rel=1e-3 if setting.unit else 0.0, abs=0.0)
                assert (setting.value, setting.soft) == (value, spans.get(name))
            else:
                assert setting.text == (setting.value or "") == ("" if value is None else word(value))


def test_a_quantity_in_another_unit_has_four_digits_and_round_numbers_come_back_round() -> None:
    foot, knot = Unit("ft/s", 0.3048), Unit("knots", 1852 / 3600)
    assert foot.value(150.0) == 45.72
    assert [foot.field(foot.value(value)) for value in (150, 1234.5)] == ["150", "1234.5"]
    assert (knot.field(45.72), foot.field(1 / 3), foot.field(0.0)) == ("88.87", "1.094", "0.00")


# Formulas and sentences


def italic(sign: str) -> str:
    """A variable's sign as a browser draws it."""
    if sign == "h":
        return "ℎ"
    for first, last, start in (("A", "Z", 0x1D434), ("a", "z", 0x1D44E), ("Α", "Ω", 0x1D6E2), ("α", "ω", 0x1D6FC)):
        if first <= sign <= last:
            return chr(start + ord(sign) - ord(first))
    return sign


def test_the_font_has_every_sign_of_every_formula() -> None:
    held = TTFont(FONT).getBestCmap()
    sheets = "".join(unescape(sheet_json(scene).decode()) for scene in SCENES.values())
    formulas = "".join(re.findall(r"<math.*?</math>", sheets))
    used = set(re.sub(r"<mtext.*?</mtext>|<[^>]*>", "", formulas))
    assert {"ω", "−", "½"} <= used
    assert {sign for sign in used if ord(sign) not in held or ord(italic(sign)) not in held} == set()


@pytest.mark.parametrize(
    ("latex", "part"),
    [
        (r"\tfrac{1}{2} m", "<mn>½</mn>"),
        (r"\val{k1}", '<mn class="n" data-value="k1"></mn>'),
        (r"\tint{m1}{x}", '<mstyle class="tint m1">'),
        ("v'", "<mi>v</mi><mo"),
        (r"l \sin t", '<mi>l</mi><mspace width="0.15em" /><mi class="up">sin</mi><mspace width="0.15em" />'),
        (r"x = -1", '<mo form="prefix">&#x02212;</mo>'),
        (r"b \pm c", "<mo>&#x000B1;</mo>"),
    ],
)
def test_what_the_converter_is_corrected_in(latex: str, part: str) -> None:
    assert part in mathml(latex)


def test_a_sentence_escapes_what_is_not_markup_and_no_line_ends_between_a_number_and_its_unit() -> None:
    live = '<span class="n" data-value="{}"></span>\xa0'
    texts = {
        "a < b & **c**": "a &lt; b &amp; <b>c</b>",
        "see [scene:phugoid|the **aircraft**]": 'see <a href="?scene=phugoid">the <b>aircraft</b></a>',
        "[m1|{x1} m]": f'<span class="tint m1">{live.format("x1")}m</span>',
        "1.5 rad/s, 8 % of 3 m": "1.5\xa0rad/s, 8\xa0% of 3\xa0m",
        "{a} m/s² in 2 systems": f"{live.format('a')}m/s² in 2 systems",
        **{
            f"as {formula}, so": f'as <span class="whole">{rich(formula)},</span> so' for formula in ("$x$", "[m1|$x$]")
        },
    }
    assert {text: rich(text) for text in texts} == texts


def test_of_what_is_set_little_is_remembered() -> None:
    """Formulas from anybody's file would fill the memory of a server for good: few are kept, and no long one."""
    made: list[str] = []
    set_once = kept(lambda latex: made.append(latex) or latex)
    for formula in ("x", "x", long := "x" * (SHORT + 1), long, *map(str, range(2 * SENTENCES)), "x"):
        set_once(formula)
    assert made[:3] == ["x", long, long] and made[-1] == "x" and SENTENCES * SHORT < 2**20


@pytest.mark.parametrize(
    ("said", "shown"),
    [
        ("the amplitude B = v_0/omega_n = -2.668e+331 leaves", "The amplitude B = v₀/ωₙ = −2.668e331 leaves."),
        ("x1_0 = nan: only finite numbers", "x₁(0) = nan: only finite numbers."),
        ("the amplitude Xp1 at omega = 3 rad/s", "The amplitude Xₚ₁ at ω = 3 rad/s."),
        ("above 2 sqrt(k1 m1), omega_+ and 9 m/s^2", "Above 2 √(k₁ m₁), ω₊ and 9 m/s²."),
        ("“plot:x2” and “x1” of D31 stay, as 1e5 does", "“plot:x2” and “x1” of D31 stay, as 1e5 does."),
    ],
)
def test_symbols_are_those_of_the_screen(said: str, shown: str) -> None:
    assert sentence(ValueError(said)) == shown
