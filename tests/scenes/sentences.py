"""The visible sentences of a scene, as they are read."""

import re
from collections.abc import Iterator
from html import unescape
from typing import Any

from components.language.text import Forms
from components.layout.sheet import blocks, in_force
from components.layout.views import shown_blocks
from components.scene import Scene
from components.scene.face import SceneFace

TAG, LIVE = re.compile(r"<[^>]+>"), re.compile(r'<(\w+)[^>]*data-value="(\w+)"[^>]*></\1>')


def sentences(scene: Scene | SceneFace) -> list[str]:
    """Return the visible sentences of a scene, with live numbers filled in and formulas as plain text."""
    shown = set(map(id, shown_blocks(scene.sheet(), scene.values.get("view", ""))))
    seen = (block for block in in_force(scene.sheet(), scene.shown.forms) if id(block) in shown)
    return [text for block in seen for text in _texts(scene, block)]


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


def _texts(scene: Any, block: Any) -> Iterator[str]:
    for item in getattr(block, "items", ()):
        html = item.variants.get(scene.shown.forms.get(item.name, "") if item.name else "")
        if html:
            yield _read(scene, html)


def _read(scene: Any, html: str) -> str:
    """The words of a text, with the numbers of the picture."""
    words = TAG.sub("", LIVE.sub(lambda live: scene.shown.values.get(live[2], ""), html))
    return unescape(words).replace("\N{NO-BREAK SPACE}", " ")
