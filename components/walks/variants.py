"""Variants of a step: its question with other numbers, so that students get different numbers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from urllib.parse import parse_qsl, urlencode

from msgspec.structs import replace

from components.quantities.formatting import MINUS, excerpt, shortest, three
from components.quantities.parameters import Quantity
from components.scene import Scene
from components.walks.expressions import numbers_of, worked_out
from components.walks.types import Span
from components.walks.walk import Step

VARIANTS = 37
"""Number of variants of a step, with the seeds from 1 on; a prime, so that any stride reaches all values of a range."""
STRIDES = (1, 8, 14, 5)
"""For each quantity, by how many values of its range the next variant moves on. The numbers differ, so that the
quantities do not change together."""
NUMBER = re.compile(r"\$[^$]+\$|(?<![_^])\{([\w\s.+*/^()-]+)\}")
"""A formula, which does not change, or an expression in braces."""


def varied(step: Step, seed: int) -> Step:
    """Return the step with the numbers of a seed; 0 means the numbers of its file. Raises ValueError, with a reason,
    for an unknown seed. A value that the answer changes keeps the number of its file."""
    if seed == 0:
        return step
    if not step.vary:
        raise ValueError("seed: this step has the same numbers for all.")
    if seed > VARIANTS:
        raise ValueError(f"seed: {seed} is none; they go from 1 to {VARIANTS}.")
    numbers = {name: shortest(number) for name, number in numbers_drawn(step, seed).items()}
    asked, told = _query(step.state), _query(step.reveal)
    kept = {name for name in numbers if name in told and told[name] != asked.get(name)}
    reveal = _link(told | {name: text for name, text in numbers.items() if name not in kept}) if told else ""
    return replace(step, state=_link(asked | numbers), reveal=reveal)


def variants_of(step: Step) -> Iterator[tuple[int, Step]]:
    """Yield the seed and the step of each variant; nothing for a step without `vary`."""
    yield from ((seed, varied(step, seed)) for seed in range(1, VARIANTS + 1) if step.vary)


def numbers_drawn(step: Step, seed: int) -> dict[str, float]:
    """Return the numbers of a seed, in SI, with as few digits as distinguish the seeds."""
    strides = zip(step.vary.items(), STRIDES, strict=False)
    return {name: _at(span, seed * stride % VARIANTS / (VARIANTS - 1)) for (name, span), stride in strides}


def _at(span: Span, share: float) -> float:
    """Return a round number at a share of a span; its end for the share 1."""
    low, high = span
    least = 10.0 ** max(math.floor(math.log10((high - low) / VARIANTS)), -300)
    return high if share == 1 else float(f"{low + least * math.floor(share * (high - low) / least + 1e-9):.15g}")


def strange_spans(step: Step, kind: type[Scene]) -> Iterator[str]:
    """Return a sentence for each entry of `vary` that is not a possible range of a quantity of the scene."""
    for name, (low, high) in step.vary.items():
        if not isinstance(kind.linked().get(name), Quantity):
            yield f"vary: “{excerpt(name)}” is no quantity of this scene."
        elif not low < high or math.isinf(high - low):
            yield f"vary: {name} goes from {low:g} to {high:g}: give two numbers, the smaller one first."


def with_numbers(text: str, scene: Callable[[], Scene]) -> str:
    """Return a text with the value of each {expression} outside formulas: parameters with all digits, other numbers
    with three."""

    def number(match: re.Match[str]) -> str:
        if not match[1]:
            return match[0]
        own = scene().values.get(match[1])
        if isinstance(own, float):
            return shortest(own).replace("-", MINUS)
        return three(worked_out(match[1], numbers_of(scene())))

    return NUMBER.sub(number, text)


def numbers_text(numbers: Mapping[str, float]) -> str:
    """Return numbers as text: "k1 = 0.5, k2 = 3"."""
    return ", ".join(f"{name} = {shortest(number)}" for name, number in numbers.items())


def _query(link: str) -> dict[str, str]:
    return dict(parse_qsl(link.removeprefix("?"), keep_blank_values=True))


def _link(query: Mapping[str, str]) -> str:
    return f"?{urlencode(query, safe=',:')}"
