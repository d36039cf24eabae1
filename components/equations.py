r"""The lecture's formulas, with live numbers in them.

A formula is LaTeX, turned into MathML once a process. Two commands are our own:

    \val{name}         the number called `name`, filled in by the browser at every change
    \tint{class}{...}  the colour of a quantity: m1, m2, slow, fast, T, V, F, k, ...
"""

from __future__ import annotations

import re
from functools import cache, lru_cache
from html import escape

from latex2mathml.converter import convert

_VALUE = re.compile(r"\\val\{(\w+)\}")
_VALUE_MATHML = re.compile(r"<mtext>@(\w+)@</mtext>")
_THIN = '<mspace width="0.15em" />'
_FUNCTION = re.compile(r"<mi>([a-z]{2,})</mi>")
_FRACTION = re.compile(r"<mstyle[^>]*><mfrac><mrow><mn>1</mn></mrow><mrow><mn>([24])</mn></mrow></mfrac></mstyle>")
_ONE_OVER = {"2": "½", "4": "¼"}  # one sign each, so that a line stays low
_SIGN = re.compile(r"(<mo>&#x0003D;</mo>)<mo>&#x02212;</mo>")
# Signs that the converter takes for letters, or whose spaces are too wide.
_OPERATORS = {
    "<mi>&#x000B1;</mi>": "<mo>&#x000B1;</mo>",
    '<mo stretchy="false">&#x0007C;</mo>': '<mo stretchy="false" lspace="0" rspace="0">&#x0007C;</mo>',
    "<mo>&#x0002F;</mo>": '<mo lspace="0.1em" rspace="0.1em">&#x0002F;</mo>',
}
_PRIMED = re.compile(r"<msup>(<mi>\w</mi>)<mi>&#x02032;</mi></msup>")
_PRIMED_POWER = re.compile(r"<msup>(<mi>\w</mi>)<mrow><mi>&#x02032;</mi>(<mn>\d+</mn>)</mrow></msup>")
_PRIME = '<mo lspace="0" rspace="0">&#x02032;</mo>'
_TINT = re.compile(r"\\tint\{(\w+)\}")
_TINT_MATHML = re.compile(r'<mstyle mathcolor="(\w+)">')


@cache
def mathml(latex: str) -> str:
    """MathML of a formula; its live numbers are elements with a `data-value` attribute."""
    source = _VALUE.sub(r"\\text{@\1@}", latex)
    markup = convert(_TINT.sub(r"\\color{\1}", source))
    markup = _VALUE_MATHML.sub(r'<mn class="n" data-value="\1"></mn>', markup)
    markup = _FRACTION.sub(lambda match: f"<mn>{_ONE_OVER[match[1]]}</mn>", markup)
    # A prime is high enough as it is: as an exponent it would be tiny.
    markup = _PRIMED.sub(rf"<mrow>\1{_PRIME}</mrow>", markup)
    markup = _PRIMED_POWER.sub(rf"<msup><mrow>\1{_PRIME}</mrow>\2</msup>", markup)
    for wrong, right in _OPERATORS.items():
        markup = markup.replace(wrong, right)
    markup = _FUNCTION.sub(rf'<mi class="up">\1</mi>{_THIN}', markup)
    markup = markup.replace('</mi><mi class="up">', f'</mi>{_THIN}<mi class="up">')
    # Not the minus of a difference, which would stand apart from its number.
    markup = _SIGN.sub(r'\1<mo form="prefix">&#x02212;</mo>', markup)
    return _TINT_MATHML.sub(r'<mstyle class="tint \1">', markup)


_SENTENCES = 4096  # kept; those with numbers in them have no end
_INLINE = re.compile(r"\$([^$]+)\$|\*\*([^*]+)\*\*|\{(\w+)\}|\[(\w+)\|([^\]]+)\]")


@lru_cache(maxsize=_SENTENCES)
def rich(text: str) -> str:
    """HTML of a sentence: $formula$, **strong**, {name} a live number, [tint|coloured words]; what is strong or
    coloured may hold the others; all else is plain text."""
    parts, end = [], 0
    for match in _INLINE.finditer(text):
        parts.append(escape(text[end : match.start()]))
        formula, strong, name, tint, coloured = match.groups()
        if formula:
            parts.append(mathml(formula))
        elif strong:
            parts.append(f"<b>{rich(strong)}</b>")
        elif tint:
            parts.append(f'<span class="tint {tint}">{rich(coloured)}</span>')
        else:
            parts.append(f'<span class="n" data-value="{name}"></span>')
        end = match.end()
    return "".join(parts) + escape(text[end:])
