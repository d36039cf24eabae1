r"""N equal masses on N + 1 equal springs, from two masses to the wave (lecture D31, slide 7; D34, slide 5).

    wall --k-- [m] --k-- [m] --k-- .. --k-- [m] --k-- wall        x_p of mass p = 1 .. N, from equilibrium

    m x_p'' = k (x_(p-1) - 2 x_p + x_(p+1)),   x_0 = x_(N+1) = 0 at walls; a free end has no spring

With Omega = sqrt(k/m) mode j swings at omega_j = 2 Omega sin(theta_j/2), and its shape is

    fixed, fixed   theta_j = j pi/(N + 1), j = 1 .. N          sqrt(2/(N + 1)) sin(theta_j p)
    fixed, free    theta_j = (2j - 1) pi/(2N + 1), j = 1 .. N    2/sqrt(2N + 1) sin(theta_j p)
    free, free     theta_j = j pi/N, j = 0 .. N - 1             sqrt((2 - [j = 0])/N) cos(theta_j (p - 1/2))

Shapes are orthonormal: each coordinate q_j = sum_p phi_j(p) x_p swings separately with constant energy. Mode 0
of a free chain is a drift. On the ideal string through the same masses mode j has the frequency Omega theta_j.

Sines of all angles come from one table of 80 digits, with angles counted in whole numbers.

Source: lecture D31 names waves on a string; D34 superposes independent harmonic motions.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property, lru_cache
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from physics.oscillator import phase_of
from physics.precision.exact import NOISE, PI, Array, exact, precise, rounded
from physics.precision.polynomials import context
from physics.sinusoids import ExactSinusoid, added, combined, on_heads
from physics.valid import check_positive, finite_array, is_number, keep_doubles, rows_in_range, shown

ChainEnds = Literal["fixed-fixed", "fixed-free", "free-free"]
_TABLE_DIGITS = 90


class ChainMotion(NamedTuple):
    """The motion of a chain.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times in s.
    x, v : ndarray, shape (N, n)
        Displacements in m and velocities in m/s of each mass.
    """

    t: Array
    x: Array
    v: Array


@dataclass(frozen=True, kw_only=True)
class UniformChain:
    """Equal masses on equal springs.

    Parameters
    ----------
    N : int
        The number of masses, 1 or more.
    m : float
        Each mass in kg, above 0.
    k : float
        Each stiffness in N/m, above 0.
    ends : {"fixed-fixed", "fixed-free", "free-free"}
        The ends of the chain.

    Raises
    ------
    ValueError
        If a value is not possible.
    """

    N: int
    m: float
    k: float
    ends: ChainEnds = "fixed-fixed"

    def __post_init__(self) -> None:
        keep_doubles(self, "m", "k")
        if not (is_number(self.N) and self.N >= 1 and int(self.N) == self.N):
            raise ValueError(f"N = {shown(self.N)}: a whole number of masses, at least 1, is needed")
        if self.ends not in get_args(ChainEnds):
            raise ValueError(f"ends = {self.ends!r}: choose the ends of a chain: {' or '.join(get_args(ChainEnds))}")
        check_positive("a mass in kg", m=self.m)
        check_positive("a stiffness in N/m", k=self.k)

    @cached_property
    def omega(self) -> Array:
        """The natural frequencies in rad/s (N,), slowest first, each rounded once."""
        return np.array([rounded("a natural frequency", omega) for omega in self.exact_omega])

    @cached_property
    def theta(self) -> Array:
        """The phase in rad (N,) from one mass to the next, each rounded once."""
        with precise():
            return np.array([float(2 * PI * n / self._parts) for n in self._numbers])

    @cached_property
    def string_omega(self) -> Array:
        """The natural frequencies in rad/s (N,) of the ideal string, Omega theta_j."""
        with precise():
            exactly = [self.exact_Omega * 2 * PI * n / self._parts for n in self._numbers]
        return np.array([rounded("a natural frequency of the string", omega) for omega in exactly])

    @cached_property
    def shapes(self) -> Array:
        """The orthonormal shapes (N modes, N masses), each number rounded once."""
        table = np.array([float(one) for one in self._scaled_sines])
        shapes = table[self._places]
        if self.ends == "free-free":
            shapes[0] = float(self.rigid)
        return np.asarray(shapes)

    @cached_property
    def exact_Omega(self) -> Decimal:
        """Omega = sqrt(k/m) in rad/s, to 80 digits."""
        with precise():
            return (exact(self.k) / exact(self.m)).sqrt()

    @cached_property
    def exact_omega(self) -> list[Decimal]:
        """The natural frequencies in rad/s, to 80 digits."""
        with precise():
            return [2 * self.exact_Omega * self._sines[n] for n in self._numbers]

    def modes(self, x_0: ArrayLike, v_0: ArrayLike) -> "ChainModes":
        """Return the modes of the motion from given displacements and velocities.

        Parameters
        ----------
        x_0, v_0 : array_like, shape (N,)
            Displacements in m and velocities in m/s at t = 0.

        Returns
        -------
        ChainModes
            The coordinates and their velocities, to 80 digits.

        Raises
        ------
        ValueError
            If a number is not finite, or there are not N of them.
        """
        return ChainModes(self, self._coordinates("x_0", x_0), self._coordinates("v_0", v_0))

    def drawn_modes(self, x_0: Array, v_0: Array) -> "DrawnModes":
        """Return the modes in float64, as a picture needs them.

        A coordinate is within a few u of the largest one.

        Parameters
        ----------
        x_0, v_0 : ndarray, shape (N,)
            Displacements in m and velocities in m/s at t = 0.

        Returns
        -------
        DrawnModes
            Amplitude, phase and energy of each mode, and the drift.

        Raises
        ------
        ArithmeticError
            If they leave the range of doubles, with NumPy set to raise errors.
        """
        q, v = self.shapes @ x_0, self.shapes @ v_0
        energy = self.m * (v**2 + (self.omega * q) ** 2) / 2
        rigid = self.shapes[0, 0] if self.ends == "free-free" else 0.0
        drift = float(q[0] * rigid), float(v[0] * rigid)
        moving = self.omega > 0
        late = np.divide(v, self.omega, out=np.zeros_like(v), where=moving)
        q = np.where(moving, q, 0.0)
        return DrawnModes(self, np.hypot(q, late), np.arctan2(q, late), energy, drift)

    def motion(self, x_0: ArrayLike, v_0: ArrayLike, t: ArrayLike) -> ChainMotion:
        """Return the free motion, within 2 u of the sum of the amplitudes of all modes.

        Parameters
        ----------
        x_0, v_0 : array_like, shape (N,)
            Displacements in m and velocities in m/s at t = 0.
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        ChainMotion
            x and v, each (N, n).

        Raises
        ------
        ValueError
            If a number is not finite, or there are not N of them.
        """
        return self.modes(x_0, v_0).motion(t)

    def pluck(self, p: int, height: float) -> Array:
        """Return the displacements with mass p held at a height: straight lines, level beyond it to a free end.

        Parameters
        ----------
        p : int
            The mass that is held, from 1 to N.
        height : float
            Its displacement in m.

        Returns
        -------
        ndarray, shape (N,)
            Displacements in m.

        Raises
        ------
        ValueError
            If there is no such mass, or both ends are free.
        """
        self.check_mass(p)
        if self.ends == "free-free":
            raise ValueError("a chain whose ends are both free cannot be plucked: at least one fixed end is needed")
        places = np.arange(1.0, self.N + 1)
        level = np.ones_like(places)
        beyond = (self.N + 1 - places) / (self.N + 1 - p) if self.ends == "fixed-fixed" else level
        return height * np.where(places <= p, places / p, beyond)

    def one_mode(self, j: int, size: float) -> Array:
        """Return displacements (N,) in m of mode j alone, counted from 0 as in `omega`; `size` in m is the largest."""
        shape = self.shapes[j]
        return np.asarray(size * shape / np.abs(shape).max())

    def pulse(self, centre: float, width: float, height: float) -> tuple[Array, Array]:
        """Return the initial conditions of a bell that runs to the right without a part that runs back.

        Parameters
        ----------
        centre, width : float
            The place of its centre and its standard deviation, counted in masses.
        height : float
            Its height in m.

        Returns
        -------
        tuple of two ndarrays, each (N,)
            Displacements in m and velocities in m/s.
        """
        Omega = float(self.exact_Omega)

        def bell(place: Array) -> Array:
            return np.asarray(height * np.exp(-(((place - centre) / width) ** 2) / 2))

        p = np.arange(1.0, self.N + 1)
        return bell(p), Omega * (bell(p - 0.5) - bell(p + 0.5))

    def check_mass(self, p: int) -> None:
        """Raise ValueError if there is no mass p: they are counted from 1 to N."""
        if not 1 <= p <= self.N:
            raise ValueError(f"p = {p!r}: a mass from 1 to {self.N} is needed")

    def _coordinates(self, name: str, values: ArrayLike) -> list[Decimal]:
        """q_j of displacements or of velocities."""
        entries = finite_array(name, values)
        if entries.shape != (self.N,):
            raise ValueError(f"{name} has {entries.size} numbers: {self.N} are needed, one for each mass")
        moving = np.flatnonzero(entries)
        if not moving.size:
            return [Decimal(0)] * self.N
        numbers = [exact(value) for value in entries[moving].tolist()]
        with precise():
            rounding = NOISE * max(map(abs, numbers))
            sums = self._exact_shapes[:, moving] @ np.array(numbers, dtype=object)
            return [total if abs(total) > rounding else Decimal(0) for total in sums]

    @property
    def _exact_shapes(self) -> NDArray[np.object_]:
        """The shapes, to 80 digits."""
        shapes = np.array(self._scaled_sines, dtype=object)[self._places]
        if self.ends == "free-free":
            shapes[0] = self.rigid
        return shapes

    @cached_property
    def heads_of_shapes(self) -> tuple[Array, Array]:
        """The shapes without a drift, each number as a head and what is left of it."""
        places = self._places[self.ends == "free-free" :]
        head, rest = on_heads(self._scaled_sines)
        return head[places], rest[places]

    @property
    def _parts(self) -> int:
        """The number of parts of half a turn in which angles are counted: theta_j/2 is a whole number of them."""
        return {"fixed-fixed": 2 * (self.N + 1), "fixed-free": 2 * (2 * self.N + 1), "free-free": 2 * self.N}[self.ends]

    @property
    def _numbers(self) -> Sequence[int]:
        """theta_j/2 of each mode in these parts."""
        if self.ends == "fixed-free":
            return range(1, 2 * self.N, 2)
        return range(1, self.N + 1) if self.ends == "fixed-fixed" else range(self.N)

    @cached_property
    def _places(self) -> NDArray[np.int_]:
        """Indices of the shapes' numbers in the table of sines (N modes, N masses)."""
        theta, p = np.array(self._numbers)[:, None], np.arange(1, self.N + 1)
        angle = theta * (2 * p - 1) + self.N if self.ends == "free-free" else 2 * theta * p
        return np.asarray(angle % (2 * self._parts))

    @cached_property
    def _sines(self) -> list[Decimal]:
        return _table(self._parts)

    @cached_property
    def _scaled_sines(self) -> list[Decimal]:
        """The table of sines times the factor of the shapes."""
        squares = {"fixed-fixed": (2, self.N + 1), "fixed-free": (4, 2 * self.N + 1), "free-free": (2, self.N)}
        above, below = squares[self.ends]
        with precise():
            factor = (Decimal(above) / below).sqrt()
            return [factor * one for one in self._sines]

    @property
    def rigid(self) -> Decimal:
        """The shape of the drift of a free chain, one for all masses."""
        with precise():
            return (Decimal(1) / self.N).sqrt()


@dataclass(frozen=True, eq=False)
class DrawnModes:
    """A motion as the sum of its modes in float64: q_j = amplitude sin(omega_j t + phase), and the energy of each.

    A drift of the whole chain is a + b t.

    Attributes
    ----------
    chain : UniformChain
        The chain that moves.
    amplitude : ndarray, shape (N,)
        The amplitude in m of each coordinate; 0 for a drift.
    phase : ndarray, shape (N,)
        The phase in rad of each coordinate.
    energy : ndarray, shape (N,)
        The energy in J of each mode.
    drift : tuple of two floats
        (a, b) in m and m/s; both are 0 for a chain with a fixed end.
    """

    chain: UniformChain
    amplitude: Array
    phase: Array
    energy: Array
    drift: tuple[float, float]

    def x(self, t: Array) -> Array:
        """The displacements in m (N, n) at the times t (n,) in s, without the drift's b t."""
        coordinates = self.amplitude[:, None] * np.sin(np.outer(self.chain.omega, t) + self.phase[:, None])
        return np.asarray(self.chain.shapes.T @ coordinates + self.drift[0])


@dataclass(frozen=True, eq=False)
class ChainModes:
    """A motion as the sum of its modes: coordinates and their velocities at t = 0, to 80 digits.

    Attributes
    ----------
    chain : UniformChain
        The chain that moves.
    coordinates, velocities : list of N Decimal
        Each q_j in m and its rate of change in m/s at t = 0.
    """

    chain: UniformChain
    coordinates: list[Decimal]
    velocities: list[Decimal]

    @cached_property
    def amplitude(self) -> Array:
        """The amplitude in m of each coordinate (N,): q_j = amplitude sin(omega_j t + phase); 0 of a drift."""
        with precise():
            sizes = [(q**2 + (v / w) ** 2).sqrt() if w else Decimal(0) for q, v, w in self._each()]
        return np.array([rounded("an amplitude", size) for size in sizes])

    @cached_property
    def phase(self) -> Array:
        """The phase in rad of each coordinate (N,); 0 of a drift."""
        with precise():
            return np.array([phase_of(q * w, v) if w else 0.0 for q, v, w in self._each()])

    @cached_property
    def energy(self) -> Array:
        """The energy in J of each mode (N,), which is constant; a drift's is kinetic. Each is rounded once."""
        m = exact(self.chain.m)
        with precise():
            both = [m * (v**2 + (w * q) ** 2) / 2 for q, v, w in self._each()]
        return np.array([rounded("the energy of a mode", one) for one in both])

    @property
    def drift(self) -> tuple[float, float]:
        """The displacement in m at t = 0 and the velocity in m/s of a drift; 0 of a chain with a fixed end."""
        if self.chain.ends != "free-free":
            return 0.0, 0.0
        with precise():
            return float(self.chain.rigid * self.coordinates[0]), float(self.chain.rigid * self.velocities[0])

    def motion(self, t: ArrayLike) -> ChainMotion:
        """Return displacements and velocities of all masses.

        Parameters
        ----------
        t : array_like, shape (n,)
            Times in s.

        Returns
        -------
        ChainMotion
            x and v, each (N, n).

        Raises
        ------
        ValueError
            If a time is not finite, or a result leaves the range of doubles.
        """
        t = finite_array("t", t)
        with precise():
            velocities = [(v, -w * w * q, w) for q, v, w in self._each()]
        return ChainMotion(t, self.x(t), self._combined(t, "velocity", velocities))

    def x(self, t: Array) -> Array:
        """The displacements in m (N, n) at the times t (n,) in s."""
        return self._combined(t, "displacement", self._each())

    def _combined(self, t: Array, what: str, coordinates: list[tuple[Decimal, Decimal, Decimal]]) -> Array:
        """The displacements or velocities (N, n) of all masses, from (q_j, its derivative, omega_j) at t = 0."""
        chain, names = self.chain, [f"the {what} of mass {p + 1}" for p in range(self.chain.N)]
        waves = [ExactSinusoid(w, (q,), (v,)) for q, v, w in coordinates if w]
        found = combined(chain.heads_of_shapes, waves, t, names)
        if chain.ends != "free-free":
            return found
        q, v, w = coordinates[0]
        with precise():
            rigid = ExactSinusoid(w, (chain.rigid * q,), (chain.rigid * v,))
        drift = added([rigid], t, ["the drift of the chain"])
        with np.errstate(over="ignore"):
            return rows_in_range(names, found + drift)

    def _each(self) -> list[tuple[Decimal, Decimal, Decimal]]:
        return list(zip(self.coordinates, self.velocities, self.chain.exact_omega, strict=True))


@lru_cache(64)
def _table(parts: int) -> list[Decimal]:
    """sin(pi n/parts) of a whole turn."""
    ctx = context(_TABLE_DIGITS)
    quarter = [Decimal(ctx.nstr(ctx.sinpi(ctx.mpf(n) / parts), _TABLE_DIGITS)) for n in range(parts // 2 + 1)]
    half = [*quarter, *quarter[(parts - 1) // 2 : 0 : -1]]
    return [*half, *(-one for one in half)]
