"""The process that reads walks of strangers for a server: `python -m reading FOLDER ...`. It knows no page."""

from __future__ import annotations

import sys
from pathlib import Path

from components.scenes import SCENES
from components.session.worker import prepare, work
from components.walks.registry import all_walks
from physics.accuracy_worker import restrain

if __name__ == "__main__":
    walks = all_walks(map(Path, sys.argv[1:]), SCENES)
    prepare(walks, SCENES)  # at once, since somebody waits: with low priority it may take minutes
    restrain()
    work(walks, SCENES, sys.stdin.buffer, sys.stdout.buffer)
