"""Where the Chromium for the browser tests is: the one that CHROMIUM names, or an installed one, or new.

`python -m tools.browsers.chromium` prints its path, or nothing where none could be had; the rest goes to stderr.
"""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys

from playwright.sync_api import sync_playwright

SHELL = "chromium-headless-shell"
"""Chromium without a window: a page costs two thirds of the usual CPU time."""
NAMES = (
    SHELL,
    "chromium",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "chromium-browser",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
)


def find() -> str | None:
    """Return the first Chromium that reports its version. So an empty wrapper does not count."""
    installed = (os.environ.get("CHROMIUM"), *map(shutil.which, NAMES))
    return next(filter(_answers, installed), None) or next(filter(_answers, [_playwrights_own()]), None)


def install() -> None:
    """Install Debian's Chromium without windows if this is root on Debian, and Playwright's own elsewhere."""
    if _is_debian() and os.geteuid() == 0:
        _run("apt-get", "update")
        _run("apt-get", "install", "--yes", "--no-install-recommends", SHELL, "fonts-liberation")
    else:
        _run(sys.executable, "-m", "playwright", "install", "chromium")


def _is_debian() -> bool:
    try:
        return platform.freedesktop_os_release()["ID"] == "debian"
    except OSError:
        return False


def _playwrights_own() -> str | None:
    with sync_playwright() as playwright:
        return shutil.which(playwright.chromium.executable_path)


def _answers(path: str | None) -> bool:
    if not path:
        return False
    try:
        return subprocess.run([path, "--version"], capture_output=True, timeout=30).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False


def _run(*command: str) -> None:
    print("$", *command, file=sys.stderr)
    subprocess.run(command, stdout=sys.stderr, check=False)


if __name__ == "__main__":
    if not find():
        install()
    print(find() or "")
