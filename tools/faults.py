"""Faults that were found once, for `make mutants`: each replaces a text in a file, and names the tests that must
notice.

They fit the current code. A pattern must occur exactly once in its file; otherwise the tool stops, so that
no fault is skipped.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Mutant:
    """A fault: a file, a text in it, its replacement, and the test files that must find the fault."""

    name: str
    file: str
    old: str
    new: str
    tests: str


MUTANTS = (
    # physics
    Mutant(
        "sign", "physics/oscillator.py", "exact(v_0), -omega * omega", "exact(v_0), omega * omega",
        "tests/physics/test_one_mass.py",
    ),
    Mutant(
        "digits", "physics/forced.py", "float(exact(self.omega) - mode.omega)", "self.omega - float(mode.omega)",
        "tests/physics/test_two_masses.py",
    ),
    Mutant(
        "half", "physics/energy.py", "2 * exponents + exponent - 1", "2 * exponents + exponent",
        "tests/physics/test_two_masses.py",
    ),
    Mutant(
        "seam", "physics/damped.py", '_SAME = Decimal("1e-6")', '_SAME = Decimal("0.5")',
        "tests/physics/test_one_mass.py",
    ),
    Mutant(
        "pairing", "physics/damped_chain.py", "(real[1], real[2]), (real[0], real[3])",
        "(real[1], real[0]), (real[2], real[3])", "tests/physics/test_two_masses.py",
    ),
    Mutant(
        "no swings", "physics/damped_chain.py", "return _turns(self.exponents[0])", "return None",
        "tests/physics/test_two_masses.py",
    ),
    Mutant(
        "cubic", "physics/forced_vibration.py", "3 * rise - 2 * first - last", "3 * rise - 2 * first + last",
        "tests/physics/test_one_mass.py",
    ),
    # what a page says and hides
    Mutant(
        "width", "components/scenes/driven/shown.py", "lambda c: 2 * c.zeta * c.one.omega_n,", "lambda c: c.width,",
        "tests/scenes/test_numbers.py",
    ),
    Mutant(
        "period", "components/scenes/damped/case.py", "2 * math.pi / c.one", "math.pi / c.one",
        "tests/scenes/test_numbers.py",
    ),
    Mutant(
        "no answer", "components/session/session.py", "reply = self._packed(before, answer, (SORRY,))", "raise",
        "tests/page/test_refusals.py",
    ),
    Mutant(
        "cover", "components/state/covers.py",
        "for one in hidden for column in one.columns", "for one in () for column in ()",
        "tests/page/test_covers.py",
    ),
    Mutant(
        "rounding", "components/quantities/formatting.py", "{value:.2e}", "{value:.1e}",
        "tests/components/test_numbers.py"
    ),
    Mutant("link", "components/state/link.py", "DIGITS = 4\n", "DIGITS = 2\n", "tests/page/test_opening.py"),
    Mutant(
        "answer", "components/walks/content/d31.toml",
        'answer = { of = "2 * delta_st"', 'answer = { of = "delta_st"',
        "tests/walks/test_content.py",
    ),
    # the server and the class
    Mutant(
        "vote", "components/live_class/room.py", "return name in self.streams or", "return name not in self.streams or",
        "tests/live_class/test_routes.py",
    ),
    Mutant(
        "listener", "components/live_class/store.py", "self._listeners.remove(receive)", "pass",
        "tests/live_class/test_stores.py",
    ),
    Mutant(
        "table", "components/live_class/votes_csv.py", "and not NUMBER.fullmatch(text)", "and NUMBER.fullmatch(text)",
        "tests/live_class/test_registry.py",
    ),
    Mutant(
        "line", "components/serving/admission.py", "has < OF_A_NETWORK", "has <= OF_A_NETWORK",
        "tests/serving/test_sessions.py",
    ),
    Mutant("header", "components/serving/headers.py", "\"base-uri 'none'\", ", "", "tests/serving/test_routes.py"),
    # scripts
    Mutant("silence", "static/live_class/stream.js", "receivedAt > SILENCE", "receivedAt > 9 * SILENCE", "tests/js"),
    Mutant("twice told", "static/core/storage.js", "if (!wasReported) note(NOTHING)", "note(NOTHING)", "tests/js"),
    Mutant(
        "slider", "static/controls/scales.js", "Math.cbrt(value", "Math.sqrt(value",
        "tests/js",
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
        "tests/browser/test_compare.py",
    ),
    Mutant("overlap", "static/scene/labels.js", "everyWhich(spans)", "1", "tests/browser/test_views.py"),
    Mutant("pale", "static/styles/tokens.css", "--mute: #59636e", "--mute: #a9b3be", "tests/browser/test_views.py"),
)  # fmt: skip


def broken(mutant: Mutant, folder: Path) -> str:
    """Return the text of the file with the fault. Raises ValueError unless its pattern occurs once."""
    text = (folder / mutant.file).read_text(encoding="utf-8")
    if (count := text.count(mutant.old)) != 1:
        raise ValueError(f"{mutant.name}: {mutant.old!r} occurs {count} times in {mutant.file}")
    return text.replace(mutant.old, mutant.new)
