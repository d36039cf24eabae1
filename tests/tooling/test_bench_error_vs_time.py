"""`make bench` on a short leash: its files are complete, also where runs fail."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from physics.accuracy import SYSTEMS, Limits, Run, entered
from tests.bench import error_vs_time, studies
from tests.bench.record import record, slim
from tests.bench.tables import price_text


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Studies of two places each."""
    for name, value in (("LENGTHS", (5, 10)), ("STEPPING", ("rk4",)), ("TOLERANCES", {"lsoda": 1e-6})):
        monkeypatch.setattr(studies, name, value)
    monkeypatch.setattr(studies, "NEIGHBOURS", (1.0,))


def test_tables_and_figures_of_one_system(short: None, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    error_vs_time.main(["--systems", "dashpot", "--seconds", "0.02", "--output", str(tmp_path)])
    with (tmp_path / "runs.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert tuple(dict.fromkeys(row["method"] for row in rows)) == entered(SYSTEMS["dashpot"])
    assert all(bool(row["error"]) != bool(row["failure"]) for row in rows)
    text = (tmp_path / "error_vs_time.md").read_text()
    assert "unstable step: h f = 5e+04" in (tmp_path / "runs.csv").read_text()
    for told in ("none: time limit 0.02 s", "## Length of the run", "80 digits alone", "† marks"):
        assert told in text
    for name in ("dashpot", "stability", "length", "digits"):
        assert (tmp_path / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    assert len((tmp_path / "length.csv").read_text().splitlines()) == 1 + 2 * 5
    assert "Stiff: a dashpot: RK4 1 steps an output: unstable" in capsys.readouterr().err


def test_what_is_recorded_comes_back(tmp_path: Path) -> None:
    from components.scenes.accuracy.measuring import decoded_run

    run = Run(
        system="benign", method="rk45", setting=3.2e-5, time=0.123456, error=1.23456e-7, error_growth=(0.0, 1.23e-9)
    )
    back = decoded_run(json.loads(json.dumps(slim(run))))
    assert (back.setting, back.time, back.error, back.error_growth) == (3.2e-5, 0.1235, 1.235e-07, (0.0, 1.2e-9))
    report = error_vs_time.Report({"date": "x"}, {"benign": [run]}, [run], {"ratio": {"x": [1.0]}}, [])
    record(tmp_path, report.about, Limits(), report)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["benign.json", "digits.json", "length.json"]


def test_what_a_price_says() -> None:
    from physics.price import Price

    facts = {"method": "rk4", "best": 1e-5}
    assert price_text(Price(time=0.02, evaluations=5e4, end="", repeats=False, **facts), 1e-3) == "20 ms †, × 20, 5e+04"
    for end, told in (("time limit", "not within the time limit"), ("floor", "never"), ("", "not refined so far")):
        assert price_text(Price(time=None, evaluations=None, end=end, **facts), 1e-3) == told
