"""A process like the one that reads walks, which comes to no end with some of them."""

from __future__ import annotations

import sys
import time

from components.walks import Walks, apart
from components.walks.apart import Errand, Reading, Replied
from components.walks.links import Scenes


def replied(asked: Errand, walks: Walks, scenes: Scenes) -> Replied:
    while isinstance(asked, Reading) and asked.name == "endless":
        pass
    if isinstance(asked, Reading) and asked.name == "asleep":
        time.sleep(60)
    return Replied(refused="read")


if __name__ == "__main__":
    apart.replied = replied
    apart.work({}, {}, sys.stdin.buffer, sys.stdout.buffer)
