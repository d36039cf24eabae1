"""The rules of `python -m tools.docstrings`, one by one."""

from __future__ import annotations

import pytest

from tools.docstrings import gaps_of

PARAMETER, RETURNS = "    Parameters\n    ---\n    a : int\n", "    Returns\n    ---\n    int\n"
RAISES = "    Raises\n    ---\n    ValueError\n        Always.\n"
RULES = [
    ('def f():\n    """x and v."""', ("a first word",)),
    ('def f():\n    """True if it swings."""', ("a first word",)),
    ('def f():\n    """A curve."""', ()),
    ('class A:\n    """A."""\n    @property\n    def x(self) -> bool:\n        """True if it swings."""', ()),
    ("def f(a):\n    pass", ("a docstring",)),
    ('def f(a, b):\n    """Return the sum."""', ("a", "b")),
    ('def f(a, b):\n    """Return a + b."""', ()),
    ('def f(a, b, c):\n    """Return a + b + c."""', ("a", "b", "c")),
    (f'def f(a) -> int:\n    """Double a.\n\n{PARAMETER}    """', ("Returns",)),
    (f'def f(a) -> int:\n    """Double it.\n\n{RETURNS}    """', ("a",)),
    (f'def f(a) -> int:\n    """Double it.\n\n{PARAMETER}\n{RETURNS}    """', ()),
    ('def f(a, b, c):\n    """Springs. Parameters and result as in `Runner`."""', ()),
    ('def f():\n    """Fail."""\n    raise ValueError("no")', ("ValueError",)),
    (f'def f():\n    """Fail.\n\n{RAISES}    """\n    raise ValueError("no")', ()),
    ('class A:\n    """A."""\n    @property\n    def x(self) -> float:\n        """The length in m."""', ()),
    ('@dataclass\nclass A:\n    """A record."""\n    a: int', ("a",)),
    (f'@dataclass\nclass A:\n    """A record.\n\n{PARAMETER}    """\n    a: int', ()),
]


@pytest.mark.parametrize(("code", "lacks"), RULES)
def test_a_docstring_explains_parameters_results_and_errors(code: str, lacks: tuple[str, ...]) -> None:
    found = list(gaps_of("physics/one.py", f'"""Source: lecture D31, slide 4."""\n{code}'))
    assert [one.lacks for one in found] == ([lacks] if lacks else [])


@pytest.mark.parametrize("words", ["Motions.", "The motion at 1000 times.", "Widths of sliders."])
def test_a_module_names_its_source(words: str) -> None:
    assert [one.lacks for one in gaps_of("physics/one.py", f'"""{words}"""')] == [("a source",)]
    assert list(gaps_of("physics/valid.py", f'"""{words}"""')) == []
    assert list(gaps_of("physics/one.py", f'"""{words} Source: Den Hartog (1956)."""')) == []
