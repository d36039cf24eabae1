"""`make reconnect`: lose the connection in every possible way, many times, and check the values after reconnecting.

A run fails if picture or control shows another value than the last one set. The failure is printed with its seed, and
the exit code is then 1.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from playwright.sync_api import Browser, Page, sync_playwright

from tools.browsers.chromium import find
from tools.reconnect.losses import LOSSES, too_late, visit
from tools.reconnect.site import GatedSite


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, prog="make reconnect ARGS=...")
    parser.add_argument("--runs", type=int, default=20, help="runs of each kind of loss (20)")
    parser.add_argument("--seconds", type=float, default=60.0, help="seconds without a network (60)")
    parser.add_argument("--only", default="", help="a part of the name of a kind of loss")
    options = parser.parse_args()
    kinds: dict[str, Callable[[Page, GatedSite, int], None]] = {
        name: lambda page, site, seed, loss=loss: visit(page, site, loss, seed, options.seconds)  # type: ignore[misc]
        for name, loss in LOSSES.items()
    }
    kinds["expired token"] = too_late
    failed = 0
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find())
        for name, lose in kinds.items():
            if options.only in name:
                failed += _tried(browser, name, lose, options.runs)
        browser.close()
    return 1 if failed else 0


def _tried(browser: Browser, name: str, lose: Callable[[Page, GatedSite, int], None], runs: int) -> int:
    """Return the number of runs that lose a value. It is printed with the duration of a run."""
    times, failed = [], 0
    with TemporaryDirectory() as folder, GatedSite(Path(folder)) as site:
        for seed in range(runs):
            context = browser.new_context(viewport={"width": 1280, "height": 720}, bypass_csp=True)
            start = time.monotonic()
            try:
                lose(context.new_page(), site, seed)
            except Exception as error:
                failed += 1
                print(f"  {name}, seed {seed}: {error}")
            times.append(time.monotonic() - start)
            context.close()
    print(f"{name}: nothing lost in {runs - failed} of {runs} runs; {median(times):.1f} s a run", flush=True)
    return failed


if __name__ == "__main__":
    sys.exit(main())
