"""Which tests run a line: measured once by coverage, with the duration of each test, for `make mutants`.

The measurement takes about twice as long as `make fast`. It stays in build/tests-by-line until code or tests change.
"""

from __future__ import annotations

import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable
from functools import cached_property
from hashlib import sha256
from pathlib import Path

from coverage import CoverageData

MEASURED = ("components", "physics", "tests")
SETTINGS = "[run]\nsource = components,physics\nrelative_files = true\ndata_file = {}\n"
IN_MEMORY = "not browser and not slow"
"""The tests that can run in one process, without a page."""


class TestsByLine:
    """The tests of a folder that pass, by the lines of code that they run."""

    def __init__(self, folder: Path, kept: Path) -> None:
        self.folder = folder
        self.kept = kept / _digest(folder)[:16]

    def measure(self) -> None:
        """Run all fast tests without a browser, unless this code has been measured already."""
        if (self.kept / "times.xml").exists():
            return
        self.kept.mkdir(parents=True, exist_ok=True)
        settings = self.kept / "settings"
        settings.write_text(SETTINGS.format(self.kept / "lines"), encoding="utf-8")
        told = (f"--cov-config={settings}", f"--junitxml={self.kept / 'running.xml'}", "-o", "junit_family=xunit1")
        command = ("-m", "pytest", "-q", "-n", "2", "--dist", "worksteal", "-p", "no:cacheprovider", "-m", IN_MEMORY)
        coverage = ("--cov", "--cov-context=test", "--cov-report=", *told)
        subprocess.run([sys.executable, *command, *coverage], cwd=self.folder, check=False)
        (self.kept / "running.xml").rename(self.kept / "times.xml")

    def tests(self, file: str, line: int, seconds: float) -> list[str]:
        """Return tests that take so many seconds together, the quickest first: tests that run the line, then tests that
        run its file. For a line that runs at import or is cached, only the tests of its file are known."""
        of_line = self.of_line(file, line)
        of_file = {test for tests in self._data.contexts_by_lineno(file).values() for test in _named(tests)}
        return self.within(seconds, of_line, of_file - of_line)

    def of_line(self, file: str, line: int) -> set[str]:
        """Return the tests that run a line and pass."""
        return _named(self._data.contexts_by_lineno(file).get(line, [])) & self.seconds.keys()

    def within(self, seconds: float, *groups: set[str]) -> list[str]:
        """Return tests that take so many seconds together, group after group, the quickest of each first."""
        found, left = list[str](), seconds
        for group in groups:
            for test in sorted(group & self.seconds.keys(), key=lambda test: (self.seconds[test], test)):
                left -= self.seconds[test]
                if left > 0:
                    found.append(test)
        return found

    @cached_property
    def _data(self) -> CoverageData:
        data = CoverageData(str(self.kept / "lines"))
        data.read()
        return data

    @cached_property
    def seconds(self) -> dict[str, float]:
        """The duration of each test that passed."""
        cases = ElementTree.parse(self.kept / "times.xml").iter("testcase")
        return {
            f"{case.get('file')}::{case.get('name')}": float(case.get("time", 0)) for case in cases if not list(case)
        }


def _named(contexts: Iterable[str]) -> set[str]:
    """The tests of contexts such as "tests/page/test_names.py::test_one|run"."""
    return {context.rpartition("|")[0] for context in contexts}


def _digest(folder: Path) -> str:
    found = sha256()
    for top in MEASURED:
        for path in sorted((folder / top).rglob("*")):
            if path.suffix in (".py", ".toml", ".json", ".js"):
                found.update(path.read_bytes())
    return found.hexdigest()
