"""Cards: the part of a walk that the browser gets before its questions are answered, in an immutable file."""

from __future__ import annotations

import re
from hashlib import sha256

import msgspec
from msgspec.structs import replace

from components.language.walk import StepCard, WalkSheet, WalkTrial
from components.layout.text import rich
from components.walks.links import Scenes
from components.walks.subject import Subject
from components.walks.texts import FORMULA
from components.walks.variants import variants_of, with_numbers
from components.walks.walk import Step, Walk

SENTENCE = re.compile(r"(?<=[.?!]) (?=[A-ZΑ-Ω*√½\"“])|(?<=[。？！])")
ASKS = re.compile(r"[?？]$|^(Sketch|Mark)\b")


def walk_sheet(walk: Walk, scenes: Scenes) -> WalkSheet:
    steps = tuple(_card_with_variants(walk.name, step, scenes) for step in walk.steps)
    trials = tuple(WalkTrial(scene=one.scene, title=rich(one.title), text=rich(one.text)) for one in walk.trials)
    return WalkSheet(name=walk.name, title=walk.title, steps=steps, end=tuple(map(rich, walk.end)), trials=trials)


def walk_file(walk: Walk, scenes: Scenes) -> tuple[str, bytes]:
    """Return the sheet of a walk for the browser, at an address with the hash of its content."""
    content = msgspec.json.encode(walk_sheet(walk, scenes))
    return f"walks/{walk.name}.{sha256(content).hexdigest()[:16]}.json", content


def _card_with_variants(walk: str, step: Step, scenes: Scenes) -> StepCard:
    variants = tuple(step_card(walk, one, scenes, seed) for seed, one in variants_of(step))
    return replace(step_card(walk, step, scenes), variants=variants)


def step_card(walk: str, step: Step, scenes: Scenes, seed: int = 0) -> StepCard:
    """Return the card of a step with the numbers of a seed."""
    subject = Subject(walk, step, scenes, seed)
    given, question = parted(asked(step, subject))
    opens = subject.opening
    return step.card(
        subject,
        id=step.id,
        kind=step.kind,
        place=place_in_lecture(step.slides),
        scene=scenes[opens.scene].title,
        given=rich(given),
        question=rich(question),
        minutes=step.planned,
        core=step.core,
        derive=step.derive,
        closes=step.closes,
        opens=opens,
        reveals=subject.answer,
        controls=step.controls,
    )


def asked(step: Step, subject: Subject) -> str:
    """Return the question of a step with its numbers. Raises ValueError, with a reason, if the scene does not have
    them."""
    return with_numbers(step.question, lambda: subject.page_state.scene)


def parted(question: str) -> tuple[str, str]:
    """Split a question's text in two: the given facts, and the text from the first sentence that asks something."""
    parts = sentences(question)
    first = next((i for i, sentence in enumerate(parts) if ASKS.search(sentence)), 0)
    return " ".join(parts[:first]), " ".join(parts[first:])


def sentences(text: str) -> list[str]:
    """Return the sentences of a text. A formula is never split."""
    whole = FORMULA.sub(lambda match: match[0].replace(" ", "\0"), text)
    return [sentence.replace("\0", " ") for sentence in SENTENCE.split(whole) if sentence]


def place_in_lecture(slides: tuple[str, ...]) -> str:
    """Return the place of a step in the lecture: "D34, slide 8"."""
    if not slides:
        return ""
    lecture, _, page = slides[0].partition("-")
    return f"{lecture}, notes {page[1:]}" if page.startswith("N") else f"{lecture}, slide {page}"
