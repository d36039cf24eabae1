"""Spreadsheets and pandas read the CSV export to the last digit; it names its scene and parameters."""

from __future__ import annotations

import base64
import csv
import io
import re
import zipfile
from typing import Any
from urllib.parse import parse_qs, urlsplit

import numpy as np
import pandas as pd
import pytest

from components.chain import of_scene
from components.scene import Scene
from components.scene.columns import tables_of
from components.scenes import SCENES
from components.state.csv_export import tables
from components.state.link import read_query
from components.state.page_state import fitted
from components.state.scene_sheet import column_axes, plots
from tests.page.headless_page import Page
from tests.scenes.checks import as_arguments, choices

HERE = "http://lectures.example/oscillations/"
scenes = pytest.mark.parametrize("slug", SCENES)


def taken(scene: Scene, page: str = HERE, **state: Any) -> dict[str, bytes]:
    """The files that the button CSV gives, by name."""
    visit = Page(scene)
    if state:
        visit.send({"type": "open", "number": 1, "state": {"scene": scene.slug, **state}})
    file = visit.send({"type": "csv", "page": page, "number": 2})
    content = base64.b64decode(file["content"])
    if file["kind"] == "text/csv":
        return {file["name"]: content}
    assert (file["name"], file["kind"]) == (f"{scene.slug}.zip", "application/zip")
    with zipfile.ZipFile(io.BytesIO(content)) as packed:
        return {name: packed.read(name) for name in packed.namelist()}


def body(content: bytes) -> bytes:
    """The lines of a file without comments."""
    return b"".join(line for line in content.splitlines(keepends=True) if not line.startswith(b"#"))


def comments(content: bytes) -> list[str]:
    return [line.removeprefix("# ") for line in content.decode("ascii").splitlines() if line.startswith("#")]


@scenes
def test_pandas_reads_every_column_of_every_plot_to_the_last_digit(slug: str) -> None:
    for values in ({}, *choices(SCENES[slug])):
        scene = SCENES[slug](**values)
        drawn = [plot for plot in plots(SCENES[slug]) if plot.x in scene.shown.axes and plot.y in scene.shown.axes]
        files = taken(scene)
        for file, content in files.items() if drawn else ():
            assert b"$" not in content, "no formula's source"
            table, name = pd.read_csv(io.BytesIO(content), comment="#"), table_of(file, slug)
            for source, rows in table.groupby("curve") if "curve" in table else [(name, table)]:
                numbers, rows = scene.frame(source), rows.drop(columns="curve", errors="ignore")
                assert list(numbers) == list(rows)
                for head, column in numbers.items():
                    assert np.array_equal(rows[head].to_numpy(), column, equal_nan=True)


def table_of(file: str, slug: str) -> str:
    """The name of the table in a file, "" for the only one."""
    return file.removeprefix(slug).removeprefix("-").removesuffix(".csv")


@scenes
def test_the_numbers_of_a_file_are_those_that_are_drawn(slug: str) -> None:
    """In windows whose motions are drawn as curves."""
    for values in ({}, *choices(SCENES[slug])):
        scene = SCENES[slug](**values)
        found = tables_of(scene.shown, column_axes(SCENES[slug]))
        for name, data in scene.sources.items():
            shared = found[name].columns.keys() & data.data.keys() if name in found else ()
            assert all(np.array_equal(found[name].columns[one], data.data[one]) for one in shared if "t" in shared)


@scenes
def test_a_spreadsheet_shows_each_comment_in_one_cell_over_a_table(slug: str) -> None:
    for content in taken(SCENES[slug]()).values():
        rows = list(csv.reader(io.StringIO(content.decode("ascii"), newline="")))
        notes = [row for row in rows if row[0].startswith("#")]
        assert all(len(row) == 1 for row in notes) and rows[: len(notes)] == notes
        head, *body = rows[len(notes) :]
        assert body and {len(row) for row in body} == {len(head)}
        assert len(set(head)) == len(head)


@scenes
def test_the_comments_bring_the_picture_back_and_say_what_it_obeys(slug: str) -> None:
    scene = SCENES[slug](window=12.5, hidden=["x1", "x2"])
    for content in taken(scene).values():
        _, address, *notes = comments(content)
        assert address.startswith(HERE) and "," not in address
        link = read_query(as_arguments(urlsplit(address).query), SCENES)
        assert (link.problems, fitted(SCENES[link.slug](**link.values).value).state) == ([], fitted(scene.value).state)
        assert all(line in notes for line in scene.equations) and scene.equations
        assert "window = 12.5 s" in notes


def test_units_are_si_whatever_the_axes_count_in() -> None:
    flight = taken(SCENES["phugoid"](unit="knots"))["phugoid-time.csv"]
    assert list(pd.read_csv(io.BytesIO(flight), comment="#"))[:3] == ["t [s]", "h_lin [m]", "v_lin [m/s]"]
    sweep = taken(SCENES["absorber"]())["absorber-sweep.csv"]
    assert list(pd.read_csv(io.BytesIO(sweep), comment="#"))[:2] == ["w [rad/s]", "swing [m]"]
    pendulum = taken(SCENES["analogues"]())["analogues-time.csv"]
    assert list(pd.read_csv(io.BytesIO(pendulum), comment="#"))[2] == "q [rad]"
    rows = taken(SCENES["modes"](view="guess"))["modes-det.csv"]
    assert list(pd.read_csv(io.BytesIO(rows), comment="#")) == ["w [rad/s]", "D [N^2/m^2]"]
    for values in ({}, {"k": 1.0}):  # drawn over omega/omega_n
        response = taken(SCENES["driven"](**values))["driven-below.csv"]
        assert list(pd.read_csv(io.BytesIO(response), comment="#"))[:3] == ["omega [rad/s]", "M [1]", "lag [rad]"]
    late = taken(SCENES["analogues"]())["analogues-excess.csv"]
    assert "excess [1]" in list(pd.read_csv(io.BytesIO(late), comment="#")) and b"percent" not in late


def test_powers_of_ten_of_a_unit_are_written_out() -> None:
    for values, unit in (({"m1": 5e-324}, "D [10^324 N^2/m^2]"), ({"k2": 1e300}, "D [10^600 N^2/m^2]")):
        files = taken(SCENES["modes"](view="guess", **values))
        assert unit in list(pd.read_csv(io.BytesIO(files["modes-det.csv"]), comment="#"))


def test_what_is_covered_is_not_in_the_files() -> None:
    files = taken(SCENES["coupled"](), covered=["plot:x2", "plot:plane"])
    assert not any(
        "x2" in column for content in files.values() for column in pd.read_csv(io.BytesIO(content), comment="#")
    )


def test_where_no_plot_is_seen_there_are_the_numbers_unless_they_are_covered() -> None:
    solve = {"view": "solve"}
    (content,) = taken(SCENES["modes"](), parameters=solve, covered=["plot:det"]).values()
    table = pd.read_csv(io.BytesIO(content), comment="#")
    modes = of_scene(SCENES["modes"]()).modes()
    assert table["omega_slow [rad/s]"].tolist() == [modes.omega[0]]
    assert table["ratio_fast [1]"].tolist() == [modes.ratio[1]]
    (content,) = taken(SCENES["modes"](), parameters=solve, covered=["plot:det", "value:slow_omega"]).values()
    assert content and not body(content)


def test_the_parameters_are_those_that_count() -> None:
    def named(scene: Scene) -> set[str]:
        content = next(iter(taken(scene).values()))
        return {note.split(" = ")[0] for note in comments(content) if re.fullmatch(r"\w+ = .*", note)}

    assert {"X_slow", "phi_fast"} <= named(SCENES["coupled"](given_by="modes"))
    assert not {"X_slow", "phi_fast"} & named(SCENES["coupled"]())
    assert "pendulum_l" not in named(SCENES["analogues"](system="pipe")) > {"pipe_L", "pipe_start"}
    assert {"m1", "k1", "F_0"} <= named(SCENES["absorber"]())


def test_an_address_cannot_add_lines() -> None:
    address = "http://a.example/\r\nx,y\n=1+1,2"
    for content in taken(SCENES["oscillator"](), address).values():
        _, line, *_ = comments(content)
        assert line.startswith("http://a.example/%0D%0Ax%2Cy%0A=1+1%2C2?scene=oscillator")
        assert parse_qs(urlsplit(line).query)["scene"] == ["oscillator"]


@scenes
def test_a_frame_has_the_columns_of_a_source_under_the_names_of_the_export(slug: str) -> None:
    scene = SCENES[slug]()
    for table in tables(SCENES[slug], scene.shown):
        if "curve" in table.head:
            continue  # pieces of one table are separate sources
        found = pd.DataFrame(scene.frame(table.name))
        assert set(table.head) <= set(found.columns)
        assert np.array_equal(found[list(table.head)].to_numpy(), np.array(table.rows), equal_nan=True)
    with pytest.raises(ValueError, match="“nothing” has no numbers here: choose one of "):
        scene.frame("nothing")
