"""`make deploy-test`: two replicas behind the real proxy. One is killed while visitors change values; then an upgrade.

Picture and control must show every value that was set last. The longest wait is printed. ARGS="--runs 3 --guests 10"
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from tools.deploy.site import deployed
from tools.deploy.trials import FailureTrial, failure, upgrade

AIM = 2.0
"""Seconds after which every visitor should be served again."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=20, help="times that a replica is killed (%(default)s)")
    parser.add_argument("--guests", type=int, default=40, help="visitors changing things (%(default)s)")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name, deployed(Path(name)) as site:
        trials = []
        for run in range(options.runs):
            trials.append(failure(site, options.guests, run % 2))
            print(f"killed, {run + 1}: {_in_words(trials[-1])}", flush=True)
        trials.append(upgrade(site, options.guests, Path(name) / "later"))
        print(f"upgraded: {_in_words(trials[-1])}")
        complaints = site.complaints()
    print(*complaints, sep="\n")
    sys.exit(any(trial.lost or trial.longest > AIM for trial in trials) or bool(complaints))


def _in_words(trial: FailureTrial) -> str:
    lost = f"; lost: {'; '.join(trial.lost)}" if trial.lost else "; nothing lost"
    return f"{trial.returned} came back, a change took {trial.longest:.2f} s at most{lost}"


if __name__ == "__main__":
    main()
