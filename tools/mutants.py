"""`python -m tools.mutants [NAME ...]` breaks a copy of the project, once for each fault, and prints what finds it.

Without names it puts in the faults of the register (tools/faults.py), each held against its own test files, and random
ones (tools/random_faults.py), each held against the tests that run its line. It prints the share that is found.

    --seed 20261127    the random faults of that seed; by default the date
    --random 30        so many random faults; 0 for none
    --tests FILE ...   only these test files for the random faults, without measuring which tests run a line
"""

from __future__ import annotations

import sys
import time
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import islice
from pathlib import Path
from queue import Queue
from tempfile import TemporaryDirectory

from tools.faults import MUTANTS, Mutant, broken
from tools.random_faults import AREAS, RandomFault, put, random_sites
from tools.tests_by_line import TestsByLine
from tools.trials import ROOT, copied, failures

SECONDS = 60.0
"""Measured duration of the tests that are tried for one random fault."""
WORKERS = 2
MutantTrial = Callable[[Path], tuple[str, bool]]
"""A function that puts a fault into a copy of the project. It returns a message, and whether a test has found the
fault."""


def known(mutant: Mutant, folder: Path) -> tuple[str, bool]:
    """Return a message about a fault of the register, and whether it is found."""
    found = failures(folder, mutant.file, broken(mutant, folder), mutant.tests.split())
    return f"{mutant.name:12} {'; '.join(found) or 'NOT FOUND by ' + mutant.tests}", bool(found)


def drawn(fault: RandomFault, tests: Sequence[str], folder: Path) -> tuple[str, bool]:
    """Return a message about a random fault, and whether it is found."""
    found = failures(folder, fault.site.file, fault.text, tests) if tests else []
    place = f"{fault.site.file}:{fault.site.line}"
    change = f"{_short(fault.old)} -> {_short(fault.new)}"
    return f"{place:44} {change:60} {'; '.join(found) or f'NOT FOUND by {len(tests)} tests'}", bool(found)


def _short(text: str) -> str:
    return text.splitlines()[0][:60]


def in_copies(top: Path, jobs: Sequence[MutantTrial]) -> list[bool]:
    """Run jobs, each in one of the copies of the project, print their messages, and return whether each fault was
    found."""
    free: Queue[Path] = Queue()
    for number in range(WORKERS):
        free.put(copied(ROOT, top / str(number)))

    def done(job: MutantTrial) -> bool:
        folder = free.get()
        try:
            said, is_found = job(folder)
        finally:
            free.put(folder)
        print(said, flush=True)
        return is_found

    with ThreadPoolExecutor(WORKERS) as pool:
        return list(pool.map(done, jobs))


def try_known(asked: Sequence[Mutant]) -> int:
    """The number of faults of the register that no test has found."""
    for mutant in asked:
        broken(mutant, ROOT)
    with TemporaryDirectory() as top:
        found = in_copies(Path(top), [partial(known, mutant) for mutant in asked])
    print(f"{sum(found)} of {len(asked)} faults of the register are found")
    return len(asked) - sum(found)


def try_random(seed: int, count: int, tests: Sequence[str]) -> None:
    """Print which random faults are found, and their share in each area."""
    faults = [put(ROOT, site) for site in islice(random_sites(ROOT, seed), count)]
    with TemporaryDirectory() as top:
        measured = TestsByLine(copied(ROOT, Path(top) / "sound"), ROOT / "build" / "tests-by-line")
        if not tests:
            measured.measure()
        jobs = [partial(drawn, one, tests or measured.tests(one.site.file, one.site.line, SECONDS)) for one in faults]
        found = in_copies(Path(top), jobs)
    for area in AREAS:
        of_area = [done for one, done in zip(faults, found, strict=True) if one.site.file.startswith(area)]
        print(f"{area}: {sum(of_area)} of {len(of_area)}")
    print(f"{sum(found)} of {len(faults)} random faults are found; seed {seed}")


def options(arguments: Sequence[str]) -> Namespace:
    """Return the choices of the command line."""
    parser = ArgumentParser(prog="python -m tools.mutants", description="Break a copy and see which test notices.")
    parser.add_argument("names", nargs="*", help="faults of the register")
    parser.add_argument("--seed", type=int, default=int(time.strftime("%Y%m%d")), help="of the random faults")
    parser.add_argument("--random", type=int, default=100, help="how many random faults")
    parser.add_argument("--tests", nargs="+", default=[], help="test files for the random faults")
    return parser.parse_args(arguments)


def main(arguments: Sequence[str]) -> int:
    """The number of faults of the register that no test has found."""
    asked = options(arguments)
    missed = 0
    if not asked.tests:
        missed = try_known([mutant for mutant in MUTANTS if not asked.names or mutant.name in asked.names])
    if asked.random and not asked.names:
        try_random(asked.seed, asked.random, asked.tests)
    return missed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
