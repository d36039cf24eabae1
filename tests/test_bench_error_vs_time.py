"""`make bench` on a short leash: its files are complete, also where runs fail."""

import csv
import json

from physics.accuracy import SYSTEMS, plan
from tests.bench.error_vs_time import main


def test_tables_and_figures_of_one_system(tmp_path, capsys):
    main(["--systems", "stiff", "--seconds", "0.02", "--output", str(tmp_path)])
    cases = [(case.method, case.setting) for case in plan(SYSTEMS["stiff"])]
    report = json.loads((tmp_path / "error_vs_time.json").read_text())
    assert [(run["method"], run["setting"]) for run in report["runs"]["stiff"]] == cases
    assert set(report["about"]) == {"date", "machine", "versions", "limits"}
    with (tmp_path / "error_vs_time.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["method"], float(row["setting"])) for row in rows] == cases
    assert all(bool(row["error"]) != bool(row["failure"]) for row in rows)
    text = (tmp_path / "error_vs_time.md").read_text()
    assert "unstable step: h omega_+ = 628" in text
    assert "time limit 0.02 s, at" in text
    assert "An error of 1e-06 costs: " in text
    for name in ("stiff", "stability"):
        assert (tmp_path / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert "</svg>" in (tmp_path / f"{name}.svg").read_text()
    assert f"Stiff 1e6 {len(cases)}/{len(cases)}" in capsys.readouterr().err
