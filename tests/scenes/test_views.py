"""Views of the scenes: what each shows, sends and links to; and a scene made of a case and its paper.

Files: every motion of any state, resolved and finite or refused, equal to the physics; spreadsheets and pandas read
them to the last digit, and their comments bring the picture back.
"""

import csv
import io
import math
import re
import zipfile
from collections.abc import Mapping
from dataclasses import replace
from typing import Any
from urllib.parse import parse_qs, urlsplit

import numpy as np
import pandas as pd
import pytest
from hypothesis import Phase, given, settings
from msgspec.structs import replace as replace_in

from components.chain import of_scene
from components.language.blocks import Block, PlotBlock
from components.language.messages import Choose, Open
from components.language.state import State
from components.layout.sheet import column, in_force
from components.layout.stage import line
from components.layout.views import KEYS, View, shown_blocks
from components.paper.deferred import Attributes, deferred
from components.paper.plot_axes import TIME, axis
from components.paper.plots import Plot, curve, words
from components.quantities.motion import derived
from components.quantities.refusals import in_words
from components.scene import Scene
from components.scene.case import CaseScene
from components.scene.traces import BAND, band_columns
from components.scenes import SCENES
from components.scenes.damped import Damped
from components.scenes.damped.case import DampedCase, DampedShown
from components.session.links import page_state_of
from components.state.csv_export import as_csv, as_file, tables
from components.state.link import Link, read_query
from components.state.page_state import PageState, changed, fitted, page_state_in, with_values
from components.state.scene_sheet import plots, scene_sheet
from components.state.sent_picture import drawn_on, sent_picture
from components.state.states import state_in
from tests.grids import sample, tries
from tests.scenes.checks import as_arguments, changes, choices
from tests.states import links, state_of

VIEWS = [(slug, view.slug) for slug, scene in SCENES.items() for view in scene.views]
views = pytest.mark.parametrize(("slug", "view"), VIEWS)
OLD = [
    *(("oscillator", "motion"), ("oscillator&m=2", "formulas"), ("oscillator&view=swing&m=2", "motion")),
    *(("energy&m=2", "energy"), ("damped&c=2", "motion"), ("driven&omega=3", "response"), ("coupled&k2=3", "motion")),
    *(("coupled&view=constants", "formulas"), ("modes", "hunt"), ("modes&m2=3", "guess")),
    *(("modes&task=hunt&x1_0=0.5", "hunt"), ("modes&task=solve", "solve"), ("modes&task=sweep&swept=m1", "sweep")),
    *(("forced&k1=2", "response"), ("forced&view=amplitudes", "response"), ("analogues&system=circuit", "roles")),
    *(("phugoid&excess=0.1", "period"), ("phugoid&show=period", "period"), ("phugoid&show=exchange", "energy")),
    *(("absorber&m2=20", "goals"), ("absorber&played=particular", "goals")),
    *(("absorber&played=rest&x1_0=0.01", "rest"), ("accuracy", "drift"), ("accuracy&system=wide", "time")),
    *((f"accuracy&view={view}", view) for view in ("time", "growth", "length", "digits", "stability")),
]
"""Links older than views, and the view that each opens; some name none."""
OTHER_MOTIONS = {"modes"}
"""Scenes whose views show different motions, each with a separate file."""
HERE = "http://lectures.example/oscillations/"
scenes = pytest.mark.parametrize("slug", SCENES)
Tables = dict[str, pd.DataFrame]
PER_PERIOD, PERIODS = 20, 10


def opened(query: str) -> PageState:
    """The page of a link, which has no problems."""
    link = read_query(as_arguments(query), SCENES)
    assert not link.problems
    return page_state_in(SCENES[link.slug], state_in(link))


@pytest.mark.parametrize(("query", "view"), OLD)
def test_an_old_link_opens_the_matching_view(query: str, view: str) -> None:
    now = opened(f"scene={query}")
    assert now.scene.values["view"] == view
    assert now.show == ()


@views
def test_a_page_of_one_view_shows_what_the_whole_picture_shows_there(slug: str, view: str) -> None:
    kind = SCENES[slug]
    whole = fitted(kind.at({"view": view}))
    assert f"view={view}" in whole.query and opened(whole.query).scene.key == whole.scene.key
    check_file(whole, whole if slug in OTHER_MOTIONS else fitted(kind.at()))
    page = replace(page_state_in(kind, whole.state), in_view=True)
    check_parts(page, next(one for one in kind.views if one.slug == view))
    whole, page = (with_values(now, next(changes(kind))) for now in (whole, page))
    part = page.drawn.picture
    one, other = sent_picture(page, part), sent_picture(replace(page, drawn=whole.drawn), whole.shown)
    assert page.drawn.frame == whole.drawn.frame and page.query == whole.query
    assert one.values == other.values and one.forms == other.forms and one.scalars == other.scalars
    assert {**one.signals, "zero": derived(0.0)} == {**other.signals, "zero": derived(0.0)}
    for source, columns in drawn_on(page).items():
        for name in columns.keys() & other.sources.get(source, {}).keys():
            assert np.array_equal(one.sources[source][name], other.sources[source][name])
    assert read_aloud(whole, view).items() <= part.values.items()
    covered = changed(page, Open(state=replace_in(page.state, covered=("next",)), keeps=True), SCENES)
    assert covered.drawn.picture.values == whole.shown.values, "what depends on a change is looked up in all views"


def check_file(now: PageState, first: PageState) -> None:
    """A view sends only its curves, with what they need; a file has those of all views."""
    columns = {source: list(found) for source, found in now.shown.sources.items()}
    assert columns == {source: list(found) for source, found in first.shown.sources.items()}
    sent = sent_picture(now, now.shown)
    for source, traces in sent.traces.items():
        assert set(traces.names) <= drawn_on(now).get(source, {}).keys()
        assert traces.needed <= sent.signals.keys()


def check_parts(page: PageState, view: View) -> None:
    """A view has a task and parts that no other view of its scene has, and the forms that show these parts."""
    shown = {one.slug: frozenset(map(id, shown_blocks(page.kind.sheet(), one.slug))) for one in page.kind.views}
    assert shown[view.slug] and [one.task for one in page.kind.views].count(view.task) == 1
    sent = sent_picture(page, page.drawn.picture)
    assert set(view.names) - {KEYS} <= {block.part for block in in_force(page.kind.sheet(), sent.forms)}


def read_aloud(now: PageState, view: str) -> dict[str, str]:
    """The texts of the numbers that descriptions of a view read aloud."""
    plots = [one.says for one in shown_blocks(now.kind.sheet(), view) if isinstance(one, PlotBlock)]
    sentences = " ".join(text for spoken in (scene_sheet(now.kind).spoken, *plots) for text in spoken.values())
    return {name: now.shown.values[name] for name in re.findall(r"{(\w+)}", sentences) if name in now.shown.values}


def test_a_list_of_parts_replaces_the_view_until_a_tab_is_pressed() -> None:
    state = State(scene="damped", show=("stage", "plot:P"))
    now = changed(fitted(SCENES["oscillator"]().value), Open(state=state), SCENES)
    assert "show=stage,plot:P" in now.query
    assert drawn_on(now)["time"].keys() == {"t", "P", "zero"}
    assert opened(now.query).show == now.show
    now = changed(now, Choose(name="view", value="roots"), SCENES)
    assert now.show == ()
    assert "roots" in drawn_on(now) or "locus" in drawn_on(now)


value = Attributes(DampedCase)
X = Plot("x", TIME, axis("m", lambda c: (-1.0, 1.0)))


def variant(shown: type[Any], *shapes: Block) -> type[CaseScene]:
    """The damped scene with another case, and these blocks as its paper."""

    class Variant(Damped):
        case, paper, views, groups = shown, staticmethod(lambda: column(*shapes)), (), ()

    return Variant


def test_an_author_is_told_of_a_number_that_is_none_or_has_a_name_that_is_taken() -> None:
    broken, quick, doubled = (
        type("Wrong", (DampedShown,), {name: value(lambda c, n=number: n)})
        for name, number in (("lost", None), ("speed", 1.0), ("m", 2.0))
    )
    with pytest.raises(TypeError, match="lost is None: make it an optional attribute"):
        variant(broken, X.block(curve(deferred(broken).lost), title="Nothing")).at().picture()
    with pytest.raises(ValueError, match="Wrong: the page has a live number “speed” of its own: choose another name"):
        variant(quick)
    with pytest.raises(TypeError, match="Wrong: m is a parameter: give the attribute another name"):
        variant(doubled)


@pytest.mark.parametrize("order", [(True, False), (False, True)])
def test_a_picture_does_not_depend_on_papers_built_before_it(order: tuple[bool, bool]) -> None:
    """Two papers share the time axis; one of them also shows its unit, and a length relative to its end."""

    def timed(uses_time: bool) -> type[CaseScene]:
        shown = type("Timed", (DampedShown,), {})
        over = [line(0, 0, 90 * TIME.share, 0)] if uses_time else []
        text = [words(f"in {TIME.unit_text}")] if uses_time else []
        return variant(shown, X.block(curve(deferred(shown).x), title="x", over=over), *text)

    shown = {uses: timed(uses).at().shown for uses in order}
    assert (shown[True].scalars["t_share"], shown[True].values["t_unit"]) == (1 / shown[True].axes["t"].end, "s")
    assert not shown[False].scalars and not shown[False].values


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
        for head, plain in zip(numbers, without_units(own), strict=True):
            found = own[head].to_numpy()
            assert np.array_equal(found, numbers[head], equal_nan=True), (source, head)
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
        for name, table in files.items():
            values = table.drop(columns="curve", errors="ignore").to_numpy(float)
            gaps = table.filter(["Xp1", "Xp2"] if name == "response" else [])  # an amplitude at resonance is no number
            assert not np.isinf(values).any() and np.isnan(values).sum() == gaps.isna().to_numpy().sum()
        for name in shown_motions(now):
            assert any(name in table for table in files.values()), f"no column {name} in {list(files)}"
        check_motion(now, files)

    holds()


def shown_motions(now: PageState) -> set[str]:
    """The motions that the plots show as curves or as bands."""
    told, drawn = now.to_send[0], set[str]()
    stand = {block.name for block in in_force(now.kind.sheet(), told.forms) if hasattr(block, "curves")}
    for plot in plots(now.kind):
        for one in plot.curves if plot.name in stand else ():
            trace = told.traces.get(one.source)
            band = band_columns(one.y)[0] in told.columns.get(BAND, {})
            if one.x == "t" and ((trace and one.y in trace.names) or band):
                drawn.add(one.y)
    return drawn


def check_motion(now: PageState, files: Tables) -> None:
    """Rows resolve the window, or ten periods of its fastest motion, and have the exact motions at their times."""
    names = [one.name for one in tables(now.kind, now.to_send[0])]
    for source, trace in now.to_send[0].traces.items():
        table = files.get("" if names == [source] else source, pd.DataFrame())
        if "t" not in table or "curve" in table:
            continue
        t, rows = table["t"].to_numpy(), np.linspace(0, len(table) - 1, 5).astype(int)
        period = 2 * math.pi / trace.fastest if trace.fastest else math.inf
        assert t[-1] >= min(trace.end, PERIODS * period) * (1 - 1e-9)
        early = t[t <= PERIODS * period]
        assert len(early) < 2 or np.diff(early).max() <= period / PER_PERIOD * (1 + 1e-9)
        true, sizes = trace.exact(t[rows]), table.abs().max().to_dict()
        for name in true.keys() & set(table):
            # A mass of a chain that no wave has reached has only the rounding of the others.
            stem = "" if now.kind.slug == "chain" else name.split("_")[0]
            alike = [one for one in table if one != "t" and stem in ("", one.split("_")[0])]
            size = max(sizes[one] for one in alike)
            np.testing.assert_allclose(table[name][rows], true[name], rtol=1e-9, atol=1e-9 * size)


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
