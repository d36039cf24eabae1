"""The Panel face without a browser: tests set a widget's value and read the data sources and the texts of figures."""

import itertools
from functools import cache

import numpy as np
import panel as pn
import pytest
from bokeh.document import Document
from bokeh.events import RangesUpdate

from components.language.controls import SliderRow
from components.panel_face.face import PanelFace
from components.panel_face.label_collisions import TextBox, box_of, text_width, without_collisions
from components.panel_face.live_figure import EDGE, HEAD, SMALL, WORDS, LiveFigure, LiveStage, axis_words, plain_html
from components.panel_face.shapes import text_row
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

PHONE, WIDE = (366, 290), (700, 700)
"""Widths in pixels of a stage and of a plot's frame: in a page 390 pixels wide, and in a wide one."""
scenes = pytest.mark.parametrize("kind", sample(list(SCENES.values())), ids=lambda kind: kind.slug)


@cache
def _built(slug: str) -> PanelFace:
    """A face that many tests use: to build one takes half a second."""
    return PanelFace(SCENES[slug]())


def first_face(slug: str, widths: tuple[int, int] | None = None) -> PanelFace:
    """Return the face of a scene with its first values, at t = 0; with widths that a browser would report."""
    face = _built(slug)
    for one in (*face.stages.values(), *face.figures.values()) if widths else ():
        one.model.set_from_json("inner_width", widths[isinstance(one, LiveFigure)])
    face.scene.set(SCENES[slug].at().values)
    face.player.value = 0
    return face


def numbers(scene: SceneFace) -> dict[str, dict[str, list[float]]]:
    found = {name: source.data for name, source in scene.sources.items()}
    return {name: {column: list(data[column]) for column in data} for name, data in found.items() if data}


def check_figures(face: PanelFace) -> None:
    """All figures draw what the scene's values give, in the units of their axes; the legend has what is drawn."""
    picture, drawn = draw(face.scene.value).picture, 0
    np.testing.assert_equal(numbers(face.scene), {of: columns for of, columns in picture.sources.items() if columns})
    for figure in face.figures.values():
        block = figure.block
        if figure not in face.seen or not figure.has(picture):
            continue
        ruler = picture.axes[block.x].ruler
        rest = 1e-9 * (ruler.end - ruler.start)
        assert figure.model.x_range.start <= ruler.start + rest < ruler.end <= figure.model.x_range.end + rest
        for renderer, part in figure.parts.items():
            given = picture.sources.get(part.source, {}).get(part.x, ())
            if renderer.visible:
                assert np.array_equal(renderer.data_source.data[part.x], picture.axes[block.x].places(given))
                drawn += 1
        for item, renderers in figure.items.items():
            assert item.visible == any(renderer.visible for renderer in renderers)
        drawn += figure.field is not None and len(figure.field.data["image"])
    assert drawn or not any(isinstance(one, LiveFigure) for one in face.seen)


@pytest.mark.parametrize(
    ("slug", "widths"), [*((slug, PHONE) for slug in SCENES), *((slug, WIDE) for slug in sample(list(SCENES), 3))]
)
def test_every_view_is_drawn_and_no_text_is_cut_or_overlaps_another(slug: str, widths: tuple[int, int]) -> None:
    face = first_face(slug, widths)
    for view in face.scene.views:
        face.scene.view = view.slug
        assert face.seen
        for one in face.seen:
            check_texts(one)
            if isinstance(one, LiveFigure):
                check_words(face, one)
            elif not one.block.shapes[0].inside:
                assert any(source.data["x"] for source in one.drawing.sources.values()), view
        check_figures(face)


@pytest.mark.parametrize("slug", SCENES)
def test_a_stage_on_a_wide_page_shows_all_of_its_drawing(slug: str) -> None:
    """In the first view."""
    for stage in (one for one in first_face(slug).seen if isinstance(one, LiveStage)):
        stage.model.set_from_json("inner_width", stage.model.max_width)
        marks = [row for kind in ("lines", "areas") for row in stage.drawing.sources[kind].data["y"]]
        assert all(-HEAD <= y <= stage.height + EDGE for row in marks for y in row if not np.isnan(y))


def check_texts(one: LiveStage | LiveFigure) -> None:
    """The texts of a figure are inside it and apart, in pixels from the upper left corner of its frame."""
    columns = one.drawing.sources["texts"].data
    x, y = one.model.x_range, one.model.y_range
    low, boxes = one.height if isinstance(one, LiveFigure) else y.start, dict[str, TextBox]()
    for row in (dict(zip(columns, of, strict=True)) for of in zip(*columns.values(), strict=True)):
        row["x"] = (row["x"] - x.start) * one.width / (x.end - x.start)
        row["y"] = (y.end - row["y"]) * low / (y.end - y.start) if isinstance(one, LiveFigure) else row["y"]
        if row["text"]:
            box = boxes[row["text"]] = box_of(row)
            assert box.left >= -0.5 and box.right <= one.width + 0.5, row
            assert box.top >= -12.5 and box.bottom <= low + 0.5, row
    for (text, box), (other, its) in itertools.combinations(boxes.items(), 2):
        assert not box.meets(its), (text, other)


def check_words(face: PanelFace, one: LiveFigure) -> None:
    """The words at an axis and the legend fit."""
    if one.has(face.scene.shown):
        for axis, length in ((one.model.xaxis[0], one.width), (one.model.yaxis[0], one.height)):
            assert text_width(axis.axis_label or "", WORDS) <= length, axis.axis_label
        names = [text_width(item.label.value, SMALL) for item in one.items if item.visible]
        count = one.legend.ncols
        assert not names or count == 1 or sum(max(names[i::count]) for i in range(count)) < one.width


def test_an_axis_and_a_mark_have_words_with_symbols_and_numbers() -> None:
    face = first_face("forced")
    marks = face.figures["response"].block.marks
    assert [plain_html(one.html, face.scene.shown) for one in marks] == ["slow ω₋ 0.618", "Xₚ₁=0 1.00", "fast ω₊ 1.62"]
    plane, field = (
        first_face(slug).figures[plot].block for slug, plot in (("oscillator", "plane"), ("chain", "field"))
    )
    assert (axis_words(plane), axis_words(field)) == (("displacement", "velocity"), ("", "time"))
    assert text_width("ω₋ 0.618 rad/s", 12, True) == pytest.approx(81.5, rel=0.1), "as in Chromium"


def test_the_later_of_two_overlapping_texts_moves_or_is_left_out() -> None:
    plane = TextBox(0, 100, 0, 100)
    same = [text_row(50, 20, text, "ink", "t1", "middle").row for text in ("first", "other")]
    one, other = without_collisions(same, plane)
    assert (one["x"], one["y"]) == (50, 20) and other["x"] == 50 and not box_of(one).meets(box_of(other))
    assert [row["text"] for row in without_collisions(same, TextBox(0, 100, 5, 25))] == ["first"]
    (edge,) = without_collisions([text_row(98, 20, "cut", "ink", "t1", "start").row], plane)
    assert box_of(edge).right <= 100
    left, right = (text_row(x, 20, "beside", "ink", "t1", "beside").row for x in (95, 5))
    assert [row["align"] for row in without_collisions([left, right], plane)] == ["right", "left"]


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
            check_figures(face)
    assert numbers(scene) != first
    for name in face.sliders:
        low, high = kind.param[name].softbounds
        text = "2" if kind.param[name].scale == "count" else f"{(low + high) / 2 if low else high / 2:.6g}"
        face.widgets[name].value = text
        unit = scene.units().get(name)
        assert face.problems or scene.values[name] == pytest.approx(float(text) * (unit.size if unit else 1))
    for control in face.controls:
        for option in control.row.options if isinstance(control, ChoiceControl) else ():
            control.field.value = option.value
            assert face.problems or str(scene.values[control.row.name]) == option.value, control.row.label
            check_figures(face)


@scenes
def test_a_refused_value_stays_in_its_field_with_the_reason(kind: type[Scene]) -> None:
    face = first_face(kind.slug)
    shown = face.scene.shown
    for one in face.controls:
        for text in ("many", "1e999", "nan") if one.row.name in face.sliders else ():
            place, one.field.value = one.slider.value, text
            assert one.problem.visible and one.problem.object.startswith(f"{one.row.label}: ")
            assert one.problem.object.endswith(".") and not face.refused.visible
            assert (one.field.value, one.slider.value) == (text, place)
    assert face.scene.shown is shown
    check_figures(face)
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
    face = first_face("damped")

    def shown() -> set[str]:
        away = [pane for part, _, _ in face.parts if not part.visible for pane in part.select(pn.pane.Bokeh)]
        hidden = [pane.object for pane in away]
        return {name for name, figure in (face.figures | face.stages).items() if figure.model not in hidden}

    assert shown() == {"stage", "x"}
    face.tabs.active = [view.slug for view in face.scene.views].index("energy")
    assert face.scene.view == "energy" and shown() == {"stage", "x", "P", "energy"}
    face.scene.view = "roots"
    assert face.tabs.active == 1 and shown() == {"stage", "x", "roots"}


def test_the_player_moves_the_stage_the_cursor_and_the_numbers_and_a_zoom_leaves_out_what_it_cuts() -> None:
    face, document = PanelFace(SCENES["coupled"]()), Document()
    face.__panel__().server_doc(document)
    stage, plot, masses = face.stages["stage"], face.figures["x1"], []
    stage.model.set_from_json("inner_width", 700)
    for share in (0, 1, 2):
        face.player.value = share * face.player.end // 4
        time, drawn = plot.cursor.location, stage.drawing.sources
        x = instant(face.scene.shown.signals, face.scene.shown.scalars, time)["x1"]
        masses.append(list(drawn["areas"].data["x"]))
        assert f"x₁ = {x:+.2f} m".replace("-", "−") in drawn["texts"].data["text"]
        assert x in plot.dots.data["y"] and plot.dots.data["x"] == [time] * 3
    assert masses[0] != masses[1] != masses[2]
    plot.model.x_range.start = time + 1.0  # Bokeh does not clip what is over a plot
    document.callbacks.trigger_event(RangesUpdate(plot.model))
    assert plot.dots.data["x"] == []


@pytest.mark.parametrize(
    ("slug", "view", "part", "name"),
    [
        *(("oscillator", "motion", "stage", "x_0"), ("damped", "roots", "roots", "zeta")),
        *(("coupled", "plane", "plane", "x1_0"), ("modes", "roots", "roots", "c1")),
        *(("analogues", "roles", "stage", "theta_0"), ("phugoid", "period", "path", "excess")),
        *(("forced", "nyquist", "nyquist", "omega"), ("chain", "wave", "stage", "h")),
        *(("driven", "response", "response", "omega"), ("analogues", "large", "late", "theta_0")),
        *(("accuracy", "time", "work", "wanted"), ("forced", "bode", "response", "omega")),
    ],
)
def test_a_dot_or_the_line_of_a_value_can_be_dragged(slug: str, view: str, part: str, name: str) -> None:
    """Each dot of a figure moves by a twentieth of the figure; one of them, or a line, sets the parameter."""
    for sign in (1, -1):
        face = first_face(slug)
        scene = face.scene
        scene.set({"view": view} | ({"c1": 0.5, "c2": 0.5} if view == "nyquist" else {}))
        figure = (face.figures | face.stages)[part]
        before, grips = scene.values[name], figure.drawing.grips
        for handle, line in figure.lines.items() if isinstance(figure, LiveFigure) else ():
            if getattr(handle, "parameter", "") == name:
                assert line.editable and line.visible
                line.location = line.location + 0.1
        for i in range(len(grips.data["x"]) if scene.values[name] == before else 0):
            moved = {axis: list(column) for axis, column in grips.data.items()}
            for axis, span in (("x", figure.model.x_range), ("y", figure.model.y_range)):
                moved[axis][i] += sign * 0.05 * (span.end - span.start)
            grips.data = moved
            if scene.values[name] != before:
                assert grips.data != moved
                break
        if scene.values[name] != before:
            assert not face.problems
            return
    pytest.fail(f"no dot and no line sets {name}")


def test_all_faces_follow_the_scene() -> None:
    scene = SCENES["coupled"]()
    one, other = scene.panel(), scene.panel()
    scene.k2 = 3.0
    assert (one.widgets["k2"].value, other.widgets["k2"].value) == ("3.00", "3.00")
    one.widgets["k2"].value = "1/3"
    assert scene.k2 == 1 / 3 and other.widgets["k2"].value == one.widgets["k2"].value
    parts, others = ({model.id for model in face.figures["x1"].model.references()} for face in (one, other))
    assert not parts & others
    check_figures(other)


def test_sliders_have_the_scales_of_the_page() -> None:
    rows = [row for kind in SCENES.values() for group in scene_sheet(kind).panel.groups for row in group.rows]
    cases = [(row.scale, i / 37, row.soft) for row in rows if isinstance(row, SliderRow) for i in range(38)]
    values = each("static/controls/scales.sliderValue", cases)
    assert [slider_value(*case) for case in cases] == values
    placed = [(scale, value, soft) for (scale, _, soft), value in zip(cases, values, strict=True)]
    places = each("static/controls/scales.sliderPlace", placed)
    assert [slider_place(*one) for one in placed] == pytest.approx(places, abs=1e-12)
