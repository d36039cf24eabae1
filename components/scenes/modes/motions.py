"""Free motions of a chain with dashpots, in words: their roots and shapes, and whether they oscillate or decay."""

from __future__ import annotations

from components import chain
from components.layout.sheet import Paragraph, either
from components.layout.stage import H, Looks, Shape, W, shown_by, text
from components.quantities.declared import Declared, Family, Form, Scalar
from components.scenes.modes.numbers import MOTIONS, BrakedChain
from components.scenes.modes.numbers import BrakedNumbers as B
from components.scenes.modes.solve import TOPS
from physics.damped_chain import Kind

form = Form[BrakedChain]


class Motions(Declared[BrakedChain]):
    """Flags for the visible texts on the free motions, and for the motions that are drawn."""

    braked = form(lambda c: c.brakes)
    many = form(lambda c: len(c.motions) > len(chain.MODES))
    root = Family(MOTIONS, lambda place: form(lambda c: c.root(place)), "{}_root")
    statement = form(lambda c: c.statement)
    drawn = Family(chain.MODES, lambda mode: Scalar[BrakedChain](lambda c, a: mode in c.exponents), "{}_drawn")
    missing = Family(chain.MODES, lambda mode: Scalar[BrakedChain](lambda c, a: mode not in c.exponents), "{}_missing")


def _root(place: str) -> Paragraph:
    """The line on the roots of a motion, in one variant per kind of root.

    Only the first two motions can be modes and can oscillate.
    """
    name, rate = f"{B.name[place]}: $X_2/X_1 = {B.ratio[place]}$,", f"$s = {B.rate[place]}$"
    lines = {
        "single": f"{name} {rate} 1/s. It does not swing.",
        "again": f"{name} {rate} 1/s, {B.repeats[place]}. It does not swing.",
        "rest": f"{name} $s = 0$: a rest.",
    }
    if place not in chain.MODES:
        return either(Motions.root[place], **lines)
    pair, both = rf"$s = {B.rate[place]} \pm {B.turn[place]}\, i$ 1/s", f"{rate} and ${B.other[place]}$ 1/s"
    swings = (
        rf"It swings and decays, $\zeta = {B.zeta[place]}$, $Q = {B.Q[place]}$; $1/e$ is left after {B.decay[place]} s."
    )
    lines |= {
        "pair": f"{name} {pair}. {swings}",
        "met": f"{name} {pair}, each twice. {swings}",
        "lasting": f"{name} $s = \\pm {B.turn[place]}\\, i$ 1/s. It swings with constant amplitude.",
        "real": f"{name} {both}. It does not swing.",
        "critical": rf"{name} {rate} 1/s twice. It is critical: $(A + B t)\, e^{{s t}}$.",
        "settles": f"{name} {both}. It does not swing; what is left is a displacement.",
        "drift": f"{name} $s = 0$ twice: $a + b t$.",
    }
    return either(Motions.root[place], **{form: f"[{place}|{line}]" for form, line in lines.items()})


def root_words() -> list[Paragraph]:
    """Return the equation for the exponents, and its roots."""
    return [
        either(
            Motions.braked,
            shown=r"**With dashpots** $D$ has odd powers. With $s = i \omega$ it is zero where "
            rf"${B.p4}\, s^4\, {B.p3}\, s^3\, {B.p2}\, s^2\, {B.p1}\, s\, {B.p0} = 0$:",
        ),
        *map(_root, MOTIONS),
        either(Motions.many, shown="The picture shows motions 1 and 2."),
    ]


IN_LINE = (
    rf"**The arrows** stay in line, as $c_1 k_2 = c_2 k_1$ $= {B.cross}$: the shapes are those without dashpots, and "
    "each mode decays by itself."
)
OFF_LINE = (
    rf"**The arrows** leave the line, by {B.angle['slow']}° and {B.angle['fast']}°, as $c_1 k_2 - c_2 k_1 = {B.gap}$ "
    "is not 0: in neither motion are both masses at 0 together."
)
DRIFTS = "with $a + b t$. Nothing brakes the drift."
BOTH_REST = r"$x_1(0) + (m_1 v_1(0) + m_2 v_2(0))/c_1$"
MEET = "Roots have met. A root that occurs more than once has one shape"
STATEMENTS: dict[str, str] = {
    Kind.UNDAMPED: "**No dashpot:** all roots are on the imaginary axis, and nothing decays.",
    Kind.DRIFT_BOTH: f"**Nothing ties the masses to a place:** both drift {DRIFTS}",
    Kind.DRIFT_TWO: f"**Nothing ties mass 2 to a place:** it drifts {DRIFTS}",
    Kind.REST_EACH: "**$s = 0$:** no spring brings a mass back. What is left at the end is a displacement: "
    rf"$x_1$ = {BOTH_REST}, and $x_2 - x_1$ = $x_2(0) - x_1(0) + m_2 v_2(0)/c_2$.",
    Kind.REST_BOTH: "**$s = 0$:** no spring brings both masses back. What is left at the end is a displacement: "
    f"both rest at {BOTH_REST}.",
    Kind.REST_TWO: "**$s = 0$:** no spring brings mass 2 back. What is left at the end is a displacement: "
    "mass 1 is at 0 again, mass 2 rests at $x_2(0) - x_1(0) + m_2 v_2(0)/c_2$.",
    Kind.PROPORTIONAL: IN_LINE,
    f"{Kind.PROPORTIONAL}_late": f"{IN_LINE} Neither swings, and the fast mode now outlasts the slow one.",
    Kind.EXCEPTIONAL: "**Both modes have become one:** one pair of roots, one shape. Its motions are $e^{s t}$ and "
    r"$t\, e^{s t}$.",
    Kind.PARTED: rf"**Two pairs with the same $|s|$.** The modes met at $c_1 = {B.c1_met}$, $c_2 = {B.c2_met}$ and "
    "parted: neither is the slow or the fast one.",
    f"{Kind.TWO_PAIRS}_lags": f"{OFF_LINE} In both, mass 2 lags behind mass 1.",
    f"{Kind.TWO_PAIRS}_leads": f"{OFF_LINE} In both, mass 2 leads mass 1.",
    Kind.ONE_PAIR: "**One motion swings, two do not.** Each has its own shape.",
    f"{Kind.ONE_PAIR}_met": rf"**One pair of roots swings, one does not.** {MEET}: its motions are $e^{{s t}}$ and "
    r"$t\, e^{s t}$.",
    Kind.CREEPING: "**Nothing swings.** Each motion has its own shape: 1 and 2 creep, 3 and 4 decay quickly.",
    Kind.FOUR_REAL: "**Nothing swings.** Four motions, each with its own shape.",
    f"{Kind.FOUR_REAL}_met": rf"**Nothing swings.** {MEET}: its motions are $e^{{s t}}$, $t\, e^{{s t}}$ and so on.",
}
"""The sentence on the kinds of the free motions with dashpots."""


def motion_title(mode: str) -> list[Shape]:
    """The title of a motion over its chain, with the shape under the arrows. Its roots are in the text."""
    look: Looks = {"tint": mode, "style": "t2 b"}
    lines = (f"{B.name[mode]}, {B.fate[mode]}", 0.03), (f"*X*_2/*X*_1 = {B.ratio[mode]}", 0.49)
    title = (text(chain.WALL * W, (TOPS[mode] + at) * H, f"{said}", "start", **look) for said, at in lines)
    missing = text(chain.WALL * W, (TOPS[mode] + 0.03) * H, "no second shape", "start", **look)
    return [*shown_by(Motions.drawn[mode], *title), *shown_by(Motions.missing[mode], missing)]
