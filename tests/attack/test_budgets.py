"""Every link gives a picture, a file and "About these numbers", or a refusal, within a budget of function calls; a page
stays consistent after any link or message: a short form of `make attack`.
"""

import sys
from functools import partial

import pytest
from hypothesis import given, settings

from components.quantities.refusals import SORRY
from components.scene import Scene
from components.scenes import SCENES
from components.session.exports import AboutExport, LinkExport, PageExport
from components.session.opening import opened
from components.session.worker import WorkerJob, replied
from components.state.link import Link, read_query
from tests.grids import sample, tries
from tests.page.headless_page import PICTURE, counted
from tests.scenes.checks import as_arguments
from tests.serving.served import lecture
from tests.states import links
from tools.attack.extremes import ExtremeValues, Message, messages, queries, values
from tools.attack.greedy import FILES
from tools.attack.visit import follow, visit

HERE = "http://here/"
FILE, ABOUT = 1_800_000, 3_000_000
"""Calls for a file of numbers and for "About these numbers" in the worker process: about 1 s at most."""
WORST = (
    "scene=driven&push=pulses&width=0.95&Y=0.1408&omega=0.9875&m=3414&k=37.616&zeta=1.000000000000001&keep=zeta"
    "&axes=log&held.push=pulses&held.omega=0.136&held.m=5.4&held.k=0.1&held.zeta=6.83",
    "scene=forced&c2=1.685856879665411e280&window=1e-4",
    "scene=driven&window=1e155&kind=unbalance&keep=c",
    "scene=driven&window=5e-324&kind=unbalance&omega=11.729809191764284&k=1e-300&c=33.108882784528554&keep=zeta",
    "scene=absorber&damping=added&m1=1e300&x2_0=-1.3&window=3&played=rest",
    "scene=modes&view=roots&k1=1.3131340137628744e-231&c1=1.7572071498403488",
    *FILES,
)
"""Links that once took seconds or failed without a reason."""


@pytest.fixture(scope="module", autouse=True)
def started() -> None:
    """Build what a server computes once, before its first visitor arrives."""
    assert len(lecture().files) > len(SCENES)


def check(link: Link, has_jobs: bool = True) -> None:
    """Open a link, and request its file and its errors. Each picture, current, compared or earlier, and each job stays
    within its budget or is refused with a reason.
    """
    page, calls = counted(lambda: opened(SCENES, link))
    pictures = 1 + (link.held is not None) + (link.before is not None)
    assert calls <= PICTURE * pictures, f"{pictures} pictures take {calls} calls"
    if has_jobs:
        check_job(PageExport(page.now.state, HERE, 1), FILE)
        check_job(AboutExport(page.now.state, 1), ABOUT)


def check_job(job: WorkerJob, budget: int) -> None:
    reply, calls = counted(lambda: replied(job, {}, SCENES))
    assert calls <= budget, f"{type(job).__name__} takes {calls} calls"
    assert SORRY not in reply.refused


@pytest.mark.parametrize("query", sample(WORST))
def test_the_slowest_links_stay_within_their_budgets(query: str) -> None:
    arguments = as_arguments(query)
    check(read_query(arguments, SCENES))
    check_job(LinkExport(dict(arguments), HERE), FILE)


@pytest.mark.parametrize("slug", sample(list(SCENES), 3))
@pytest.mark.parametrize("kind", ["extremes", "any state"])
@pytest.mark.timeout(600)
def test_any_link_stays_within_the_budgets(slug: str, kind: str) -> None:
    """Resonances, equal values and critical damping need more digits than extreme values."""
    drawn = links(SCENES[slug]) if kind == "any state" else values(SCENES[slug]).map(partial(Link, slug))
    settings(max_examples=tries(60))(given(drawn)(lambda link: check(link, has_jobs=kind == "extremes")))()


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES.keys())
@pytest.mark.timeout(600)
def test_pages_at_extremes_and_malformed_links(scene: type[Scene]) -> None:
    def page(link: ExtremeValues, sent: list[Message]) -> None:
        visit(scene.slug, link, sent)

    few = settings(max_examples=15)
    few(given(values(scene), messages(scene))(page))()
    few(given(queries(scene))(follow))()
    for window in (5e-324, 1e-300, 1.7e308):
        visit(scene.slug, {}, [{"type": "set", "values": {"window": window}}])


SOFT = {"scene": "energy", "parameters": {"k": 5e-324, "x_0": 0.0, "m": sys.float_info.min}, "frame": {}}


@pytest.mark.parametrize(
    ("slug", "link", "sent"),
    [
        # A kept frame grows to 5e16 m for the smallest mass on the softest spring. It was once labelled −4e+16.
        ("oscillator", {}, [{"type": "open", "state": SOFT}, {"type": "set", "values": {"m": 5e-324}}]),
        # The number of the harmonic at the peak has 40 digits. No integer of NumPy holds it.
        ("driven", {"push": "pulses", "k": 1e80, "view": "harmonics"}, []),
        # In so short a window nothing moves: the axis had no length.
        ("absorber", {"window": 1e-80, "omega": 1e-80, "x1_0": 0.01, "view": "rest"}, []),
        # The square of the frequency, which another view shows, leaves the range of doubles.
        ("oscillator", {}, [{"type": "set", "values": {"m": 5e-324, "x_0": 0.0}}]),
    ],
    ids=["ticks far off their unit", "harmonics of a quick mass", "nothing moves", "beyond doubles in another view"],
)
def test_what_a_search_once_found(slug: str, link: ExtremeValues, sent: list[Message]) -> None:
    visit(slug, link, sent)
