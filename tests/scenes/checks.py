"""Checks that the picture of each scene must pass for any parameters, and its visible sentences as they are read."""

import math
import re
from collections.abc import Callable, Iterable, Iterator
from decimal import Decimal
from html import unescape
from typing import Any
from urllib.parse import parse_qs

import numpy as np
import param
from hypothesis import Phase, given, settings

from components.language.text import Forms
from components.layout.choices import options
from components.layout.controls import Choice
from components.layout.sheet import blocks, in_force
from components.layout.views import shown_blocks
from components.quantities.parameters import Quantity
from components.scene import Scene
from components.scene.face import SceneFace
from components.scenes import SCENES
from components.session.opening import opened
from components.session.session import Session
from components.state.link import read_query
from components.state.page_state import PageState
from tests.grids import tries
from tests.page.headless_page import picture_wire
from tests.physics.truth import Truth
from tests.states import values

TAG, LIVE = re.compile(r"<[^>]+>"), re.compile(r'<(\w+)[^>]*data-value="(\w+)"[^>]*></\1>')
LONG_NUMBER = re.compile(r"\d{7,}|\d\.\d{6,}|\bnan\b|\binf\b|e[-+]?\d", re.IGNORECASE)
HYPHEN = re.compile(r"(?<![\w)\]])-\s?\.?\d")
"""Matches a hyphen that is used as a minus sign."""
SIZES = {"force": "F_0", "base": "Y", "unbalance": "moment"}
"""The parameter with the size of each kind of drive."""
System = tuple[int, int, int]
UNITS = {
    "kg": (1, 0, 0), "m": (0, 1, 0), "s": (0, 0, 1), "N": (1, 1, -2), "J": (1, 2, -2), "W": (1, 2, -3),
    "Hz": (0, 0, -1), "H": (1, 2, 0), "F": (-1, -2, 2),
}  # fmt: skip
"""Powers of mass, length and time in each unit that has some."""


def quantities(scene: type[Scene]) -> dict[str, Quantity]:
    return {name: p for name in scene.param if isinstance(p := scene.param[name], Quantity) and p.default is not None}


def choices(scene: type[Scene]) -> Iterator[dict[str, Any]]:
    """Every value of every choice, alone."""
    for name, parameter in scene.linked().items():
        if isinstance(parameter, Choice) and not isinstance(parameter, param.ListSelector):
            yield from ({name: value} for value in options(parameter).values())


def in_any_state(
    kind: type[Scene],
    see: Callable[[Any], Any],
    check: Callable[[Any, Any], object],
    count: int,
    decades: float = 2.0,
    rare: Iterable[dict[str, Any]] = (),
    **shown: Any,
) -> None:
    """Check what is seen of a scene in each preset, in rare states, and in `count` random ones, with the values
    `shown`. States that the scene refuses are skipped. A failing state is reported unshrunk: shrinking takes minutes.
    """

    def compare(state: dict[str, Any]) -> None:
        try:
            seen = see(scene := kind.at({**state, **shown}))
        except ValueError:  # in words
            return
        check(scene, seen)

    for state in (*map(kind.preset_all, kind.presets), *rare):
        compare(dict(state))
    if count:
        random = settings(max_examples=tries(count), phases=(Phase.explicit, Phase.generate))
        random(given(values(kind, decades))(compare))()


def check_picture(scene: Scene | PageState) -> None:
    """All numbers of the picture, as Python has them and as they are sent, are finite, and its texts can be read.

    Columns and samples are sent as integers. Any other number that is not finite would be null, which `picture_wire`
    refuses. Numbers that only the browser draws may raise ValueError, if doubles cannot hold them.
    """
    try:
        drawn = scene.shown.sources
    except ValueError as reason:
        assert "doubles" in str(reason) or "more digits of arithmetic" in str(reason), reason
        drawn = scene.shown.columns
    for source, data in drawn.items():
        for name, column in data.items():
            assert np.all(np.isfinite(column)), f"{source}.{name}"
    message = picture_wire(scene)
    for name, text in {**message["values"], **{f"note {i}": n for i, n in enumerate(message["notes"])}}.items():
        assert not LONG_NUMBER.search(text) and not HYPHEN.search(text), f"{name}: {text}"
    for axis in message["axes"].values():
        assert axis["start"] != axis["end"] and not any(LONG_NUMBER.search(label) for label in axis["labels"]), axis


def as_arguments(query: str) -> dict[str, list[bytes]]:
    """Return the query of a link as the server parses it."""
    return {name: [v.encode() for v in values] for name, values in parse_qs(query, keep_blank_values=True).items()}


def changes(scene: type[Scene]) -> Iterator[dict[str, float]]:
    """Every quantity of the panel, each alone at another value."""
    known, forms = quantities(scene), scene().shown.forms
    names = [name for group in scene.groups if group.is_shown(forms) for name in group.names if name in known]
    for name in names:
        value = 0.37 * known[name].softbounds[0] + 0.63 * known[name].softbounds[1]
        yield {name: round(value) if known[name].scale == "count" else value}


def by_link(query: str) -> Session:
    """The session that a link opens."""
    return opened(SCENES, read_query(as_arguments(query), SCENES))


def taken(slug: str, label: str) -> Any:
    """A scene after a preset was chosen."""
    scene = SCENES[slug]()
    scene.set(SCENES[slug].preset_all(label))
    return scene


def harmonics(s: Any, count: int) -> tuple[Any, Any]:
    """The harmonics of a push from 1 to below `count`: |f_n| in N and |X_n| in m."""
    n = np.arange(1, count)
    f = {
        "impulses": np.full(len(n), s.J * s.omega / math.pi),
        "square": 4 * s.F_0 / (n * math.pi) * (n % 2),
        "triangle": 8 * s.F_0 / (n * math.pi) ** 2 * (n % 2),
        "pulses": 2 * s.F_0 * np.abs(np.sin(n * math.pi * s.width)) / (n * math.pi),
    }[s.push]
    with np.errstate(divide="ignore", invalid="ignore"):
        return f, f / np.abs(s.k - s.m * (n * s.omega) ** 2 + 1j * n * s.c * s.omega)


def modes_of(s: Any) -> Truth:
    """The modes of the masses and springs of a scene, with many digits."""
    return Truth(s.m1, s.m2, s.k1, s.k2)


def power(unit: str, system: System) -> int:
    above, _, below = unit.partition("/")
    parts = [*((part, 1) for part in above.split()), *((part, -1) for part in below.split())]
    sizes = {"²": 2, "³": 3}
    return sum(
        sign * sizes.get(part[-1], 1) * own * unit
        for part, sign in parts
        for own, unit in zip(UNITS.get(part.rstrip("²³"), (0, 0, 0)), system, strict=True)
    )


def scaled(scene: Scene, system: System) -> Any:
    """The state with its numbers in a system of units."""
    found = {name: scene.values[name] for name in scene.linked() if name != "zeta"}
    for name, quantity in scene.linked().items():
        if isinstance(quantity, Quantity) and found.get(name) is not None:
            found[name] = float(Decimal(repr(float(found[name]))).scaleb(power(quantity.unit, system)))
    return scene.at(found)


def sentences(scene: Scene | SceneFace) -> list[str]:
    """Return the visible sentences of a scene, with live numbers filled in and formulas as plain text."""
    shown = set(map(id, shown_blocks(scene.sheet(), scene.values.get("view", ""))))
    seen = (block for block in in_force(scene.sheet(), scene.shown.forms) if id(block) in shown)
    items: Iterator[Any] = (item for block in seen for item in getattr(block, "items", ()))
    forms = ((item.variants, scene.shown.forms.get(item.name, "") if item.name else "") for item in items)
    return [_read(scene, variants[form]) for variants, form in forms if variants.get(form)]


def visible_text(scene: Scene | SceneFace) -> str:
    return "\n".join(sentences(scene))


def said(scene: Scene | SceneFace, name: str) -> str:
    """Return the sentences with a name, in the form of the picture."""
    form = scene.shown.forms[name]
    return "\n".join(_read(scene, one.variants[form]) for one in _named(scene, name) if form in one.variants)


def wordings(scene: type[Scene], name: str) -> set[str]:
    """Return all forms of a sentence."""
    return {form for one in _named(scene, name) for form in one.variants}


def number(text: str) -> float:
    """Return a number as the page writes it: −1.23·10⁻⁷."""
    plain = text.replace("−", "-").replace("·10", "e").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    return float(plain.replace("+", ""))


def numbers(text: str) -> list[float]:
    return [number(found) for found in re.findall(r"[−+]?\d+(?:\.\d+)?(?:·10[⁻⁰¹²³⁴-⁹]+)?", text)]


def _named(scene: Any, name: str) -> Iterator[Forms]:
    texts = (one for block in blocks(scene.sheet()) for one in getattr(block, "items", ()))
    return (one for one in texts if name and one.name == name)


def _read(scene: Any, html: str) -> str:
    """The words of a text, with the numbers of the picture."""
    words = TAG.sub("", LIVE.sub(lambda live: scene.shown.values.get(live[2], ""), html))
    return unescape(words).replace("\N{NO-BREAK SPACE}", " ")
