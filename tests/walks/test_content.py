"""Each step of the lecture's walks against its scene and the physics; only words and formulas on the page of a walk."""

import math
import re
from collections.abc import Callable, Iterator
from decimal import Decimal
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from components.language.messages import Given
from components.layout.markup import CLASSES, LENGTHS, MATH, NAMES
from components.layout.text import rich
from components.quantities.formatting import three
from components.scene import Scene
from components.scene.traces import Floats
from components.scenes import SCENES
from components.state.covers import PLOT
from components.state.scene_sheet import plots
from components.walks.checking import problems, shortcomings
from components.walks.expressions import numbers_of as scene_numbers
from components.walks.features import Period
from components.walks.links import page_state_at
from components.walks.questions.choice import ChoiceStep
from components.walks.questions.number import NumericStep
from components.walks.questions.sketch import SketchStep
from components.walks.subject import Subject
from components.walks.texts import FORMULA, line, pieces
from components.walks.walk import Step
from physics.chain import UniformChain
from physics.coupled import TwoMassChain, free_modes
from physics.damped import DampedOscillator
from physics.forced import particular_solution
from physics.free_decay import FreeDecay
from physics.hanging import HangingMass
from physics.lanchester import period_excess
from physics.magnification import magnification
from physics.modes import trial_forces
from physics.oscillator import Oscillator
from physics.pendulum import amplitude_at_excess, excess
from physics.phugoid import flight
from tests.walks.test_walking import SKETCHES, STEPS, WALKS, heights

NUMBER = re.compile(r"(?<![\w.{_^])[−-]?\d+(?:\.\d+)?(?![\w.]*[}])")
NAME = re.compile(r"(?:(?:[Ss]lides?|[Mm]ass|[Ss]pring|[Rr]ows?) |√)$")
INDEX = re.compile(r"_(?:\{[^}]*\}|\w)|\{\w+\}|\*")


# The true answers, the numbers in the texts, and the wrong sketches that the walks describe.

FT = 0.3048
spring, heavy = Oscillator(m=1, k=39.4), Oscillator(m=4, k=39.4)
start = spring.constants(0.1, -0.8)
hanging = HangingMass(m=1, k=39.4, g=9.81)
stretched = float(hanging.spring([0.0])[0])
plain = TwoMassChain(m1=2, m2=1, k1=4, k2=2)
equal = TwoMassChain(m1=1, m2=1, k1=1, k2=1)
beats = TwoMassChain(m1=1, m2=0.04, k1=0.96, k2=0.04)
uneven = TwoMassChain(m1=3, m2=1, k1=9, k2=6)
slowly = TwoMassChain(m1=2, m2=1, k1=1, k2=2)
pushed = particular_solution(slowly, F_0=1.0, omega=0.0).tolist()
ONE_PERCENT = math.degrees(amplitude_at_excess(0.01))


def end_of(link: str) -> float:
    return math.floor(page_state_at(link, SCENES).shown.axes["t"].end)


def force_on_mass_1(ratio: float) -> float:
    return float(trial_forces(plain, 1.7, ratio).springs[0])


def late(degrees: float) -> float:
    return 100 * excess(math.radians(degrees))


first_low = (3 * math.pi / 2 - start.phi) % (2 * math.pi) / spring.omega_n
half_a_period = math.pi / math.sqrt(2) * (1 + period_excess(0.1))
speed_at_the_top = float(flight(1, 1, 0.1, [half_a_period]).V[0])
force_off = math.degrees(brentq(lambda a: (a - math.sin(a)) / a - 0.01, 0.01, 1))
growth = 1 / (2 * (2 + 1 * 2.0**2) * 1.0)

bob, car = DampedOscillator(m=1, c=1.257, k=39.48), DampedOscillator(m=300, c=1500, k=2e4)
slowly_dying = DampedOscillator(m=1, c=0.446, k=39.48)
kept = [0.1 * math.exp(-n * slowly_dying.log_decrement) for n in range(5)]
fastest = FreeDecay(oscillator=car, x_0=0.05, v_0=0.0).first_top_speed or 0.0
at_top_speed = car.motion(0.05, 0.0, [fastest])
to_equilibrium = (FreeDecay(oscillator=car, x_0=0.05, v_0=0.0).first_zero or 0.0) - fastest
half_power = [bob.omega_n * (math.hypot(1, bob.zeta) + way * bob.zeta) for way in (-1, 1)]
eight = UniformChain(N=8, m=0.5, k=2.0)
plucked = eight.drawn_modes(eight.pluck(3, 0.4), [0.0] * 8).energy


def home(zeta: float) -> float:
    """The time after which the displacement of the released mass of 1 kg stays within 1 % of its initial value."""
    one = DampedOscillator(m=1, c=2 * zeta * math.sqrt(39.48), k=39.48)
    return FreeDecay(oscillator=one, x_0=0.1, v_0=0.0).settled(0.01) or 0.0


# The answer of each number and point, and the value of each typical wrong answer.
ANSWERS: dict[str, tuple[list[float], list[float]]] = {
    "d31-02": ([heavy.period], [4 * spring.period, spring.period, spring.period / 2]),
    "d31-08": ([2 * hanging.delta_st], [hanging.delta_st]),
    "d31-12": ([ONE_PERCENT], [force_off, 5, 45]),
    "d31-13": ([100 * 2 * 0.05], [5, 0, 2.5]),
    "d32-33-01": ([kept[4]], [0.02, kept[3], kept[2], 0.0]),
    "d32-33-08": ([1 / (2 * bob.zeta)], [2 * bob.zeta, 1 / bob.zeta, 1.0, half_power[1] - half_power[0]]),
    "d34-01": ([force_on_mass_1(1.0)], [force_on_mass_1(0.0), 4, -4 + 2 * (2 - 1)]),
    "d34-07": ([float(uneven.modes().ratio[1])], [-1.5, -1 / 1.5, 2]),
    "d34-08": (equal.modes().ratio.tolist(), [1, -1, 0]),
    "d34-13": ([pushed[1]], [-pushed[1], 0, 1 / slowly.k1 + 0.5, 1 / (slowly.k1 + slowly.k2)]),
    "d34-16": ([48.0], [math.sqrt(250e3 / 100), 60, 24]),
    "waves-04": ([eight.omega[7]], [eight.string_omega[7], 4.0, 2.0]),
}

# The periods of sketched curves; for a beat or a growing oscillation, the period of the oscillation.
slow, fast = free_modes(beats, (0.2, 0.0), (0.0, 0.0)).omega.tolist()
PERIODS: dict[str, float] = {
    "d31-04": spring.period,
    "d31-09": Oscillator(m=0.25, k=39.4).period / 2,
    "d31-15": 200 * FT / 9.80665 * 2 * half_a_period,
    "d32-33-10": 2 * math.pi / 6.2833,
    "d34-10": 4 * math.pi / (slow + fast),
    "d34-15": 2 * math.pi / 1.0,
}

STATED: dict[str, list[float]] = {
    "d31-03": [SCENES["oscillator"].param["x_0"].softbounds[1]],
    "d31-04": [first_low, end_of("?scene=oscillator"), 0.8],
    "d31-06": [0.15 * math.sqrt(9.87), -0.15],
    "d31-07": [24.8 / 9.81],
    "d31-09": [0.2 / 2],
    "d31-10": [stretched - float(hanging.spring([-0.2])[0]), 0.2, 9.81 * 0.2],
    "d31-12": [late(5), late(45), late(60), 60, 100 * (1 - math.sin(math.radians(22.8138)) / math.radians(22.8138))],
    "d31-13": [1 + 0.05, 1.05**2, 0.6, 1.6**2, 1 + 2 * 0.6],
    "d31-14": [speed_at_the_top**2, 1.1**2],
    "d31-15": [0.1 * 200, 100 * period_excess(0.6), 0.6],
    "d32-33-01": [kept[1], math.exp(-2 * slowly_dying.log_decrement)],
    "d32-33-02": [float(at_top_speed.x[0]), to_equilibrium, car.c * float(at_top_speed.v[0]) ** 2],
    "d32-33-03": [100 * (bob.omega_d / DampedOscillator(m=1, c=2.514, k=39.48).omega_d - 1)],
    "d32-33-04": [home(0.1), 0.83, home(0.83)],
    "d32-33-08": half_power,
    "d32-33-09": [float(abs(magnification(1.6, zeta, "base")[0])) for zeta in (0.0, 0.05)],
    "d34-07": [1.5 * 1.5, beats.m1 / beats.m2, beats.modes().ratio[0], -uneven.m1 / uneven.m2],
    "d34-10": [end_of("?scene=coupled&m1=1&k1=0.96&m2=0.04&k2=0.04&x1_0=0.2"), 2 * 0.04, beats.m1 / beats.m2],
    "d34-15": [end_of("?scene=forced&m1=2&k1=4&k2=2&omega=1"), 1 / growth, 0.95],
    "waves-01": [6, 100 * plucked[-2:].sum() / plucked.sum()],
    "tour-05": [math.sqrt(250e3 / 100)],
    **{"d31-16": [150], "d32-33-05": [3], "d34-12": [200], "d34-14": [2.5, 5, -5], "waves-04": [eight.N + 1]},
}  # fmt: skip
"""Numbers in the texts of a step that are no parameter or number of one of its scenes, and no right or wrong answer."""

W = 2 * math.pi


def response(w: Any) -> Any:
    return np.abs((1 - w * w) / (w**4 - 3 * w * w + 1))


# The wrong sketches that the walks describe, as functions of the abscissa; a dict if two curves are drawn.
WRONG: list[tuple[str, Callable[[Any], Any]]] = [
    ("d31-04", lambda t: 0.1 * np.cos(W * t)),
    ("d31-04", lambda t: 0.1 * np.cos(W * t + 0.9) + 0.1 * (1 - math.cos(0.9)) * np.exp(-40 * t)),
    ("d31-06", lambda t: 0.471 * np.cos(W / 2 * t)),
    ("d31-06", lambda t: np.abs(0.471 * np.sin(W / 2 * t))),
    ("d31-06", lambda t: 0.471 * np.sin(W / 2 * t)),
    ("d31-09", lambda t: {"V": 0.394 * (1 + np.cos(2 * W * t)), "T": 0.394 * (1 - np.cos(2 * W * t))}),
    ("d31-09", lambda t: {"V": 0.788 * np.cos(2 * W * t), "T": 0.788 * np.sin(2 * W * t)}),
    ("d31-15", lambda t: 124 * np.sin(0.2275 * t)),
    ("d31-15", lambda t: -128 + 249 * (1 - np.exp(-t / 4))),
    ("d31-15", lambda t: 124 * np.cos(0.2275 * t)),
    ("d32-33-05", lambda t: 0.1 * np.exp(-25 * t)),
    ("d32-33-05", lambda t: 0.1 * np.exp(-1.5 * t) * np.cos(W / 0.66 * t)),
    ("d32-33-10", lambda t: -0.4 * np.cos(W * t)),
    ("d32-33-10", lambda t: -0.02 * np.exp(1.1 * t) * np.cos(W * t)),
    ("d32-33-10", lambda t: -0.2 * (1 - np.exp(-3 * t)) * np.cos(W * t)),
    ("d34-10", lambda t: np.cos(0.1005 * t) * np.cos(0.995 * t)),
    ("d34-10", lambda t: np.minimum(t / 16, 1) * np.sin(0.995 * t)),
    ("d34-10", lambda t: 0.2 * np.sin(0.995 * t)),
    ("d34-14", lambda w: 1 / np.abs(1 - (w / 1.118) ** 2 + 1e-9)),
    ("d34-14", lambda w: np.maximum(response(w), 0.8)),
    ("d34-14", lambda w: w**2 * response(w)),
    ("d34-15", lambda t: -2.0 * np.cos(t)),
    ("d34-15", lambda t: -0.02 * np.exp(0.21 * t) * np.cos(t)),
    ("d34-15", lambda t: -1.0 * (1 - np.exp(-t / 4)) * np.cos(t)),
]


@pytest.mark.parametrize("name", WALKS)
def test_a_walk_has_neither_problems_nor_shortcomings(name: str) -> None:
    """It opens, everything that it names is there, and no step shows a number that a later one asks for."""
    assert [*problems(WALKS[name], SCENES), *shortcomings(WALKS[name], SCENES)] == []


@pytest.mark.parametrize("name", WALKS)
def test_no_step_draws_the_curve_that_a_later_one_asks_for(name: str) -> None:
    """Curves over time are left out: each step has its own motion."""
    shown = set[tuple[type[Scene], str]]()
    for step in WALKS[name].steps:
        scene = page_state_at(step.state, SCENES).kind
        plot = getattr(step, "plot", "") or getattr(step, "axis", "").partition(".")[0]
        assert plot in {one.name for one in plots(scene) if one.time} or (scene, PLOT + plot) not in shown, step.id
        shown |= {(scene, part) for part in set(step.show) - set(step.still)}


@pytest.mark.parametrize(
    "step", [step for step in STEPS.values() if isinstance(step, NumericStep)], ids=lambda step: step.id
)
def test_answers_and_misses_are_what_the_physics_says(step: NumericStep) -> None:
    right, misses = ANSWERS[step.id]
    tolerance, subject = step.answer.tolerance, Subject("", step, SCENES)
    assert step.answer.quantities, "what is true is a quantity of the scene"
    assert list(step.right(subject)) == pytest.approx(right, abs=0.1 * tolerance)
    assert list(step.wrong(subject)) == pytest.approx(misses, abs=0.15 * tolerance)


def numbers_of(step: Step) -> Iterator[str]:
    """The numbers in the sentences of a step, without slide numbers, mass numbers and coefficients of formulas."""
    for _, sentence in step.sentences():
        text = INDEX.sub("", FORMULA.sub("", sentence))
        for match in NUMBER.finditer(text):
            after = text[match.end() : match.end() + 1]
            coefficient = after.isalpha() and match[0] in ("2", "3", "4")
            if not (NAME.search(text[: match.start()]) or coefficient or match[0] == "0"):
                yield match[0]


@pytest.mark.parametrize("step", STEPS.values(), ids=STEPS)
def test_every_number_in_a_text_is_the_scenes_or_the_physics(step: Step) -> None:
    """Parameters of the scenes of a step and its replies are repeated exactly, live values digit for digit, answers and
    other numbers to their last digit and 2 %.
    """
    replies = step.options if isinstance(step, ChoiceStep) else step.wrong if isinstance(step, SketchStep) else ()
    parameters, numbers, live = set[float](), set[float](), set[str]()
    if isinstance(step, NumericStep):
        subject = Subject("", step, SCENES)
        numbers |= {*step.right(subject), *step.wrong(subject)}
    for link in filter(None, (step.state, step.shown, *(reply.where for reply in replies))):
        page = page_state_at(link, SCENES)
        parameters |= {v for v in page.scene.values.values() if isinstance(v, float)}
        numbers |= set(scene_numbers(page.scene).values())
        for text in page.shown.values.values() if link in (step.state, step.shown) else ():
            live.update(re.findall(r"−?\d+(?:\.\d+)?(?!\d|·)", text))
    stated, used = STATED.get(step.id, []), set[float]()
    for text in numbers_of(step):
        number, place = float(text.replace("−", "-")), 0.5000001 * 10.0 ** -len(text.partition(".")[2])
        facts = {one for one in stated if abs(one - number) <= place}
        close = any(abs(one - number) <= min(place, 0.02 * abs(number)) for one in numbers)
        assert facts or close or text in live or number in parameters, text
        used |= facts
    assert used == set(stated), "each is in the texts"


DRAWN = 2e-3
"""Of a number, by which one that is read off a drawn curve may be off: a beat turns a little before it swings."""


@pytest.mark.parametrize("step", SKETCHES, ids=lambda step: step.id)
def test_a_feature_states_what_the_true_curve_has(step: SketchStep) -> None:
    """To the last written digit; for an expression, to the accuracy of a drawn curve."""
    subject = Subject("", step, SCENES)
    curves = subject.true(step.plot, step.curves)
    for written, feature in zip(step.must, step.told(step.must, subject), strict=True):
        found = feature.seen(curves[feature.on or step.curve])
        assert found.has
        number = PERIODS[step.id] if isinstance(feature, Period) else found.number
        for name, true in (("value", number), ("at", found.x)):
            stated = getattr(feature, name, None)
            if stated is not None and true is not None:
                told = isinstance(getattr(written, name), str)
                off = DRAWN * abs(true) if told else 0.5 * 10.0 ** int(Decimal(repr(stated)).as_tuple().exponent)
                assert abs(true - stated) <= off, (feature, true)
                assert not isinstance(feature, Period) or three(stated) == three(true), "it is said to be the true one"


def judged(step: SketchStep, draw: Callable[[Any], Any]) -> tuple[bool | None, str, set[str]]:
    """Return whether a sketch is right, the reply to it, and the kinds of the features that it lacks."""
    subject = Subject("", step, SCENES)
    axes = subject.axes(step.plot)
    x = np.linspace(*axes.frame.x, 201)
    drawn = draw(x)
    curves = {name: (x, y) for name, y in (drawn if isinstance(drawn, dict) else {step.curve: drawn}).items()}
    lesson = step.lesson(Given(walk="", step=step.id, curves=heights(step, curves)), subject)
    missed = {one.kind for one, found in zip(step.must, lesson.findings, strict=True) if not found.has}
    return lesson.right, lesson.reply, missed


@pytest.mark.parametrize("step", SKETCHES, ids=lambda step: step.id)
def test_a_wrong_sketch_gets_its_reply_and_no_other(step: SketchStep) -> None:
    assert all(wrong.has for wrong in step.wrong)
    sketches = [draw for name, draw in WRONG if name == step.id]
    for described, draw in zip(step.wrong, sketches, strict=True):
        right, reply, missed = judged(step, draw)
        assert (right, reply) == (False, rich(described.reply)), described.draws
        assert missed >= set(described.fails), described.draws
    low, high = Subject("", step, SCENES).axes(step.plot).frame.y
    for level in (low + share * (high - low) for share in (0.5, 0.75, 0.97)):
        assert judged(step, lambda x, y=level: dict.fromkeys(step.curves, 0 * x + y))[:2] == (False, ""), level


def drawn(scene: Scene, name: str = "x") -> Floats:
    """A curve of its picture, over time."""
    return scene.shown.sources["time"][name]


def lag(scene: Scene) -> float:
    return next(one.value for one in scene.readouts() if one.name == "phi")


CLAIMS: list[tuple[str, int | None, Callable[[Scene], Any]]] = [
    ("d34-13", None, lambda scene: scene.shown.values["Xp2"] == "+1.00"),  # as far as spring 1 gives way
    ("d31-15", 1, lambda scene: np.all(np.diff(drawn(scene)) > 0) and 0 <= -drawn(scene)[-1] < -0.01 * drawn(scene)[0]),
    ("d32-33-05", 0, lambda scene: np.all(drawn(scene) > 0) and drawn(scene)[-1] < 0.35 * drawn(scene)[0]),
    ("d32-33-05", 1, lambda scene: np.count_nonzero(np.diff(np.signbit(drawn(scene)))) > 1),
    ("d32-33-04", 1, lambda scene: home(0.83) < home(scene.values["zeta"]) < home(3.0)),
    ("d32-33-06", 1, lambda scene: scene.shown.forms["holds"] == "spring"),
    ("d32-33-06", 2, lambda scene: scene.shown.forms["holds"] == "inertia"),
    ("d32-33-07", 1, lambda scene: lag(scene) < 0.1),
    ("d32-33-07", 2, lambda scene: abs(lag(scene) - math.pi / 2) < 1e-3),
    ("d32-33-07", 3, lambda scene: float(scene.shown.values["M"]) < 0.003),
    (
        "d34-02",
        2,
        lambda scene: all(
            np.ptp(x[-len(x) // 8 :]) < 0.2 * np.ptp(x) for x in (drawn(scene, "x1"), drawn(scene, "x2"))
        ),
    ),
    ("d34-06", 2, lambda scene: scene.shown.forms["braked"] == "shown"),
    ("d34-06", 2, lambda scene: scene.shown.values["p3"] != "+ 0.00" != scene.shown.values["p1"]),  # the odd powers
    ("waves-01", 2, lambda scene: {2.0, 4.0, 6.0} <= {*scene.shown.columns["silent"]["silent_j"].tolist()}),
]
"""A step, one of its replies or none, and what is true of the picture of the reply or the step."""


@pytest.mark.parametrize(("step", "i", "is_true"), CLAIMS)
def test_what_a_step_says_is_true_of_its_picture(step: str, i: int | None, is_true: Callable[[Scene], Any]) -> None:
    one = STEPS[step]
    replies = one.options if isinstance(one, ChoiceStep) else one.wrong if isinstance(one, SketchStep) else ()
    assert is_true(page_state_at(one.state if i is None else replies[i].where, SCENES).scene)


REFRESH = r"\text{<meta http-equiv=refresh content='0;//a.example'>}"
LINKED = r"\href{https://a.example}{x}"
PIECES = (
    *("$", "$$", "*", "**", "_", "{x}", "[m1|", "[notice|", "[scene:modes|", "]", "%", "?", ". Is it", ": ", " ", "a"),
    *(REFRESH, LINKED, r"\class{notice}{x}", r"\style{position:fixed}{x}", r"\text{", "}", "{", r"\frac", r"\quad "),
    *("<!--", "-->", "<![CDATA[", "]]>", "<?a", "&lt;", "&", "'", '"', "="),
    *(r"\val{x}", r"\tint{k}", r"\hspace{-900em}"),
)
texts = st.lists(st.sampled_from(PIECES), min_size=1, max_size=9).map("".join)


ELEMENT = re.compile(r'<(/?)([a-z]+)((?: [a-z-]+="[^"<>]*")*) ?/?>')
ATTRIBUTE = re.compile(r'([a-z-]+)="([^"]*)"')


def strange(html: str) -> list[str]:
    """Return what a browser would read as neither words nor formulas."""
    found = re.findall("<[^<]{0,9}", ELEMENT.sub("", html))
    for _, tag, attributes in ELEMENT.findall(html):
        found += [] if tag in MATH | {"b", "sub", "span", "a"} else [tag]
        for name, value in ATTRIBUTE.findall(attributes):
            known = name in NAMES | LENGTHS or (name, tag) == ("xmlns", "math")
            leads = (name, tag) == ("href", "a") and value.startswith("?scene=")
            styled = name == "class" and CLASSES.issuperset(value.split())
            found += [] if known or leads or styled else [f"{name}={value}"]
    return found


@given(texts, texts)
def test_whatever_is_written_becomes_words_and_formulas(one: str, two: str) -> None:
    for make, text in ((rich, one + two), (line, one), (rich, f"Let ${one}$ be. Is ${two}$ so?")):
        try:
            html = make(text)
        except ValueError:
            continue
        assert strange(html) == []


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"F = -k x, \quad k > 0", [r"F = -k x, \quad ", "k > 0"]),
        (r"a = b \;\Rightarrow\; c = d = e", [r"a = b \;", r"\Rightarrow\; c = d ", "= e"]),
        (r"x = 0 \text{ at } t = 0", ["x = 0 ", r"\text{ at } t = 0"]),
        (r"(a = b = c) = \frac{a = b}{c}", [r"(a = b = c) = \frac{a = b}{c}"]),
        (r"\left\{a = b = c\right. \quad d", [r"\left\{a = b = c\right. \quad d"]),
        (r"\begin{matrix} a = b = c & d \end{matrix} = e", [r"\begin{matrix} a = b = c & d \end{matrix} = e"]),
        (r"a = b = c \over d", [r"a = b = c \over d"]),
    ],
)
def test_a_line_ends_between_its_pieces(latex: str, expected: list[str]) -> None:
    assert pieces(latex) == expected
