"""Every file has every motion of its scene in any state: resolved and finite or refused, and equal to the physics."""

from __future__ import annotations

import io
import math
import zipfile
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings

from components.chain import damping_of, of_scene, start_of
from components.language.messages import File
from components.layout.sheet import in_force
from components.quantities.refusals import in_words
from components.scene.traces import BAND, band_columns
from components.scenes import SCENES
from components.session.links import page_state_of
from components.state.csv_export import as_csv, as_file, tables
from components.state.link import Link
from components.state.page_state import PageState, fitted
from components.state.scene_sheet import plots
from physics.absorber import damped_solution
from physics.coupled import free_motion
from physics.damped import DampedOscillator
from physics.driven import DrivenOscillator
from physics.forced import forced_motion
from physics.oscillator import Oscillator
from physics.particular import particular_solution
from physics.transient import DampedModes
from tests.grids import tries
from tests.states import links, state_of

scenes = pytest.mark.parametrize("slug", SCENES)
Tables = dict[str, pd.DataFrame]
PER_PERIOD, PERIODS = 20, 10


def taken(now: PageState) -> Tables:
    """The tables that a page takes away, by name, with columns as they are called without units."""
    with in_words():
        file = as_file(now.asked, now.to_send[0], "http://here/")
    return {name: read(content) for name, content in unpacked(file, now.kind.slug)}


def unpacked(file: File, slug: str) -> Iterator[tuple[str, bytes]]:
    if file.kind == "text/csv":
        yield "", file.content
        return
    with zipfile.ZipFile(io.BytesIO(file.content)) as packed:
        for name in packed.namelist():
            yield name.removeprefix(f"{slug}-").removesuffix(".csv"), packed.read(name)


def read(content: bytes) -> pd.DataFrame:
    """The numbers; of names alone where a file has comments and nothing else."""
    lines = [line for line in content.decode("ascii").splitlines() if not line.startswith("#")]
    if not lines:
        return pd.DataFrame()
    heads = lines[0].split(",")
    assert len(set(heads)) == len(heads), "no name twice"
    table = pd.read_csv(io.StringIO("\n".join(lines)))
    names = [head.split(" [")[0] for head in heads]
    assert len(set(names)) == len(names) and "none" not in names
    return table.set_axis(names, axis=1)


@scenes
def test_a_file_has_every_motion_in_any_state(slug: str) -> None:
    @settings(max_examples=tries(80))
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
        check_motion(now.asked.scene, now, files)

    holds()


def check_finite(files: Tables) -> None:
    """Only an amplitude at resonance is no number."""
    for name, table in files.items():
        numbers = table.drop(columns="curve", errors="ignore").to_numpy(float)
        gaps = table[["Xp1", "Xp2"]] if name == "response" and "Xp1" in table else table.iloc[:, :0]
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


def check_motion(scene: Any, now: PageState, files: Tables) -> None:
    """It is resolved over ten periods of its fastest part, and sampled rows agree with the physics."""
    if scene.slug not in TRUE:
        return
    table = next((one for name, one in files.items() if name in ("", "time", "rest") and "t" in one), None)
    if table is None or "curve" in table:
        return
    t, end = table["t"].to_numpy(), now.asked.shown.axes["t"].end
    if fastest := FASTEST[scene.slug](scene):
        period = 2 * math.pi / fastest
        assert t[-1] >= min(end, PERIODS * period) * (1 - 1e-9)
        early = t[t <= PERIODS * period]
        assert len(early) < 2 or np.diff(early).max() <= period / PER_PERIOD * (1 + 1e-9)
    rows = np.linspace(0, len(t) - 1, 5).astype(int)
    for name, true in TRUE[scene.slug](scene, t[rows]).items():
        if name in table:
            parts = [np.abs(table[one]).max() for one in table if one.split("_")[0] == name]
            np.testing.assert_allclose(table[name][rows], true, rtol=1e-9, atol=1e-9 * max(parts))


def chain_fastest(scene: Any) -> float:
    _, fast = of_scene(scene).modes().omega.tolist()
    return max(fast, scene.omega if scene.slug == "forced" and scene.F_0 else 0.0)


def swinging(one: DampedOscillator) -> float:
    return one.omega_d


def driven_fastest(scene: Any) -> float:
    size = {"force": scene.F_0, "base": scene.Y, "unbalance": scene.moment}[scene.kind]
    repeats = size and not (scene.kind == "force" and scene.push in ("step", "impulse"))
    return max(swinging(DampedOscillator(m=scene.m, c=scene.c, k=scene.k)), scene.omega if repeats else 0.0)


FASTEST: dict[str, Callable[[Any], float]] = {
    "oscillator": lambda s: math.sqrt(s.k) / math.sqrt(s.m),
    "energy": lambda s: math.sqrt(s.k) / math.sqrt(s.m),
    "damped": lambda s: swinging(DampedOscillator(m=s.m, c=s.c, k=s.k)),
    "driven": driven_fastest,
    "coupled": chain_fastest,
    "forced": chain_fastest,
}


def driven_true(scene: Any, t: np.ndarray) -> dict[str, np.ndarray]:
    if scene.kind == "force" and scene.push != "sine":  # see test_driven_pushes
        return {}
    one = DrivenOscillator(m=scene.m, c=scene.c, k=scene.k)
    size = {"force": scene.F_0, "base": scene.Y, "unbalance": scene.moment}[scene.kind]
    return {"x": one.motion(scene.omega, size, scene.x_0, scene.v_0, t, scene.kind).x}


def forced_true(scene: Any, t: np.ndarray) -> dict[str, np.ndarray]:
    (c1, c2), (x_0, v_0) = damping_of(scene), start_of(scene)
    if c1 or c2:
        drive = {"F_0": scene.F_0, "omega": scene.omega}
        x = DampedModes(chain=of_scene(scene), c=c2, c1=c1, x_0=x_0, v_0=v_0, **drive).motion(t).x
    else:
        x = forced_motion(of_scene(scene), F_0=scene.F_0, omega=scene.omega, t=t, x_0=x_0, v_0=v_0).x
    return {"x1": x[0], "x2": x[1]}


def coupled_true(scene: Any, t: np.ndarray) -> dict[str, np.ndarray]:
    if scene.given_by == "modes":
        return {}
    motion = free_motion(of_scene(scene), *start_of(scene), t=t)
    return {"x1": motion.x[0], "x2": motion.x[1], "T1": scene.m1 * motion.v[0] ** 2 / 2}


def rows_of(motion: Any, *names: str) -> dict[str, np.ndarray]:
    return {name: getattr(motion, name) for name in names}


TRUE: dict[str, Callable[[Any, np.ndarray], dict[str, np.ndarray]]] = {
    "oscillator": lambda s, t: rows_of(Oscillator(m=s.m, k=s.k).motion(s.x_0, s.v_0, t), "x", "v", "a"),
    "energy": lambda s, t: rows_of(Oscillator(m=s.m, k=s.k).motion(s.x_0, s.v_0, t), "x"),
    "damped": lambda s, t: rows_of(DampedOscillator(m=s.m, c=s.c, k=s.k).motion(s.x_0, s.v_0, t), "x"),
    "driven": driven_true,
    "coupled": coupled_true,
    "forced": forced_true,
}


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


@pytest.mark.parametrize("curve", ["size", "signed", "log"])
def test_an_amplitude_of_forced_is_one_column_and_no_number_at_resonance(curve: str) -> None:
    scene = SCENES["forced"](curve=curve)
    table, natural = taken(fitted(scene.value))["response"], of_scene(scene).modes().omega
    assert list(table) == ["omega", "Xp1", "Xp2"] and table["omega"].is_monotonic_increasing
    gaps = table[table["Xp1"].isna()]
    assert gaps["omega"].to_list() == natural.tolist() and gaps["Xp2"].isna().all()
    rest = table.dropna()
    np.testing.assert_allclose(
        rest[["Xp1", "Xp2"]].to_numpy().T, particular_solution(of_scene(scene), scene.F_0, rest["omega"]), rtol=1e-14
    )
    assert (rest["Xp1"] < 0).any() and (rest["Xp1"] > 0).any()


def test_with_dashpots_it_has_sizes_and_lags() -> None:
    scene = SCENES["forced"](c1=0.5, c2=0.2)
    table = taken(fitted(scene.value))["response"]
    assert list(table) == ["omega", "Xp1", "Xp2", "phi1", "phi2"] and not table.isna().any(axis=None)
    for _, row in table.iloc[::40].iterrows():
        X = damped_solution(of_scene(scene), 0.2, scene.F_0, row["omega"], 0.5)
        assert row[["Xp1", "Xp2"]].to_list() == pytest.approx(np.abs(X).tolist(), rel=1e-14)
        turned = np.exp(-1j * row[["phi1", "phi2"]].to_numpy(float)) * np.abs(X)
        np.testing.assert_allclose(turned, X, atol=1e-14 * np.abs(X).max())


@pytest.mark.parametrize(
    ("cover", "left"),
    [
        ("plot:response", []),
        ("plot:lag", ["omega", "Xp1", "Xp2"]),
        ("curve:response.Xp2", ["omega", "Xp1", "phi1"]),
    ],
)
def test_a_covered_amplitude_is_in_no_file_nor_its_lag(cover: str, left: list[str]) -> None:
    files = taken(page_state_of(SCENES["forced"], Link("forced", {"c1": 0.5}, covered=(cover,)))[0])
    assert list(files.get("response", [])) == left


def test_a_long_window_says_what_its_rows_are_and_has_the_bounds() -> None:
    scene = SCENES["coupled"](window=1000.0)
    (time,), (band,) = (
        [table for table in tables(SCENES["coupled"], scene.shown) if table.name == name] for name in ("time", "band")
    )
    assert [note.split(";")[0][:27] for note in time.notes] == ["Rows: the first 10 periods "]
    assert [note.split(".")[0] for note in band.notes] == ["Rows: the whole window"]
    assert f"# {time.notes[0]}\r\n".encode() in as_csv(time, ["here"])
    assert {"x1_lo [m]", "x1_hi [m]", "x2_fast_hi [m]", "T1_mean [J]", "T2_mean [J]"} < set(band.head)
    last = 20 * math.pi / of_scene(scene).modes().omega[1]
    assert (time.rows[-1][0], band.rows[-1][0]) == (pytest.approx(last), 1000)
    motion, bounds = taken(fitted(scene.value))["time"], taken(fitted(scene.value))["band"]
    for name in ("x1", "x2"):
        assert motion[name].abs().max() <= bounds[f"{name}_hi"].max() * (1 + 1e-12)


@pytest.mark.parametrize("seconds", [1.0, 30.0, 33.0, 56.0, 57.0, 1e4, 1e12])
def test_the_rows_of_a_file_are_bounded(seconds: float) -> None:
    scene = SCENES["oscillator"](window=seconds, k=(2 * math.pi) ** 2)
    for table in tables(SCENES["oscillator"], scene.shown):
        assert len(table.rows) <= 1134
