"""The Panel face without a browser: tests set a widget's value and read the data sources."""

from typing import Any

import panel as pn
import pytest

from components.language.controls import SliderRow
from components.panel_face.face import PanelFace
from components.panel_face.live_figure import LiveFigure, LiveStage
from components.panel_face.widgets import ChoiceControl
from components.quantities.instant import instant
from components.quantities.scales import slider_place, slider_value
from components.scene import Scene
from components.scene.face import SceneFace
from components.scene.picture import draw
from components.scenes import SCENES
from components.state.scene_sheet import scene_sheet
from tests.grids import sample
from tests.page.scripts import each
from tests.panel_face.faces import check_figures, first_face

scenes = pytest.mark.parametrize("kind", sample(list(SCENES.values())), ids=lambda kind: kind.slug)


def numbers(scene: SceneFace) -> dict[str, dict[str, list[float]]]:
    found = {name: source.data for name, source in scene.sources.items()}
    return {name: {column: list(data[column]) for column in data} for name, data in found.items() if data}


def check_drawn(face: PanelFace) -> None:
    """Check that the figures draw what the scene's values give."""
    shown = draw(face.scene.value).picture.sources
    assert numbers(face.scene) == {
        of: {name: list(one) for name, one in columns.items()} for of, columns in shown.items() if columns
    }
    check_figures(face)


@scenes
def test_every_slider_field_and_choice_moves_the_scene(kind: type[Scene]) -> None:
    face = first_face(kind.slug)
    scene = face.scene
    first = numbers(scene)
    for name, slider in face.sliders.items():
        slider.value = 0.75 if slider.value < 0.7 else 0.3
        if not face.problems:
            assert face.widgets[name].value
            assert scene.values[name] == scene.value.values[name] != kind.param[name].default
            check_drawn(face)
    assert numbers(scene) != first
    for name in face.sliders:
        low, high = kind.param[name].softbounds
        text = "2" if kind.param[name].scale == "count" else f"{(low + high) / 2 if low else high / 2:.6g}"
        face.widgets[name].value = text
        unit = scene.units().get(name)
        assert face.problems or scene.values[name] == pytest.approx(float(text) * (unit.size if unit else 1))
    for control in face.controls:
        if isinstance(control, ChoiceControl):
            for option in control.row.options:
                control.field.value = option.value
                assert face.problems or str(scene.values[control.row.name]) == option.value, control.row.label
                check_drawn(face)


@scenes
def test_a_refused_value_stays_in_its_field_with_the_reason(kind: type[Scene]) -> None:
    face = first_face(kind.slug)
    scene = face.scene
    before, shown = numbers(scene), scene.shown
    for one in face.controls:
        if one.row.name in face.sliders:
            place = one.slider.value
            for text in ("many", "1e999", "nan"):
                one.field.value = text
                assert one.problem.visible and one.problem.object.startswith(f"{one.row.label}: ")
                assert one.problem.object.endswith(".") and not face.refused.visible
                assert (one.field.value, one.slider.value) == (text, place)
    assert scene.shown is shown and numbers(scene) == before
    next(iter(face.presets.values())).clicks += 1
    assert not face.problems and not any(getattr(one, "problem", face.refused).visible for one in face.controls)


def test_an_unexpected_error_is_reported_and_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    face = first_face("coupled")
    scene, shown = face.scene, face.scene.shown
    monkeypatch.setattr(scene.scene_kind, "picture", lambda *_: [][1])
    face.widgets["k2"].value = "17"
    assert "Something went wrong" in face.refused.object
    assert face.widgets["k2"].value == "2.00" and scene.shown is shown


@scenes
def test_presets_actions_and_rows_are_those_of_the_scene(kind: type[Scene]) -> None:
    face = first_face(kind.slug)
    scene, panel = face.scene, scene_sheet(kind).panel
    rows = [row for group in panel.groups for row in group.rows]
    assert [control.row for control in face.controls][: len(rows)] == rows
    assert list(face.presets) == list(kind.presets)
    for label, button in face.presets.items():
        button.clicks += 1
        assert scene.preset() == label
        assert [one for one, other in face.presets.items() if other.button_type == "primary"] == [label]
    assert list(face.actions) == [name for group in kind.groups for name, _ in group.actions]
    for name, button in face.actions.items():
        wanted = scene.action(name)
        button.clicks += 1
        assert face.problems or {one: scene.values[one] for one in wanted} == dict(wanted)


def test_a_tab_shows_its_view_and_follows_the_scene() -> None:
    scene = SCENES["damped"]()
    face = PanelFace(scene)

    def shown() -> set[str]:
        away = [pane for part, _, _ in face.parts if not part.visible for pane in part.select(pn.pane.Bokeh)]
        hidden = [pane.object for pane in away]
        return {name for name, figure in (face.figures | face.stages).items() if figure.model not in hidden}

    assert shown() == {"stage", "x"}
    face.tabs.active = [view.slug for view in scene.views].index("energy")
    assert scene.view == "energy" and shown() == {"stage", "x", "P", "energy"}
    scene.view = "roots"
    assert face.tabs.active == 1 and shown() == {"stage", "x", "roots"}


def drawn(one: LiveFigure | LiveStage, of: str, column: str = "x") -> list[Any]:
    """Return a column of the areas, lines, points or texts that a stage or plot draws with its shapes."""
    return list(one.drawing.sources[of].data[column])


def test_the_player_moves_the_stage_the_cursor_and_the_numbers() -> None:
    face = PanelFace(SCENES["coupled"]())  # not one that another test has zoomed
    scene = face.scene
    stage, plot, masses = face.stages["stage"], face.figures["x1"], []
    stage.model.set_from_json("inner_width", 700)
    for share in (0, 1, 2):
        face.player.value = share * face.player.end // 4
        time = plot.cursor.location
        x = instant(scene.shown.signals, scene.shown.scalars, time)["x1"]
        masses.append(drawn(stage, "areas"))
        assert f"x₁ = {x:+.2f} m".replace("-", "−") in drawn(stage, "texts", "text")
        assert x in plot.dots.data["y"] and set(plot.dots.data["x"]) == {time}
    assert masses[0] != masses[1] != masses[2]


@pytest.mark.parametrize(
    ("slug", "view", "part", "name"),
    [
        *(("oscillator", "motion", "stage", "x_0"), ("damped", "roots", "roots", "zeta")),
        *(("coupled", "plane", "plane", "x1_0"), ("modes", "roots", "roots", "c1")),
        *(("analogues", "roles", "stage", "theta_0"), ("phugoid", "period", "path", "excess")),
        *(("forced", "nyquist", "nyquist", "omega"), ("chain", "wave", "stage", "h")),
    ],
)
def test_a_dot_can_be_dragged(slug: str, view: str, part: str, name: str) -> None:
    """Each dot of a figure moves by a fifth of the figure; one of them sets the parameter."""
    for sign in (1, -1):
        face = first_face(slug)
        scene = face.scene
        scene.set({"view": view} | ({"c1": 0.5, "c2": 0.5} if slug == "forced" else {}))
        figure = (face.figures | face.stages)[part]
        before, grips = scene.values[name], figure.drawing.grips
        wide = 0.05 * (figure.model.x_range.end - figure.model.x_range.start)
        high = 0.05 * (figure.model.y_range.end - figure.model.y_range.start)
        for i in range(len(grips.data["x"])):
            moved = {axis: list(column) for axis, column in grips.data.items()}
            moved["x"][i] += sign * wide
            moved["y"][i] += sign * high
            grips.data = moved
            if scene.values[name] != before:
                assert not face.problems and grips.data != moved
                return
    pytest.fail(f"no dot sets {name}")


@pytest.mark.parametrize(("slug", "view", "plot", "name"), [
    ("driven", "response", "response", "omega"), ("analogues", "large", "late", "theta_0"),
    ("accuracy", "time", "work", "wanted"), ("forced", "bode", "response", "omega"),
])  # fmt: skip
def test_the_line_of_a_value_can_be_dragged(slug: str, view: str, plot: str, name: str) -> None:
    face = first_face(slug)
    face.scene.view, before = view, face.scene.values[name]
    (line,) = (line for one, line in face.figures[plot].lines.items() if getattr(one, "parameter", "") == name)
    assert line.editable and line.visible
    line.location = line.location + 0.1
    assert not face.problems and face.scene.values[name] != before


def test_all_faces_follow_the_scene() -> None:
    scene = SCENES["coupled"]()
    one, other = scene.panel(), scene.panel()
    scene.k2 = 3.0
    assert (one.widgets["k2"].value, other.widgets["k2"].value) == ("3.00", "3.00")
    one.widgets["k2"].value = "1/3"
    assert scene.k2 == 1 / 3 and other.widgets["k2"].value == one.widgets["k2"].value
    assert scene.sources["time"].data["x1"][-1] == SCENES["coupled"](k2=1 / 3).shown.sources["time"]["x1"][-1]
    assert not {model.id for model in one.figures["x1"].model.references()} & {
        model.id for model in other.figures["x1"].model.references()
    }


def test_a_scene_displays_in_a_notebook(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pn.extension, "_loaded", True)
    monkeypatch.setattr(pn.config, "comms", "default")
    bundle, _ = SCENES["oscillator"]()._repr_mimebundle_()
    assert "text/html" in bundle
    root: Any = pn.Column(SCENES["oscillator"]()).get_root()
    assert [model for model in root.references() if type(model).__name__ == "TextInput"], "as any object"


def test_sliders_have_the_scales_of_the_page() -> None:
    rows = [row for kind in SCENES.values() for group in scene_sheet(kind).panel.groups for row in group.rows]
    sliders = {(row.scale, row.soft) for row in rows if isinstance(row, SliderRow)}
    cases = [(scale, i / 37, soft) for scale, soft in sliders for i in range(38)]
    values = each("static/controls/scales.sliderValue", cases)
    assert [slider_value(*case) for case in cases] == values
    placed = [(scale, value, soft) for (scale, _, soft), value in zip(cases, values, strict=True)]
    places = each("static/controls/scales.sliderPlace", placed)
    assert [slider_place(*one) for one in placed] == pytest.approx(places, abs=1e-12)
