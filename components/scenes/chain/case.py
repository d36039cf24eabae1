"""The case of a chain of N equal masses: its start, its motion as a sum of modes, and everything that is shown."""

from __future__ import annotations

import math
from functools import cached_property, lru_cache
from typing import Literal

import numpy as np

from components.language.picture import Onward, Pace
from components.paper.deferred import Attributes
from components.quantities.formatting import three
from components.quantities.motion import ModalPlay, pace
from components.scene import Picture
from components.scene.about import About, CheckedPoint, Table, bounded, drift, few, few_of, points
from components.scene.case import Case
from components.scene.traces import Columns, Floats
from physics.chain import ChainEnds, ChainModes, DrawnModes, UniformChain
from physics.motion import Elementary, ExactMotion, Harmonic, constant, harmonic_motion
from physics.precision.exact import rounded
from physics.reference.uniform_chain import chain_frequencies, chain_points
from physics.valid import in_range

PARTS: dict[str, float] = {"fixed-fixed": 1.0, "fixed-free": 0.5, "free-free": 0.0}
"""Number of spacings of a chain minus the number of its masses, by the kind of its ends."""
TRAVERSES, FEW_TRAVERSES, FEW = 3.0, 12.0, 4
"""Length of the time window, in times that a wave takes from end to end; the second value is for fewer than FEW
masses."""
LOOKS = 160
"""Number of instants at which the extremes of a motion are searched."""
SHRINKS = 0.8
"""Largest share by which a spring is drawn shorter."""
MOST_TURNS = 40
"""Largest number of reflections of the string's crest that are drawn."""
TAKES_PART = 0.002
"""Least share of the energy of a mode that takes part in the motion."""
SEEN = 0.01
"""Least visible displacement, as a share of the largest one."""
LEAST_GRIP = 0.2
"""Least displacement, as a share of h, of a mass that the visitor can drag."""
SMALLER = "Displacements are drawn {share} times as large, so that no masses meet."
DRIFTS = "The chain drifts at {rate} m/s, which is mode 1. It is drawn about its centre of mass."
KNOWN = {
    (1.0, "fixed-fixed"): "One mass between two springs is Oscillator with the stiffness 2k.",
    (1.0, "fixed-free"): "One mass on one spring is Oscillator.",
    (2.0, "fixed-free"): "Two masses and a free end are Coupled with equal masses and springs.",
}
"""The scenes that have the same system, by N and the ends."""


@lru_cache(64)
def chain_of(N: int, m: float, k: float, ends: ChainEnds) -> UniformChain:
    return UniformChain(N=N, m=m, k=k, ends=ends)


class MassesCase(Case):
    """A free motion of N equal masses on equal springs."""

    N: float
    m: float
    k: float
    a: float
    keep: str
    ends: ChainEnds
    starts: str
    j: float
    p: float
    h: float
    v_0: float
    centre: float
    width: float
    way: str
    view: str

    @cached_property
    def chain(self) -> UniformChain:
        return chain_of(int(self.N), self.m, self.k, self.ends)

    @property
    def parts(self) -> float:
        """The length of the chain in spacings."""
        return self.N + PARTS[self.ends]

    @cached_property
    def length(self) -> float:
        return within("the length of the chain", self.parts * self.a)

    @cached_property
    def Omega(self) -> float:
        """sqrt(k/m) in rad/s, which is also the number of masses that a long wave passes per second."""
        return rounded("the frequency of a mass on one spring", self.chain.exact_Omega)

    @property
    def left(self) -> float:
        """The position of the left end, in spacings, where mass p is at p."""
        return 0.5 if self.ends == "free-free" else 0.0

    @property
    def lasting(self) -> float:
        count = TRAVERSES if self.N >= FEW else FEW_TRAVERSES
        return within("the time window", count * self.parts / self.Omega)

    @property
    def highest(self) -> float:
        return float(self.chain.omega[-1])

    @property
    def pace(self) -> Pace:
        slow = next((omega for omega in self.chain.omega.tolist() if omega), 0.0)
        return pace(slow, slow)

    @property
    def spans(self) -> dict[str, tuple[float, float]]:
        last = max(self.N, 2.0)
        return {"j": (1.0, last), "p": (1.0, last), "centre": (0.0, self.length)}

    def notes(self) -> tuple[str, ...]:
        known = KNOWN.get((self.N, self.ends))
        notes = [known] if known else []
        rate = self.drawn.drift[1]
        if abs(rate) * self.end > SEEN * self.reach:
            notes.append(DRIFTS.format(rate=three(rate)))
        return tuple(notes)

    def to_scale(self) -> str:
        return SMALLER.format(share=three(self.scale)) if self.scale and self.scale < 1 else ""

    def onward(self) -> tuple[Onward, ...]:
        x, v = (one.tolist() for one in self.started)
        given: dict[str, float | str]
        if self.N == 1 and self.ends != "free-free":
            springs = 2 * PARTS[self.ends]
            given = {"m": self.m, "k": springs * self.k, "x_0": x[0], "v_0": v[0]}
            return (Onward(label="Open in Oscillator", scene="oscillator", given=given),)
        if self.N == 2 and self.ends == "fixed-free":
            both = ((f"{name}{i}", getattr(self, name)) for name in "mk" for i in (1, 2))
            given = {**dict(both), "x1_0": x[0], "x2_0": x[1], "v1_0": v[0], "v2_0": v[1]}
            return (Onward(label="Open in Coupled", scene="coupled", given=given),)
        return ()

    def about(self, shown: Picture) -> About:
        columns, masses = shown.sources["time"], sorted({1, self.held, int(self.N)})
        true = chain_points(self.chain, *self.started, few_of(columns["t"]), masses)
        names = {f"x{p}": f"$x_{{{p}}}$" for p in masses}
        rows = points(names, columns, {f"x{p}": found for p, found in true.items()})
        ends = sorted({1, int(self.N)})
        modes = [
            CheckedPoint(rf"$\omega_{{{j}}}$", f"Mode {j}", float(self.chain.omega[j - 1]), omega)
            for j, omega in zip(ends, chain_frequencies(self.chain, ends), strict=True)
        ]
        once = Table(
            "Each frequency is rounded once: its error is at most 0.51 ulp of its own value.", 0.51, tuple(modes)
        )
        return About(
            (bounded("a displacement", 2, "the amplitudes of its modes together", rows), once), self._balance()
        )

    def _balance(self) -> str:
        """Return the sentence on how far T + V differs over the window from the sum of the modes' energies."""
        _, x, v = self.modes.motion(self.times[few(self.times)])
        energy = self.m * (v**2).sum(axis=0) + self.k * (self.stretches(x) ** 2).sum(axis=0)
        return drift(energy / 2, float(self.modes.energy.sum()))

    def stretches(self, x: Floats) -> Floats:
        """The stretch of each spring, from the displacements (N, n)."""
        wall = np.zeros((1, x.shape[1]))
        at_left, at_right = self.left == 0, self.ends == "fixed-fixed"
        return np.diff(np.vstack([*[wall] * at_left, x, *[wall] * at_right]), axis=0)

    @cached_property
    def unit_start(self) -> tuple[Floats, Floats]:
        """The displacements and velocities at t = 0 if h is 1 m and v_0 is 0."""
        rest = np.zeros(int(self.N))
        if self.starts == "pulse":
            return self.chain.pulse(self.centre / self.a + self.left, self.width / self.a, 1.0)
        if self.starts == "mode":
            return self.chain.one_mode(int(self.j) - 1, 1.0), rest
        if self.starts == "mass":
            return np.where(np.arange(1, int(self.N) + 1) == self.p, 1.0, 0.0), rest
        held = chain_of(int(self.N), self.m, self.k, "fixed-fixed") if self.ends == "free-free" else self.chain
        return held.pluck(int(self.p), 1.0), rest

    @property
    def by_mass(self) -> bool:
        """True if the motion starts from one mass, chosen by the visitor."""
        return self.starts in ("pluck", "mass")

    @cached_property
    def started(self) -> tuple[Floats, Floats]:
        """The displacements in m and velocities in m/s at t = 0."""
        x, v = (self.h * one for one in self.unit_start)
        if self.by_mass:
            v[int(self.p) - 1] += self.v_0
        return x, v

    @cached_property
    def drawn(self) -> DrawnModes:
        return self.chain.drawn_modes(*self.started)

    @cached_property
    def modes(self) -> ChainModes:
        """The modes to 80 digits, for files."""
        return self.chain.modes(*self.started)

    @cached_property
    def held(self) -> int:
        """The number of the mass that the visitor drags."""
        if self.by_mass:
            return int(self.p)
        return int(np.argmax(np.abs(self.unit_start[0]))) + 1

    @property
    def grip(self) -> float:
        """The initial displacement of the mass that the visitor drags, divided by h."""
        return float(self.unit_start[0][self.held - 1])

    @property
    def can_be_held(self) -> bool:
        return abs(self.grip) >= LEAST_GRIP

    @cached_property
    def in_hand(self) -> ExactMotion:
        """The displacement of the mass that the visitor drags, from the same signal as all other masses."""

        def exact(t: Floats) -> Floats:
            return np.asarray(self.modes.x(t)[self.held - 1])

        is_linear = not (self.by_mass and self.v_0)
        play = ModalPlay(self.drawn, "x", at="mass", of="h", by=self.h if is_linear else 0.0)
        return Elementary(symbol="x", exact=exact, played=play, size=lambda: self.reach, omega=self.highest)

    @cached_property
    def drifting(self) -> ExactMotion:
        """The displacement of all masses by the drift of a chain that nothing holds."""
        rate = self.drawn.drift[1]
        return harmonic_motion("drift", Harmonic((), (0.0, rate)), lambda t: rate * t)

    @cached_property
    def looked_at(self) -> Floats:
        """The displacements (N, n) at a few instants, to find their extremes."""
        return self.drawn.x(np.linspace(0.0, self.own_end, LOOKS))

    @cached_property
    def reach(self) -> float:
        """The largest displacement in m."""
        return float(np.abs(self.looked_at).max()) or abs(self.h) or 1.0

    @cached_property
    def fits(self) -> float | None:
        """The scale of drawn displacements along the chain, so that no masses meet; None for transverse motion."""
        if self.way == "across":
            return None
        shrunk = -float(self.stretches(self.looked_at).min(initial=0.0))
        return min(1.0, SHRINKS * self.a / shrunk) if shrunk else 1.0

    @cached_property
    def shares(self) -> Floats:
        """The share of each mode in the energy (N,)."""
        total = float(self.drawn.energy.sum())
        return self.drawn.energy / total if total else np.zeros(int(self.N))

    @property
    def late(self) -> float:
        """The lag in percent of the fastest mode behind the string's mode of the same number."""
        string = float(self.chain.string_omega[-1])
        return 100 * (1 - self.highest / string) if string else 0.0

    def ray(self, way: Literal[-1, 1]) -> Columns | None:
        """Return the path of the crest that starts to one side on the ideal string, with reflections; None if there is
        none."""
        if self.starts == "mode" or (self.starts == "pulse" and way < 0):
            return None
        place = self.p if self.by_mass else self.centre / self.a + self.left
        first, last = self.left, self.left + self.parts
        to_end = (last - place if way > 0 else place - first) / self.Omega
        across = self.parts / self.Omega
        turns = math.ceil(max(self.end - to_end, 0.0) / across)
        if turns > MOST_TURNS:
            return None
        times = np.array([0.0, *(to_end + n * across for n in range(turns + 1))])
        ends = [(last, first), (first, last)][way < 0]
        places = np.array([place, *(ends[n % 2] for n in range(turns + 1))])
        name = "crest" if way > 0 else "other"
        return {f"{name}_x": places, f"{name}_t": times}

    def lap(self, n: int) -> float | None:
        """The time at which a wave has run n times from end to end, if it is in the window and the crest is drawn."""
        time = n * self.parts / self.Omega
        return time if time <= self.end and self.ray(1) else None

    def spectrum(self, taking: bool) -> Columns:
        """The modes that take part in the motion, or the others."""
        name = "taking" if taking else "silent"
        chosen = (self.shares > TAKES_PART) == taking
        return {f"{name}_j": np.flatnonzero(chosen) + 1.0, f"{name}_omega": self.chain.omega[chosen]}

    @property
    def law(self) -> Columns:
        """The frequencies of the chain and of the ideal string between the modes, up to the last one."""
        j = np.linspace(0.0, self.N, 61)
        theta = self.angles(j)
        return {"law_j": j, "law": 2 * self.Omega * np.sin(theta / 2), "string": self.Omega * theta}

    def angles(self, j: Floats) -> Floats:
        """The phase advance per mass theta_j in rad, also for j between the modes."""
        return np.maximum(j - (1 - PARTS[self.ends]), 0.0) * math.pi / self.parts

    @property
    def bars(self) -> Columns:
        """The outline of a bar for the energy of each mode."""
        half = 0.36
        j = np.arange(1.0, self.N + 1)
        across = np.column_stack([j - half, j - half, j + half, j + half]).ravel()
        up = np.column_stack([0 * j, self.drawn.energy, self.drawn.energy, 0 * j]).ravel()
        return {"bar_j": across, "zero": np.zeros_like(up), "bar": up}


def within(name: str, value: float) -> float:
    """Return a number. ValueError if it leaves the range of doubles."""
    return float(in_range(name, np.array([value]))[0])


value = Attributes(MassesCase)


class MassesShown(MassesCase):
    """Everything that the paper shows."""

    mass = value(lambda c: constant(float(c.held)))
    x = value(lambda c: c.in_hand)
    drift = value(lambda c: c.drifting)
    h_now = value.optional(lambda c: (c.in_hand - c.drifting) / c.grip if c.can_be_held else None)
    name = value(lambda c: str(c.held))
    is_across = value(lambda c: float(c.way == "across"))
    picks = value(lambda c: float(c.by_mass))
    first = value(lambda c: 1.0 - c.left)
    per_part = value(lambda c: 1 / c.parts)
    per_length = value(lambda c: 1 / c.length)
    right_wall = value(lambda c: float(c.ends == "fixed-fixed"))
    left_wall = value(lambda c: float(c.ends != "free-free"))
    least = value(lambda c: SEEN * c.reach)
    full = value(lambda c: abs(c.h) or c.reach)
    graspable = value(lambda c: float(c.can_be_held and c.starts != "pulse"))
    crest = value.optional(lambda c: c.ray(1))
    other = value.optional(lambda c: c.ray(-1))
    lap_1 = value.optional(lambda c: c.lap(1))
    lap_2 = value.optional(lambda c: c.lap(2))
    lap_3 = value.optional(lambda c: c.lap(3))
    taking = value(lambda c: c.spectrum(True))
    silent = value(lambda c: c.spectrum(False))
    chosen = value(lambda c: str(int(c.j)) if c.starts == "mode" else "")
    # Numbers in formulas.
    slowest = value(lambda c: float(c.chain.omega[0]), "rad/s", "frequency of the slowest mode")
    fastest = value(lambda c: c.highest, "rad/s", "frequency of the fastest mode")
    string_slowest = value(lambda c: float(c.chain.string_omega[0]), "rad/s", "slowest frequency of the string")
    string_fastest = value(lambda c: float(c.chain.string_omega[-1]), "rad/s", "the string's frequency of that number")
    ceiling = value(lambda c: 2 * c.Omega, "rad/s", "frequency that no mode reaches")
    lag = value(lambda c: c.late)
    per_mode = value(lambda c: math.pi / c.parts)
    wave_speed = value(lambda c: within("the speed of a wave", c.a * c.Omega), "m/s", "speed of long waves")
    L = value(lambda c: c.length, "m", "length of the chain")
    E = value(lambda c: float(c.drawn.energy.sum()), "J", "total energy")
    traverse = value(lambda c: c.parts / c.Omega, "s", "time of a wave from end to end")
    N_text = value(lambda c: str(int(c.N)))
