"""Choices: the values of parameters that are not numbers, and the words for them in links and messages."""

import re

import param

from components.language.blocks import Option
from components.language.state import Value
from components.quantities.formatting import excerpt, shortest
from components.quantities.parameters import AnyParameter

MOST_ITEMS = 50
_ITEM = re.compile(r"[A-Za-z0-9_.:+-]{1,40}")


def word(value: object) -> str:
    """Return the word for a value of a choice: signed, true, 0.5."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return shortest(value) if isinstance(value, float) else str(value)


def stated(value: object) -> Value:
    """Return a parameter's value in the form of a state: numbers stay, other values become words."""
    if isinstance(value, list):
        return [word(item) for item in value]
    return value if value is None or (isinstance(value, float) and not isinstance(value, bool)) else word(value)


def options(parameter: AnyParameter) -> dict[str, object]:
    """Return the possible values of a choice, by word."""
    values = (False, True) if isinstance(parameter, param.Boolean) else parameter.get_range().values()
    return {word(value): value for value in values}


def labelled(parameter: AnyParameter) -> tuple[Option, ...]:
    """Return the labels of the values of a choice, by word."""
    labels = getattr(parameter, "names", None) or {}
    by_word = {word(value): label for label, value in labels.items()}
    return tuple(Option(value, by_word.get(value, value)) for value in options(parameter))


def chosen(parameter: AnyParameter, given: object) -> object:
    """Return the value that `given` means. Raises ValueError, with a reason, if there is none.

    `given` is a value or its word; for a list, a list or its words with commas between.
    """
    if isinstance(parameter, param.ListSelector):
        return [_one(parameter, item) for item in _items(given)]
    if isinstance(parameter, param.List):
        return [_name(item) for item in _items(given)]
    return _one(parameter, given)


def _one(parameter: AnyParameter, given: object) -> object:
    possible = options(parameter)
    text = word(given)
    if text not in possible:
        raise ValueError(f"“{excerpt(text)}” is not possible: choose one of {', '.join(possible)}.")
    return possible[text]


def _items(given: object) -> list[object]:
    items = [item for item in given.split(",") if item] if isinstance(given, str) else given
    if not isinstance(items, list) or len(items) > MOST_ITEMS:
        raise ValueError(f"“{excerpt(str(given))}” is not possible: give at most {MOST_ITEMS} names.")
    return items


def _name(item: object) -> str:
    if not isinstance(item, str) or not _ITEM.fullmatch(item):
        raise ValueError(f"“{excerpt(str(item))}” is not possible: a name has letters, digits, _.:+- only.")
    return item
