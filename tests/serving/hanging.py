"""A worker process that reads nothing, and in which the walk “endless” never ends."""

from __future__ import annotations

import sys

from components.session import worker
from components.session.worker import Reading, Replied, WorkerJob
from components.walks import Walks
from components.walks.links import Scenes


def replied(asked: WorkerJob, walks: Walks, scenes: Scenes) -> Replied:
    while isinstance(asked, Reading) and asked.name == "endless":
        pass
    return Replied(refused="read")


if __name__ == "__main__":
    worker.replied = replied
    worker.work({}, {}, sys.stdin.buffer, sys.stdout.buffer)
