"""Formats and parses numbers: three digits on the screen; in a field as many as are needed to read back the same
number."""

import math
import re
import unicodedata
from decimal import Decimal
from functools import lru_cache

MINUS = "\N{MINUS SIGN}"
PLAIN_EXPONENTS = range(-3, 5)
"""Numbers between these powers of ten are written in full; others with a power of ten."""

LONGEST_INPUT = 60
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_NUMBER = re.compile(
    r"(?P<mantissa>[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))(?:(?:e|[*·×⋅]10\^)(?P<exponent>[+-]?[0-9]+))?"
    r"|(?P<sign>[+-]?)10\^(?P<power>[+-]?[0-9]+)"
)


class NoNumberError(ValueError):
    """An error: a typed text is not a number."""

    def __init__(self, text: str) -> None:
        super().__init__(f"“{excerpt(text)}” is not a number: type one such as 2.5 or 1e-3.")


def three(value: float | Decimal) -> str:
    """Return three significant digits with trailing zeros: 2.00, 0.0400, −1.24, 1.23·10⁻⁷. Decimals of any size are
    allowed.
    """
    if not (value.is_finite() if isinstance(value, Decimal) else math.isfinite(value)):
        return "NaN" if math.isnan(value) else ("∞" if value > 0 else MINUS + "∞")
    if value == 0:
        return "0.00"
    rounded = f"{value:.2e}"
    mantissa, _, exponent = rounded.partition("e")
    power = int(exponent)
    if power in PLAIN_EXPONENTS:
        return _fixed(float(rounded), 2 - power).replace("-", MINUS)
    return mantissa.replace("-", MINUS) + ten_to(power)


def signed(value: float | Decimal) -> str:
    """Return three significant digits, always with a sign."""
    text = three(value)
    return text if text.startswith(MINUS) else "+" + text


def plus(value: float | Decimal) -> str:
    """Return a number as a further term of a sum: "+ 0.667" or "− 0.667"."""
    text = signed(value)
    return f"{text[0]} {text[1:]}"


def short(value: float | Decimal) -> str:
    """Return a number in at most three significant digits, without trailing zeros: 5, 0.2, 1.5, 2·10⁻⁷."""
    text = three(value)
    head, mark, power = text.partition("·")
    head = head.rstrip("0").rstrip(".") if "." in head else head
    return f"{head or '0'}{mark}{power}"


def with_error(value: float, error: float) -> tuple[str, str]:
    """Return a number and its standard error: the error with one digit (two if it begins with 1), and the number
    rounded to
    the same place. Both have the same power of ten."""
    if not (math.isfinite(value) and math.isfinite(error) and error > 0):
        return three(value), ""
    digits = 2 if f"{error:.1e}"[0] == "1" else 1
    place = Decimal(f"{error:.{digits - 1}e}").adjusted() - digits + 1
    power = max(Decimal(repr(value)).adjusted(), place)
    power = 0 if power in PLAIN_EXPONENTS and place < 1 else power
    parts = [f"{Decimal(repr(part)).scaleb(-power):.{max(0, power - place)}f}" for part in (value, error)]
    number, scatter = (part.replace("-", MINUS) + (ten_to(power) if power else "") for part in parts)
    return number, scatter


def at_tick(value: float) -> str:
    """Return the number at a tick of an axis: up to six digits, or three and a power of ten for very large and small
    ones."""
    text = f"{value:.6g}"
    plain = "e" not in text and len(text.partition(".")[2]) < 6
    return text.replace("-", MINUS) if plain else short(value)


@lru_cache(maxsize=4096)
def tidy(value: float) -> str:
    """Return the text of an input field: three digits, or as many as are needed to read back the same `value`."""
    if value == 0:
        return "0.00"
    number = Decimal(repr(float(value))).normalize()
    digits = len(number.as_tuple().digits)
    if number.adjusted() in PLAIN_EXPONENTS:
        return _fixed(number, max(3, digits) - 1 - number.adjusted())
    return shortest(value)


def shortest(value: float) -> str:
    """Return the shortest plain text that reads back as the same double: 3, 0.04, 1e-300."""
    if not math.isfinite(value):
        raise ValueError(f"{value} has no digits to write")
    number = Decimal(repr(float(value))).normalize()
    if number == 0:
        return "0"
    if number.adjusted() in PLAIN_EXPONENTS:
        return f"{number:f}"
    return f"{number.scaleb(-number.adjusted()):f}e{number.adjusted()}"


def parse_number(text: str) -> float:
    """Return the number in a typed text: 1e-3, 1,5, −3, 1.5·10^-3, 1.23·10⁻⁷, 12 000.

    Raises ValueError, with a reason, for any other text, and for numbers outside the range of doubles.
    """
    if not text.strip():
        raise ValueError("Nothing is typed here: type a number such as 2.5 or 1e-3.")
    match = _NUMBER.fullmatch(plain_number(text)) if len(text) <= LONGEST_INPUT else None
    if match is None:
        raise NoNumberError(text)
    mantissa = match["mantissa"] or match["sign"] + "1"
    value = float(f"{mantissa}e{match['exponent'] or match['power'] or 0}")
    return in_doubles(value, value == 0 and not mantissa.strip("+-0."), text)


def in_doubles(value: float, is_zero: bool, text: str) -> float:
    """Return the value of a typed text. Raises ValueError if it overflows, or underflows to 0."""
    if math.isinf(value):
        raise ValueError(f"{excerpt(text)} is too large: the largest number that can be held is about 1.8e308.")
    if value == 0 and not is_zero:
        raise ValueError(f"{excerpt(text)} is too small: the smallest number that can be held is about 5e-324.")
    return value


def power_unit(value: float) -> tuple[int, str]:
    """Return the exponent of ten for an axis that reaches to `value`, and the text before its unit.

    The exponent is a multiple of 3 and 0 from 1e-3 to 1e4. It is at least -306, because smaller powers of ten have
    fewer digits, and their reciprocals overflow.
    """
    if not math.isfinite(value):
        raise OverflowError(f"an axis cannot reach to {value}")
    if value == 0 or 1e-3 <= abs(value) < 1e4:
        return 0, ""
    exponent = max(-306, 3 * (Decimal(repr(float(value))).adjusted() // 3))
    return exponent, ten_to(exponent) + " "


def ten(exponent: int) -> str:
    """Return a power of ten: 10⁻⁴, and 1 for the power 0."""
    if exponent == 0:
        return "1"
    return ten_to(exponent).removeprefix("·")


def ten_to(exponent: int) -> str:
    """Return the factor ·10ⁿ."""
    return "·10" + str(exponent).translate(_SUPERSCRIPTS)


def excerpt(text: str, longest: int = 40) -> str:
    """Return the start of a visitor's text, without invisible characters."""
    start = text[: longest + 1]  # a text from a browser may be megabytes long
    seen = "".join(character if character.isprintable() else "\N{REPLACEMENT CHARACTER}" for character in start)
    return seen if len(seen) <= longest else seen[: longest - 1] + "…"


def raised(text: str) -> str:
    """Return a text with ^ before superscripts: m², 10⁻³."""
    return re.sub("[⁺⁻⁰¹²³⁴-⁹]+", lambda match: "^" + match[0], text)


def _fixed(number: float | Decimal, decimals: int) -> str:
    return f"{number:.{max(0, decimals)}f}"


def plain_number(text: str) -> str:
    """Return `text` in ASCII signs and digits, without spaces that have no meaning."""
    text = unicodedata.normalize("NFKC", raised(text.strip())).replace(MINUS, "-").replace(",", ".").lower()
    text = re.sub(r"(?<![0-9])\s+|\s+(?![0-9])", "", text)
    return re.sub(r"(?<=[0-9])\s(?=[0-9]{3}(?![0-9]))", "", text)
