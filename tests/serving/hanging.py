"""A worker process in which some jobs never end."""

from __future__ import annotations

import sys
import time

from components.session import worker
from components.session.exports import LinkExport
from components.session.measured import Fitting
from components.session.worker import Reading, Replied, WorkerJob
from components.walks import Walks
from components.walks.links import Scenes


def replied(asked: WorkerJob, walks: Walks, scenes: Scenes) -> Replied:
    is_endless = asked.size > 1 if isinstance(asked, Fitting) else isinstance(asked, LinkExport)
    while is_endless or (isinstance(asked, Reading) and asked.name == "endless"):
        pass
    if isinstance(asked, Fitting) or (isinstance(asked, Reading) and asked.name == "asleep"):
        time.sleep(60)
    return Replied(refused="read")


if __name__ == "__main__":
    worker.replied = replied
    worker.work({}, {}, sys.stdin.buffer, sys.stdout.buffer)
