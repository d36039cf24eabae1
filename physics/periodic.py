r"""Periodic and impulsive pushes of one damped mass, m x'' + c x' + k x = F(t), of the period T = 2 pi/omega.

    square     +F in the first half of a period, -F in the second
    triangle   like the sine: 0 at t = 0, F at T/4, -F at 3T/4
    pulses     F for 0 < t < w T, else 0
    impulses   of F in N s at 0, T, 2T, ..
    step       F from t = 0 on
    impulse    of F in N s at t = 0

Their motions are in physics.pushed.

Source: beyond lecture D31; J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), sections 2.1 and 3.1.
"""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from physics.precision.exact import FINE, PI, Array, exact, precise, remainders
from physics.precision.turns import cospi, sinpi
from physics.valid import check_finite, check_positive, is_number, keep_doubles, shown

_PERIODS, _BITS = 64, 250  # bits of the number of periods until a time, and of a time in a piece

PushKind = Literal["square", "triangle", "pulses", "impulses", "step", "impulse"]


class Piece(NamedTuple):
    """A part of a period, from one share of it to another: the force in N at its start, and its rise in N a period.

    Attributes
    ----------
    begin, end : Fraction
        The shares of a period at which it begins and ends, from 0 to 1.
    force : Fraction
        The force at its start in N, without impulses.
    rise : Fraction
        The rise of the force in N per period.
    """

    begin: Fraction
    end: Fraction
    force: Fraction
    rise: Fraction = Fraction(0)


@dataclass(frozen=True, kw_only=True)
class PeriodicPush:
    """A push on a mass that repeats, or a step or an impulse.

    Parameters
    ----------
    kind : {"square", "triangle", "pulses", "impulses", "step", "impulse"}
        The shape of the push.
    size : float
        The largest force in N; of impulses the momentum in N s.
    omega : float
        The angular frequency of the repetition in rad/s, above 0. It does not matter for a step or one impulse.
    width : float
        The share of a period that a pulse takes, between 0 and 1. It matters only for pulses.

    Raises
    ------
    ValueError
        If a number or a kind is not possible.
    """

    kind: PushKind
    size: float = 1.0
    omega: float = 1.0
    width: float = 0.5

    def __post_init__(self) -> None:
        keep_doubles(self, "size", "omega", "width")
        if self.kind not in get_args(PushKind):
            raise ValueError(f"kind = {self.kind!r}: a push is allowed to be {' or '.join(get_args(PushKind))}")
        check_finite("the size of a push", size=self.size)
        check_positive("a drive frequency in rad/s", omega=self.omega)
        if not (is_number(self.width) and 0 < self.width < 1):
            raise ValueError(f"width = {shown(self.width)}: choose a number between 0 and 1, the share of a period")

    @property
    def once(self) -> bool:
        """True if it does not repeat."""
        return self.kind in ("step", "impulse")

    @property
    def impulsive(self) -> bool:
        """True if it changes the velocity at once."""
        return self.kind in ("impulses", "impulse")

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The pieces of a period; cut in the middle if they alternate."""
        F, none = Fraction(self.size), Fraction(0)
        match self.kind:
            case "square":
                ends, forces, rises = [Fraction(1, 2)], [F, -F], [none] * 2
            case "triangle":
                ends, forces = [Fraction(i, 4) for i in (1, 2, 3)], [none, F, none, -F]
                rises = [4 * F, -4 * F, -4 * F, 4 * F]
            case "pulses":
                ends, forces, rises = [Fraction(self.width)], [F, none], [none] * 2
            case _:
                ends, forces, rises = [], [none if self.impulsive else F], [none]
        return tuple(map(Piece, [none, *ends], [*ends, Fraction(1)], forces, rises))

    @property
    def alternates(self) -> bool:
        """True if the second half of a period is the first, turned over."""
        return self.kind in ("square", "triangle")

    @property
    def mean(self) -> float:
        """The mean force in N."""
        if self.kind == "pulses":
            return self.size * self.width
        return self.size * self.omega / (2 * math.pi) if self.kind == "impulses" else 0.0

    def has_line(self, n: int) -> bool:
        """Return True if the line n > 0 is part of the push.

        Parameters
        ----------
        n : int
            The number of the line, above 0.

        Returns
        -------
        bool
            False if f_n is 0.
        """
        if self.kind == "pulses":
            return bool((Fraction(self.width) * n) % 1)
        return self.kind == "impulses" or n % 2 == 1

    def line(self, n: int) -> complex:
        """Return f_n in N of F(t) = sum of Re(f_n exp(i n omega t)), within 4 u.

        Parameters
        ----------
        n : int
            The number of the line, 0 or more; 0 is the mean.

        Returns
        -------
        complex
            f_n in N, 0 for a line that is not part of the push.

        Raises
        ------
        ValueError
            If the push does not repeat.
        """
        if self.once:
            raise ValueError(f"kind = {self.kind!r}: a push that repeats is needed")
        if not n:
            return complex(self.mean)
        if not self.has_line(n):
            return 0j
        over, quarter = n * math.pi, (1.0, -1.0)[n // 2 % 2]
        match self.kind:
            case "square":
                return complex(0.0, -4 * self.size / over)
            case "triangle":
                return complex(0.0, -8 * self.size * quarter / over**2)
            case "pulses":
                turn = Fraction(self.width) * n
                size = 2 * self.size * sinpi(turn) / over
                return complex(size * cospi(turn), -size * sinpi(turn))
        return complex(self.size * self.omega / math.pi)

    def sizes(self, n: Array) -> Array:
        """Return |f_n| (n,) in N for n above 0, in doubles: a missing line may be a rounding error.

        Parameters
        ----------
        n : ndarray, shape (n,)
            The numbers of the lines, above 0.

        Returns
        -------
        ndarray (n,)
            The amplitudes of the lines in N.
        """
        over, size = np.pi * n, abs(self.size)
        match self.kind:
            case "square":
                return np.asarray(4 * size * (n % 2) / over)
            case "triangle":
                return np.asarray(8 * size * (n % 2) / over**2)
            case "pulses":
                return np.asarray(2 * size * np.abs(np.sin(np.pi * np.mod(self.width * n, 1.0))) / over)
        return np.full_like(over, size * self.omega / math.pi)


class TimesInPieces(NamedTuple):
    """Times by the period and the piece of a push in which they are.

    Attributes
    ----------
    period : list of int
        The number of the period of each time.
    piece : ndarray of int (n,)
        The piece of the period.
    tau, rest : ndarray (n,)
        The time in s since the piece began, as the sum of two doubles.
    """

    period: list[int]
    piece: NDArray[np.int_]
    tau: Array
    rest: Array

    @classmethod
    def of(cls, push: PeriodicPush, t: Array) -> "TimesInPieces":
        """Return the period and the piece of the `push` at each time of t (n,) in s, and the time since its start."""
        none = np.zeros(t.size, dtype=int)
        if push.once:
            return cls(none.tolist(), none, t, np.zeros_like(t))
        with precise():
            rate, T = exact(push.omega) / (2 * PI), 2 * PI / exact(push.omega)
        above, below = T.as_integer_ratio()
        shift = _BITS - above.bit_length() + below.bit_length()
        unit = (above << max(0, shift)) // (below << max(0, -shift))
        turns = remainders(rate, t, 1 << _PERIODS)
        shares = [turn & ((1 << FINE) - 1) for turn in turns]
        begins = [math.floor(one.begin * (1 << FINE)) for one in push.pieces]
        piece = np.array([sum(share >= begin for begin in begins) - 1 for share in shares], dtype=int)
        times = [(share - begins[i]) * unit >> FINE for share, i in zip(shares, piece.tolist(), strict=True)]
        tau = [math.ldexp(float(time), -shift) for time in times]
        rest = [math.ldexp(float(time - int(float(time))), -shift) for time in times]
        return cls([turn >> FINE for turn in turns], piece, np.array(tau), np.array(rest))
