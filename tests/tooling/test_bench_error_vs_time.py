"""`make bench` with small settings: its files are complete, also if runs fail."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path

import pytest

from physics.integrators.accuracy import SYSTEMS, Run, entered
from physics.integrators.solvers import METHODS
from tools.bench import changes, error_vs_time, studies
from tools.bench.price_table import price_table
from tools.bench.record import Report, recalled, record, slim
from tools.bench.tables import markdown, reached_table


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Studies with two points each; nothing is compiled."""
    monkeypatch.setattr("tools.bench.compiled.compiled_methods", lambda systems: [])
    for name, value in (("LENGTHS", (5, 10)), ("STEPPING", ("rk4",)), ("TOLERANCES", {"lsoda": 1e-6})):
        monkeypatch.setattr(studies, name, value)
    monkeypatch.setattr(studies, "NEIGHBOURS", (1.0,))


@pytest.mark.slow
def test_tables_and_figures_of_one_system(short: None, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    error_vs_time.main(["--systems", "dashpot", "--seconds", "0.02", "--output", str(tmp_path)])
    with (tmp_path / "runs.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert tuple(dict.fromkeys(row["method"] for row in rows)) == entered(SYSTEMS["dashpot"])
    assert all(bool(row["error"]) != bool(row["failure"]) for row in rows)
    text = (tmp_path / "error_vs_time.md").read_text()
    assert "unstable step: h f = 5e+04" in (tmp_path / "runs.csv").read_text()
    for expected in ("## Length of the run", "80 digits alone", "† marks"):
        assert expected in text
    for name in ("dashpot", "stability", "length", "digits"):
        assert (tmp_path / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    assert len((tmp_path / "length.csv").read_text().splitlines()) == 1 + 2 * 5
    assert "Stiff: a dashpot: RK4 1 steps an output: unstable" in capsys.readouterr().err


def test_a_record_can_be_read_back(tmp_path: Path) -> None:
    from components.scenes.accuracy.measuring import decoded_run

    run = Run(
        system="benign", method="rk45", setting=3.2e-5, time=0.123456, error=1.23456e-7, error_growth=(0.0, 1.23e-9)
    )
    back = decoded_run(json.loads(json.dumps(slim(run))))
    assert (back.setting, back.time, back.error, back.error_growth) == (3.2e-5, 0.1235, 1.23456e-07, (0.0, 1.2e-9))
    near = replace(run, error=0.0010004123456, mode_errors=(1e-9, 0.0010004123456))
    assert decoded_run(json.loads(json.dumps(slim(near)))).error == 0.0010004123, "what misses a column still does"
    runs = {slug: [replace(run, system=slug)] for slug in SYSTEMS}
    report = Report({"date": "x"}, 1.0, runs, [run], {"ratio": {"x": [1.0]}}, [])
    record(tmp_path, report)
    names = [*SYSTEMS, "digits", "length"]
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(f"{name}.json" for name in names)
    assert recalled(tmp_path).runs["beats"] == [replace(back, system="beats")]


def test_a_second_recording_is_shown_next_to_the_first_and_differences_are_marked() -> None:
    """Ratios to the closed form are compared, not times: a uniformly slower machine changes nothing."""
    closed = Run(system="benign", method="closed", setting=0, time=1e-3, error=1e-16, evaluations=1001)
    rk4 = Run(system="benign", method="rk4", setting=9, time=1e-2, error=1e-7, evaluations=36000)
    first = Report({"date": "x"}, 1.0, {"benign": [closed, rk4]}, [], {}, [])
    for slower, expected in ((1.25, "10 (12.5)"), (1.5, "10 (15) ‡"), (0.7, "10 (7) ‡")):
        second = {"benign": [replace(closed, time=2e-3), replace(rk4, time=2e-2 * slower)]}
        rows = price_table(changes.with_second(first, second, set()).runs["benign"], 1e-6)
        assert f"| RK4 | 3.6e+04 | 10 ms | {expected} |" in rows[3]
    assert "| RK4 | 3.6e+04 | 10 ms | 10 |" in price_table(first.runs["benign"], 1e-6)[3]


def test_the_document_agrees_with_the_record() -> None:
    report = recalled(error_vs_time.RECORDED)
    assert (error_vs_time.ROOT / "docs/bench/error_vs_time.md").read_text(encoding="utf-8") == markdown(report)
    for run in (run for many in report.runs.values() for run in many if run.time):
        long = run.family == "adaptive" and run.method in error_vs_time.LONG.get(run.system, {})
        assert 0.0 < run.time < 2 * (error_vs_time.PATIENCE if long else 1.0)


def test_solves_of_implicit_steps_are_counted_and_shown_next_to_the_evaluations() -> None:
    from physics.integrators.problem import Watch
    from physics.integrators.race import counts

    problem = SYSTEMS["dashpot"].problem(5, 100)
    found = {}
    for method, setting in (("radau", 1e-4), ("bdf", 1e-4), ("lsoda", 1e-4), ("gauss4", 3)):
        watch = Watch()
        METHODS[method].run(problem, setting, watch)
        found[method] = counts(watch)
    assert (found["gauss4"]["factorisations"], found["gauss4"]["solves"]) == (1, 300)
    assert found["radau"]["solves"] > 2 * found["radau"]["factorisations"] > 0 == found["radau"]["jacobians"]
    assert found["bdf"]["solves"] >= found["bdf"]["steps"] > found["bdf"]["factorisations"] > 0
    assert found["lsoda"]["jacobians"] == found["lsoda"]["factorisations"] > 0
    run = Run(system="dashpot", method="bdf", setting=1e-6, error=1e-5, time=0.1, final_error=1e-7, **found["bdf"])
    row = next(line for line in reached_table([run]) if "BDF" in line)
    assert f"| rtol 1e-06, atol 1e-09 | {run.evaluations:.3g} |  | {run.factorisations:.3g} | {run.solves:.3g} |" in row


RK4 = Run(system="benign", method="rk4", setting=9, time=1e-2, again=1.2e-2, error=1e-7)


def test_added_methods_are_timed_in_units_of_the_first_recording(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(changes, "both_ways", list)
    new = replace(RK4, method="ieuler", time=3e-2, time_low=2e-2, time_high=4e-2, again=None)
    first, second = [replace(RK4, time=2e-2, again=None), new], [replace(RK4, time=3e-2), replace(new, time=6e-2)]
    report = Report({}, 1.0, {"benign": [RK4], "beats": [replace(RK4, system="beats")]}, [], {}, [])
    found = changes.with_added(report, {"benign": first}, {"benign": second})
    known, added = found.runs["benign"]
    assert known == RK4 and found.runs["beats"] == report.runs["beats"]
    assert (added.time, added.time_low, added.time_high) == pytest.approx((1.5e-2, 1e-2, 2e-2))
    assert added.again == pytest.approx(6e-2 * 1.2 / 3)
    assert "Implicit Euler" in found.about["added"] and "RK4" not in found.about["added"]
    assert changes.with_added(found, {"benign": first}, {}).runs == found.runs, "it is added once"


def test_only_methods_timed_once_get_a_second_time() -> None:
    once = replace(RK4, method="ieuler", time=3e-2, again=None)
    report = Report({}, 1.0, {"benign": [RK4, once]}, [], {}, [])
    asked = changes.once_only(report)
    assert asked == {("ieuler", False)}
    found = changes.with_second(report, {"benign": [replace(RK4, time=2.4e-2), replace(once, time=8e-2)]}, asked)
    kept, timed = found.runs["benign"]
    assert kept == RK4 and timed.again == pytest.approx(4e-2)
    assert not changes.once_only(found), "then nothing is left to do"


def test_long_runs_replace_those_that_were_stopped() -> None:
    closed = Run(system="wide", method="closed", setting=0, time=1e-3, error=1e-16)
    late = Run(system="wide", method="rk45", setting=1e-2, failure="time limit 1 s", end="time limit")
    before = Run(system="wide", method="lsoda", setting=1e-6, time=25.0, error=1e-3)
    done = replace(late, setting=1e-6, failure=None, end="finest", time=30.0, error=1e-3)
    again, last = replace(before, time=32.0), replace(before, setting=1e-13, time=50.0, error=1e-7)
    report = Report({"date": "x"}, 1.0, {"wide": [closed, late, before], "light": []}, [], {}, [])
    found = changes.with_long(report, {"wide": [replace(closed, time=2e-3), done, again, last]}, 60.0)
    kept, rk45, first, second = found.runs["wide"]
    assert kept == closed and "up to 60 s" in found.about["long"] and "Closed" not in found.about["long"]
    assert (rk45.time, rk45.again, rk45.end) == (15.0, None, "time limit"), "a finer run would have taken too long"
    assert (first.time, first.again, first.end) == (16.0, 25.0, "") and second.end == "finest"


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        (["--seconds", "0"], "a time limit is a number of seconds above 0, and '0' is not"),
        (["--seconds", "soon"], "a time limit is a number of seconds above 0, and 'soon' is not"),
        (["--systems", "benin"], "invalid choice: 'benin'"),
        (["--again", "--add"], "argument --add: not allowed with argument --again"),
        (["--quick", "--record"], "leave out --quick or --record"),
        (["--rewrite", "--seconds", "1"], "--rewrite measures no times: leave out --systems and --seconds"),
        (["--long", "--systems", "benign"], "choose of --systems wide light"),
        (["--count", "--recorded", "/nowhere"], "/nowhere has none: make one with --record"),
        (["--output", __file__], "--output needs a folder, and"),
    ],
)
def test_contradictory_options_are_refused_with_a_reason(
    given: list[str], expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        error_vs_time.main(given)
    assert expected in capsys.readouterr().err


@pytest.mark.slow
def test_a_tiny_record_is_made_and_changed_by_each_option(
    short: None, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    few = {slug: METHODS[slug] for slug in ("closed", "slides", "eigh", "naive", "expm", "rk4", "gauss4", "lsoda")}
    monkeypatch.setattr(error_vs_time, "METHODS", few)
    monkeypatch.setattr(error_vs_time, "LONG", {"wide": {"lsoda": (1e-2, 1e-13)}})
    folders = ["--recorded", str(tmp_path / "record"), "--output", str(tmp_path / "docs")]

    def changed(*options: str) -> Report:
        error_vs_time.main([*folders, *options])
        return recalled(tmp_path / "record")

    first = changed("--record", "--systems", "wide", "--seconds", "0.02")
    assert list(first.runs) == ["wide"] and changes.recorded_kinds(first) == {(slug, False) for slug in few}
    again = changed("--again", "--seconds", "0.02")
    assert any(run.again for run in again.runs["wide"]) and "again" in again.about
    monkeypatch.setattr(error_vs_time, "METHODS", few | {"adams": METHODS["adams"]})
    more = changed("--add", "--systems", "wide", "--seconds", "0.02")
    assert ("adams", False) in changes.recorded_kinds(more) and more.about["added"].endswith(": VODE-Adams")
    long = changed("--long", "--seconds", "0.02")
    assert [run.setting for run in long.runs["wide"] if run.method == "lsoda"] == [1e-2] and "long" in long.about
    assert changed("--count").about["counted"].startswith("spread of counts")
    page = (tmp_path / "docs/error_vs_time.md").read_text()
    changed("--record", "--systems", "wide", "--seconds", "0.01")
    assert not any(run.again for run in recalled(tmp_path / "record").runs["wide"]), "it is recorded from scratch"
    assert "Wide apart, 1e6: recorded again" in (tmp_path / "docs/error_vs_time.md").read_text()
    page = (tmp_path / "docs/error_vs_time.md").read_text()
    changed("--rewrite")
    assert (tmp_path / "docs/error_vs_time.md").read_text() == page and "at least" in page
    capsys.readouterr()


def test_neighbours_of_a_run_differ_by_one_unit_in_the_last_place() -> None:
    from tools.bench.counting import neighbours

    for system in ("benign", "near"):
        first, *others = neighbours(Run(system=system, method="rk45", setting=1e-3))
        for other in others:
            pairs = zip((*first.start, first.F_0), (*other.start, other.F_0), strict=True)
            moved = [abs(a - b) / abs(b) for a, b in pairs if a != b]
            assert len(moved) == 1 and 0 < moved[0] < 2.3e-16
            assert other.size == first.size > 1.2, "in whose units tolerances are"
