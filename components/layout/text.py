r"""The notation of texts: plain words, and in them

    $formula$              LaTeX, converted to MathML once per process
    {name}, \val{name}     the live number called `name`
    *x*_1, *x*_{max}       the symbol of a quantity and its index
    **strong**, [tint|words in the colour of a quantity], [scene:slug|words that link to it]

`rich` converts it to HTML, `runs` to the pieces of a drawing, which cannot have formulas, strong or coloured words.
Formulas have two additional commands; the first one also works in plain words:

    \val{name}             the live number called `name`
    \tint{class}{...}      the colour of a quantity: m1, m2, slow, fast, T, V, F, k, ...
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache
from html import escape

from latex2mathml.converter import convert

from components.language.text import Html, Runs, TextRun
from components.layout.markup import check_markup
from components.quantities.formatting import excerpt

SENTENCES = 2048  # limit of cached texts, because texts of visitors' files are unlimited in number
SHORT = 400  # longest cached text in characters; longer ones only reuse their formulas
_VALUE = re.compile(r"\\val\{(\w+)\}")
_VALUE_MATHML = re.compile(r"<mtext>@(\w+)@</mtext>")
_THIN = '<mspace width="0.15em" />'
_FUNCTION = re.compile(r"<mi>([a-z]{2,})</mi>")
_FRACTION = re.compile(r"<mstyle[^>]*><mfrac><mrow><mn>1</mn></mrow><mrow><mn>([24])</mn></mrow></mfrac></mstyle>")
_ONE_OVER = {"2": "½", "4": "¼"}  # fractions as one character, so that the line does not become higher
_SIGN = re.compile(r"(<mo>&#x0003D;</mo>)<mo>&#x02212;</mo>")
# Signs that the converter treats as letters, signs with too wide spaces, and φ in the shape that texts have.
_OPERATORS = {
    "<mi>&#x000B1;</mi>": "<mo>&#x000B1;</mo>",
    "&#x003D5;": "&#x003C6;",
    '<mo stretchy="false">&#x0007C;</mo>': '<mo stretchy="false" lspace="0" rspace="0">&#x0007C;</mo>',
    "<mo>&#x0002F;</mo>": '<mo lspace="0.1em" rspace="0.1em">&#x0002F;</mo>',
    # Time derivatives, which WebKit sets too high: static/styles/text.css.
    **{f"<mo>{dots}</mo></mover>": f'<mo class="dots">{dots}</mo></mover>' for dots in ("&#x002D9;", "&#x000A8;")},
}
# WebKit puts spaces around a sign in an index, as around a minus between two numbers.
_INDEX_SIGN = re.compile(r"(<msub(?:sup)?><mi>[^<]*</mi>(?:<mrow>)?<mo)(>&#x0(?:002B|2212|00B1);</mo>)")
_PRIMED = re.compile(r"<msup>(<mi>\w</mi>)<mi>&#x02032;</mi></msup>")
_PRIMED_POWER = re.compile(r"<msup>(<mi>\w</mi>)<mrow><mi>&#x02032;</mi>(<mn>\d+</mn>)</mrow></msup>")
_PRIME = '<mo lspace="0" rspace="0">&#x02032;</mo>'
_TINT = re.compile(r"\\tint\{(\w+)\}")
_TINT_MATHML = re.compile(r'<mstyle mathcolor="(\w+)">')


def kept(make: Callable[[str], str]) -> Callable[[str], str]:
    """Cache the results for short texts."""
    remembering = lru_cache(maxsize=SENTENCES)(make)
    return lambda text: (remembering if len(text) <= SHORT else make)(text)


@kept
def mathml(latex: str) -> str:
    """Return the MathML of a formula; its live numbers are elements with a `data-value` attribute.

    Raises ValueError, with a reason, for a text that is not exactly one formula.
    """
    try:
        markup = _converted(latex)
    except Exception as error:  # the converter raises many kinds of errors for wrong formulas
        raise ValueError(f"“{excerpt(latex)}” cannot be set as a formula") from error
    try:
        check_markup(markup)
    except ValueError as reason:
        raise ValueError(f"“{excerpt(latex)}”: {reason}") from reason
    return markup


def _converted(latex: str) -> str:
    source = _VALUE.sub(r"\\text{@\1@}", latex)
    markup = convert(_TINT.sub(r"\\color{\1}", source))
    markup = _VALUE_MATHML.sub(r'<mn class="n" data-value="\1"></mn>', markup)
    markup = _FRACTION.sub(lambda match: f"<mn>{_ONE_OVER[match[1]]}</mn>", markup)
    # Write a prime as an operator, because it would be tiny as an exponent.
    markup = _PRIMED.sub(rf"<mrow>\1{_PRIME}</mrow>", markup)
    markup = _PRIMED_POWER.sub(rf"<msup><mrow>\1{_PRIME}</mrow>\2</msup>", markup)
    for wrong, right in _OPERATORS.items():
        markup = markup.replace(wrong, right)
    markup = _INDEX_SIGN.sub(r'\1 lspace="0" rspace="0"\2', markup)
    markup = _FUNCTION.sub(rf'<mi class="up">\1</mi>{_THIN}', markup)
    markup = markup.replace('</mi><mi class="up">', f'</mi>{_THIN}<mi class="up">')
    # The minus sign of a difference keeps its spaces.
    markup = _SIGN.sub(r'\1<mo form="prefix">&#x02212;</mo>', markup)
    return _TINT_MATHML.sub(r'<mstyle class="tint \1">', markup)


_INLINE = re.compile(
    r"\$(?P<formula>[^$]+)\$|\*\*(?P<strong>[^*]+)\*\*|(?:\\val)?\{(?P<value>\w+)\}"
    r"|\[scene:(?P<slug>\w+)\|(?P<leading>[^\]]+)\]|\[(?P<tint>\w+)\|(?P<coloured>[^\]]+)\]"
    r"|\*(?P<symbol>[^*\s][^*]*)\*|(?P<index>_(?:\{[^}]+\}|\w))"
)

_FORMULA = re.compile(r"\$[^$]+\$|\[\w+\|\$[^$]+\$\]")
_CLOSING = tuple(",.;:!?)")
"""Punctuation that stays on the same line as the formula before it."""
_UNIT = re.compile(r"(?<=[\d}]) (?=(?:%|[kmcµ]?(?:m|s|g|N|J|W|V|Hz|rad|ft)(?:[²³]|/\w+²?)?)(?![\w}|]))")
"""The space between a number and its unit, at which a line must not break."""


@kept
def rich(text: str) -> Html:
    """Return the HTML of a sentence; strong or coloured words may contain symbols and formulas.

    Raises ValueError, with a reason, for a wrong formula or an unknown colour.
    """
    html = _set(text)
    check_markup(html)
    return html


def _set(text: str) -> Html:
    text = _UNIT.sub("\N{NO-BREAK SPACE}", text)
    parts, end, symbol_ends = [], 0, -1
    for match in _INLINE.finditer(text):
        parts.append(escape(text[end : match.start()]))
        html, end = _markup(match, indexed=match.start() == symbol_ends), match.end()
        symbol_ends = end if match["symbol"] else -1
        if text[end : end + 1] in _CLOSING and _FORMULA.fullmatch(match[0]):
            html, end = f'<span class="whole">{html}{text[end]}</span>', end + 1
        parts.append(html)
    return "".join(parts) + escape(text[end:])


def _markup(match: re.Match[str], indexed: bool) -> Html:
    if match["formula"]:
        return mathml(match["formula"])
    if match["strong"]:
        return f"<b>{_set(match['strong'])}</b>"
    if match["coloured"]:
        return f'<span class="tint {match["tint"]}">{_set(match["coloured"])}</span>'
    if match["leading"]:
        return f'<a href="?scene={match["slug"]}">{_set(match["leading"])}</a>'
    if match["value"]:
        return f'<span class="n" data-value="{match["value"]}"></span>'
    if match["symbol"]:
        return f'<span class="v">{escape(match["symbol"])}</span>'
    # In other places an underscore is an ordinary character.
    return f"<sub>{escape(_index(match))}</sub>" if indexed else escape(match[0])


def _index(match: re.Match[str]) -> str:
    return match["index"][1:].strip("{}")


@lru_cache(maxsize=SENTENCES)
def runs(text: str) -> Runs:
    """Return the pieces of a short text in a drawing. Raises ValueError for notations that a drawing does not have."""
    found: list[TextRun] = []
    end = 0
    for match in _INLINE.finditer(text):
        if match["formula"] or match["strong"] or match["coloured"] or match["leading"]:
            raise ValueError(f"a drawing sets no {match[0]!r}: plain words, symbols and live numbers only")
        if match.start() > end:
            found.append(TextRun("plain", text[end : match.start()]))
        if match["symbol"]:
            found.append(TextRun("symbol", match["symbol"]))
        elif match["value"]:
            found.append(TextRun("value", match["value"]))
        else:
            found.append(TextRun("index", _index(match)))
        end = match.end()
    if end < len(text):
        found.append(TextRun("plain", text[end:]))
    return tuple(found)


def plain(text: str) -> str:
    """Return a text without notation, for the tooltip of a curve and for screen readers."""
    return "".join(run.text for run in runs(text))
