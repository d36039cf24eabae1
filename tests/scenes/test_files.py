"""Files: every motion of any state, resolved and finite or refused, equal to the physics; spreadsheets and pandas read
them to the last digit, and their comments bring the picture back.
"""

import csv
import io
import math
import zipfile
from collections.abc import Mapping
from typing import Any
from urllib.parse import parse_qs, urlsplit

import numpy as np
import pandas as pd
import pytest
from hypothesis import Phase, given, settings

from components.chain import of_scene
from components.layout.sheet import in_force
from components.quantities.refusals import in_words
from components.scene import Scene
from components.scene.traces import BAND, band_columns
from components.scenes import SCENES
from components.session.links import page_state_of
from components.state.csv_export import as_csv, as_file, tables
from components.state.link import Link, read_query
from components.state.page_state import PageState, fitted
from components.state.scene_sheet import plots
from tests.grids import sample, tries
from tests.scenes.checks import as_arguments, choices
from tests.states import links, state_of

HERE = "http://lectures.example/oscillations/"
scenes = pytest.mark.parametrize("slug", SCENES)
Tables = dict[str, pd.DataFrame]
PER_PERIOD, PERIODS = 20, 10


def contents(now: PageState, page: str = HERE) -> dict[str, bytes]:
    """The files that a page takes away, by the name of their table; "" for the only one."""
    with in_words():
        file = as_file(now.asked, now.to_send[0], page)
    slug = now.kind.slug
    if file.kind == "text/csv":
        assert file.name == f"{slug}.csv"
        return {"": file.content}
    assert (file.name, file.kind) == (f"{slug}.zip", "application/zip")
    with zipfile.ZipFile(io.BytesIO(file.content)) as packed:
        return {name.removeprefix(f"{slug}-").removesuffix(".csv"): packed.read(name) for name in packed.namelist()}


def taken(now: PageState) -> Tables:
    """The tables of these files, with columns as they are called without units."""
    return {name: without_units(read(content)) for name, content in contents(now).items()}


def covering(slug: str, *covered: str, **values: Any) -> PageState:
    return page_state_of(SCENES[slug], Link(slug, values, covered=covered))[0]


def read(content: bytes) -> pd.DataFrame:
    """The numbers as pandas reads them; an empty table where a file has comments and nothing else."""
    lines = [line for line in content.decode("ascii").splitlines() if not line.startswith("#")]
    if not lines:
        return pd.DataFrame()
    heads = lines[0].split(",")
    assert len(set(heads)) == len(heads), "no name twice"
    return pd.read_csv(io.BytesIO(content), comment="#")


def without_units(table: pd.DataFrame) -> pd.DataFrame:
    names = [head.split(" [")[0] for head in table]
    assert len(set(names)) == len(names) and "none" not in names
    return table.set_axis(names, axis=1)


def comments(content: bytes) -> list[str]:
    return [line.removeprefix("# ") for line in content.decode("ascii").splitlines() if line.startswith("#")]


@scenes
def test_a_file_has_the_drawn_numbers_to_the_last_digit_and_says_what_they_are(slug: str) -> None:
    """In each way of showing things."""
    for values in ({"window": 12.5, "hidden": ["x1", "x2"]}, *sample(list(choices(SCENES[slug])), 3)):
        scene = SCENES[slug].at(values)
        for name, content in contents(fitted(scene)).items():
            check_comments(content, scene)
            check_numbers(name, read(content), scene, {} if "window" in values else scene.shown.sources)
    for source in ("nothing", 3):
        with pytest.raises(ValueError, match=rf"“{source}” has no numbers here: choose one of \w+"):
            scene.frame(source)  # type: ignore[arg-type]


def check_comments(content: bytes, scene: Scene) -> None:
    """A spreadsheet shows each comment in one cell over the table; the link in them opens the same picture."""
    assert b"$" not in content, "no formula's source"
    rows = list(csv.reader(io.StringIO(content.decode("ascii"), newline="")))
    notes = [row for row in rows if row[0].startswith("#")]
    assert all(len(row) == 1 for row in notes) and rows[: len(notes)] == notes
    assert {len(row) for row in rows[len(notes) :]} == {len(rows[len(notes)])}
    _, address, *said = comments(content)
    assert address.startswith(HERE) and "," not in address
    link = read_query(as_arguments(urlsplit(address).query), SCENES)
    assert (link.problems, fitted(SCENES[link.slug].at(link.values)).state) == ([], fitted(scene).state)
    assert set(scene.equations) <= set(said) and scene.equations
    assert scene.values.get("window") != 12.5 or "window = 12.5 s" in said


def check_numbers(name: str, table: pd.DataFrame, scene: Scene, drawn: Mapping[str, Any]) -> None:
    """They are those of `Scene.frame`, and in a window whose motions are drawn as curves those of the curves."""
    for source, rows in table.groupby("curve") if "curve" in table else [(name, table)]:
        numbers, own = scene.frame(source), rows.drop(columns="curve", errors="ignore")
        assert list(numbers) == list(own)
        for column, plain in zip(numbers, without_units(own), strict=True):
            found = own[column].to_numpy()
            assert np.array_equal(found, numbers[column], equal_nan=True), (source, column)
            if source in drawn and {"t", plain} <= drawn[source].keys():
                assert np.array_equal(found, drawn[source][plain])


@scenes
def test_a_file_has_every_motion_in_any_state(slug: str) -> None:
    @settings(max_examples=tries(48), phases=(Phase.explicit, Phase.generate))
    @given(links(SCENES[slug]))
    def holds(link: Link) -> None:
        now = state_of(link)
        try:
            files = taken(now)
        except ValueError as reason:
            assert "doubles" in str(reason) or "more digits of arithmetic" in str(reason), reason
            return
        check_finite(files)
        for name in shown_motions(now):
            assert any(name in table for table in files.values()), f"no column {name} in {list(files)}"
        check_motion(now, files)

    holds()


def check_finite(files: Tables) -> None:
    """Only an amplitude at resonance is no number."""
    for name, table in files.items():
        numbers = table.drop(columns="curve", errors="ignore").to_numpy(float)
        gaps = table.filter(["Xp1", "Xp2"] if name == "response" else [])
        assert not np.isinf(numbers).any() and np.isnan(numbers).sum() == gaps.isna().to_numpy().sum()


def shown_motions(now: PageState) -> set[str]:
    """The motions that the plots show as curves or as bands."""
    told, drawn = now.to_send[0], set[str]()
    stand = {block.name for block in in_force(now.kind.sheet(), told.forms) if hasattr(block, "curves")}
    for plot in plots(now.kind):
        for curve in plot.curves if plot.name in stand else ():
            trace = told.traces.get(curve.source)
            band = band_columns(curve.y)[0] in told.columns.get(BAND, {})
            if curve.x == "t" and ((trace and curve.y in trace.names) or band):
                drawn.add(curve.y)
    return drawn


def check_motion(now: PageState, files: Tables) -> None:
    """Rows resolve the window, or ten periods of its fastest motion, and have the exact motions at their times."""
    for source, trace in now.to_send[0].traces.items():
        table = files.get(source, files.get("", pd.DataFrame()))
        if "t" not in table or "curve" in table:
            continue
        t, rows = table["t"].to_numpy(), np.linspace(0, len(table) - 1, 5).astype(int)
        period = 2 * math.pi / trace.fastest if trace.fastest else math.inf
        assert t[-1] >= min(trace.end, PERIODS * period) * (1 - 1e-9)
        early = t[t <= PERIODS * period]
        assert len(early) < 2 or np.diff(early).max() <= period / PER_PERIOD * (1 + 1e-9)
        true = trace.exact(t[rows])
        for name in true.keys() & set(table):
            # A mass of a chain that no wave has reached has only the rounding of the others.
            alike = [one for one in table if one != "t" and (now.kind.slug == "chain" or stem(one) == stem(name))]
            size = max(np.abs(table[one]).max() for one in alike)
            np.testing.assert_allclose(table[name][rows], true[name], rtol=1e-9, atol=1e-9 * size)


def stem(name: str) -> str:
    return name.split("_")[0]


@scenes
def test_a_band_holds_the_motion_and_is_hardly_wider(slug: str) -> None:
    """In a window so long that no motion is drawn as a line; its first periods have separate rows."""
    kind, held = SCENES[slug], 0
    for label in kind.presets:
        scene = kind.at(kind.preset_all(label))
        if "t" not in scene.picture().axes:
            continue
        files = taken(fitted(kind.at({**kind.preset_all(label), "window": 1000 * scene.picture().axes["t"].end})))
        band, table = files.get("band", pd.DataFrame()), files.get("time", pd.DataFrame())
        for name in table:
            if f"{name}_hi" in band:
                x, t = table[name], table["t"]
                low, high = (np.interp(t, band["t"], band[f"{name}_{end}"]) for end in ("lo", "hi"))
                wide = high.max() - low.min()
                room = 0.003 * wide + 1e-60
                assert np.all(low - room <= x) and np.all(x <= high + room), (label, name)
                assert min(x.max() - low.min(), high.max() - x.min()) >= 0.4 * wide, (label, name)
                held += 1
    assert held or slug in ("modes", "absorber", "chain", "accuracy"), "scenes without such bands"


def test_a_long_window_says_what_its_rows_are_and_has_the_bounds() -> None:
    found = {one.name: one for one in tables(SCENES["coupled"], SCENES["coupled"](window=1000.0).shown)}
    said = {"time": "Rows: the first 10 periods ", "band": "Rows: the whole window"}
    assert all(found[name].notes[0].startswith(note) for name, note in said.items())
    assert f"# {found['time'].notes[0]}\r\n".encode() in as_csv(found["time"], ["here"])
    assert {"x1_lo [m]", "x1_hi [m]", "x2_fast_hi [m]", "T1_mean [J]", "T2_mean [J]"} < set(found["band"].head)


@pytest.mark.parametrize(
    ("slug", "values", "name", "heads"),
    [
        ("phugoid", {"unit": "knots"}, "time", "t [s],h_lin [m],v_lin [m/s]"),
        ("analogues", {}, "time", "t [s],x [rad],q [rad]"),
        ("analogues", {}, "excess", "curve,angle [deg],excess [1]"),
        ("modes", {"view": "guess"}, "det", "w [rad/s],D [N^2/m^2]"),
        ("modes", {"view": "guess", "m1": 5e-324}, "det", "w [rad/s],D [10^324 N^2/m^2]"),
        ("driven", {"k": 1.0}, "below", "omega [rad/s],M [1],lag [rad]"),  # drawn over omega/omega_n
    ],
)
def test_units_are_si_whatever_the_axes_count_in(slug: str, values: dict[str, Any], name: str, heads: str) -> None:
    (found,) = (one.head for one in tables(SCENES[slug], SCENES[slug].at(values).shown) if one.name == name)
    assert ",".join(found).startswith(heads)


def test_what_is_covered_is_not_in_the_files_and_without_a_plot_they_have_the_readouts() -> None:
    assert not any(
        "x2" in name for table in taken(covering("coupled", "plot:x2", "plot:plane")).values() for name in table
    )
    for cover, left in (("plot:response", []), ("curve:response.Xp2", ["omega", "Xp1", "phi1"])):
        assert list(taken(covering("forced", cover, c1=0.5)).get("response", [])) == left, "nor a covered lag"
    table = taken(covering("modes", "plot:det", view="solve"))[""]
    modes = of_scene(SCENES["modes"]()).modes()
    assert (table["omega_slow"].tolist(), table["ratio_fast"].tolist()) == ([modes.omega[0]], [modes.ratio[1]])
    assert taken(covering("modes", "plot:det", "value:slow_omega", view="solve"))[""].empty


def test_an_address_cannot_add_lines() -> None:
    for content in contents(fitted(SCENES["oscillator"].at()), "http://a.example/\r\nx,y\n=1+1,2").values():
        _, line, *_ = comments(content)
        assert line.startswith("http://a.example/%0D%0Ax%2Cy%0A=1+1%2C2?scene=oscillator")
        assert parse_qs(urlsplit(line).query)["scene"] == ["oscillator"]
