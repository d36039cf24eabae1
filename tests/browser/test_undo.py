"""Undo and redo, and the back button: one entry for each action, none for a refused one."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

pytestmark = pytest.mark.browser
Open = Callable[..., Page]


def is_shown(page: Page, **values: float) -> None:
    for name, value in values.items():
        page.wait_for_function(f"oscillations.shown.settings.{name}.value === {value}")


def type_in(page: Page, name: str, text: str) -> None:
    box = page.locator(f"input[name={name}]")
    box.fill(text)
    box.press("Enter")
    box.blur()


def test_typed_values_and_presets_are_undone_one_by_one_and_done_again(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", m1=3)
    undo, redo = (page.get_by_role("button", name=name, exact=True) for name in ("Undo", "Redo"))
    expect(undo).to_be_disabled()
    type_in(page, "k2", "7")
    is_shown(page, k2=7)
    type_in(page, "x1_0", "0.5")
    is_shown(page, x1_0=0.5)
    page.get_by_role("button", name="All equal").click()
    is_shown(page, m1=1)
    undo.click()
    is_shown(page, m1=3, k2=7, x1_0=0.5)
    page.keyboard.press("Control+z")
    is_shown(page, m1=3, k2=7, x1_0=1)
    page.keyboard.press("Control+z")
    is_shown(page, m1=3, k2=2, x1_0=1)
    expect(undo).to_be_disabled()
    page.keyboard.press("Control+Shift+z")
    is_shown(page, k2=7, x1_0=1)
    redo.click()
    is_shown(page, k2=7, x1_0=0.5)
    type_in(page, "m2", "4")
    is_shown(page, m2=4)
    expect(redo).to_be_disabled()


def test_a_whole_drag_is_one_entry_and_a_refused_change_none(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    box = page.locator("input[name=k1-slider]").bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + 0.3 * box["width"], y)
    page.mouse.down()
    for part in (0.4, 0.6, 0.8):
        page.mouse.move(box["x"] + part * box["width"], y)
        page.wait_for_function("!oscillations.messages.asked")
    page.mouse.up()
    dragged = page.evaluate("oscillations.messages.state.parameters.k1")
    assert dragged > 4
    type_in(page, "k2", "-3")
    expect(page.get_by_role("alert").filter(has_text="−3 N/m is not possible")).to_be_visible()
    page.keyboard.press("Control+z")
    is_shown(page, k1=4)
    expect(page.get_by_role("button", name="Undo", exact=True)).to_be_disabled()
    page.keyboard.press("Control+Shift+z")
    is_shown(page, k1=dragged)


def test_a_field_that_is_typed_in_undoes_its_own_text(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    type_in(page, "k2", "7")
    is_shown(page, k2=7)
    field = page.locator("input[name=m1]")
    field.focus()
    page.keyboard.type("5")
    page.keyboard.press("Control+z")
    page.wait_for_function("!oscillations.messages.asked && !oscillations.page.compare.undoGroup")
    assert page.evaluate("(({past, future}) => [past.length, future.length])(oscillations.undo.story)") == [1, 0]
    expect(field).to_have_value("2.00")


def test_each_scene_has_its_own_past(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled")
    type_in(page, "k2", "7")
    is_shown(page, k2=7)
    page.get_by_role("link", name="Forced").click()
    page.wait_for_function("oscillations.shown.scene === 'forced'")
    expect(page.get_by_role("button", name="Undo", exact=True)).to_be_disabled()
    page.go_back()
    page.wait_for_function("oscillations.shown.scene === 'coupled'")
    is_shown(page, k2=7)
    page.get_by_role("button", name="Undo", exact=True).click()
    is_shown(page, k2=2)


def test_a_preset_plays_from_the_start_and_keeps_what_it_does_not_name(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="coupled", hidden="x1_slow", window=40)
    page.get_by_role("button", name="Pause").click()
    page.evaluate("oscillations.clock.seek(20)")
    page.get_by_role("button", name="Beats").click()
    page.wait_for_function("oscillations.shown.preset === 'beats'")
    assert page.evaluate("oscillations.clock.playing && oscillations.clock.t < 20")
    assert page.evaluate("oscillations.messages.state.hidden") == ["x1_slow"]
    assert page.evaluate("oscillations.messages.state.parameters.window") == 40


def test_a_preset_that_is_refused_says_why(page: Page, open_scene: Open) -> None:
    open_scene(page, scene="forced", window=1e-3)
    page.evaluate("oscillations.take({omega: 1e300})")
    expect(page.locator(".notice")).to_contain_text("Still drawn as before.")
    expect(page.get_by_role("button", name="Undo", exact=True)).to_be_disabled()
