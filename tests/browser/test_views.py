"""Every view of every scene is visited once on a desk and once on a phone, for all that can be seen there."""

import pytest
from playwright.sync_api import Page

from components.scenes import SCENES
from tests.browser import looks
from tests.browser.looks import faults
from tests.browser.waiting import passed, seek, turned, unfold
from tests.grids import WHOLE
from tests.scenes.checks import choices

pytestmark = pytest.mark.browser
Given = dict[str, object]
State = tuple[str, Given]
VIEWS: list[State] = [(slug, {"view": view.slug}) for slug, scene in SCENES.items() for view in scene.views]
OPENING: list[State] = [(slug, {"view": scene.views[0].slug}) for slug, scene in SCENES.items()]
SPECIAL: list[State] = [
    ("forced", {"c1": 0.4, "c2": 0.2, "view": "formulas"}),  # the longest equations
    ("absorber", {"damping": "added", "c": 40.0}),  # the longest words next to a stage
    ("analogues", {"system": "pipe"}),  # the longest formulas
    ("energy", {"g": 24.8, "view": "motion"}),  # the longest name
    ("energy", {"g": 24.8, "view": "energy"}),
    ("driven", {"omega": 0.0123, "k": 12345.0, "c": 1e-5, "view": "motion"}),  # the widest numbers
    ("energy", {"datum": "separate", "view": "well"}),  # the longest name in a well
    ("modes", {"view": "guess", "ratio": 0.0}),  # the handle at a vertical axis is on a number
    ("modes", {"view": "guess", "ratio": 3.0}),
]
OPTIONS: list[State] = [
    (slug, dict(choice))
    for slug, scene in SCENES.items()
    for choice in choices(scene)
    if scene.at().differing(choice) and (slug, choice) not in VIEWS
]
CROWDED: State = ("forced", {"view": "bode"})  # the numbers at its axes have no room
QUICK = [CROWDED, *(state for state in OPENING if state[0] in ("coupled", "accuracy"))]  # two masses; no stage
MORE = [state for state in OPENING if state[0] in ("analogues", "phugoid")]  # many small pictures; a path
REST = (*VIEWS, *SPECIAL, *OPTIONS) if WHOLE else (*OPENING[1::3], *MORE, *SPECIAL[::2])
EACH = [*QUICK, *(pytest.param(state, marks=pytest.mark.slow) for state in REST if state not in QUICK)]
states = pytest.mark.parametrize("state", EACH, ids=lambda state: "-".join(map(str, (state[0], *state[1].values()))))
READ = ((1280, 720), (1024, 768))
"""Sizes of a desk at which the order of the parts is looked at."""
DESKS = ((1280, 720), (1250, 590), (1024, 768), (1920, 1080))
FOLD = "document.querySelectorAll('.panel details.fold').forEach(fold => { fold.open = false })"
BELOW = {
    ("analogues", "string"): 4, ("damped", "formulas"): 44, ("driven", "power"): 11, ("absorber", "stroke"): 28,
    ("driven", "forces"): 35, ("driven", "formulas"): 9,
}  # fmt: skip
"""How far below the first screen of a phone parts that a task names end, in px. Rows for fingers take this room."""


def at_size(page: Page, size: tuple[int, int], *scripts: str, text: str = "100%") -> list[str]:
    """The faults of a page in a window of this size, with text of this size."""
    page.set_viewport_size({"width": size[0], "height": size[1]})
    page.evaluate("text => { document.documentElement.style.fontSize = text }", "" if text == "100%" else text)
    passed(page)
    seek(page, 0.0)
    found = faults(page) + looks.of(page, looks.TICKS, looks.SIZES, *scripts)
    return [f"{size[0]} x {size[1]}, text of {text}: {one}" for one in found]


@states
def test_nothing_is_wrong_on_a_desk(desk: Page, state: State) -> None:
    """Each second visit is dark."""
    slug, given = state
    turned(desk, slug, given)
    desk.evaluate(FOLD)
    desk.locator("#theme").click()
    theme = desk.evaluate("document.documentElement.dataset.theme")
    panel = [looks.PANEL] if state in OPENING else []
    found = []
    for size in DESKS:
        fits = size[0] > 1249 and (slug != "accuracy" or size[1] > 680)  # the names of methods need a high plot
        found += at_size(desk, size, *([looks.DESK, *panel] if fits else []))
        found += looks.of(desk, looks.ORDER) if size in READ else []
    found += at_size(desk, (1280, 720), text="200%")
    unfold(desk)
    found += at_size(desk, (1280, 720), looks.LOST) + looks.of(desk, looks.TARGETS, given=24) + looks.axe(desk)
    if state in OPENING:  # other views may draw dots alone
        desk.wait_for_function(f"!({looks.UNINKED})().length")
    desk.evaluate("oscillations.change(() => ({covered: oscillations.plots.map(p => `plot:${p.block.name}`)}))")
    desk.wait_for_function("oscillations.shown.state.covered.length === oscillations.plots.length")
    found += looks.of(desk, looks.TWICE)
    assert not found, "\n".join([theme, *found])


@states
def test_nothing_is_wrong_on_a_phone(phone: Page, state: State) -> None:
    """The parts that the task names are on the first screen, or on the first two of a small phone."""
    slug, given = state
    phone.set_viewport_size({"width": 390, "height": 844})
    turned(phone, slug, given)
    phone.evaluate(FOLD)
    (view,) = [view for view in SCENES[slug].views if view.slug == SCENES[slug](**given).view]
    found = []
    below = BELOW.get((slug, str(given.get("system") or view.slug)), 0)
    for size, screens, room in (((390, 844), 1, below), ((320, 568), 2, 0)):
        found += at_size(phone, size, looks.ORDER)
        found += looks.of(phone, looks.FIRST, given=[list(view.names), screens, room])
    found += at_size(phone, (844, 390), looks.ORDER, looks.SIDEWAYS)
    unfold(phone)
    found += at_size(phone, (360, 640)) + at_size(phone, (390, 844), text="200%")
    found += at_size(phone, (390, 844), looks.FIELDS, looks.LOST)
    found += looks.of(phone, looks.TARGETS, given=44) + looks.axe(phone)
    assert not found, "\n".join(found)
