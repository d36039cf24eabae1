"""`python -m tools.browsers.installing` installs Safari's engine and Firefox from Debian, for the tests of `make rest`.

It needs root and a Debian whose archive has them; elsewhere it prints the reason and exits with 1.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

from tools.browsers import firefox, webkit

PACKAGES = ("webkit2gtk-driver", "gir1.2-webkit2-4.1", "python3-gi", "xvfb", "firefox-esr", "fonts-liberation")
INSTALL = ("apt-get", "install", "--yes", "--no-install-recommends", *PACKAGES)
FOUND = {"Safari's engine, WebKitGTK": webkit.find, "Firefox": firefox.find}


def missing() -> list[str]:
    return [name for name, find in FOUND.items() if not find()]


def refusal() -> str:
    """Return the reason why nothing can be installed here, or ""."""
    if not shutil.which("apt-get"):
        return "there is no apt-get"
    return "" if os.geteuid() == 0 else f"that needs root: sudo {' '.join(INSTALL)}"


def main() -> int:
    if not missing():
        print("Safari's engine and Firefox are installed.")
        return 0
    reason = refusal()
    for command in () if reason else (("apt-get", "update"), INSTALL):
        print("$", *command, flush=True)
        if subprocess.run(command, env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"}).returncode:
            reason = f"{' '.join(command[:2])} failed"
    for name in missing():
        print(f"{name} is not tested: {reason or 'the packages do not have it'}.")
    return bool(missing())


if __name__ == "__main__":
    sys.exit(main())
