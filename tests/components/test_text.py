"""Formulas: corrections of the converter's output; the font has every character."""

import re
from html import unescape

import pytest
from fontTools.ttLib import TTFont

from components.layout.text import SENTENCES, SHORT, kept, mathml, rich
from components.scenes import SCENES
from components.state.commands import sentence
from components.state.scene_sheet import sheet_json
from tools.math_font import FONT


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
