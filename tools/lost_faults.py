"""`python -m tools.lost_faults BEFORE` compares changed tests with the earlier ones: which faults are found no more?

BEFORE is another checkout, with the earlier tests, in which `make mutants` has measured which tests run a line. This
checkout has the changed tests; both have the same product. Each random fault is in a line that earlier tests of the
changed files run. If one of them finds it, some test of this checkout must find it too; otherwise it is printed.
All tests must pass without a fault: one that fails counts as finding each.

    --count 60         so many random faults, of all areas in turn
    --seed 20261127    other faults
    --seconds 200      more of the earlier and of the unchanged tests for each fault
    --files tests/physics    only changed test files whose path contains this
"""

from __future__ import annotations

import subprocess
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from tools.random_faults import RandomFault, Site, put, random_sites
from tools.tests_by_line import TestsByLine
from tools.trials import ROOT, copied, failures


class Compared(NamedTuple):
    """Test files that differ, the tests of this checkout that are in them, copies of both checkouts, and the measured
    duration of the tests that are tried for one fault."""

    changed: frozenset[str]
    current: frozenset[str]
    measured: TestsByLine
    before: Path
    after: Path
    seconds: float

    def earlier(self, site: Site) -> list[str]:
        """Return the earlier tests of changed files that run the line of a fault."""
        tests = self.measured.of_line(site.file, site.line)
        return self.measured.within(self.seconds, {test for test in tests if _file(test) in self.changed})

    def found(self, fault: RandomFault) -> list[str]:
        """Return the test of this checkout that finds a fault: an unchanged one, then one of the changed files."""
        tests = self.measured.of_line(fault.site.file, fault.site.line)
        tests = {test for test in tests if (self.after / _file(test)).exists()}
        kept = {test for test in tests if _file(test) not in self.changed or test in self.current}
        new = sorted(self.current - self.measured.seconds.keys())
        for some in (self.measured.within(self.seconds, kept), new):
            if some and (names := failures(self.after, fault.site.file, fault.text, some)):
                return names
        return []


def changed_files(before: Path, part: str) -> frozenset[str]:
    """Return the test files that differ from those of another checkout, or are in one of both only."""
    names = {path.relative_to(top).as_posix() for top in (before, ROOT) for path in (top / "tests").rglob("test_*.py")}
    return frozenset(name for name in names if part in name and _text(before / name) != _text(ROOT / name))


def collected(files: Sequence[str]) -> frozenset[str]:
    """Return the names of the quick tests of files that need no browser."""
    command = [sys.executable, "-m", "pytest", "--collect-only", "-q", "-m", "not slow and not browser", *files]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False).stdout
    return frozenset(line for line in listed.splitlines() if "::" in line)


def compare(asked: Namespace) -> Iterator[tuple[str, bool]]:
    """Yield a message about each fault that earlier tests find, and whether it is lost."""
    before = Path(asked.before).resolve()
    changed = changed_files(before, asked.files)
    current = collected([name for name in sorted(changed) if (ROOT / name).exists()])
    with TemporaryDirectory() as top:
        folders = copied(before, Path(top) / "before"), copied(ROOT, Path(top) / "after")
        measured = TestsByLine(folders[0], before / "build" / "tests-by-line")
        compared = Compared(changed, current, measured, *folders, asked.seconds)
        sites = (site for site in random_sites(ROOT, asked.seed) if compared.earlier(site))
        for fault in (put(ROOT, site) for site in islice(sites, asked.count)):
            if names := failures(folders[0], fault.site.file, fault.text, compared.earlier(fault.site)):
                place = f"{fault.site.file}:{fault.site.line}  {fault.old.splitlines()[0]} -> {fault.new}"
                found = compared.found(fault)
                yield (f"{place}\n    {names[0]} -> {found[0] if found else 'LOST'}", not found)


def _file(test: str) -> str:
    return test.partition("::")[0]


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8") if path.exists() else ""


def main(arguments: Sequence[str]) -> int:
    """Return the number of faults that are lost."""
    parser = ArgumentParser(prog="python -m tools.lost_faults", description="Compare changed tests by random faults.")
    parser.add_argument("before", help="a checkout with the earlier tests, measured by make mutants")
    parser.add_argument("--count", type=int, default=60, help="how many random faults")
    parser.add_argument("--seed", type=int, default=1, help="of the random faults")
    parser.add_argument("--seconds", type=float, default=40.0, help="measured duration of the tests for one fault")
    parser.add_argument("--files", default="", help="a part of the paths of the changed test files")
    found, lost = 0, 0
    for message, is_lost in compare(parser.parse_args(arguments)):
        print(message, flush=True)
        found, lost = found + 1, lost + is_lost
    print(f"{lost} of {found} faults that earlier tests find are lost")
    return lost


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
