"""The view Roots of the scene modes: the roots of the chain with dashpots, their paths, and their motions."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from msgspec.structs import replace

from components import chain
from components.chain import BOTH, MODES
from components.chain.parameters import Pair
from components.chain.signals import Axes as TimeAxes
from components.language.blocks import Block
from components.language.expressions import as_expression, var
from components.language.shapes import ChainRoot, Grab
from components.language.state import Frame
from components.layout.grabs import grab, on_plot
from components.layout.plots import Room, curve, plot
from components.layout.root_plane import root_plane
from components.layout.sheet import choice, column, either, phrase, row, term, words
from components.layout.stage import Looks, PlotFrame, Shape, arrow, circle, line, path, shown_by, text
from components.quantities.axes import nice_axis, nice_ticks, time_axis
from components.quantities.declared import AxesInForce, Column, Declared, DrawnAxis, Family, LiveNumber, Scalar, by_name
from components.quantities.formatting import three
from components.quantities.motion import pace
from components.quantities.parameters import one_of
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns
from components.scenes.modes.motions import STATEMENTS, Motions, motion_title, root_words
from components.scenes.modes.numbers import BrakedChain, BrakedNumbers, RootReadouts
from components.scenes.modes.solve import Turning, turning_stage
from physics.coupled import TwoMassChain
from physics.damped_chain import Complexes
from physics.root_paths import RootPath, Varied
from physics.sampling import time_window
from physics.valid import DOUBLES

GROWING = {"c1": "c₁", "c2": "c₂", "both": "Both in proportion"}
GROWS = one_of("c1", GROWING, "Growing dashpot")
LEFT, RIGHT, UP = 1.9, 0.55, 1.15
"""The half width of the plane, in units of the higher natural frequency."""
FAR, LARGE = 3.0, 40.0
"""Paths are cut, and circles left out, beyond this multiple of the higher natural frequency."""
ROOTS = range(4)
LASTING, TURNS, POINTS = 4.0, 8.0, 321
"""In its plane, a motion is drawn for at most this many decay times, and at most this many cycles."""
TERMS = [(power, part) for part in range(3) for power in range(5)]
"""For each coefficient of P: its power of s, and the power of the path's parameter."""
DIAMOND, SQUARE = "M0-17L17 0L0 17L-17 0Z", "M-4-4H4V4H-4Z"
PLANE, SHAPES = PlotFrame("roots"), PlotFrame("shapes")


@lru_cache(100)
def known(path: RootPath) -> RootPath:
    """Return the same path, cached, with the points where its roots meet. During a drag of a dashpot the path stays the
    same."""
    return path


@dataclass(frozen=True, eq=False)
class RootPlane:
    """A chain with its dashpots, and the dashpot that changes along the paths."""

    braked: BrakedChain
    grows: Varied

    @cached_property
    def path(self) -> RootPath:
        return known(RootPath.of(self.braked.damped, self.grows))

    @property
    def value(self) -> float:
        """The position of the current dashpots on the path."""
        one, two = self.braked.damping
        return float(self.braked.brakes) if self.grows == "both" else one if self.grows == "c1" else two

    @property
    def beta(self) -> str:
        """The time c/k of the dashpots if it is equal for both springs, otherwise their ratio."""
        (one, two), k1 = self.braked.damping, self.braked.system.k1
        return f"β = {three(one / k1)} s" if k1 and not self.braked.gap else f"c₁ : c₂ = {three(one)} : {three(two)}"

    @property
    def omega(self) -> dict[str, float]:
        return dict(zip(MODES, self.braked.system.modes().omega.tolist(), strict=True))

    @property
    def highest(self) -> float:
        """The higher natural frequency in rad/s, or another positive frequency if it is 0."""
        return self.omega["fast"] or max(map(abs, self.braked.damped.roots)) or 1.0

    @cached_property
    def branches(self) -> Complexes:
        """The roots (n, 4) along the path. The last row has the current dashpots."""
        return self.path.branches(self.value)

    @property
    def now(self) -> Complexes:
        return np.asarray(self.branches[-1])

    @property
    def beyond(self) -> list[float]:
        """The roots left of the plane, nearest first."""
        return sorted((float(s.real) for s in self.now if s.real < -LEFT * self.highest), reverse=True)

    def radius(self, i: int) -> float:
        """The radius k/c of the circle of spring and dashpot i in 1/s; 0 if there is none, or if it is too large to
        draw.
        """
        k, c = (self.braked.system.k1, self.braked.system.k2)[i - 1], self.braked.damping[i - 1]
        return k / c if c and k / c < LARGE * self.highest else 0.0


class Axes(Declared[RootPlane]):
    re, im, x1, x2 = DrawnAxis.some(4)


class Texts(Declared[RootPlane]):
    out = LiveNumber[RootPlane](lambda c: ", ".join(map(three, c.beyond)))
    grows = LiveNumber[RootPlane](
        lambda c: f"both grow, {c.beta}" if c.grows == "both" else f"{GROWING[c.grows]} grows"
    )


class Curves(Declared[RootPlane]):
    """The paths of the four roots, and the path of both masses in each drawn motion."""

    re, im = (Column[RootPlane].each(ROOTS, source="paths") for _ in range(2))
    x = Family(
        [(i, mode) for mode in MODES for i in BOTH], lambda one: Column[RootPlane](f"spiral_{one[1]}"), "spiral{}_{}"
    )


scalar = Scalar[RootPlane]


class Places(Declared[RootPlane]):
    """Positions in the plane of the roots, in the units of its axes. A scalar that is 0 hides the shapes that depend on
    it.
    """

    re = Family(ROOTS, lambda j: scalar(lambda c, a: Axes.re(a).place(float(c.now[j].real))), "root{}_re")
    im = Family(ROOTS, lambda j: scalar(lambda c, a: Axes.im(a).place(float(c.now[j].imag))), "root{}_im")
    seen = Family(ROOTS, lambda j: scalar(lambda c, a: _seen(c, a, j)), "root{}_in")
    held = Family(
        [(j, way) for j in ROOTS for way in GROWING],
        lambda one: scalar(lambda c, a: _seen(c, a, one[0]) and c.grows == one[1]),
        "root{}_{}",
    )
    ring = Family(MODES, lambda m: scalar(lambda c, a: Axes.re(a).place(c.omega[m])), "ring_{}")
    radius = Family(BOTH, lambda i: scalar(lambda c, a: Axes.re(a).place(c.radius(i))), "radius{}")
    end_re = Family(BOTH, lambda i: scalar(lambda c, a: Axes.re(a).place(float(c.path.limits[i - 1].real))), "end{}_re")
    end_im = Family(BOTH, lambda i: scalar(lambda c, a: Axes.im(a).place(float(c.path.limits[i - 1].imag))), "end{}_im")
    ends_at_0 = scalar(lambda c, a: c.grows != "both")
    met_re = Family(BOTH, lambda i: scalar(lambda c, a: _met(c, a, i).real), "met{}")
    met_im = Family(BOTH, lambda i: scalar(lambda c, a: _met(c, a, i).imag), "met{}_im")
    met = scalar(lambda c, a: bool(c.path.exceptional))
    out = scalar(lambda c, a: bool(c.beyond))
    # From these numbers a drag computes dashpots: the coefficients of P for roots in the unit of the path, and their
    # growth.
    unit = scalar(lambda c, a: Axes.re(a).place(c.path.unit))
    term = Family(TERMS, lambda one: scalar(lambda c, a: float(c.path.scaled[one])), "term{}_{}")
    value = scalar(lambda c, a: c.value)
    slope = Family(BOTH, lambda i: scalar(lambda c, a: c.path.direction[i - 1]), "slope{}")


def _met(case: RootPlane, axes: AxesInForce, i: int) -> complex:
    """The position of a double root."""
    s = case.path.exceptional[i - 1] if case.path.exceptional else 0j
    return complex(Axes.re(axes).place(s.real), Axes.im(axes).place(s.imag))


def _seen(case: RootPlane, axes: AxesInForce, j: int) -> bool:
    return bool(case.now[j].real >= Axes.re(axes).start)


P, C = Places, Curves
X0, Y0 = PLANE.x(0.0), PLANE.y(0.0)


def sheet() -> Block:
    return row(
        column(choice(GROWS, phone=10), _plane(), grow=430),
        column(
            row(
                turning_stage("roots", "Two free motions of the chain", motion_title, grow=240, phone=16),
                _spirals(),
                grow=250,
            ),
            words(*root_words(), either(Motions.statement, **STATEMENTS), phone=20, name="motions"),
            grow=480,
        ),
    )


def _plane() -> Block:
    paths = (curve(C.im[j], x=C.re[j], source="paths", tint="T", width="line", group="paths") for j in ROOTS)
    return plot(
        PLANE, x=Axes.re, y=Axes.im, x_column=C.re[0],
        title="Plane of the roots s, with their paths as a dashpot grows: to the left a motion decays faster, upwards "
        "it swings faster",
        curves=tuple(paths),
        heading=(
            term("", "none", "ink", formula=r"\text{roots } s"),
            phrase("paths", "line", "T", formula=f"paths, as {Texts.grows}"),
            phrase("", "dash", "mute", words="bounds of swinging roots"),
        ),
        room=Room(52, 10, top=8), square=True, shapes=tuple(_shapes()), grow=1, phone=9, height=330,
    )  # fmt: skip


def _spirals() -> Block:
    return plot(
        SHAPES, x=Axes.x1, y=Axes.x2, x_column=C.x[1, "slow"],
        title="Displacement of mass 2 against that of mass 1 in each motion: a line, or an ellipse that shrinks",
        curves=tuple(curve(C.x[2, mode], x=C.x[1, mode], tint=mode, width="line") for mode in MODES),
        heading=(term("", "none", "ink", formula=r"x_2 \text{ against } x_1"),),
        room=Room(40, 10, top=8), square=True, grow=240, phone=17, height=260,
    )  # fmt: skip


def _shapes() -> list[Shape]:
    """The roots, their positions without and with infinitely strong dashpots, and the circles that bound the
    oscillating ones.
    """
    cut: Looks = {"inside": PLANE}
    found = root_plane((PLANE.left, PLANE.right, PLANE.top, PLANE.bottom), X0, Y0, "*c* < 0")
    for mode, sign in zip(MODES, "−+", strict=True):
        radius = PLANE.per_x * var(P.ring[mode])
        found.append(circle(X0, Y0, radius, tint=mode, style="outline dots", **cut))
        found += [circle(X0, Y0 + way * radius, 5, tint=mode, style="ring") for way in (-1, 1)]
        found.append(text(X0, Y0 - radius, f"*ω*_{{{sign}}}", "beside", tint=mode, style="halo"))
    for i in BOTH:
        radius = PLANE.per_x * var(P.radius[i])
        found += shown_by(P.radius[i], circle(X0 - radius, Y0, radius, style="eq", **cut))
        end = PLANE.x(var(P.end_re[i])), PLANE.y(var(P.end_im[i]))
        found.append(path(SQUARE, *end, tint="ink", style="ring", **cut))
    found += shown_by(P.ends_at_0, path(SQUARE, X0, Y0, tint="ink", style="ring"))
    points = ((PLANE.x(var(P.met_re[i])), PLANE.y(var(P.met_im[i]))) for i in BOTH)
    found += shown_by(P.met, *(path(DIAMOND, *point, tint="F", style="ring", **cut) for point in points))
    for j in ROOTS:
        x, y = PLANE.x(var(P.re[j])), PLANE.y(var(P.im[j]))
        cross = (line(x - 7, y - 7 * way, x + 7, y + 7 * way, style="sum", tint="ink", **cut) for way in (1, -1))
        found += shown_by(P.seen[j], *cross)
        for grows in GROWING:
            found += shown_by(P.held[j, grows], circle(x, y, 11, tint="ink", style="outline", grab=_hold(j, grows)))
    edge = PLANE.left + 4
    found += [
        text(edge, PLANE.top + 14, "○ no dashpot, □ endless", "start", tint="mute"),
        *shown_by(P.met, text(edge, PLANE.top + 30, "◇ two pairs meet", "start", tint="mute")),
    ]
    found += shown_by(
        P.out, arrow(edge + 34, Y0, edge, Y0, tint="ink", style="thin"), text(edge, Y0 + 21, f"{Texts.out}", "start")
    )
    return found


def _hold(j: int, grows: str) -> Grab:
    """Let the visitor drag a root, which sets the dashpot that changes, or both."""
    along = on_plot(PLANE, "x", "", P.re[j], Axes.re), on_plot(PLANE, "y", "", P.im[j], Axes.im)
    first, second, third = (tuple(as_expression(var(P.term[power, part])) for power in range(5)) for part in range(3))
    way = ChainRoot(
        x=X0, y=Y0, right=PLANE.per_x * var(P.unit), down=PLANE.per_y * var(P.unit), terms=(first, second, third),
        base=0.0, slope=0.0, now=var(P.value),
    )  # fmt: skip
    poles = (replace(way, parameter=f"c{i}", slope=var(P.slope[i])) for i in BOTH if grows in ("both", f"c{i}"))
    return grab(f"Root {j + 1}", *along, *poles, inside=PLANE)


def picture(system: TwoMassChain, damping: Pair, grows: Varied, window: float | None, frame: Frame = FITTED) -> Picture:
    """Return everything that the view shows for one chain with its dashpots. Raise ValueError if a path leaves the
    range of doubles.
    """
    braked = BrakedChain(system, damping)
    case = RootPlane(braked, grows)
    try:
        columns = _paths(case) | _spiral_columns(braked)
    except ArithmeticError as error:
        raise ValueError(f"a path of the roots leaves {DOUBLES}") from error
    slow, fast = system.modes().omega.tolist()
    high = case.highest
    re = nice_axis(-LEFT * high, RIGHT * high, "1/s", 4, exact=True)
    high *= UP
    end = re.place(high)
    im = replace(re, start=-high, end=high, drawn=(-high, high), unit="rad/s", ticks=nice_ticks(-end, end, 4))
    one = nice_axis(-1.1, 1.1, "m", 4, exact=True)
    own = {Axes.re: re, Axes.im: im, Axes.x1: one, Axes.x2: one}
    axes = framed(frame, by_name({TimeAxes.t: time_axis(window or _lasting(braked)), **own}))
    return Picture(
        columns=columns,
        axes=axes,
        signals=Turning.signals(braked, axes),
        scalars=Turning.scalars(braked, axes)
        | Motions.scalars(braked, axes)
        | chain.Has.scalars(damping, axes)
        | Places.scalars(case, axes),
        pace=pace(slow or fast, fast),
        values=BrakedNumbers.texts(braked, axes) | RootReadouts.texts(braked, axes) | Texts.texts(case, axes),
        forms=Motions.forms(braked),
    )


def _lasting(braked: BrakedChain) -> float:
    """The time in s after which the clock starts again: that of the chain, or less if all drawn motions have decayed
    before.
    """
    slow, fast = braked.system.modes().omega.tolist()
    decay = min((-s.real for s in braked.exponents.values()), default=0.0)
    window = time_window(slow, fast)
    return min(window, LASTING / decay) if decay * window > LASTING else window


def _paths(case: RootPlane) -> dict[str, Columns]:
    """The paths of the roots, cut far outside the plane."""
    branches, far = case.branches, FAR * case.highest
    if not np.all(np.isfinite(branches)):
        raise OverflowError
    re, im = np.clip(branches[:-1].real, -far, far), np.clip(branches[:-1].imag, -far, far)
    return {"paths": by_name({C.re[j]: re[:, j] for j in ROOTS} | {C.im[j]: im[:, j] for j in ROOTS})}


def _spiral_columns(braked: BrakedChain) -> dict[str, Columns]:
    """The path of both masses in each drawn motion, until it has decayed."""
    found = {}
    for mode, s in braked.exponents.items():
        ends = [*([LASTING / -s.real] if s.real else []), *([TURNS * 2 * np.pi / s.imag] if s.imag else [])]
        t = np.linspace(0.0, min(ends, default=0.0), POINTS)
        with np.errstate(under="ignore"):
            motion = np.exp(s * t)
        found[f"spiral_{mode}"] = by_name({C.x[i, mode]: (braked.amplitudes[i, mode] * motion).real for i in BOTH})
    return found
