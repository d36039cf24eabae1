"""The numbers of the view Guess: curves, forces, and what the matrix says at the trial frequency."""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property

import numpy as np
from msgspec.structs import replace

from components.chain import MODES
from components.language.signals import AnySignal
from components.language.state import Frame
from components.quantities.axes import Axis, nice_axis, squared_axis, time_axis
from components.quantities.declared import Declared, LiveNumber
from components.quantities.motion import pace, sines
from components.quantities.numbers import signed, ten, three
from components.scene import Picture
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns
from physics.coupled import Modes, TwoMassChain
from physics.exact import exact, precise, within_an_ulp
from physics.modes import Trial, TrialForces, determinant_curve, row_curves, trial, trial_forces
from physics.sampling import NOTHING_OSCILLATES, periods
from physics.valid import DOUBLES

REACH = 0.17
"""The longest force arrow, as a fraction of the stage's width."""
NEAR, ALIKE = 1e-3, Decimal("0.01")
"""Limits: of a frequency near a natural one, and of the gap of rows, over the larger, that are nearly one equation."""
ROUNDING = Decimal("1e-12")
"""A typed ratio is rounded, so at a mode a force of this size, compared with the others, is left: it is shown as 0."""
LITTLE = Decimal("0.005")
"""The share of the other forces below which a hand's is little."""


@dataclass(frozen=True, eq=False)
class Guess:
    """A chain, a trial frequency and shape, and the axes that they are drawn on, with what the physics says of them.

    `det` counts D in units of 10**exponent, since D leaves the range of doubles long before the rest does.
    """

    system: TwoMassChain
    omega: float
    ratio: float
    frequency: Axis
    shape: Axis
    det: Axis
    exponent: int

    def place_D(self, value: Decimal) -> float:
        """A value of D on its axis, cut far outside the frame."""
        scaled = float(value.scaleb(-self.exponent))
        return self.det.place(scaled if abs(scaled) < 1e30 else 1e30)

    @cached_property
    def asked(self) -> Trial:
        return said(self.system, self.omega)

    @cached_property
    def push(self) -> TrialForces:
        return trial_forces(self.system, self.omega, self.ratio)

    @cached_property
    def at_rest(self) -> Decimal:
        """D at omega = 0."""
        _, _, k1, k2 = self.system.exact_parameters
        with precise():
            return k1 * k2

    @property
    def w_in(self) -> float:
        return inside(self.frequency, self.omega)

    @property
    def sizes(self) -> list[Decimal]:
        """The larger of the force that is needed and that of the springs, on each mass."""
        return [max(abs(one), abs(two)) for one, two in zip(self.push.needed, self.push.springs, strict=True)]

    @cached_property
    def left(self) -> list[Decimal]:
        """The force missing on each mass; nothing at a mode, whose frequency and shape few doubles are."""
        for mode in self.system.exact_modes:
            if not mode.shape[0]:
                continue
            with precise():
                ratio = mode.shape[1] / mode.shape[0]
            alike = abs(ratio - exact(self.ratio)) <= ROUNDING * abs(ratio)
            if alike and within_an_ulp(self.omega, mode.omega):
                return [Decimal(0)] * 2
        sizes = zip(self.push.missing, self.sizes, strict=True)
        return [value if abs(value) > ROUNDING * size else Decimal(0) for value, size in sizes]


def added(guess: Guess) -> str:
    """The force of the hand, in words."""
    if not any(guess.left):
        return "no extra force: a mode"
    little = all(abs(value) <= LITTLE * size for value, size in zip(guess.left, guess.sizes, strict=True))
    return "almost no extra force" if little else "force of your hand"


number = LiveNumber[Guess]


class GuessNumbers(Declared[Guess]):
    a11, a12 = number.both(lambda g: g.asked.matrix[0])
    a22 = number(lambda g: g.asked.matrix[1][1])
    D = number(lambda g: g.asked.determinant)
    square = number(lambda g: Decimal(g.omega) ** 2)
    apart = number(lambda g: g.asked.apart)
    distance = number(lambda g: None if g.asked.apart is None else abs(g.asked.apart))
    k1k2 = number(lambda g: g.at_rest)
    k2k2 = number(lambda g: -(Decimal(g.system.k2) ** 2))
    row = row1, row2 = number.both(lambda g: g.asked.rows, signed)
    omega = omega_slow, omega_fast = number.both(lambda g: g.system.modes().omega)
    r = r_slow, r_fast = number.both(lambda g: g.system.modes().ratio, signed)
    slow_long, fast_long = number.both(
        lambda g: [f"{w:.5g}" if 0.1 <= w < 1e4 else three(w) for w in g.system.modes().omega]
    )
    X = X1, X2 = number.both(lambda g: g.push.amplitude, signed)
    need = need1_N, need2_N = number.both(lambda g: g.push.needed, signed, unit="N", whole=True)
    give = give1_N, give2_N = number.both(lambda g: g.push.springs, signed, unit="N", whole=True)
    add = add1_N, add2_N = number.both(lambda g: g.left, signed, unit="N", whole=True)
    you_add = number(added)


def inside(axis: Axis, value: float | Decimal) -> float:
    """1 where a value is within the range of an axis, else 0."""
    return float(axis.start <= value <= axis.end)


def picture(system: TwoMassChain, omega: float, ratio: float, window: float | None, frame: Frame = FITTED) -> Picture:
    """All of the view for one chain and one guess; ValueError where a curve leaves the range of doubles."""
    modes = system.modes()
    if system.k2 and not np.all(np.isfinite(modes.ratio)):
        raise ValueError(f"a mode ratio X2/X1 leaves {DOUBLES}")
    end = _end(float(modes.omega[1]), omega)
    reach, shape = _shape_axis(modes)
    across = replace(squared_axis(end, "(rad/s)²", 3), drawn=(0.0, max(float(modes.omega[1]), min(omega, end))))
    own = {"w": across, "r": shape}
    time = time_axis(window or (periods(omega, 4) if omega else NOTHING_OSCILLATES))
    axes = framed(frame, own | {"t": time})
    columns, det, exponent = _columns(system, axes["w"].end, reach)
    axes |= framed(frame, {"D": det})
    guess = Guess(system, omega, ratio, frequency=axes["w"], shape=axes["r"], det=axes["D"], exponent=exponent)
    return Picture(
        columns=columns,
        axes=axes,
        signals=_signals(guess.push, omega, axes["t"]),
        scalars=_swing_scalars(guess.push) | _force_scalars(guess.push) | _known(guess) | _tried(guess),
        pace=pace(omega, omega),
        values=GuessNumbers.texts(guess, axes),
        forms=_forms(guess),
    )


def _shape_axis(modes: Modes) -> tuple[float, Axis]:
    """The reach of the curves of X2/X1, and their axis, which holds both modes."""
    half = 2 * max((abs(float(r)) for r in modes.ratio if r and math.isfinite(r)), default=2.0)
    reach = 3 * half
    if math.isinf(reach):
        raise ValueError(f"three times the larger mode ratio X2/X1, as far as it is drawn, leaves {DOUBLES}")
    axis = nice_axis(-half, half, "", 4, exact=True)
    return reach, replace(axis, ticks=axis.ticks[1:-1], drawn=(-half / 2, half / 2))


def said(system: TwoMassChain, omega: float) -> Trial:
    """The two equations at `omega`; next to a zero, where hardly a double is nearer, at the zero itself."""
    asked, none = trial(system, omega), Decimal(0)
    for mode in system.exact_modes:
        if not within_an_ulp(omega, mode.omega):
            continue
        if not system.k2:
            if mode.shape[0]:  # mass 1 alone: row 1 is 0 = 0
                asked = asked._replace(matrix=((none, none), asked.matrix[1]), rows=(None, asked.rows[1]))
            return asked._replace(determinant=none)
        with precise():
            rows = (mode.shape[1] / mode.shape[0],) * 2
        return asked._replace(determinant=none, rows=rows, apart=none)
    m1, m2, k1, k2 = system.exact_parameters
    with precise():
        alone = ((k1 + k2) / m1).sqrt(), (k2 / m2).sqrt()
    (a11, a12), (_, a22), (one, two) = *asked.matrix, asked.rows
    if k2 and within_an_ulp(omega, alone[0]):
        a11, one = none, none
    if k2 and within_an_ulp(omega, alone[1]):
        a22, two = none, Decimal("inf")
    return asked._replace(matrix=((a11, a12), (a12, a22)), rows=(one, two), apart=asked.apart if a22 else None)


def _end(fast: float, omega: float) -> float:
    """The frame holds both modes, and the trial frequency where it is not far beyond them."""
    both = math.sqrt(1.375) * fast
    return (max(both, 1.1 * omega) if omega < 2 * fast or not fast else both) or 1.0


def _signals(push: TrialForces, omega: float, time: Axis) -> dict[str, AnySignal]:
    """The guess as a motion, from full swing; at omega = 0 it stays there."""
    metres = Axis(-1.0, 1.0, "m")
    sizes = {"swing": 1.0, "x1": float(push.amplitude[0]), "x2": float(push.amplitude[1])}
    return {name: sines(metres, time, (size, omega, math.pi / 2)) for name, size in sizes.items()}


def _columns(system: TwoMassChain, end: float, largest: float) -> tuple[dict[str, Columns], Axis, int]:
    first, second = row_curves(system, end, largest)
    columns: dict[str, Columns] = {"row1": {"w": first.omega[0], "row1": first.ratio[0]}}
    for name, w, r in zip(("row2_below", "row2_above"), second.omega, second.ratio, strict=False):
        columns[name] = {"w": w, name: r}
    w = end * np.sqrt(np.linspace(0.0, 1.0, 201))
    curve, exponent = determinant_curve(system, w)
    columns["det"] = {"w": w, "D": curve}
    low, at_zero = float(np.min(curve)), float(curve[0])
    unit = f"{ten(exponent)} N²/m²" if exponent else "N²/m²"
    size = max(1.2 * at_zero, -2.1 * low, 0.0) or 1.0
    det = nice_axis(min(1.33 * low, -0.1 * size), size, unit, 2, exact=True)
    return columns, replace(det, drawn=(low, at_zero)), exponent


def _swing_scalars(push: TrialForces) -> dict[str, float]:
    """Both amplitudes, and which of them is not the larger one."""
    X1, X2 = (float(amplitude) for amplitude in push.amplitude)
    return {"X1": X1, "X2": X2, "less1": float(abs(X1) <= abs(X2)), "less2": float(abs(X2) <= abs(X1))}


def _force_scalars(push: TrialForces) -> dict[str, float]:
    """Lengths of the arrows at full swing, as fractions of the width, each under the name of its number."""
    size = max((abs(value) for pair in push[1:] for value in pair), default=Decimal(0))
    scalars: dict[str, float] = {}
    for i in (1, 2):
        need, give = (REACH * float(pair[i - 1] / size) if size else 0.0 for pair in (push.needed, push.springs))
        scalars |= {f"need{i}_N": need, f"give{i}_N": give, f"add{i}_N": 1.0}
    return scalars


def _known(guess: Guess) -> dict[str, float]:
    """Where the modes and the two known values of D stand, in the units of the axes, and which are inside the frame."""
    system, modes, shape = guess.system, guess.system.modes(), guess.shape
    least = -(Decimal(system.k2) ** 2)
    scalars = {
        "zero": 0.0,
        "w0": 0.0,
        "D0": guess.place_D(guess.at_rest),
        "D0_in": float(system.k1 > 0 < system.k2),
        "w_held": guess.frequency.place(math.sqrt(system.k2) / math.sqrt(system.m2)),
        "D_held": guess.place_D(least),
        "held_in": float(system.k2 > 0) * inside(guess.det, least.scaleb(-guess.exponent)),
    }
    for mode, w, r in zip(MODES, modes.omega, modes.ratio, strict=True):
        r_in = float(math.isfinite(r)) and inside(shape, float(r))
        scalars |= {f"w_{mode}": guess.frequency.place(float(w)), f"w_{mode}_si": float(w)}
        scalars |= {f"{mode}_in": r_in, f"r_{mode}": shape.place(float(r)) if r_in else 0.0}
    return scalars


def _tried(guess: Guess) -> dict[str, float]:
    """The places of the trial point, of the shapes that the rows ask for, and of D."""
    frequency, shape, D = guess.frequency, guess.shape, guess.asked.determinant
    w = frequency.place(min(guess.omega, 2 * frequency.end))
    r = shape.place(max(min(guess.ratio, 2 * shape.end), 2 * shape.start))
    scalars = {"w": w, "w_in": guess.w_in, "r": r, "guess_in": guess.w_in * inside(shape, guess.ratio)}
    scalars |= {"D": guess.place_D(D), "D_in": guess.w_in * inside(guess.det, D.scaleb(-guess.exponent))}
    ends = []
    for i, row in enumerate(guess.asked.rows, start=1):
        place = 0.0 if row is None else shape.place(float(max(min(row, Decimal(shape.end)), Decimal(shape.start))))
        ends.append(place)
        scalars |= {f"row{i}": place, f"row{i}_in": guess.w_in * (row is not None and inside(shape, row))}
    scalars |= {"gap": guess.w_in * (None not in guess.asked.rows), "gap_low": ends[0], "gap_high": ends[1]}
    return scalars


def _forms(guess: Guess) -> dict[str, str]:
    system, asked = guess.system, guess.asked
    forms: dict[str, str] = {}
    for i, value in enumerate(asked.rows, start=1):
        forms[f"row{i}_says"] = "any" if value is None else "number" if value.is_finite() else "pole"
    forms["agree"] = agreement(guess)
    forms["D"] = "value" if asked.apart is None else "product"
    forms["roots"] = "loose" if not system.k2 else "two" if system.k1 else "wall"
    return forms


def agreement(guess: Guess) -> str:
    """Which sentence on both rows holds: how far apart they are, that they are one equation, or what obeys both."""
    one, two = guess.asked.rows
    if not guess.system.k2:
        free = {(True, True): "every", (True, False): "alone_1", (False, True): "alone_2"}
        return free.get((one is None, two is None), "pole")
    for mode, exactly in zip(MODES, guess.system.exact_modes, strict=True):
        if within_an_ulp(guess.omega, exactly.omega):
            return f"same_{mode}"
    if guess.asked.apart is None or one is None or two is None:
        return "pole"
    for mode, w in zip(MODES, guess.system.modes().omega, strict=True):
        if abs(guess.omega - w) <= NEAR * w and abs(guess.asked.apart) <= ALIKE * max(abs(one), abs(two)):
            return f"near_{mode}"
    return "apart"
