"""The figures of the Panel face: the numbers that they draw, and texts of which none is cut or overlaps another."""

import itertools

import numpy as np
import pytest
from bokeh.document import Document
from bokeh.events import RangesUpdate

from components.panel_face.drawing import ShapeGlyphs
from components.panel_face.face import PanelFace
from components.panel_face.label_collisions import TextBox, box_of, text_width, without_collisions
from components.panel_face.live_figure import EDGE, HEAD, SMALL, WORDS, LiveFigure, LiveStage, axis_words, plain_html
from components.panel_face.shapes import text_row
from components.scenes import SCENES
from tests.grids import sample
from tests.panel_face.faces import check_figures, first_face

STAGE, FRAME = 366, 290
"""Widths in pixels of a stage and of a plot's frame in a page 390 pixels wide."""
WIDE = 700


def fitted(slug: str, stage: int, frame: int) -> PanelFace:
    """Return a face whose figures have the widths that a browser would report."""
    face = first_face(slug)
    figures: list[LiveStage | LiveFigure] = [*face.stages.values(), *face.figures.values()]
    for one in figures:
        one.model.set_from_json("inner_width", stage if isinstance(one, LiveStage) else frame)
    return face


def rows(drawing: ShapeGlyphs, one: LiveStage | LiveFigure) -> list[dict[str, object]]:
    """Return the drawn texts of a figure, in pixels from the upper left corner of its frame."""
    columns = drawing.sources["texts"].data
    x, y = one.model.x_range, one.model.y_range
    top = one.height if isinstance(one, LiveFigure) else y.start
    high = top / (y.end - y.start) if isinstance(one, LiveFigure) else -1.0
    found = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
    found = [row for row in found if row["text"]]
    for row in found:
        row["x"] = (row["x"] - x.start) * one.width / (x.end - x.start)
        row["y"] = (y.end - row["y"]) * high if isinstance(one, LiveFigure) else row["y"]
    return found


@pytest.mark.parametrize(
    ("slug", "stage", "frame"),
    [*((slug, STAGE, FRAME) for slug in SCENES), *((slug, WIDE, WIDE) for slug in sample(list(SCENES), 3))],
)
def test_every_view_is_drawn_and_no_text_is_cut_or_overlaps_another(slug: str, stage: int, frame: int) -> None:
    face = fitted(slug, stage, frame)
    for view in face.scene.views:
        face.scene.view = view.slug
        assert face.seen
        for one in face.seen:
            check_texts(one)
            if isinstance(one, LiveFigure):
                check_words(face, one, frame)
            elif not one.block.shapes[0].inside:
                assert any(source.data["x"] for source in one.drawing.sources.values()), view
        check_figures(face)


def check_texts(one: LiveStage | LiveFigure) -> None:
    boxes = {str(row["text"]): box_of(row) for row in rows(one.drawing, one)}
    low = one.height if isinstance(one, LiveFigure) else one.model.y_range.start
    for text, box in boxes.items():
        assert box.left >= -0.5 and box.right <= one.width + 0.5, (text, box)
        assert box.top >= -12.5 and box.bottom <= low + 0.5, (text, box)
    for (text, box), (other, its) in itertools.combinations(boxes.items(), 2):
        assert not box.meets(its), (text, other)


def check_words(face: PanelFace, one: LiveFigure, wide: int) -> None:
    """The words at an axis and the legend fit."""
    if one.has(face.scene.shown):
        for axis, length in ((one.model.xaxis[0], wide), (one.model.yaxis[0], one.height)):
            assert text_width(axis.axis_label or "", WORDS) <= length, axis.axis_label
        names = [text_width(item.label.value, SMALL) for item in one.items if item.visible]
        count = one.legend.ncols
        assert not names or count == 1 or sum(max(names[i::count]) for i in range(count)) < wide


def test_an_axis_and_a_mark_have_words_with_symbols_and_numbers() -> None:
    face = fitted("forced", WIDE, WIDE)
    marks = face.figures["response"].block.marks
    assert [plain_html(one.html, face.scene.shown) for one in marks] == ["slow ω₋ 0.618", "Xₚ₁=0 1.00", "fast ω₊ 1.62"]
    plots = (("oscillator", "plane", ("displacement", "velocity")), ("chain", "field", ("", "time")))
    for slug, plot, names in plots:
        assert axis_words(fitted(slug, WIDE, WIDE).figures[plot].block) == names


def test_a_dot_outside_the_visible_part_of_a_plot_is_not_drawn() -> None:
    """Bokeh does not clip what is over a plot."""
    face, document = fitted("coupled", WIDE, WIDE), Document()
    face.__panel__().server_doc(document)
    figure = face.figures["x1"]
    assert len(figure.dots.data["x"]) == 3
    figure.model.x_range.start = 1.0  # a visitor zooms; all dots are at t = 0
    document.callbacks.trigger_event(RangesUpdate(figure.model))
    assert figure.dots.data["x"] == []


@pytest.mark.parametrize("slug", SCENES)
def test_a_stage_on_a_wide_page_shows_all_of_its_drawing(slug: str) -> None:
    """In the first view."""
    for stage in (one for one in first_face(slug).seen if isinstance(one, LiveStage)):
        stage.model.set_from_json("inner_width", stage.model.max_width)
        marks = [stage.drawing.sources[kind].data["y"] for kind in ("lines", "areas")]
        heights = [y for rows_of_kind in marks for row in rows_of_kind for y in row]
        assert all(-HEAD <= y <= stage.height + EDGE for y in heights if not np.isnan(y))


def test_the_later_of_two_overlapping_texts_moves_or_is_left_out() -> None:
    same = [text_row(50, 20, text, "ink", "t1", "middle").row for text in ("first", "other")]
    one, other = without_collisions(same, TextBox(0, 100, 0, 100))
    assert (one["x"], one["y"]) == (50, 20) and other["x"] == 50 and other["y"] != 20
    assert not box_of(one).meets(box_of(other))
    assert [row["text"] for row in without_collisions(same, TextBox(0, 100, 5, 25))] == ["first"]
    (edge,) = without_collisions([text_row(98, 20, "cut", "ink", "t1", "start").row], TextBox(0, 100, 0, 100))
    assert box_of(edge).right <= 100
    left, right = (text_row(x, 20, "beside", "ink", "t1", "beside").row for x in (95, 5))
    assert [row["align"] for row in without_collisions([left, right], TextBox(0, 100, 0, 100))] == ["right", "left"]


@pytest.mark.parametrize(
    ("text", "size", "bold", "width"),
    [("x₁ = +0.10 m", 13, False, 73.6), ("ω₋ 0.618 rad/s", 12, True, 81.5), ("mass 1, 2.00 kg", 15, False, 105.9)],
)
def test_estimated_text_widths_agree_with_chromium(text: str, size: float, bold: bool, width: float) -> None:
    assert text_width(text, size, bold) == pytest.approx(width, rel=0.1)
