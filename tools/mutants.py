"""`python -m tools.mutants [NAME ...]` breaks a copy of the project in some twenty ways, one by one, and prints the
test that finds each fault. Of the fast tests in the files named for a fault, at least one must fail; all pass on the
unbroken copy.

A pattern must occur exactly once in its file; otherwise the tool stops, so that no fault is skipped.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
LEFT = (".git", "build", "*_cache", "__pycache__", ".hypothesis")
SHARED = (".venv", "node_modules")
FAILED = re.compile(r"^(?:FAILED|ERROR) (\S+)", re.M)


@dataclass(frozen=True)
class Mutant:
    """A fault: what is written in a file in place of what, and the files of tests that must find it."""

    name: str
    file: str
    old: str
    new: str
    tests: str


MUTANTS = (
    # physics
    Mutant(
        "sign", "physics/oscillator.py", "exact(v_0), -omega * omega", "exact(v_0), omega * omega",
        "tests/physics/test_oscillator.py",
    ),
    Mutant(
        "digits", "physics/forced.py", "float(exact(self.omega) - mode.omega)", "self.omega - float(mode.omega)",
        "tests/physics/test_forced.py",
    ),
    Mutant(
        "half", "physics/energy.py", "2 * exponents + exponent - 1", "2 * exponents + exponent",
        "tests/physics/test_energy.py",
    ),
    Mutant(
        "seam", "physics/damped.py", '_SAME = Decimal("1e-6")', '_SAME = Decimal("0.5")',
        "tests/physics/test_damped.py",
    ),
    Mutant(
        "pairing", "physics/damped_chain.py", "(real[1], real[2]), (real[0], real[3])",
        "(real[1], real[0]), (real[2], real[3])", "tests/physics/test_damped_chain.py",
    ),
    # what a page says and hides
    Mutant(
        "cover", "components/state/covers.py",
        "for one in hidden for column in one.columns", "for one in () for column in ()",
        "tests/page/test_covers.py",
    ),
    Mutant(
        "rounding", "components/quantities/formatting.py", "{value:.2e}", "{value:.1e}",
        "tests/components/test_numbers.py"
    ),
    Mutant("link", "components/state/link.py", "DIGITS = 4\n", "DIGITS = 2\n", "tests/components/test_let_go.py"),
    Mutant(
        "answer", "components/walks/content/d31.toml",
        'answer = { of = "2 * delta_st"', 'answer = { of = "delta_st"',
        "tests/walks/test_content.py tests/walks/test_claims.py",
    ),
    # the server and the class
    Mutant(
        "vote", "components/live_class/room.py", "return name in self.streams or", "return name not in self.streams or",
        "tests/live_class/test_abuse.py",
    ),
    Mutant(
        "table", "components/live_class/votes_csv.py", "and not NUMBER.fullmatch(text)", "and NUMBER.fullmatch(text)",
        "tests/live_class/test_registry.py",
    ),
    Mutant(
        "line", "components/serving/admission.py", "has < OF_A_NETWORK", "has <= OF_A_NETWORK",
        "tests/serving/test_admission.py",
    ),
    Mutant("header", "components/serving/headers.py", "\"base-uri 'none'\", ", "", "tests/serving/test_headers.py"),
    # scripts
    Mutant("silence", "static/live_class/stream.js", "heardAt > SILENCE", "heardAt > 9 * SILENCE", "tests/js"),
    Mutant("twice told", "static/core/storage.js", "if (!told) note(NOTHING)", "note(NOTHING)", "tests/js"),
    Mutant(
        "slider", "static/controls/scales.js", "Math.cbrt(value", "Math.sqrt(value",
        "tests/browser/test_controls.py",
    ),
    Mutant(
        "dead button", "static/controls/transport.js",
        '() => clock.step(1), "icon forward"', '() => {}, "icon forward"',
        "tests/browser/test_page.py",
    ),
    Mutant(
        "dead key", "static/controls/keys.js", "=> l.page.compare.toggle()", "=> {}",
        "tests/browser/test_compare.py",
    ),
    Mutant(
        "undo", "static/shell/undo.js", 'this.go(event.shiftKey ? "future" : "past")', 'this.go("past")',
        "tests/browser/test_undo.py",
    ),
    Mutant("overlap", "static/scene/labels.js", "everyWhich(spans)", "1", "tests/browser/test_screens.py"),
    Mutant("pale", "static/styles/tokens.css", "--mute: #59636e", "--mute: #a9b3be", "tests/browser/test_axe.py"),
)  # fmt: skip


def broken(mutant: Mutant, folder: Path) -> str:
    """Return the text of the file with the fault. Raises ValueError unless its pattern occurs once."""
    text = (folder / mutant.file).read_text(encoding="utf-8")
    if (count := text.count(mutant.old)) != 1:
        raise ValueError(f"{mutant.name}: {mutant.old!r} stands {count} times in {mutant.file}")
    return text.replace(mutant.old, mutant.new)


def failures(mutant: Mutant, folder: Path) -> list[str]:
    """The tests that fail in a copy of the project while the fault is in it."""
    path = folder / mutant.file
    sound, faulty = path.read_bytes(), broken(mutant, folder)
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-x",
        "-m",
        "not slow",
        "-p",
        "no:cacheprovider",
        *mutant.tests.split(),
    ]
    try:
        path.write_text(faulty, encoding="utf-8")
        told = subprocess.run(command, cwd=folder, env=dict(os.environ), capture_output=True, text=True, check=False)
    finally:
        path.write_bytes(sound)
    return FAILED.findall(told.stdout)


def main(names: list[str]) -> int:
    """The number of faults that no test has found."""
    asked = [mutant for mutant in MUTANTS if not names or mutant.name in names]
    for mutant in asked:
        broken(mutant, ROOT)
    missed = 0
    with tempfile.TemporaryDirectory() as top:
        folder = Path(top) / "project"
        shutil.copytree(ROOT, folder, ignore=shutil.ignore_patterns(*LEFT, *SHARED))
        for name in SHARED:
            (folder / name).symlink_to((ROOT / name).resolve())
        for mutant in asked:
            found = failures(mutant, folder)
            missed += not found
            print(f"{mutant.name:12} {'; '.join(found) or 'NOT FOUND by ' + mutant.tests}", flush=True)
    print(f"{len(asked) - missed} of {len(asked)} faults are found")
    return missed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
