"""`make attack`: search for inputs that break a page. The search is bounded and repeatable; it fails if it finds one.

It combines extreme values of all scenes and parameters at random, set by link, slider, field, preset and button, with
malformed messages in between. It also tries malformed links and abuses the protocol of a server on this machine.
"""

from __future__ import annotations

import argparse
import logging
import sys
from collections.abc import Callable, Iterator
from time import monotonic
from traceback import format_exception

from hypothesis import HealthCheck, Phase, given, seed, settings

from components.scene import Scene
from components.scenes import SCENES
from tests.serving.server import ROOT, serving
from tools.attack import protocol, stage
from tools.attack.extremes import messages, queries, values
from tools.attack.result import AttackResult
from tools.attack.visit import follow, visit
from tools.browsers.chromium import find

LOG = ROOT / "build" / "attack" / "server.log"
PATIENCE = 2.0
"""Longest allowed answer in s: other visitors wait while one visitor's picture is computed."""
LINES = 40
"""Lines of the detail of a finding that are printed."""


def extremes(size: int, start: int) -> Iterator[AttackResult]:
    for slug, scene in SCENES.items():
        took: list[float] = []
        pages = hunt(f"{slug}: {size} pages at extremes", size, start, _pages(scene, took))
        yield pages._replace(detail=pages.detail or f"the slowest answer took {max(took):.2f} s")
        yield AttackResult(f"{slug}: no answer takes {PATIENCE:.0f} s", max(took) < PATIENCE)
        yield hunt(f"{slug}: {size} malformed links", size, start, given(queries(scene))(follow))


def _pages(scene: type[Scene], took: list[float]) -> Callable[[], None]:
    return given(values(scene), messages(scene))(
        lambda link, messages_sent: took.append(visit(scene.slug, link, messages_sent))
    )


def hunt(name: str, size: int, start: int, test: Callable[[], None]) -> AttackResult:
    """Check a property on `size` random examples. A failure is reported with its simplest example."""
    checks = {"suppress_health_check": list(HealthCheck), "deadline": None, "database": None}
    phases = (Phase.generate, Phase.shrink)
    try:
        seed(start)(settings(max_examples=size, derandomize=False, phases=phases, **checks)(test))()
    except Exception as error:
        return AttackResult(name, False, "".join(format_exception(error)))
    return AttackResult(name, True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", type=int, default=200, help="pages and links of each scene (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="a different seed tries different examples (%(default)s)")
    options = parser.parse_args()
    logging.disable(logging.WARNING)
    begun, failed = monotonic(), 0
    for finding in found(options.size, options.seed):
        failed += not finding.passed
        print(f"{monotonic() - begun:6.1f} s  {in_words(finding)}", flush=True)
    print(f"{failed} of the findings failed; seed {options.seed}." if failed else "All passed.")
    return 1 if failed else 0


def in_words(finding: AttackResult) -> str:
    """Return a line; for a failure also the last lines of its detail, which name the example."""
    if finding.passed:
        return f"passed  {finding.name}" + (f": {finding.detail}" if finding.detail else "")
    return "\n".join([f"FAILED  {finding.name}", *finding.detail.splitlines()[-LINES:]])


def found(size: int, start: int) -> Iterator[AttackResult]:
    yield from extremes(size, start)
    LOG.parent.mkdir(parents=True, exist_ok=True)
    with serving(LOG) as server:
        yield from protocol.attack(server.url)
        if find():
            yield from stage.attack(server.url, size, start)
        yield AttackResult("the log has no unexpected line", not server.complaints(), "\n".join(server.complaints()))


if __name__ == "__main__":
    sys.exit(main())
