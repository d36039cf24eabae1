"""Tests of a copy of the project with one fault, in a new process for each fault, for `make mutants`.

Importing the libraries takes longer than most tests. Each process is therefore a fork of one that has imported them,
and imports only the project.
"""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
LEFT = (".git", "build", "*_cache", "__pycache__", ".hypothesis")
SHARED = (".venv", "node_modules")
OURS = ("app", "components", "physics", "reading", "tests", "tools")
"""The project's own modules: a process imports them from its copy."""
LIBRARIES = ["bokeh.plotting", "mpmath", "numpy", "panel", "scipy.integrate", "scipy.linalg", "scipy.optimize"]
ENDLESS = 900.0
"""Seconds after which tests count as stopped by the fault."""

forks = get_context("forkserver")
forks.set_forkserver_preload(LIBRARIES)


def copied(source: Path, folder: Path) -> Path:
    """Return a copy of the project. Its compiled modules are checked by their content, because two faults can have the
    same size and second."""
    shutil.copytree(source, folder, ignore=shutil.ignore_patterns(*LEFT, *SHARED))
    for name in SHARED:
        (folder / name).symlink_to((source / name).resolve())
    compiled = ("-m", "compileall", "-q", "--invalidation-mode", "checked-hash", *OURS)
    subprocess.run([sys.executable, *compiled], cwd=folder, check=False, capture_output=True)
    return folder


def failures(folder: Path, file: str, faulty: str, tests: Sequence[str]) -> list[str]:
    """Return the first test that fails in a copy of the project with the fault, or another reason why they stop. Raises
    ValueError for a test file that does not exist.
    """
    if missing := [test for test in tests if not (folder / test.partition("::")[0]).exists()]:
        raise ValueError(f"There is no test file {missing[0]}.")
    path = folder / file
    sound = path.read_bytes()
    ours, theirs = forks.Pipe(duplex=False)
    process = forks.Process(target=_run, args=(theirs, folder, [*tests]))
    path.write_text(faulty, encoding="utf-8")
    try:
        process.start()
        theirs.close()
        return _answer(ours)
    finally:
        if process.pid:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.join()
        path.write_bytes(sound)


def _answer(process: Connection) -> list[str]:
    """Return what a process says of its tests. Raises EOFError if it does not start."""
    process.recv()
    if not process.poll(ENDLESS):
        return ["no end"]
    try:
        names: list[str] = process.recv()
    except EOFError:
        return ["the process ends"]
    return names


def _run(answer: Connection, folder: Path, tests: list[str]) -> None:
    """Run tests in a copy of the project until one fails."""
    os.setsid()
    answer.send(["started"])
    os.chdir(folder)
    with open(os.devnull, "w", encoding="utf-8") as nowhere:
        os.dup2(nowhere.fileno(), 1)
        os.dup2(nowhere.fileno(), 2)
    sys.dont_write_bytecode = True
    sys.path[:] = [str(folder), *(name for name in sys.path if name and Path(name) != ROOT)]
    for name in [name for name in sys.modules if name.partition(".")[0] in OURS]:
        del sys.modules[name]
    trial = _Trial(tests)
    files = [*dict.fromkeys(test.partition("::")[0] for test in tests)]
    code = pytest.main(["-q", "-x", "-m", "not slow", "-p", "no:cacheprovider", *files], plugins=[trial])
    # The code is 4 if conftest.py cannot be loaded.
    answer.send(trial.failed or ([f"exit {int(code)}"] if code not in (0, 5) else []))


class _Trial:
    """A plugin of pytest that runs tests in their order, and all of a file or folder, and notes which fail.

    The names of measured tests are those of a report, which writes some characters in another way: such a test is left
    out.
    """

    def __init__(self, tests: Sequence[str]) -> None:
        self.order = {test: place for place, test in enumerate(tests)}
        self.whole = tuple(test for test in tests if "::" not in test)
        self.failed = list[str]()

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Select the tests."""
        chosen = [item for item in items if item.nodeid in self.order or item.nodeid.startswith(self.whole)]
        items[:] = sorted(chosen, key=lambda item: self.order.get(item.nodeid, 0))

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Note a test that fails."""
        if report.failed:
            self.failed.append(report.nodeid)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Note a module that cannot be collected."""
        if report.failed:
            self.failed.append(report.nodeid)
