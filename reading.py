"""The worker process of a server: `python -m reading FOLDER ...`, with the folders of its walks. It serves no page."""

from __future__ import annotations

import sys
from pathlib import Path

from components.scenes import SCENES
from components.session.worker import prepare, work
from components.walks.registry import all_walks
from physics.integrators.accuracy_worker import restrain

NICENESS = 5
"""On a busy machine the server then gets about three times as much time as this process, for which visitors wait
too."""

if __name__ == "__main__":
    walks = all_walks(map(Path, sys.argv[1:]), SCENES)
    prepare(walks, SCENES)  # at low priority this may take minutes
    restrain(NICENESS)
    work(walks, SCENES, sys.stdin.buffer, sys.stdout.buffer)
