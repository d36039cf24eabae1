"""`make audit` looks for known vulnerabilities of the pinned packages, and reports if it cannot."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
LOCK = "requirements.txt"
COMMAND = ("-m", "pip_audit", "--requirement", LOCK, "--require-hashes", "--disable-pip")
SILENT = ("--format", "json", "--progress-spinner", "off", "--timeout", "20")


def findings(report: dict[str, Any]) -> Iterator[str]:
    """Return the vulnerabilities in a report of pip-audit, one sentence per line; "" if no package has any.

    pip-audit calls a run in which it could look nothing up a success.
    """
    packages = report["dependencies"]
    unknown = [package["name"] for package in packages if "skip_reason" in package]
    if len(unknown) == len(packages):
        yield "The audit could not be asked: nothing is known of any package."
    elif unknown:
        yield f"Not looked up: {', '.join(unknown)}."
    for package in packages:
        for fault in package.get("vulns", ()):
            mended = ", ".join(fault["fix_versions"]) or "none"
            yield f"{package['name']} {package['version']}: {fault['id']}; mended in {mended}."


def main() -> None:
    ran = subprocess.run([sys.executable, *COMMAND, *SILENT], cwd=ROOT, capture_output=True, text=True)
    try:
        said = list(findings(json.loads(ran.stdout)))
    except ValueError:
        reason = (ran.stderr.strip().splitlines() or ["pip-audit says nothing"])[-1]
        said = [f"The audit could not be asked: {reason}"]
    print("\n".join(said) or f"The audit was asked: nothing is known against the packages of {LOCK}.")
    sys.exit(bool(said))


if __name__ == "__main__":
    main()
