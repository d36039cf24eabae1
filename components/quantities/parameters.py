"""Parameters: name, unit, bounds and slider of each kind, defined once."""

import math
from collections.abc import Iterable, Mapping
from numbers import Real
from typing import Any, Literal, TypeAlias, TypeVar

import param

from components.quantities.formatting import MINUS, excerpt, shortest

Scale = Literal["linear", "log", "near0", "count"]


AnyParameter: TypeAlias = param.Parameter[Any]
"""A parameter; its type decides which values it accepts."""

Values: TypeAlias = Mapping[str, object]
"""Values of parameters, by name."""

Word = TypeVar("Word", bound=str)


def names_of(parameters: Iterable[AnyParameter]) -> list[str]:
    """Return the names of parameters: the attribute names in their scene."""
    return [one.name or "" for one in parameters]


class WordSelector(param.Selector[Any]):
    """A choice between words. Its error messages list the possible words."""

    def _validate(self, val: object) -> None:
        if val not in self.objects:
            words = ", ".join(map(str, self.objects))
            raise _impossible(self, val, f"choose one of {words}")


class WordList(param.List[Any]):
    """A list of words, which says in words that it is one."""

    def _validate(self, val: object) -> None:
        if not (isinstance(val, list) and all(isinstance(word, str) for word in val)):
            raise _impossible(self, val, "give a list of words")


class Switch(param.Boolean[Any]):
    """A choice of True or False, which says in words what is possible."""

    def _validate(self, val: object) -> None:
        if not isinstance(val, bool):
            raise _impossible(self, val, "choose True or False")


def _impossible(parameter: AnyParameter, value: object, possible: str) -> ValueError:
    """The refusal of a value, with a sentence on what is possible."""
    return ValueError(f"{parameter.name or parameter.label} = {_shown(value)} is not possible: {possible}.")


def one_of(
    default: Word, objects: Iterable[Word] | Mapping[Word, str], label: str, doc: str = ""
) -> param.Selector[Word]:
    """A choice between words; a mapping gives the label of each."""
    options: Any = {text: word for word, text in objects.items()} if isinstance(objects, Mapping) else list(objects)
    return WordSelector(default=default, objects=options, label=label, doc=doc or None)


class Quantity(param.Number[Any]):  # a float, or None if the scene chooses the value
    """A physical number: `bounds` are what physics allows, `softbounds` are the ends of its slider.

    `symbol` is written k_2; `tint` names its colour; `scale` is the scale of the slider ("near0" is finer near 0,
    "count" has whole numbers only); `says` continues the symbol to a sentence; `allowed` describes the possible values
    in a sentence.
    `marks` are values with a name under the slider, which then has the width of the panel.
    """

    __slots__ = ["allowed", "marks", "says", "scale", "symbol", "tint", "unit"]

    softbounds: tuple[float, float]  # unlike in param, never None

    def __init__(
        self,
        default: float | None,
        *,
        symbol: str,
        unit: str,
        allowed: str,
        says: str,
        label: str | None = None,
        softbounds: tuple[float, float],
        tint: str = "ink",
        scale: Scale = "linear",
        marks: tuple[tuple[float, str], ...] = (),
        **options: Any,
    ) -> None:
        facts = {
            "symbol": symbol,
            "unit": unit,
            "tint": tint,
            "scale": scale,
            "says": says,
            "allowed": allowed,
            "marks": marks,
        }
        for slot, fact in facts.items():
            object.__setattr__(self, slot, fact)
        super().__init__(
            default=None if default is None else float(default),
            label=label,
            doc=says,
            softbounds=softbounds,
            per_instance=False,  # otherwise param would copy the parameter for each scene that sets it
            **options,
        )

    def __get__(self, obj: Any, objtype: Any = None) -> Any:
        """Return the value. Number.__get__ checks twice for generators of numbers, which this project does not use."""
        return param.Parameter.__get__(self, obj, objtype)

    def __set__(self, obj: Any, value: Any) -> None:
        self._validate(value)
        super().__set__(obj, None if value is None else float(value))

    def refusal(self, value: object, given: str | None = None, unit: str | None = None) -> str | None:
        """Return the reason why `value`, shown as `given` in `unit`, is not possible, or None."""
        if self._possible(value):
            return None
        sign = self.unit if unit is None else unit
        measured = isinstance(value, Real) and not isinstance(value, bool)
        text = _shown(value) if given is None else given
        return f"{text} {sign if measured else ''}".rstrip() + f" is not possible: {self.allowed}."

    def _possible(self, value: object) -> bool:
        if value is None:
            return bool(self.allow_None)
        if isinstance(value, bool) or not isinstance(value, Real):
            return False
        number = _as_float(value)
        low, high = self.bounds or (None, None)
        low_included, high_included = self.inclusive_bounds
        return (
            math.isfinite(number)
            and (low is None or number > low or (low_included and number == low))
            and (high is None or number < high or (high_included and number == high))
            and (self.scale != "count" or number.is_integer())
        )

    def _validate(self, val: object) -> None:
        refusal = self.refusal(val)
        if refusal:
            raise ValueError(f"{self.name or self.label} = {refusal}")


def mass(default: float, *, symbol: str, **facts: Any) -> Quantity:
    """A mass in kg, above 0; slider logarithmic from 0.01 to 10."""
    kind = {"unit": "kg", "label": "mass", "softbounds": (0.01, 10.0), "scale": "log"}
    says = {"says": "is a mass. Type any value above 0."}
    return positive(default, symbol=symbol, **(kind | says | facts))


def stiffness(default: float, *, symbol: str, **facts: Any) -> Quantity:
    """A stiffness in N/m, 0 or more; slider from 0 to 100, finer near 0."""
    kind = {"unit": "N/m", "label": "stiffness", "softbounds": (0.0, 100.0), "scale": "near0", "tint": "k"}
    says = {"says": "is the stiffness of a spring. Type any value from 0 up."}
    return not_negative(default, symbol=symbol, **(kind | says | facts))


def displacement(default: float = 0.0, *, symbol: str, **facts: Any) -> Quantity:
    """A displacement from equilibrium in m; slider from -2 to 2."""
    kind = {"unit": "m", "label": "displacement", "softbounds": (-2.0, 2.0)}
    says = {"says": "is where the mass starts, from equilibrium. Type any value."}
    return finite(default, symbol=symbol, **(kind | says | facts))


def velocity(default: float = 0.0, *, symbol: str, **facts: Any) -> Quantity:
    """A velocity in m/s; slider from -5 to 5."""
    kind = {"unit": "m/s", "label": "velocity", "softbounds": (-5.0, 5.0)}
    says = {"says": "is how fast the mass starts. Type any value."}
    return finite(default, symbol=symbol, **(kind | says | facts))


def force(default: float = 1.0, *, symbol: str = "F_0", **facts: Any) -> Quantity:
    """The amplitude of a force in N, 0 or more; slider from 0 to 10."""
    kind = {"unit": "N", "label": "force", "softbounds": (0.0, 10.0), "tint": "F"}
    says = {"says": "is the amplitude of the drive. Type any value from 0 up."}
    return not_negative(default, symbol=symbol, **(kind | says | facts))


def angular_frequency(default: float = 1.0, *, symbol: str = "ω", **facts: Any) -> Quantity:
    """An angular frequency in rad/s, 0 or more; the scene moves the slider's range with its modes."""
    kind = {"unit": "rad/s", "label": "angular frequency", "softbounds": (0.0, 5.0), "tint": "F"}
    says = {"says": "is the drive frequency. Type any value from 0 up."}
    return not_negative(default, symbol=symbol, **(kind | says | facts))


def positive(default: float | None, *, label: str, **facts: Any) -> Quantity:
    """Any quantity above 0."""
    allowed = f"{_a(label)} is a finite number above 0"
    options = {"bounds": (0.0, None), "inclusive_bounds": (False, True), "allowed": allowed} | facts
    return Quantity(default, label=label, **options)


def count(default: float, *, label: str, **facts: Any) -> Quantity:
    """A whole number from 1 on."""
    kind = {"bounds": (1.0, None), "scale": "count", "unit": "", "allowed": f"{_a(label)} is a whole number, 1 or more"}
    return Quantity(default, label=label, **(kind | facts))


def not_negative(default: float | None, *, label: str, **facts: Any) -> Quantity:
    """Any quantity that is 0 or more."""
    options = {"bounds": (0.0, None), "allowed": f"{_a(label)} is a finite number, 0 or more"} | facts
    return Quantity(default, label=label, **options)


def finite(default: float | None, *, label: str, **facts: Any) -> Quantity:
    """Any quantity that may have either sign."""
    return Quantity(default, label=label, **({"allowed": f"{_a(label)} is any finite number"} | facts))


def _a(noun: str) -> str:
    return noun if noun == "gravity" else f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def _as_float(value: Real) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf


def _shown(value: object) -> str:
    if isinstance(value, float) and math.isinf(value):
        return "∞" if value > 0 else MINUS + "∞"
    if isinstance(value, float) and math.isfinite(value):
        return shortest(value).replace("-", MINUS)
    return excerpt(str(value)).replace("-", MINUS) if isinstance(value, Real) else excerpt(repr(value))
