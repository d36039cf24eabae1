"""The addresses of the live class."""

from __future__ import annotations

from typing import Any

from components.live_class.follower_routes import Answers, Enter, Events, Now, TimeOfDay
from components.live_class.instructor_routes import CountAnswers, LeadClass, OpenClass, TakeAnswers
from components.live_class.remote_routes import LetIn, RemoteControl

CODE = r"([0-9A-Za-z]{4})"


def class_routes() -> list[tuple[Any, ...]]:
    return [
        (r"/class", OpenClass),
        (r"/class/time", TimeOfDay),
        (rf"/class/{CODE}/lead", LeadClass),
        (rf"/class/{CODE}/tally", CountAnswers),
        (rf"/class/{CODE}/answers.csv", TakeAnswers),
        (rf"/class/{CODE}/tickets", LetIn),
        (rf"/class/{CODE}/remote", RemoteControl),
        (rf"/class/{CODE}/token", Enter),
        (rf"/class/{CODE}/events", Events),
        (rf"/class/{CODE}/now", Now),
        (rf"/class/{CODE}/answer", Answers),
    ]
