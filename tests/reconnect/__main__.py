"""`make reconnect` loses the connection in every way there is, many times, and says what stood when it was back.

A run that ends with another value in picture or control than was set last is told with its seed; the exit code says it.
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

from tests.browser.chromium import find
from tests.reconnect.losses import LOSSES, too_late, visit
from tests.reconnect.site import Site


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, prog="make reconnect ARGS=...")
    parser.add_argument("--runs", type=int, default=20, help="of each way (20)")
    parser.add_argument("--seconds", type=float, default=60.0, help="that a network is away (60)")
    parser.add_argument("--only", default="", help="a part of the name of a way")
    options = parser.parse_args()
    ways: dict[str, Callable[[Page, Site, int], None]] = {
        name: lambda page, site, seed, loss=loss: visit(page, site, loss, seed, options.seconds)  # type: ignore[misc]
        for name, loss in LOSSES.items()
    }
    ways["token past its time"] = too_late
    failed = 0
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find())
        for name, way in ways.items():
            if options.only in name:
                failed += _tried(browser, name, way, options.runs)
        browser.close()
    return 1 if failed else 0


def _tried(browser: Browser, name: str, way: Callable[[Page, Site, int], None], runs: int) -> int:
    """The number of runs that lose a last value; it is printed, with the time of a run."""
    times, failed = [], 0
    with TemporaryDirectory() as folder, Site(Path(folder)) as site:
        for seed in range(runs):
            context = browser.new_context(viewport={"width": 1280, "height": 720}, bypass_csp=True)
            start = time.monotonic()
            try:
                way(context.new_page(), site, seed)
            except Exception as error:
                failed += 1
                print(f"  {name}, seed {seed}: {error}")
            times.append(time.monotonic() - start)
            context.close()
    print(f"{name}: all stood in {runs - failed} of {runs} runs; {median(times):.1f} s a run", flush=True)
    return failed


if __name__ == "__main__":
    sys.exit(main())
